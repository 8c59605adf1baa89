# SPDX-License-Identifier: BSD-3-Clause
"""Stations of the mesh along the rail: close under the load, wider with the distance from it."""
import numpy as np

FINEST_SHARE = 0.75   # length of the element under the load, divided by the mesh size of the section
GROWTH = 0.15         # growth of this length with the distance from the load [m/m]
COARSEST_SHARE = 6.0  # largest length of an element, divided by the mesh size


def stations(length, size, required=()):
    """Increasing x [m] from 0 (loaded section) to `length`, including every `required` x."""
    marks = np.array([0.0, length] + [x for x in required if 0 < x < length])
    marks = np.unique(np.round(marks, 9))
    cuts = [np.zeros(1)]
    for first, last in zip(marks[:-1], marks[1:]):
        count = max(1, int(np.ceil(_effort(last, size) - _effort(first, size) - 1e-9)))
        efforts = np.linspace(_effort(first, size), _effort(last, size), count + 1)
        inside = _position(efforts[1:-1], size)
        cuts.append(np.append(inside, last))
    return np.concatenate(cuts)


def _effort(x, size):
    """Number of elements from 0 to x for the element length min(finest + growth x, coarsest)."""
    finest, coarsest = FINEST_SHARE * size, COARSEST_SHARE * size
    bend = (coarsest - finest) / GROWTH
    return np.log1p(GROWTH * np.minimum(x, bend) / finest) / GROWTH + np.maximum(x - bend, 0) / coarsest


def _position(effort, size):
    """Inverse of _effort."""
    finest, coarsest = FINEST_SHARE * size, COARSEST_SHARE * size
    bend = (coarsest - finest) / GROWTH
    reached = _effort(bend, size)
    return finest * np.expm1(GROWTH * np.minimum(effort, reached)) / GROWTH + np.maximum(effort - reached, 0) * coarsest
