# SPDX-License-Identifier: BSD-3-Clause
"""Profiles for the tests: standard ones, and curves through points."""
import json
import numpy as np
from commands import FolderCase
from wheel_rail_contact.command import native
from wheel_rail_contact.profile_check.curve import Curve

MM = 1e-3  # [m]


def standard(name, kind="rail"):
    return native().read_profile(name, kind, "{}")


def points_of(profile, spacing=0.1 * MM):
    """(n, 2) points of a profile, in equal steps of its parameter."""
    return Curve(profile).at(np.linspace(0, profile.length, int(profile.length / spacing) + 1))[:, :2]


def noisy_points(profile, deviation, seed):
    """(n, 2) points of a profile 0.25 mm apart, with noise across the curve [m]."""
    p = Curve(profile).at(np.linspace(0, profile.length, int(profile.length / (0.25 * MM)) + 1))
    shift = np.random.default_rng(seed).normal(0, deviation, len(p)) / np.hypot(p[:, 2], p[:, 3])
    return p[:, :2] + shift[:, None] * np.column_stack([-p[:, 3], p[:, 2]])


def moved(points, rotation=0.0, y=0.0, z=0.0):
    c, s = np.cos(rotation), np.sin(rotation)
    return points @ np.array([[c, s], [-s, c]]) + [y, z]


class ProfileCase(FolderCase):
    def curve_through(self, points, kind="rail_section", **options):
        """Profile of a file with these points [m]. A section of a rail keeps its place, other kinds are given their origin."""
        return self.described(points, kind, **{"smoothing": 0, **options})[0]

    def described(self, points, kind, **options):
        """Profile, used points and smoothing of a file with these points [m]."""
        path = self.folder / "points.csv"
        np.savetxt(path, np.asarray(points) / MM, delimiter=",", header="y_mm,z_mm", comments="", fmt="%.17g")
        found = native().describe_profile(str(path), kind, json.dumps(options))
        self.assertNotIsInstance(found, str, found)
        return found
