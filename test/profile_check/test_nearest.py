# SPDX-License-Identifier: BSD-3-Clause
"""The nearest standard profile: its motion, its distance, and what is compared."""
from unittest import mock

import numpy as np
from profile_case import MM, ProfileCase, moved, points_of, standard

from wheel_rail_contact.profile_check import nearest
from wheel_rail_contact.profile_check.curve import Curve, Feet


def fit_to(profile, name="60E1", rotated=True):
    """Fit of a standard rail to a rail."""
    rail = standard(name)
    return nearest.standard_fit(nearest.compared_points(profile, "rail"), Curve(rail), nearest.start_of(profile, rail, "rail"),
                                rotated)


def rms_distance(points, curve):
    """Root mean square distance of points from their nearest points on a curve."""
    feet = curve.at(Feet(curve).nearest(*points.T))[:, :2]
    return np.sqrt(np.mean(np.sum((points - feet)**2, axis=1)))


class NearestStandard(ProfileCase):
    def worn(self, height):
        """60E1 after a change of the heights of its points, a function of y."""
        points = points_of(standard("60E1"))
        return self.curve_through(points + np.column_stack([np.zeros(len(points)), height(points[:, 0])]))

    # The interpolating spline deviates by up to 0.2 um from the standard, near discontinuities of the curvature.
    def test_of_a_moved_rail_is_this_rail_with_its_motion(self):
        for motion in ((0, 0, 0), (0.025, 2.1 * MM, -1.3 * MM), (-0.06, -7 * MM, 3 * MM)):
            for name in ("60E1", "UIC60_manchester"):
                fit = nearest.nearest_standard(self.curve_through(moved(points_of(standard(name)), *motion)), "rail")
                self.assertEqual(fit.curve.name, standard(name).name)
                self.assertAlmostEqual(fit.motion.rotation, motion[0], delta=1e-6)
                self.assertAlmostEqual(fit.motion.y, motion[1], delta=1e-7)
                self.assertAlmostEqual(fit.motion.z, motion[2], delta=1e-7)
                self.assertLess(fit.rms, 1e-7)
                self.assertLess(abs(fit.largest), 4e-7)
                self.assertGreater(fit.share, 0.999)

    def test_of_a_moved_wheel_is_found_without_rotation(self):
        wheel = self.curve_through(moved(points_of(standard("S1002", "wheel")), 0, 0.8 * MM, -0.5 * MM), "wheel")
        fit = nearest.nearest_standard(wheel, "wheel")
        self.assertEqual((fit.curve.name, fit.motion.rotation), ("S1002", 0))
        self.assertAlmostEqual(fit.motion.y, 0.8 * MM, delta=1e-7)
        self.assertAlmostEqual(fit.motion.z, -0.5 * MM, delta=1e-7)
        self.assertLess(fit.rms, 2e-7)

    # A hollow of 1 mm: it is the largest distance, below the standard, less what the fit moves the standard down.
    def test_distance_shows_wear(self):
        fit = nearest.nearest_standard(self.worn(lambda y: -1 * MM * np.exp(-(y / (8 * MM))**2)), "rail")
        self.assertAlmostEqual(fit.y, 0, delta=1 * MM)
        self.assertLess(fit.largest, -0.5 * MM)
        self.assertAlmostEqual(fit.largest, -1 * MM - fit.motion.z, delta=0.05 * MM)
        self.assertGreater(fit.rms, 0.1 * MM)

    # Least squares: no small motion makes the root mean square smaller.
    def test_root_mean_square_is_smallest(self):
        rail = self.worn(lambda y: 0.2 * np.minimum(y + 20 * MM, 0))
        fit, points = fit_to(rail), nearest.compared_points(rail, "rail")
        self.assertGreater(fit.rms, 0.2 * MM)

        def distance(motion):
            return rms_distance(points, Curve(self.curve_through(moved(points_of(standard("60E1")), *motion))))

        smallest = distance(fit.motion)
        self.assertAlmostEqual(smallest, fit.rms, delta=5e-3 * fit.rms)  # points beyond the ends are compared, too
        for step in (-1e-3, 1e-3):
            for by in np.diag([step, 35 * MM * step, 35 * MM * step]):
                self.assertGreater(distance(np.add(fit.motion, by)), smallest, by)

    # Noise of 20 um has the same root mean square; a motion takes away only three of 400 degrees of freedom.
    def test_distance_of_noise_is_the_noise(self):
        random = np.random.default_rng(5)
        fit = nearest.nearest_standard(self.worn(lambda y: np.where(abs(y) < 30 * MM, random.normal(0, 20e-6, len(y)), 0)), "rail")
        self.assertGreater(fit.rms, 10e-6)
        self.assertLess(fit.rms, 22e-6)
        self.assertAlmostEqual(fit.motion.rotation, 0, delta=1e-3)

    def test_ranges_of_missing_points_are_not_compared(self):
        points = points_of(standard("60E1"))
        rail = self.curve_through(points[abs(points[:, 0]) > 10 * MM])
        self.assertTrue(np.all(abs(nearest.compared_points(rail, "rail")[:, 0]) > 9.9 * MM))
        self.assertLess(abs(fit_to(rail).largest), 1e-6)

    def test_is_none_if_no_point_of_the_running_surface_is_known(self):
        with mock.patch.object(nearest.Curve, "missing", lambda _, u: np.ones(len(u), bool)):
            fit = nearest.nearest_standard(standard("60E1"), "rail")
        self.assertEqual((fit.curve, fit.rms, fit.share), (None, np.inf, 0))

    # A crown R203 that is 66 mm wide, with missing points of the corners, fits badly: with whole steps of the least squares the
    # motion never stays, and ends with a larger distance than without rotation.
    def test_rotation_does_not_make_the_distance_larger(self):
        y, radius = 0.8255 * MM * np.arange(-40, 41), 203.2 * MM
        side = MM * np.array([[-36.83, -22.86], [-36.58, -15.24], [-35.56, -7.62]])
        points = np.vstack([side, np.column_stack([y, np.sqrt(radius**2 - y**2) - radius]), side[::-1] * [-1, 1]])
        rail = self.curve_through(points)
        self.assertTrue(Curve(rail).missing(Curve(rail).boundaries).any())
        shifted, rotated = fit_to(rail, rotated=False), fit_to(rail)
        self.assertGreater(shifted.rms, 0.5 * MM)
        self.assertLessEqual(rotated.rms, shifted.rms)
        self.assertAlmostEqual(shifted.motion.y, 0, delta=1e-6)

    # A head that is 30 mm wide at its flat top is no standard rail: most of its points are beyond the ends of none, and the
    # distance is large.
    def test_of_another_shape_is_far(self):
        y = 0.5 * MM * np.arange(-60, 61)
        plate = self.curve_through(np.column_stack([y, -2 * np.maximum(abs(y) - 15 * MM, 0) - 1e-3 * y**2]))
        self.assertGreater(nearest.nearest_standard(plate, "rail").rms, 0.5 * MM)
