# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np

from wheel_rail_contact.command import contact_model, native, running_circles
from wheel_rail_contact.geometry.conicity import (NO_CENTRE, NO_WAVE, OUT_OF_RANGE, SEVERAL_WAVES, RadiusDifference,
                                                  kinematic_wavelength)
from wheel_rail_contact.geometry.loaded import loaded_points

MM = 1e-3


def curve_of(difference, reach, steps):
    """Curve of a radius difference [m] between -reach and reach [m], with a multiple of two steps."""
    y = reach * (2.0 * np.arange(steps + 1) / steps - 1)
    return RadiusDifference(np.column_stack([y, difference(y)]))


def tabulated(points, shift=0.0):
    """Curve of equal wheels from points at y >= 0 [mm]; `shift` is the difference of their radii [mm]."""
    y, difference = np.transpose(points)
    y, value = np.concatenate([-y[::-1], y]), np.concatenate([shift - difference[::-1], shift + difference])
    return RadiusDifference(np.column_stack([y, value]) * MM)


class Conicity(unittest.TestCase):
    def assert_conicity(self, curve, amplitude, expected, delta):
        """Asserts the conicity at an amplitude [mm]. Returns the centre of the wave [m]."""
        value, centre, reason = curve.conicity(amplitude * MM)
        self.assertEqual(reason, "", amplitude)
        self.assertAlmostEqual(value, expected, delta=delta, msg=amplitude)
        return centre

    def test_of_cones_it_is_their_conicity_at_every_amplitude(self):
        for steps in (2, 60):
            cones = curve_of(lambda y: 2 * 0.05 * y, 10 * MM, steps)
            for amplitude in (0.1, 1, 3.3, 9.9):
                centre = self.assert_conicity(cones, amplitude, 0.05, 1e-9)
                self.assertAlmostEqual(centre, 0, delta=1e-12, msg=amplitude)

    def test_of_cones_with_unequal_radii_it_is_that_of_a_wave_about_another_centre(self):
        cones = curve_of(lambda y: 2 * 0.1 * y + 0.4 * MM, 10 * MM, 50)
        self.assertAlmostEqual(self.assert_conicity(cones, 3, 0.1, 1e-9), -2 * MM, delta=1e-12)

    def test_of_a_jump_in_the_centre_it_falls_with_the_amplitude(self):
        # Closed form: S = d |y|, I = 2 ∫ dy / sqrt(d (A - y)) = 4 sqrt(A / d).
        jump = 1.0  # [mm]
        curve = RadiusDifference(np.array([(-10, -jump), (0, -jump), (0, jump), (10, jump)]) * MM)
        for amplitude in (0.5, 2, 7):
            self.assert_conicity(curve, amplitude, math.pi ** 2 * jump / (16 * amplitude), 1e-9)

    def test_of_a_cubic_it_grows_with_the_square_of_the_amplitude(self):
        # Closed form: I = 4 L / (sqrt(k) A) with the lemniscate constant L = ∫ dx / sqrt(1 - x⁴), x = 0 to 1. The straight
        # lines between 4000 points deviate from the cubic by 2e-7 of its largest value.
        factor, lemniscate = 1000.0, 1.3110287771461  # factor in 1/m²
        cubic = curve_of(lambda y: factor * y ** 3, 8 * MM, 4000)
        for amplitude in (4, 7.3):
            exact = (math.pi * math.sqrt(factor) * amplitude * MM / (4 * lemniscate)) ** 2
            self.assert_conicity(cubic, amplitude, exact, 1e-5 * exact)

    def test_it_agrees_with_the_standard_for_wheels_with_a_jump(self):
        # EN 15302:2008+A1:2010, annex E, wheels H on both sides (920 mm): radius difference at 0.1 mm steps, which are
        # straight lines between these points; and the conicity. Tolerance: the figures have three decimals.
        curve = tabulated([(0, 0), (2.5, 0.125), (2.6, 2.407), (6.7, 3.330), (6.8, 11.216)])
        for amplitude, conicity in ((1.0, 0.025), (2.0, 0.025), (2.6, 0.075), (2.7, 0.138), (2.8, 0.184), (3.0, 0.245),
                                    (3.5, 0.308), (4.0, 0.319), (5.0, 0.306), (6.0, 0.284), (6.7, 0.270)):
            self.assert_conicity(curve, amplitude, conicity, 1e-3)

    def test_it_agrees_with_the_standard_for_unequal_radii(self):
        # The same source, wheels B, 920 mm on the right and 918 mm on the left. Of the 0.1 mm steps, those are left out
        # between which straight lines deviate by less than 0.01 mm.
        curve = tabulated([(0, 0), (2.9, 0.145), (3.0, 1.950), (3.5, 2.224), (4.0, 2.517), (4.5, 2.830), (5.0, 3.163),
                           (5.5, 3.516), (6.0, 3.889), (6.3, 4.123)], shift=1)
        for amplitude, conicity in ((1.0, 0.660), (1.5, 0.472), (2.0, 0.376), (2.5, 0.317), (3.0, 0.278), (3.5, 0.249),
                                    (4.0, 0.227)):
            self.assert_conicity(curve, amplitude, conicity, 1e-3)

    def test_of_cylinders_it_is_zero(self):
        value, _, reason = curve_of(lambda y: 1e-8 * np.sin(9e3 * y), 10 * MM, 100).conicity(3 * MM)
        self.assertEqual((value, reason), (0, ""))
        self.assertEqual(kinematic_wavelength(0, 1.5, 0.46), math.inf)

    def test_a_centre_is_required(self):
        for curve in (curve_of(lambda y: 1 * MM + 0 * y, 10 * MM, 20), curve_of(lambda y: -0.2 * y, 10 * MM, 20),
                      RadiusDifference([])):
            self.assertEqual(curve.conicity(2 * MM)[2], NO_CENTRE)

    def test_the_whole_wave_must_be_within_the_range(self):
        centred = curve_of(lambda y: 0.2 * y, 3 * MM, 20)
        self.assertEqual(centred.conicity(2.99 * MM)[2], "")
        self.assertEqual(centred.conicity(3.01 * MM)[2], OUT_OF_RANGE)
        shifted = curve_of(lambda y: 0.2 * (y - 2 * MM), 3 * MM, 20)
        self.assertEqual(shifted.conicity(0.99 * MM)[2], "")
        value, centre, reason = shifted.conicity(1.01 * MM)
        self.assertEqual(reason, OUT_OF_RANGE)
        self.assertTrue(math.isnan(value) and math.isnan(centre))

    def test_of_two_centres_it_depends_on_the_amplitude(self):
        # dr = k (y³ - w² y): S has two minima, at ±w, and a maximum in the middle. With amplitudes up to w / sqrt(2) there
        # is a wave about each minimum; above sqrt(2) w one about both.
        w = 3 * MM
        curve = curve_of(lambda y: 1000 * (y ** 3 - w ** 2 * y), 10 * MM, 2000)
        for factor, reason in ((0.65, SEVERAL_WAVES), (0.75, NO_WAVE), (1.38, NO_WAVE), (1.45, "")):
            self.assertEqual(curve.conicity(factor * w)[2], reason, factor)

    def test_misuse_is_refused(self):
        cones = curve_of(lambda y: 0.1 * y, 10 * MM, 4)
        for amplitude in (0, math.nan):
            with self.assertRaisesRegex(ValueError, "amplitude = .* must be a positive number"):
                cones.conicity(amplitude)
        with self.assertRaisesRegex(ValueError, "decreases"):
            RadiusDifference([(1, 0), (0, 1)])

    def test_wavelength_is_that_of_klingel(self):
        # Klingel (1883): 2 pi sqrt(r b / gamma) with half the distance b.
        self.assertAlmostEqual(kinematic_wavelength(0.025, 1.5, 0.46), 2 * math.pi * math.sqrt(0.46 * 0.75 / 0.025),
                               delta=1e-12)


