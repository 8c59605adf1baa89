# SPDX-License-Identifier: BSD-3-Clause
"""Tables from which the picture of a profile is drawn."""
import numpy as np

from ..command import native
from . import text
from .curve import ArcLength, Curve, Feet, distance_across, drawn_parameters


class Tables:
    """Tables of one profile, in SI units.

    curve, points, standard: columns by name. marks: point (y, z) by name, in m. values: by name.
    """

    def __init__(self, checked):
        """checked: Checked."""
        curve = Curve(checked.profile)
        arc = ArcLength(curve)
        self.curve = _curve(curve, arc)
        self.points = _points(curve, arc, checked.points)
        self.standard = _standard(checked.nearest)
        measures = native().wheel_measures if checked.kind == "wheel" else native().rail_measures
        self.marks = {name: place for name, place in measures(checked.profile).items() if isinstance(place, tuple)}
        self.values = {"kind": checked.kind, "report": checked.profile.report, "smoothing": checked.smoothing,
                       "standard": self.standard["name"], "nearest": text.nearest(checked.nearest)}

    def missing_ranges(self):
        """Ranges of the arc length over which points are missing [m], as a list of pairs."""
        missing = np.concatenate([[0], self.curve["missing"], [0]])
        ends = np.flatnonzero(np.diff(missing))
        length = self.curve["arc_length"]
        return [(length[begin], length[end - 1]) for begin, end in zip(ends[::2], ends[1::2])]


def _curve(curve, arc):
    u = drawn_parameters(curve)
    y, z = curve.at(u)[:, :2].T
    position_error, curvature_error, missing = curve.errors(u).T
    return {"arc_length": arc.at(u), "y": y, "z": z, "curvature": curve.curvature(u), "position_error": position_error,
            "curvature_error": curvature_error, "missing": missing}


def _points(curve, arc, points):
    """Used points of the file, with their distance from the curve, positive above."""
    y, z = points.T
    u = Feet(curve).nearest(y, z)
    return {"arc_length": arc.at(u), "y": y, "z": z, "residual": distance_across(curve.at(u), y, z)}


def _standard(fit):
    """The nearest standard profile, moved onto the profile."""
    if not np.isfinite(fit.rms):
        return {"name": "", "y": np.empty(0), "z": np.empty(0)}
    y, z = fit.curve.at(drawn_parameters(fit.curve))[:, :2].T
    c, s = np.cos(fit.motion.rotation), np.sin(fit.motion.rotation)
    return {"name": fit.curve.name, "y": c * y - s * z + fit.motion.y, "z": s * y + c * z + fit.motion.z}
