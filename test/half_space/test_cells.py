# SPDX-License-Identifier: BSD-3-Clause
"""Half-spaces, contact and correction on cells, without a program."""
import unittest

import numpy as np

from wheel_rail_contact.command import Failure
from wheel_rail_contact.half_space import normal_contact
from wheel_rail_contact.half_space.correction import Correction
from wheel_rail_contact.half_space.half_space import influence
from wheel_rail_contact.half_space.gaps import Cells

MODULUS = 1.15e11  # [Pa]


def cells(rows=10, columns=20, side=0.5e-3, turn=0.0, place=(0.0, 0.0)):
    """Cells on a section whose tangent turns by `turn` [rad] from the first column to the last one."""
    arc = (np.arange(columns) - 0.5 * (columns - 1)) * side
    section = np.column_stack([arc + place[0], np.full(columns, place[1])])
    return Cells(rows, columns, side, side, arc, arc, section, np.linspace(0.5 * turn, -0.5 * turn, columns), section)


class HalfSpace(unittest.TestCase):
    def test_mean_displacement_of_a_loaded_square_is_that_of_the_closed_form(self):
        one = cells(1, 1, 1e-3)
        own = 1e-3 * 4 * (np.log(1 + np.sqrt(2)) + (1 - np.sqrt(2)) / 3)  # mean over the square of Love's displacement
        image = 1e-3 * 1.1126  # mean inverse distance of two unit squares side by side, by numerical integration
        matrix = influence([one], MODULUS, turned=False)
        # The midpoint rule of four parts is right within 2 %.
        self.assertAlmostEqual(float(matrix[0, 0]) * np.pi * MODULUS / (own + image), 1, delta=0.02)

    def test_distant_cells_act_as_point_forces(self):
        one = cells(1, 30)
        matrix = influence([one], MODULUS, turned=False)
        point = one.dx * one.dy * 2 / (np.pi * MODULUS * (29 * one.dy))
        self.assertAlmostEqual(float(matrix[0, -1]) / point, 1, delta=1e-3)

    def test_contacts_apart_act_as_one_contact_with_both_would(self):
        whole = cells(6, 12)
        left, right = cells(6, 6, place=(-1.5e-3, 0)), cells(6, 6, place=(1.5e-3, 0))
        apart = influence([left, right], MODULUS, turned=False)
        together = influence([whole], MODULUS, turned=False)
        # Cells of the outer columns are eight or more cells apart: the point force is right within (1/8)^2 / 12.
        self.assertLess(np.abs(apart[:12, -12:] / together[:12, -12:] - 1).max(), 2e-3)

    def test_turned_normals_project_the_displacement(self):
        flat, turned = (influence([cells(turn=0.6)], MODULUS, turned=flag) for flag in (False, True))
        self.assertAlmostEqual(float(turned[0, -1] / flat[0, -1]), np.cos(0.6), places=12)
        self.assertEqual(turned[0, 0], flat[0, 0])


class NormalContact(unittest.TestCase):
    RADIUS, FORCE = 0.3, 20e3  # of a sphere [m]; [N]

    def hertz(self):
        """Half-width [m] and highest pressure [Pa] (Johnson 1985, eq. 4.22, 4.24)."""
        half_width = (0.75 * self.FORCE * self.RADIUS / MODULUS)**(1 / 3)
        return half_width, 1.5 * self.FORCE / (np.pi * half_width**2)

    def solved(self):
        half_width, _ = self.hertz()
        one = cells(14, 28, 1.2 * half_width / 14)
        x, arc = np.tile(one.x, one.columns), np.repeat(one.arc, one.rows)
        areas = np.full(len(x), 2 * one.dx * one.dy)
        contact = normal_contact.solve(influence([one], MODULUS, turned=False), (x**2 + arc**2) / (2 * self.RADIUS),
                                       np.ones((len(x), 1)), [self.FORCE], areas)
        return one, contact, areas

    def test_sphere_has_the_pressure_and_the_area_of_hertz(self):
        half_width, highest = self.hertz()
        one, contact, areas = self.solved()
        pressure = contact.pressure.reshape(one.columns, one.rows).T
        self.assertAlmostEqual(float(contact.pressure @ areas) / self.FORCE, 1, places=9)
        # 12 cells on a half-width: errors of the order of (1/12)^2.
        self.assertAlmostEqual(normal_contact.highest(pressure) / highest, 1, delta=0.01)
        self.assertAlmostEqual(normal_contact.area(pressure, one.dx, one.dy) / (np.pi * half_width**2), 1, delta=0.02)

    def test_loaded_cells_touch_and_others_are_apart(self):
        one, contact, _ = self.solved()
        x, arc = np.tile(one.x, one.columns), np.repeat(one.arc, one.rows)
        distance = (influence([one], MODULUS, turned=False) @ contact.pressure + (x**2 + arc**2) / (2 * self.RADIUS)
                    + contact.motion[0])
        loaded = contact.pressure > 0
        self.assertLess(np.abs(distance[loaded]).max(), 1e-12)
        self.assertGreater(distance[~loaded].min(), 0)

    def test_a_force_that_pulls_is_refused(self):
        matrix = influence([cells(3, 6)], MODULUS, turned=False)
        with self.assertRaises(Failure):
            normal_contact.solve(matrix, np.linspace(0, 1e-6, 18), np.ones((18, 1)), [-1.0], np.full(18, 1e-6))


class CorrectionOfCells(unittest.TestCase):
    @staticmethod
    def smooth(one):
        """A displacement as that of a finite body: no singular part [m/N]."""
        x, arc = np.tile(one.x, one.columns), np.repeat(one.arc, one.rows)
        return 1e-10 * (1 + 20 * (arc[:, None] + arc) - 3e4 * (x[:, None]**2 + x**2) + 2e4 * arc[:, None] * arc)

    def test_errors_of_elements_beside_a_force_are_replaced(self):
        one = cells(10, 16)
        true = self.smooth(one)
        disturbed = true - 1e-9 * np.eye(len(true))
        found = Correction([one], disturbed)
        self.assertLess(np.abs(found.on([one]) - true).max(), 1e-14)

    def test_correction_is_the_same_function_on_finer_cells(self):
        coarse, fine = cells(10, 16, 0.6e-3), cells(20, 32, 0.3e-3)
        found = Correction([coarse], self.smooth(coarse))
        self.assertLess(np.abs(found.on([fine]) - self.smooth(fine)).max(), 1e-14)
