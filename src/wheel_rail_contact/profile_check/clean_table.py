# SPDX-License-Identifier: BSD-3-Clause
"""Table of a profile as it is understood."""
import json
import os

import numpy as np

from ..command import Failure, native, writing
from .checked import text_of
from .curve import Curve, Feet

MM, UM = 1e-3, 1e-6  # [m]
ACCURACY = 1e-7  # of a curve that is read again [m]
SPACINGS = (0.2e-3, 0.1e-3, 0.06e-3)  # of points along a smoothed curve, of which the first is used that reproduces it [m]
LEAST_SPACING = 0.06e-3  # points closer than 0.05 mm are omitted when a file is read [m]
MOST_TURN = 0.1  # of the tangent from point to point [rad]
REACH = 1e-3  # around ends and discontinuities, over which the points are closest [m]
LEAST_CHANGE = 1  # of the curvature, that counts as a discontinuity [1/m]
BESIDE = 1e-9  # a section boundary [m]


def write(source, checked, path):
    """Writes a profile as a table `y_mm,z_mm`, after comments with the name of its file and what was understood of it.

    The points are those of the file if the curve passes through them, else points along the curve. The table is then read: the
    curve must be the same within 0.1 um.

    source: name of the file
    path: of the table

    Returns what a user of the table must know: "", or that it is to be read with `smoothing: 0`, because the curve is so rough
    that it would be smoothed again. Raises Failure if the file cannot be written, or if the curve is another one: for example a
    rail that was shifted so far that its origin is found again from its shape.
    """
    is_exact = checked.smoothing == 0 and len(checked.points) > 0
    curve = Curve(checked.profile)
    for spacing in SPACINGS[:1] if is_exact else SPACINGS:
        _write(source, checked, checked.points if is_exact else points_along(curve, spacing), path)
        if _deviation(checked.kind, curve, path, {}) <= ACCURACY:
            return ""
    deviation = _deviation(checked.kind, curve, path, {"smoothing": 0})
    if deviation <= ACCURACY:
        return "the curve is rough: read the table with smoothing: 0, otherwise it is smoothed again"
    raise Failure(f"no table is written: read again, its curve deviates by {deviation / UM:g} um. Either the rail was shifted so "
                  "far that its origin is found from its shape, or the curve is rough: a larger --smoothing makes it smoother")


def _write(source, checked, points, path):
    lines = [f"# {checked.kind} profile: y to the field side, z up", f"# written by check_profile from '{text_of(source)}'",
             f"# which was read as: {checked.profile.report}"]
    if checked.smoothing > 0:
        lines.append("# the points are on the smoothed curve: they no longer show the noise of the file")
    lines += ["# with the option smoothing: 0, it is read as exactly this curve", "y_mm,z_mm"]
    lines += [f"{y / MM:.17g},{z / MM:.17g}" for y, z in points]
    with writing(path), open(path, "w", encoding="utf-8") as stream:
        stream.write("\n".join(lines) + "\n")


def _deviation(kind, curve, path, options):
    """Largest distance of the curve that is read from a table [m]."""
    again = native().describe_profile(os.fsencode(path), kind, json.dumps(options))
    if isinstance(again, str):
        raise Failure(f"no table is written: it would be refused: {again}")
    again = Curve(again[0])
    return max(largest_distance(again, curve), largest_distance(curve, again))


def points_along(curve, spacing=SPACINGS[0]):
    """(n, 2) points of a curve, from which the same curve is read again, as closely as `spacing` permits.

    They are at most `spacing` apart and include all section boundaries; closer, down to 0.06 mm, where the radius is below 10
    spacings, and near ends, discontinuities of the curvature and missing points, at which an interpolating spline deviates.
    Ranges of missing points stay without points.

    spacing: at least 0.06 mm [m]
    """
    begin, end = curve.boundaries[:-1], curve.boundaries[1:]
    missing, sharp = curve.missing(0.5 * (begin + end)), _sharp_places(curve)
    u = []
    for i, (first, last) in enumerate(zip(begin, end)):
        if not (missing[i] and i > 0 and missing[i - 1]):
            u.append(first)
        if not missing[i]:
            u += _inside(curve, spacing, sharp, first, last)
    return curve.at(np.append(u, end[-1]))[:, :2]


def _sharp_places(curve):
    """u around which points are closest: ends, discontinuities of the curvature and ends of missing ranges."""
    inner = curve.boundaries[1:-1]
    before, after = inner - BESIDE, inner + BESIDE
    sharp = np.abs(curve.curvature(after) - curve.curvature(before)) > LEAST_CHANGE
    sharp |= curve.missing(before) != curve.missing(after)
    return np.concatenate([curve.boundaries[:1], inner[sharp], curve.boundaries[-1:]])


def _inside(curve, spacing, sharp, begin, end):
    """u of the points of a section between its ends."""
    found, u = [], begin
    while True:
        dy, dz = curve.at([u])[0, 2:4]
        rest = (end - u) * np.hypot(dy, dz)
        count = min(np.ceil(rest / _spacing_at(curve, spacing, sharp, u)), np.floor(rest / LEAST_SPACING))
        if count <= 1:
            return found
        u += (end - u) / count
        found.append(u)


def _spacing_at(curve, spacing, sharp, u):
    """Distance of the points at a parameter [m]."""
    if np.abs(sharp - u).min() < REACH:
        return LEAST_SPACING
    by_turn = MOST_TURN / max(abs(curve.curvature([u])[0]), MOST_TURN / spacing)
    return max(by_turn, LEAST_SPACING)


def largest_distance(curve, other):
    """Largest distance of a curve from another one, across the other one, where no points of either are missing [m]."""
    count = int(np.ceil(curve.length / LEAST_SPACING))
    u = curve.length * np.arange(count + 1) / count
    points = curve.at(u)
    feet = Feet(other).nearest(points[:, 0], points[:, 1])
    nearest = other.at(feet)
    distance = np.hypot(points[:, 0] - nearest[:, 0], points[:, 1] - nearest[:, 1])
    return max(distance[~(curve.missing(u) | other.missing(feet))], default=0.0)
