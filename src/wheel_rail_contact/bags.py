# SPDX-License-Identifier: BSD-3-Clause
"""Bags as inputs of commands."""
import os

import rosbag

from .command import Failure

LEAST_LIMIT, EXPANSION = 2**28, 100  # as for contact_replay: size of the chunks [B], also as a multiple of the size of the file


def opened(path):
    """The bag, opened to read it.

    @throw Failure if its chunks expand without measure: each one is decompressed as a whole
    """
    bag = rosbag.Bag(str(path))
    size, limit = bag.get_compression_info().uncompressed, max(LEAST_LIMIT, EXPANSION * os.path.getsize(path))
    if size > limit:
        bag.close()
        raise Failure(f"{path}: its chunks expand to {size >> 20} MiB, which is above {limit >> 20} MiB; `rosbag decompress` "
                      "writes a bag that is read without this limit")
    return bag
