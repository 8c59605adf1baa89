# SPDX-License-Identifier: BSD-3-Clause
"""What was understood of a file and measured on its profile, in lines of text."""
import numpy as np

from ..command import native
from .checked import text_of
from .curve import Curve
from .knowledge import surface_knowledge

MM = 1e-3  # [m]
MRAD = 1e-3  # [rad]
GAUGE_DEPTH = 0.014  # of the gauge below the top [m] (EN 13848-1)
LEAST_INCLINATION = 5e-5  # smaller ones are rounded to 0 [rad]
LEAST_SLOPE = 2e-3  # from which an inclination is also written as a slope [rad]


def report(name, checked):
    """Lines about the Checked profile of a file."""
    curve = Curve(checked.profile)
    measures = _wheel(checked.profile, curve) if checked.kind == "wheel" else _rail(checked.profile, curve)
    lines = [checked.profile.report, *measures, _knowledge(checked, curve), nearest(checked.nearest), *_direction(checked)]
    return "\n  ".join([f"{text_of(name)}: {checked.kind}, {checked.known_by}", *lines])


def nearest(fit):
    """Nearest standard profile and its distance, in one line."""
    if not np.isfinite(fit.rms):
        return "no standard profile could be compared"
    text = (f"nearest standard profile: {fit.curve.name}, rms {_small(fit.rms)}, largest {_small(abs(fit.largest))} "
            f"{'below' if fit.largest < 0 else 'above'} it at y = {_mm(fit.y, 1)}; moved by {_mm(fit.motion.y)} outward and "
            f"{_mm(fit.motion.z)} up")
    return text + (f", rotated by {_inclination(fit.motion.rotation)}" if abs(fit.motion.rotation) > LEAST_INCLINATION else "")


def _fixed(value, decimals):
    text = f"{value:.{decimals}f}"
    return text.lstrip("-") if not text.strip("-0.") else text  # a rounded zero has no sign


def _mm(length, decimals=2):
    """Length with a fixed number of decimals, as in a table of measures."""
    return f"{_fixed(length / MM, decimals)} mm"


def _small(length):
    """Small length with two significant digits; shorter than a nanometre is rounding."""
    return "0 mm" if length < 1e-9 else f"{length / MM:.2g} mm"


def _place(point):
    return f"y = {_mm(point[0])}, z = {_mm(point[1])}"


def _measure(name, length):
    return f"{name} {'not known' if length is None else _mm(length)}"


def _inclination(angle):
    """Angle of a rail, with its slope 1:N and the side to which the top leans."""
    if abs(angle) < LEAST_INCLINATION:
        return "0 mrad"
    slope = "" if abs(angle) < LEAST_SLOPE else f" (1:{_fixed(1 / np.tan(abs(angle)), 1)})"
    return f"{_fixed(abs(angle) / MRAD, 1)} mrad{slope} to{' the field side' if angle < 0 else 'wards the track centre'}"


def _lean(angle):
    """Lean of a side as a slope 1:N, positive if the head widens downwards."""
    return f"{'-' if angle < 0 else ''}1:{_fixed(1 / max(np.tan(abs(angle)), 1e-9), 1)}"


def _width(curve):
    y = curve.at(curve.boundaries)[:, 0]
    return f"width {_mm(y.max() - y.min())}, from y = {_mm(y.min())} to {_mm(y.max())}"


def _wheel(profile, curve):
    wheel = native().wheel_measures(profile)
    return [f"flange height Sh {_mm(wheel['flange_height'])}, {_measure('flange thickness Sd', wheel['flange_thickness'])}, "
            f"{_measure('qR', wheel['flange_gradient'])} (EN 15313)", _width(curve)]


def _rail(profile, curve):
    rail = native().rail_measures(profile)
    gauge = _place(rail["gauge_point"]) if rail["gauge_point"] else "a depth that the profile does not reach"
    lines = [f"top at {_place(rail['top'])}, gauge point at {gauge}",
             f"{_width(curve)}, {_measure(f'{_mm(GAUGE_DEPTH, 0)} below the top', rail['head_width'])}"]
    if rail["gauge_side_lean"] is not None and rail["field_side_lean"] is not None:
        lines.append(f"sides {_lean(rail['gauge_side_lean'])} (gauge side) and {_lean(-rail['field_side_lean'])} (field side): if "
                     f"they are not worn, the head is inclined by {_inclination(rail['inclination'])}")
    return lines


def _direction(checked):
    """What a reversed y of a rail may show. A fit to the mirrored profile would not: all standard rails are symmetric."""
    if checked.kind == "rail" and np.isfinite(checked.nearest.rms) and checked.nearest.motion.rotation < -LEAST_SLOPE:
        yield ("the head is inclined to the field side, or worn there: if that is its gauge side, y points the other way (--y, "
               "--mirror)")


def _knowledge(checked, curve):
    known = surface_knowledge(curve, native().running_surface(checked.profile, checked.kind))
    text = f"running surface: curvature known within {known.usual_error:.2g} 1/m"
    if known.curvature_error > known.usual_error:
        text += f" over half of it, and {known.curvature_error:.2g} 1/m at worst (y = {_mm(known.y, 1)})"
    return text + f", points missing over {_fixed(100 * known.missing, 1)} % of it"
