# SPDX-License-Identifier: BSD-3-Clause
"""Curve of a profile, and the search of points on it."""
import numpy as np

from ..command import native

FOOT_SPACING = 5e-4  # of the points of which the nearest one is the start of a search [m]
FOOT_STEPS = 20  # most steps of Newton's method
FOOT_ACCURACY = 1e-12  # of the parameter of a nearest point [m]
END = 1e-9  # distance from an end of the curve, within which a point is at this end [m]
SPACING = 1e-4  # of the points of a drawn curve [m]


class Curve:
    """Curve of a profile of one part, by its parameter u [m] in [0, length].

    length: largest u
    boundaries: u of all section boundaries, with both ends
    """

    def __init__(self, profile):
        """profile: Profile of the extension module."""
        self._profile = profile
        self.length = profile.length
        self.boundaries = np.array(native().profile_boundaries(profile))

    @property
    def name(self):
        """Of the profile."""
        return self._profile.name

    def at(self, u):
        """(n, 6) points and derivatives at (n,) u: y, z [m], dy, dz [-], ddy, ddz [1/m]."""
        return native().profile_curve(self._profile, u)

    def curvature(self, u):
        """(n,) curvature at (n,) u [1/m], positive where the curve bends up for growing y."""
        return self._profile.curvature(u)

    def errors(self, u):
        """(n, 3) of the shape at (n,) u: standard deviation across the curve [m] and of the curvature [1/m], 1 where points are
        missing."""
        return native().profile_errors(self._profile, u)

    def missing(self, u):
        """(n,) True where points are missing at (n,) u."""
        return self.errors(u)[:, 2] > 0


class Feet:
    """Finds the points of a curve that are nearest to given points."""

    def __init__(self, curve):
        self._curve = curve
        count = max(1, int(np.ceil(curve.length / FOOT_SPACING)))
        self._spacing = curve.length / count
        self._points = curve.at(np.arange(count + 1) * self._spacing)

    def nearest(self, y, z):
        """(n,) u of the points of the curve that are nearest to the points with (n,) y and z."""
        dy, dz = self._points[:, 0] - y[:, None], self._points[:, 1] - z[:, None]
        u = np.argmin(dy * dy + dz * dz, axis=1) * self._spacing
        moving = np.arange(len(u))
        for _ in range(FOOT_STEPS):
            py, pz, dy, dz, ddy, ddz = self._curve.at(u[moving]).T
            to_y, to_z = y[moving] - py, z[moving] - pz
            speed = dy * dy + dz * dz
            # Newton's derivative can vanish in the centre of curvature; the half of the speed is then a step that is safe.
            slope = np.maximum(speed - to_y * ddy - to_z * ddz, 0.5 * speed)
            moved = np.clip(u[moving] + (to_y * dy + to_z * dz) / slope, 0.0, self._curve.length)
            stays = np.abs(moved - u[moving]) < FOOT_ACCURACY
            u[moving] = moved
            moving = moving[~stays]
            if not moving.size:
                break
        return u

    def is_end(self, u):
        """(n,) True where the curve ends at (n,) u: a point nearest to it lies beyond the end."""
        return (u < END) | (u > self._curve.length - END)


def distance_across(points, y, z):
    """(n,) distance of the points y, z from points of Curve.at(), across the curve [m]; positive to the left of the direction of
    growing u: above a rail head or a tread."""
    py, pz, dy, dz = points.T[:4]
    return (dy * (z - pz) - dz * (y - py)) / np.hypot(dy, dz)


def drawn_parameters(curve):
    """Parameters about SPACING apart, each in the middle of its range, with the same number per length in a section."""
    begin, length = curve.boundaries[:-1], np.diff(curve.boundaries)
    counts = np.maximum(1, np.floor(length / SPACING + 0.5).astype(int))
    return np.concatenate([start + size * (np.arange(count) + 0.5) / count for start, size, count in zip(begin, length, counts)])


class ArcLength:
    """Arc length as a function of the parameter of a curve [m]."""

    def __init__(self, curve):
        u = drawn_parameters(curve)
        points = curve.at(np.concatenate([[0], u, [curve.length]]))
        self._lengths = np.cumsum(np.hypot(np.diff(points[:, 0]), np.diff(points[:, 1])))
        self._parameters = np.append(u, max(curve.length, np.nextafter(u[-1], 1e9)))

    def at(self, u):
        """(n,) arc length from the first point at (n,) u."""
        return np.interp(u, np.append(0, self._parameters), np.append(0, self._lengths))
