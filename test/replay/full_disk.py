# SPDX-License-Identifier: BSD-3-Clause
"""Simulation of a full disk for child processes of tests."""
import resource


def no_file_larger_than(size):
    """A preexec_fn that limits the file size of the child process to `size` [B]. Writes then fail as on a full disk."""
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
