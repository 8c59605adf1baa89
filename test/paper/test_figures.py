# SPDX-License-Identifier: BSD-3-Clause
"""The case of the paper: its parameters, one wheel alone, placements and methods."""
import unittest

import numpy as np

from wheel_rail_contact.core.one_wheel import OneWheel, roll_to_balance
from wheel_rail_contact.paper import methods, placement
from wheel_rail_contact.paper.case import (DISPLACEMENT, INCLINATION, LATERAL_FORCE, LOAD, POSITION, PRINTED_WITHOUT,
                                           REFERENCE_DEPTH, TURN, contact, crown_displaced, deviation)
from wheel_rail_contact.paper.forces import Rail
from wheel_rail_contact.paper.stress import POISSON, YOUNG

CELLS = (32, 64)


def level_figures(*crown):
    """Figures of the wheel that runs towards its flange, at roll 0, with the crown of the rail displaced."""
    wheel = OneWheel(contact(), CELLS)
    wheel.set_rail(INCLINATION, *crown_displaced(*crown))
    assert wheel.solve(POSITION, 0.0, LOAD)
    return wheel.figures


class Parameters(unittest.TestCase):
    def test_describe_the_case_of_the_paper(self):
        described = contact()
        self.assertEqual((described.wheel_profiles[0].name, described.rail_profiles[0].name), ("S1002", "UIC60_manchester"))
        for name, value in (("wheelset/rolling_radius", 0.46), ("wheelset/flange_back_distance", 1.36), ("track/gauge", 1.435),
                            ("track/rail_inclination", INCLINATION), ("material/wheel/young", YOUNG),
                            ("material/rail/young", YOUNG), ("material/rail/poisson", POISSON),
                            ("rail_bending/lateral_force", LATERAL_FORCE)):
            self.assertEqual(float(described.config[name]), value, name)
        self.assertEqual(described.config["rail_bending/model"], "compliance")

    def test_rail_deflects_as_printed(self):
        # 0.2435 mm at the top under 30 kN at a height of 162.4 mm, 4.4 mm above the reference point. Tolerance 1 %: accuracy
        # required of the finite elements. The rail head is rigid here.
        moved = Rail("paper").table.displacement(LATERAL_FORCE, 0.0, LATERAL_FORCE * (0.1624 - 0.158))
        self.assertAlmostEqual((moved.lateral + moved.roll * REFERENCE_DEPTH) / DISPLACEMENT, 1, delta=0.01)


class Figures(unittest.TestCase):
    def test_agree_with_the_reference_program(self):
        # The program CONTACT (Vollebregt and Kalker, version of July 2025) at roll 0. Its own error with a grid of 0.2 mm is
        # up to 0.7 % in max pressure and 2.5 % in area.
        for crown, max_pressure, area in (((0.0, 0.0, 0.0), 1175.0e6, 187.2e-6), ((DISPLACEMENT, 0.0, 0.0), 1097e6, 190e-6),
                                          ((-DISPLACEMENT, 0.0, 0.0), 1246e6, 183e-6),
                                          ((DISPLACEMENT, 0.0, 2e-3), 1263e6, 179e-6),
                                          ((DISPLACEMENT, 0.0, TURN), 1347e6, 129.6e-6)):
            found = level_figures(*crown)
            self.assertAlmostEqual(found[0] / max_pressure, 1, delta=0.01, msg=str(crown))
            self.assertAlmostEqual(found[1] / area, 1, delta=0.02, msg=str(crown))

    def test_without_bending_agree_with_the_printed_ones(self):
        self.assertLess(deviation(level_figures(0.0, 0.0, 0.0), PRINTED_WITHOUT), 0.02)

    def test_printed_iteration_is_near_the_accurate_result(self):
        # Error of the method of the paper: point forces on squares of 0.5 to 1 mm, stopped at a change of 1e-3 or less. The
        # limits are 4 % in pressure and 2 % in area (found: 3 % and 1.5 %). Counting whole cells gives a larger area.
        rows = methods.compare((0.0, 0.0, 0.0))
        compared = [row for row in rows
                    if row["method"] == "seidel_printed" and row["cells_across"] >= 24 and row["stop"] <= 1e-3]
        self.assertEqual(len(compared), 3)
        for row in compared:
            self.assertAlmostEqual(row["max_pressure"] / rows[0]["max_pressure"], 1, delta=0.04)
            self.assertAlmostEqual(row["area"] / rows[0]["area"], 1, delta=0.02)
            self.assertGreater(row["counted_area"], row["area"])
            self.assertAlmostEqual(row["cell_along"] / row["cell_across"], 1, delta=0.1)


class Wheel(unittest.TestCase):
    def place(self, wheel):
        """Place of the crown (n = 2) [m], and angle of the rail [rad]."""
        ends = np.array([0.02, 0.05])
        profile = np.column_stack(contact().rail_profiles[0].at(ends))
        placed = wheel.rail_at(ends)[:, :2]
        (y, z), (own_y, own_z) = placed[1] - placed[0], profile[1] - profile[0]
        angle = np.arctan2(z, y) - np.arctan2(own_z, own_y)
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        return placed[0] - turn @ profile[0], angle

    def test_crown_of_the_rail_is_displaced_and_the_rail_turned(self):
        wheel = OneWheel(contact(), CELLS)
        crown, angle = self.place(wheel)
        wheel.set_rail(INCLINATION, *crown_displaced(0.3e-3, -0.1e-3, 9e-3))
        moved, turned = self.place(wheel)
        np.testing.assert_allclose(moved - crown, [0.3e-3, -0.1e-3], atol=1e-12)
        self.assertAlmostEqual(turned - angle, -9e-3, delta=1e-12)

    def test_two_of_them_balance_like_the_wheelset(self):
        # The balance of the wheelset allows a roll error of 3e-4 rad per unit of the tolerance.
        rigid = contact({"rail_bending": {"model": "none"}})
        tolerance = float(rigid.config["contact/tolerance"])
        first, second = OneWheel(rigid, CELLS), OneWheel(rigid, CELLS)
        roll = roll_to_balance(first, second, 2e-3, LOAD)
        result = rigid.evaluate(y=2e-3, force_z=-2 * LOAD)
        self.assertEqual(result.status, "OK", result.status_text)
        self.assertAlmostEqual(roll, result.wheelset.roll, delta=3e-4 * tolerance)
        self.assertAlmostEqual(first.height, result.wheelset.position.z, delta=0.2e-6)
        self.assertAlmostEqual(first.figures[0] / result.patches[0].max_pressure, 1, delta=2 * tolerance)

    def test_without_contact_there_is_no_solution(self):
        wheel = OneWheel(contact(), CELLS)
        self.assertFalse(wheel.solve(0.3, 0.0, LOAD))
        self.assertIsNone(roll_to_balance(wheel, OneWheel(contact(), CELLS), 0.3, LOAD))

    def test_unknown_method_is_refused(self):
        with self.assertRaisesRegex(ValueError, "method = 'hertz'"):
            OneWheel(contact(), CELLS, method="hertz")


class Placement(unittest.TestCase):
    def test_first_touch_lies_on_both_outlines(self):
        solved = placement.solve(placement.CASES[0])
        for outline in (solved.rail, solved.wheel):
            # The points are 0.2 mm apart.
            self.assertLess(np.hypot(*(outline - solved.touch).T).min(), 0.5 * 2.1e-4)