class OfContactGeometry(unittest.TestCase):
    @staticmethod
    def curve(reach, step, config=(), roll=True):
        """Curve for y within ±reach in steps [mm]."""
        model = contact_model(config)
        return RadiusDifference(native().contact_geometry(model, -reach * MM, reach * MM, step * MM, roll, 0.0).curve)

    def test_of_cones_with_unequal_radii_it_is_their_slope(self):
        wheels = {"profile": "cone_1_20", "left": {"rolling_radius": 0.4604}, "right": {"rolling_radius": 0.46}}
        value, centre, reason = self.curve(5, 1, {"wheel": wheels}, roll=False).conicity(0.9 * MM)
        self.assertEqual(reason, "")
        self.assertAlmostEqual(value, 0.05, delta=1e-5)
        self.assertAlmostEqual(centre, -4 * MM, delta=1e-6)

    def test_of_the_mirror_image_it_is_the_same_about_the_mirrored_centre(self):
        one, other = (self.curve(6, 1, {"wheel": {a: {"rolling_radius": 0.461}, b: {"rolling_radius": 0.46}},
                                        "rail": {a: {"inclination": 0.05}, b: {"inclination": 0.025}}}).conicity(3 * MM)
                      for a, b in (("left", "right"), ("right", "left")))
        self.assertAlmostEqual(one[0], other[0], delta=1e-5)
        self.assertAlmostEqual(one[1], -other[1], delta=1e-7)
        self.assertGreater(abs(one[1]), 1e-4)

    def test_it_does_not_depend_on_the_step(self):
        # The step only sets the first points of the curve.
        coarse, fine = self.curve(8, 0.5), self.curve(8, 0.05)
        for amplitude in (1, 3, 5, 6.5):
            self.assertAlmostEqual(coarse.conicity(amplitude * MM)[0], fine.conicity(amplitude * MM)[0], delta=2e-4)

    def test_under_load_the_jump_on_the_tread_is_wide_and_cones_stay_cones(self):
        y, cones = np.linspace(-2, 2, 3) * MM, {"wheel": {"profile": "cone_1_20"}}
        light, loaded, of_cones = (RadiusDifference(loaded_points(configs, y, load, None)[1]).conicity(1 * MM)[0]
                                   for configs, load in (((), 10), ((), 100e3), ([cones], 100e3)))
        # The rigid contact jumps at 0.3 mm; straight lines between the steps of 0.1 mm spread this jump.
        self.assertAlmostEqual(light, self.curve(2, 0.1).conicity(1 * MM)[0], delta=2e-3)
        self.assertAlmostEqual(loaded, 0.171, delta=2e-3)  # measured by a user of the package
        self.assertAlmostEqual(of_cones, self.curve(2, 0.1, cones).conicity(1 * MM)[0], delta=5e-4)  # the tolerance of 1 %

    def test_wavelength_has_the_running_circles_of_the_wheelset(self):
        wheels = {"left": {"rolling_radius": 0.4604}, "right": {"rolling_radius": 0.46}}
        base, radius = running_circles({"wheel": wheels})
        self.assertAlmostEqual(base, 1.5, delta=1e-12)
        self.assertAlmostEqual(radius, 0.4602, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
