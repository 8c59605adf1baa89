# SPDX-License-Identifier: BSD-3-Clause
"""Points along a curve, from which the same curve is read again."""
import unittest

import numpy as np
from profile_case import MM, ProfileCase, noisy_points, points_of, standard

from wheel_rail_contact.profile_check.clean_table import largest_distance, points_along
from wheel_rail_contact.profile_check.curve import Curve, Feet

SAME = 1e-7  # tolerance of a curve that is read again [m]


class Line:
    """A straight line in the place of a Curve, 100 mm long."""
    length = 100 * MM

    def __init__(self, z):
        self.z = z

    def at(self, u):
        one = np.ones(len(u))
        return np.column_stack([np.asarray(u) - 50 * MM, self.z * one, one, 0 * one, 0 * one, 0 * one])

    def missing(self, u):
        return np.zeros(len(u), dtype=bool)


class ReadAgain(ProfileCase):
    def expect_same(self, profile, kind):
        again, used, smoothing = self.described(points_along(Curve(profile)), kind)
        self.assertEqual((smoothing, "omitted" in again.report), (0, False), again.report)
        self.assertLess(largest_distance(Curve(again), Curve(profile)), SAME)
        self.assertLess(largest_distance(Curve(profile), Curve(again)), SAME)

    def test_curve_through_points_is_the_same(self):
        for name, kind in (("60E1", "rail"), ("S1002", "wheel")):
            self.expect_same(self.described(points_of(standard(name, kind)), kind)[0], kind)

    def test_curve_through_sparse_points_is_the_same(self):
        self.expect_same(self.described(points_of(standard("60E1"), 2.3 * MM), "rail")[0], "rail")

    def test_smoothed_curve_is_the_same(self):
        for name, kind in (("60E1", "rail"), ("S1002", "wheel")):
            profile, _, smoothing = self.described(noisy_points(standard(name, kind), 10e-6, 11), kind)
            self.assertGreater(smoothing, 5e-6)
            self.expect_same(profile, kind)

    def test_missing_points_are_missing_again(self):
        for noise in (0, 5e-6):
            points = noisy_points(standard("60E1"), noise, 12)
            first = Curve(self.described(points[(points[:, 0] < -12 * MM) | (points[:, 0] > 8 * MM)], "rail")[0])
            again = Curve(self.described(points_along(first), "rail")[0])
            for curve in (first, again):
                u = Feet(curve).nearest(np.array([-2 * MM, 9 * MM]), np.zeros(2))
                self.assertEqual(curve.missing(u).tolist(), [True, False])
            self.assertLess(largest_distance(again, first), SAME, noise)

    def test_standard_rail_is_the_same(self):
        self.expect_same(standard("60E1"), "rail")


class Points(unittest.TestCase):
    def test_are_at_most_a_fifth_of_a_millimetre_apart(self):
        distances = np.hypot(*np.diff(points_along(Curve(standard("S1002", "wheel"))), axis=0).T)
        self.assertLess(distances.max(), 0.201 * MM)
        self.assertGreater(distances.min(), 0.05 * MM)

    def test_largest_distance_is_that_of_parallel_curves(self):
        self.assertAlmostEqual(largest_distance(Line(0), Line(1 * MM)), 1 * MM, delta=1e-12)
