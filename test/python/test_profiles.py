# SPDX-License-Identifier: BSD-3-Clause
"""Profiles and compliance tables."""
import pathlib
import tempfile
import unittest

import numpy as np
from wheel_rail_contact import read_compliance_table, read_profile

PADS = "config/rails/pads_40_100.yaml"


class Profiles(unittest.TestCase):
    def test_a_standard_profile_has_its_curve(self):
        rail = read_profile("60E1", "rail")
        u = np.linspace(0, rail.length, 2001)
        y, z = rail.at(u)
        top = np.argmax(z)
        self.assertEqual((rail.name, rail.report, y.shape), ("60E1", "standard profile", u.shape))
        self.assertAlmostEqual(z[top], 0, delta=1e-6)
        self.assertAlmostEqual(y[top], 0, delta=1e-4)
        # The crown is an arc with a radius of 300 mm (EN 13674-1).
        np.testing.assert_allclose(rail.curvature(u[top]), -1 / 0.3, rtol=1e-6)
        np.testing.assert_allclose(rail.slope(u[top]), 0, atol=1e-3)
        np.testing.assert_allclose(np.hypot(np.diff(y), np.diff(z)).sum(), rail.length, rtol=1e-4)

    def test_a_file_is_read_with_the_options_of_its_group(self):
        wheel = read_profile("S1002", "wheel")
        y, z = wheel.at(np.linspace(0, wheel.length, 400))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "inward.txt"
            np.savetxt(file, np.column_stack([-1e3 * y, -1e3 * z]), fmt="%.6f")
            with self.assertRaisesRegex(ValueError, "inward.txt"):
                read_profile(file, "wheel")  # unit and axes are not stated
            read = read_profile(file, "wheel", unit="mm", y="inward", z="down", smoothing=0)
        self.assertIn("400 points", read.report)
        tread = np.linspace(-20e-3, 20e-3, 9)
        heights = np.interp(tread, *read.at(np.linspace(0, read.length, 4001)))
        np.testing.assert_allclose(heights, np.interp(tread, y, z), atol=2e-6)

    def test_arrays_of_any_shape_and_numbers_are_places(self):
        rail = read_profile("60E1", "rail")
        self.assertEqual(rail.at(np.zeros((2, 3)))[0].shape, (2, 3))
        self.assertIsInstance(rail.at(0.01)[0], float)
        self.assertEqual(rail.parts, [(0, rail.length)])

    def test_misuse_is_refused_by_name(self):
        for arguments, options, text in ((("60E1", "axle"), {}, "kind = 'axle': must be"), (("60E1", "wheel"), {}, "60E1"),
                                         (("none.csv", "rail"), {}, "no such file: none.csv"),
                                         (("none.csv", "rail"), {"units": "mm"}, "units is unknown"),
                                         (("60E1", "rail"), {"unit": "mm"}, "apply to files")):
            with self.subTest(arguments=arguments), self.assertRaisesRegex(ValueError, text):
                read_profile(*arguments, **options)
        with self.assertRaisesRegex(ValueError, "u = nan: must be within the profile"):
            read_profile("60E1", "rail").at(np.nan)
        with self.assertRaisesRegex(ValueError, "u = 5.000000: must be within the profile"):
            read_profile("60E1", "rail").at(5.0)


class ComplianceTables(unittest.TestCase):
    def test_displacements_are_those_of_the_matrix(self):
        table = read_compliance_table(PADS)
        moved = table.displacement(lateral_force=10e3, vertical_force=100e3, moment=500)
        self.assertAlmostEqual(moved.lateral, table.lateral_lateral * 10e3 + table.lateral_roll * 500)
        self.assertAlmostEqual(moved.vertical, -table.vertical_vertical * 100e3)
        self.assertAlmostEqual(moved.roll, table.lateral_roll * 10e3 + table.roll_roll * 500)
        self.assertEqual((table.name, table.linear_range), ("pads_40_100", 0.6))

    def test_an_inclined_rail_is_displaced_in_track_axes(self):
        table = read_compliance_table(PADS)
        upright, inclined = (table.displacement(vertical_force=100e3, inclination=angle) for angle in (0.0, 0.1))
        # The vertical force has a part across the axis of the rail, towards the track centre.
        self.assertLess(inclined.roll, upright.roll - 1e-4)

    def test_a_missing_file_is_named(self):
        with self.assertRaisesRegex(ValueError, "no such file: none.yaml"):
            read_compliance_table("none.yaml")
