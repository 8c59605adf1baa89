# SPDX-License-Identifier: BSD-3-Clause
"""What the points of a file leave open on the running surface."""
from collections import namedtuple

import numpy as np

# curvature_error: largest standard deviation of the curvature where no points are missing [1/m]
# y: place of it [m]
# usual_error: median over the length of the standard deviation of the curvature [1/m]
# missing: share of the length over which points are missing [-]
SurfaceKnowledge = namedtuple("SurfaceKnowledge", "curvature_error y usual_error missing")


def surface_knowledge(curve, surface):
    """SurfaceKnowledge of a Curve in the range of u of its running surface."""
    begin, end = np.maximum(curve.boundaries[:-1], surface[0]), np.minimum(curve.boundaries[1:], surface[1])
    begin, end = begin[begin < end], end[begin < end]
    _, errors, missing = curve.errors(0.5 * (begin + end)).T
    known = missing == 0
    share = np.sum((end - begin)[~known]) / (surface[1] - surface[0])
    middle, errors, length = 0.5 * (begin + end)[known], errors[known], (end - begin)[known]
    if not errors.any():
        return SurfaceKnowledge(0, 0, 0, share)
    order, worst = np.argsort(errors, kind="stable"), np.argmax(errors)
    below = np.cumsum(length[order])
    usual = errors[order][np.searchsorted(below, 0.5 * below[-1])]
    return SurfaceKnowledge(errors[worst], curve.at(middle[worst:worst + 1])[0, 0], usual, share)
