# SPDX-License-Identifier: BSD-3-Clause
"""Loops of a recording: a bag that is played in a loop, or a simulation that is started again, has stamps that go back."""
import numpy as np


def loops(stamp):
    """The pieces of a recording in which the stamps do not decrease, as slices in recording order.

    @param stamp [s], (n,) with n >= 1
    """
    starts = [0, *(np.flatnonzero(np.diff(stamp) < 0) + 1).tolist(), len(stamp)]
    return [slice(first, last) for first, last in zip(starts, starts[1:])]


def loop_of(stamp, index):
    """Number of the loop of a result, counted from 1.

    @param stamp [s], (n,)
    @param index of the result
    """
    return 1 + int((np.diff(stamp[:index + 1]) < 0).sum())
