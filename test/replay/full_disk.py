# SPDX-License-Identifier: BSD-3-Clause
"""A disk that is full, for programs that tests run."""
import resource


def no_file_larger_than(size):
    """For a child process: stands for a full disk, which a write meets in the same way. [B]"""
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
