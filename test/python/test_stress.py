# SPDX-License-Identifier: BSD-3-Clause
"""Stresses beneath patches, and numbers of stresses, as arrays."""
import unittest

import numpy as np
import wheel_rail_contact as package
from wheel_rail_contact.msg import ContactPatch, PressureGrid

STRESS = {"stress": {"depths": 8, "field": True}, "contact": {"grid": {"along": 16, "across": 16}},
          "material": {"rail": {"poisson": 0.3, "yield": 5e8}}}
CELL = ContactPatch(grid=PressureGrid(nx=1, ny=1, dx=2e-3, dy=6e-3, pressure=[1e9]))


def normal_stress(a, b, z):
    """Stress zz at the depth z below the centre of a rectangle 2 a by 2 b with unit pressure (Love 1929)."""
    r = np.sqrt(a**2 + b**2 + z**2)
    return -2 / np.pi * (np.arctan(a * b / (z * r)) + a * b * z / r * (1 / (a**2 + z**2) + 1 / (b**2 + z**2)))


class StressAt(unittest.TestCase):
    def test_the_stress_below_a_loaded_rectangle_is_that_of_the_closed_form(self):
        depth = np.array([1e-4, 1e-3, 4e-3])
        stress = package.stress_at(CELL, 0, 0, depth)
        self.assertEqual(stress.shape, (3, 6))
        np.testing.assert_allclose(stress[:, 2], 1e9 * normal_stress(1e-3, 3e-3, depth), rtol=1e-10)
        np.testing.assert_allclose(stress[:, 3:], 0, atol=1)  # by symmetry [Pa]

    def test_points_and_depths_broadcast(self):
        x, depth = np.array([0, 1e-3]), np.array([1e-3, 2e-3, 3e-3])
        stress = package.stress_at(CELL, x[:, None], 1e-3, depth)
        self.assertEqual(stress.shape, (2, 3, 6))
        np.testing.assert_array_equal(stress[1, 2], package.stress_at(CELL, x[1], 1e-3, depth[2]))

    def test_the_shear_stress_pushes_material_away_from_the_axis(self):
        # Tension positive, z into the body: at x > 0 the cell presses material below it along +x.
        stress = package.stress_at(CELL, [-1e-3, 1e-3], 0, 1e-3)
        self.assertGreater(stress[0, 4], 1e7)
        np.testing.assert_allclose(stress[1, 4], -stress[0, 4], rtol=1e-10)

    def test_layers_are_the_stress_below_the_centres_of_the_cells(self):
        pressure = np.arange(12.0).reshape(3, 4)  # [ix, iy]
        patch = ContactPatch(grid=PressureGrid(nx=3, ny=4, dx=1e-3, dy=2e-3, x0=-1e-3, y0=-3e-3, pressure=pressure.T.ravel()))
        layers = package.stress_layers(patch, [0.5e-3, 2e-3], poisson=0.3)
        self.assertEqual(layers.shape, (2, 6, 3, 4))
        expected = package.stress_at(patch, 0, 1e-3, [0.5e-3, 2e-3], poisson=0.3)
        np.testing.assert_allclose(layers[:, :, 1, 2], expected, atol=1e-9 * abs(layers).max())

    def test_misuse_is_refused(self):
        for message, arguments in ((r"depth = -0\.001000 must be", (CELL, 0, 0, -1e-3)),
                                   (r"^poisson = 0\.6", (CELL, 0, 0, 1e-3, 0.6)),
                                   ("grid: has 0 values", (ContactPatch(), 0, 0, 1e-3))):
            with self.assertRaisesRegex(ValueError, message):
                package.stress_at(*arguments)


class Numbers(unittest.TestCase):
    def test_tension_and_shear_have_their_known_numbers(self):
        stress = np.zeros((2, 1, 6))
        stress[0, 0, 1], stress[1, 0, 5] = 3e8, 2e8  # tension along y; shear xy
        np.testing.assert_allclose(package.von_mises(stress), [[3e8], [2e8 * np.sqrt(3)]])
        np.testing.assert_allclose(package.max_shear(stress), [[1.5e8], [2e8]])
        np.testing.assert_allclose(package.principal_stresses(stress), [[[3e8, 0, 0]], [[2e8, 0, -2e8]]], atol=10)

    def test_strain_is_that_of_hookes_law(self):
        stress = [[2.1e8, 0, 0, 0, 0, 0], [0, 0, 0, 2.1e8, 0, 0]]
        np.testing.assert_allclose(package.strain(stress, young=2.1e11, poisson=0.25),
                                   [[1e-3, -0.25e-3, -0.25e-3, 0, 0, 0], [0, 0, 0, 1.25e-3, 0, 0]], atol=1e-12)

    def test_misuse_is_refused(self):
        for function in (package.von_mises, package.max_shear, package.principal_stresses):
            with self.assertRaisesRegex(ValueError, r"shape \(2, 5\), but its last dimension must be 6: xx, yy"):
                function(np.zeros((2, 5)))
        with self.assertRaisesRegex(ValueError, "young = -1"):
            package.strain(np.zeros(6), young=-1, poisson=0.3)


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.patch = package.WheelsetContact(STRESS).evaluate(y=2e-3, force_z=-2e5).patches[0]

    def test_the_peak_is_the_stress_at_its_place(self):
        for stress, poisson in ((self.patch.wheel_stress, 0.28), (self.patch.rail_stress, 0.3)):
            for peak, number in ((stress.von_mises, package.von_mises), (stress.shear, package.max_shear)):
                there = number(package.stress_at(self.patch, peak.x, peak.y, peak.depth, poisson))
                # The peak is found between depths; its pressure is smoother than that of the cells.
                self.assertAlmostEqual(there / peak.value, 1, delta=0.03)

    def test_the_field_is_that_of_the_layers(self):
        stress = self.patch.rail_stress
        self.assertEqual(stress.depths.shape, (8,))
        self.assertEqual(stress.field.shape, (8, 6, *self.patch.pressure.shape))
        np.testing.assert_allclose(stress.field, package.stress_layers(self.patch, stress.depths, 0.3),
                                   atol=1e-6 * abs(stress.field).max())

    def test_only_a_body_with_a_yield_stress_has_a_load_factor(self):
        self.assertEqual(self.patch.wheel_stress.load_factor, 0)
        self.assertAlmostEqual(self.patch.rail_stress.load_factor, self.patch.max_pressure / (5e8 / np.sqrt(3)), places=9)
        self.assertGreater(self.patch.rail_stress.shakedown_limit, 3)

    def test_without_depths_all_numbers_are_zero(self):
        stress = package.WheelsetContact().evaluate(force_z=-2e5).patches[0].rail_stress
        self.assertEqual((stress.von_mises.value, stress.shear.value, stress.load_factor, stress.shakedown_limit), (0, 0, 0, 0))
        self.assertEqual((stress.depths.shape, stress.field.shape), ((0,), (0, 6, 0, 0)))
