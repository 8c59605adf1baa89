# SPDX-License-Identifier: BSD-3-Clause
"""Creep forces of ellipses: signs, limits and misuse. Their accuracy is tested in C++."""
import unittest

import numpy as np
import wheel_rail_contact as package

LIMIT = 3e4  # [N]
METHODS = ("linear", "fastsim", "exact")


def force(creepage, method="exact", **others):
    arguments = {"semi_axes": (6e-3, 4e-3), "normal_force": 1e5, "cells": (24, 24), **others}
    return np.array(package.ellipse_creep_force(creepage=creepage, method=method, **arguments))


class CreepForces(unittest.TestCase):
    def test_friction_opposes_each_creepage(self):
        for method in METHODS:
            for place, creepage in enumerate(np.diag([5e-4, 5e-4, 0.1])):
                self.assertLess(force(creepage, method)[place], 0, (method, place))
            self.assertLess(force((0, 0, 0.1), method)[1], 0)  # spin to the left pushes the wheel to the right

    def test_small_creepages_have_the_forces_of_the_linear_theory(self):
        c11, c22, c23, c33 = package.kalker_coefficients(1.5)
        c, shear = np.sqrt(24e-6), 2.1e11 / 2.56  # [m], [Pa]
        slope = -shear * np.array([[c**2 * c11, 0, 0], [0, c**2 * c22, c**3 * c23], [0, -c**3 * c23, c**4 * c33]])
        for method, tolerance in (("linear", 1e-3), ("exact", 0.03)):
            for creepage in np.diag([1e-6, 1e-6, 1e-3]):
                expected = slope @ creepage
                np.testing.assert_allclose(force(creepage, method, cells=(48, 48)) / [1, 1, c], expected / [1, 1, c],
                                           atol=tolerance * max(abs(expected / [1, 1, c])), err_msg=method)

    def test_large_creepage_has_the_force_of_the_friction_limit(self):
        for method in METHODS:
            # In the simplified theory the traction of full sliding is turned against the slip, unless this is along x.
            np.testing.assert_allclose(force((0.05, 0, 0), method)[:2], [-LIMIT, 0], atol=1e-3 * LIMIT, err_msg=method)
        np.testing.assert_allclose(force((0.03, 0.04, 0))[:2], [-0.6 * LIMIT, -0.8 * LIMIT], atol=1e-3 * LIMIT)
        np.testing.assert_allclose(force((0.05, 0, 0), friction=0.1)[0], -LIMIT / 3, rtol=1e-3)

    def test_mirrored_creepages_have_mirrored_forces_within_the_tolerance_of_the_sweeps(self):
        for method in METHODS:
            one = force((5e-4, 3e-4, 0.2), method)
            np.testing.assert_allclose(force((5e-4, -3e-4, -0.2), method), one * [1, -1, -1], rtol=0.01, err_msg=method)
            np.testing.assert_allclose(force((-5e-4, 3e-4, 0.2), method), one * [-1, 1, 1], rtol=0.01, err_msg=method)

    def test_cells_are_48_by_48_and_the_materials_those_of_the_node(self):
        creepage = (5e-4, 3e-4, 0.2)
        expected = force(creepage, cells=(48, 48), friction=0.3, young=2.1e11, poisson=0.28)
        np.testing.assert_array_equal(force(creepage, cells=None), expected)
        np.testing.assert_allclose(force(creepage, young=4.2e11), force(2 * np.array(creepage)), rtol=1e-9)
        np.testing.assert_array_equal(force(creepage, "none"), [0, 0, 0])

    def test_misuse_is_refused_with_name_value_and_rule(self):
        for error, message, others in (
                (ValueError, r"^semi_axis_across = -0\.004000 must be", {"semi_axes": (6e-3, -4e-3)}),
                (ValueError, r"^semi_axes: has the shape \(3,\), but must be an array \(2,\)", {"semi_axes": (1, 1, 1)}),
                (TypeError, "^semi_axes = 'a': must be", {"semi_axes": "a"}),
                (ValueError, r"^normal_force = 0\.0+ must be", {"normal_force": 0}),
                (TypeError, "^friction = 'dry': must be a number", {"friction": "dry"}),
                (ValueError, "^friction = 2.1", {"friction": 2.1}),
                (ValueError, "^young = -1", {"young": -1}), (ValueError, "^poisson = 0.6", {"poisson": 0.6}),
                (ValueError, "^nx = 0", {"cells": (0, 24)}), (TypeError, "^cells = .*integers", {"cells": (24.5, 24)}),
                (ValueError, "^method = 'fast': must be one of none, linear", {"method": "fast"}),
                (ValueError, "^creepage = .*nan.*: must be finite", {"creepage": (0, float("nan"), 0)})):
            with self.subTest(others=others), self.assertRaisesRegex(error, message):
                force(**{"creepage": (0, 0, 0), **others})

    def test_coefficients_are_those_of_the_table_for_numbers_and_arrays(self):
        np.testing.assert_allclose(package.kalker_coefficients(1, 0.25), [4.12, 3.67, 1.47, 1.19], rtol=1e-12)
        many = package.kalker_coefficients([[0.2], [1.5]])
        self.assertEqual(many.shape, (4, 2, 1))
        np.testing.assert_array_equal(many[:, 1, 0], package.kalker_coefficients(1.5))
        with self.assertRaisesRegex(ValueError, "ratio of the semi-axes = 0"):
            package.kalker_coefficients([1, 0])
