# SPDX-License-Identifier: BSD-3-Clause
"""The standard profile that is nearest to a profile."""
from collections import namedtuple

import numpy as np

from ..command import native
from .curve import Curve, Feet, distance_across

SPACING = 0.25e-3  # of the compared points [m]
LEAST_SHARE = 0.5  # of the running surface
MOST_STEPS = 100
ACCURACY = 1e-10  # of the motion, at which the search ends [m]
LEAST_PART = 1e-3  # of a step that is tried
LEVER = 0.035  # half the width of a profile: a rotation moves its ends by this much [m/rad]

# Motion of a profile in its plane: first the rotation about the origin, then the shift.
#
# rotation: from y (field side) towards z (up) [rad]: positive if a rail leans to the track centre
# y, z: shift to the field side and up [m]
Motion = namedtuple("Motion", "rotation y z")

# Distance of a profile from a standard profile that was moved onto it.
#
# curve: Curve of the standard profile; None: no standard profile could be compared
# motion: of the standard profile
# rms: root mean square of the distance across the curve [m]; infinite if less than half of the running surface could be
#     compared, or nothing of it is known
# largest: largest distance, with its sign: positive if the profile lies above the standard [m]
# y: place of the largest distance on the profile [m]
# share: share of the running surface over which both were compared [-]
Fit = namedtuple("Fit", "curve motion rms largest y share")


def nearest_standard(profile, kind):
    """Fit of the standard profile of a kind with the smallest root mean square distance from a profile.

    Rails are rotated, because they may be stored as they lie in the track. Wheels are not: a rotation would turn one conicity
    into another.
    """
    core = native()
    points, nearest = compared_points(profile, kind), Fit(None, Motion(0, 0, 0), np.inf, 0, 0, 0)
    for name in core.standard_profile_names(kind):
        standard = core.read_profile(name, kind, "{}")
        fit = standard_fit(points, Curve(standard), start_of(profile, standard, kind), kind != "wheel")
        nearest = fit if fit.rms < nearest.rms else nearest
    return nearest


def compared_points(profile, kind):
    """(n, 2) points of the running surface at which a profile is known."""
    curve = Curve(profile)
    begin, end = native().running_surface(profile, kind)
    count = max(1, int((end - begin) / SPACING))
    u = begin + (end - begin) * np.arange(count + 1) / count
    return curve.at(u[~curve.missing(u)])[:, :2]


def start_of(profile, standard, kind):
    """Motion at the start of the search: the same height at the top of rails and at the running circle of wheels, and the same
    gauge face."""
    core = native()
    if kind == "wheel":
        a, b = (core.wheel_measures(each)["running_circle"] for each in (profile, standard))
        return Motion(0, 0, a[1] - b[1])
    a, b = core.rail_measures(profile), core.rail_measures(standard)
    y = a["gauge_point"][0] - b["gauge_point"][0] if a["gauge_point"] and b["gauge_point"] else 0
    return Motion(0, y, a["top"][1] - b["top"][1])


def standard_fit(points, standard, motion, rotated):
    """Fit of a standard profile that is moved to where the root mean square of its distance from points is smallest.

    The distance is taken across the standard, as far as this reaches. Least squares by the method of Gauss and Newton: each step
    moves the points along the tangents at their nearest points (Chen and Medioni, Object modelling by registration of multiple
    range images, Image and Vision Computing 10, 1992). Steps that make the distance larger are shortened, and the rotation is
    determined after the shift.

    points: (n, 2) of the profile
    standard: Curve of the standard profile
    motion: start of the search
    rotated: True: the standard is also rotated
    """
    distances = _Distances(points, standard, Feet(standard), motion)
    for first in (1, 0) if rotated else (1,):
        distances = _improved(distances, first)
    value, share = distances.value, len(distances.value) / max(len(points), 1)
    if not distances.usable:
        return Fit(standard, distances.motion, np.inf, 0, 0, 0)
    i = np.argmax(np.abs(value))
    y = points[distances.compared][i, 0] if value[i] else 0
    return Fit(standard, distances.motion, np.sqrt(distances.mean_square), value[i], y, share)


class _Distances:
    """Distances of points from a moved standard profile, and their derivatives.

    compared: (n,) True for the points that are not beyond an end of the standard
    value: (k,) of these [m]
    slopes: (k, 3) by rotation times LEVER, y and z [-]
    """

    def __init__(self, points, standard, feet, motion):
        self._fixed, self.motion = (points, standard, feet), motion
        c, s = np.cos(motion.rotation), np.sin(motion.rotation)
        y, z = points[:, 0] - motion.y, points[:, 1] - motion.z
        y, z = c * y + s * z, c * z - s * y
        u = feet.nearest(y, z)
        self.compared = ~feet.is_end(u)
        y, z, feet_points = y[self.compared], z[self.compared], standard.at(u[self.compared])
        dy, dz = feet_points[:, 2:4].T
        speed = np.hypot(dy, dz)
        ny, nz = -dz / speed, dy / speed
        self.value = distance_across(feet_points, y, z)
        self.slopes = np.column_stack([(ny * z - nz * y) / LEVER, -ny * c + nz * s, -ny * s - nz * c])
        self.usable = 0 < len(self.value) >= LEAST_SHARE * len(points)
        self.mean_square = np.mean(self.value**2) if self.usable else np.inf

    def moved(self, step):
        """Distances after a step (rotation times LEVER, y, z)."""
        rotation, y, z = self.motion
        return _Distances(*self._fixed, Motion(rotation + step[0] / LEVER, y + step[1], z + step[2]))

    def least_squares_step(self, first):
        """Step that makes the linearised distances smallest, of the components from `first`. Where they do not determine a
        component, as for a circular arc, the shortest step."""
        return np.append(np.zeros(first), np.linalg.lstsq(self.slopes[:, first:], -self.value, rcond=None)[0])


def _improved(distances, first):
    """Distances after steps, until the motion stays or no step makes them smaller."""
    for _ in range(MOST_STEPS):
        step = distances.least_squares_step(first) if distances.usable else np.zeros(3)
        if np.linalg.norm(step) < ACCURACY:
            break
        # The whole step can be too long where the distances are large.
        tried = (distances.moved(0.5**i * step) for i in range(int(np.ceil(-np.log2(LEAST_PART)))))
        better = next((moved for moved in tried if moved.mean_square < distances.mean_square), None)
        if better is None:
            break
        distances = better
    return distances
