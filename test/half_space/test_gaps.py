# SPDX-License-Identifier: BSD-3-Clause
"""Cells and gaps of a place, and the half-space models on them."""
import unittest

from wheel_rail_contact.command import Failure
from wheel_rail_contact.core.contact import WheelsetContact
from wheel_rail_contact.half_space import cases, gaps

LOAD = 60e3  # [N]
PROFILES = {"wheel": {"profile": "S1002"}, "rail": {"profile": "60E1"}}


def models(y):
    """Results of all models for the only contact at a position [m], and the OneWheel that carries the load."""
    contact = WheelsetContact(PROFILES)
    place = gaps.compute(contact, y, [LOAD], (20, 40))
    wheel = gaps.loaded_wheel(contact)
    gaps.solve(wheel, y, LOAD)
    return {name: found[0] for name, found in cases.solve(place, [])[0].models.items()}, wheel


class LoadedWheel(unittest.TestCase):
    def test_carries_the_load_and_has_the_ratio_and_the_model_error_of_the_result(self):
        contact = WheelsetContact([PROFILES, {"wheelset": {"free": []}}])
        wheel = gaps.loaded_wheel(contact)
        gaps.solve(wheel, 6.5e-3, LOAD)
        self.assertAlmostEqual(wheel.vertical_force / LOAD, 1, delta=1e-6)  # the load is held to rounding
        patch = contact.evaluate(y=6.5e-3, z=wheel.height).patches[0]
        # Both are the turn between the outer loaded columns: they differ by a cell of the coarser grid.
        self.assertAlmostEqual(wheel.contacts[0]["half_space_ratio"], patch.half_space_ratio, delta=0.02)
        self.assertAlmostEqual(wheel.figures[0] / patch.max_pressure, 1, delta=0.01)
        self.assertEqual(gaps.core.model_error(patch.half_space_ratio, True), patch.model_error)

    def test_without_contact_is_refused_with_the_position(self):
        with self.assertRaisesRegex(Failure, "y = 0.3 m"):
            gaps.compute(WheelsetContact(PROFILES), 0.3, [LOAD], (8, 12))


class Models(unittest.TestCase):
    def test_agree_on_the_tread_and_with_the_package(self):
        found, wheel = models(0.0)
        turned = found["turned"].max_pressure
        # The normals turn by 0.04 rad, whose square is 0.002. A plane has other cells, so the peak differs a little more.
        self.assertAlmostEqual(found["curved"].max_pressure / turned, 1, delta=0.002)
        self.assertAlmostEqual(found["planar"].max_pressure / turned, 1, delta=0.005)
        # The package computes the same on other cells, by another method. The pressure has a peak narrower than a cell here,
        # so only the area is compared; the flange root, below, has a wide peak.
        self.assertAlmostEqual(wheel.figures[1] / found["turned"].area, 1, delta=0.01)

    def test_one_plane_lowers_the_pressure_in_the_flange_root(self):
        found, wheel = models(6.6e-3)
        planar = found["planar"].max_pressure / found["turned"].max_pressure - 1
        self.assertLess(planar, -0.02)
        self.assertGreater(planar, -0.1)
        self.assertAlmostEqual(wheel.figures[0] / found["turned"].max_pressure, 1, delta=0.01)  # the package turns here, too

    def test_planar_gap_has_the_opening_and_the_depth_of_the_surface_at_its_plane(self):
        case = gaps.compute(WheelsetContact(PROFILES), 6.2e-3, [LOAD], (8, 12)).cases[0]
        touch = case.gaps[0].min(axis=0).argmin()
        deepest = case.gaps[0][0, touch]
        self.assertLess(deepest, 0)
        self.assertAlmostEqual(case.planar[0][0, touch], deepest, delta=-1e-9 * deepest)
        self.assertAlmostEqual(case.planar_up[0], case.up[0][touch], delta=2e-3)


class CellsOfContacts(unittest.TestCase):
    def test_cover_the_pressure_of_all_loads(self):
        loads, contact = (20e3, 120e3), WheelsetContact(PROFILES)
        place = gaps.compute(contact, 6.5e-3, loads, (8, 12))
        self.assertEqual(len(place.cells), 1)
        cells = place.cells[0]
        self.assertEqual((cells.rows, cells.columns, len(cells.arc)), (8, 12, 12))
        wheel = gaps.loaded_wheel(contact)
        for load in loads:
            gaps.solve(wheel, 6.5e-3, load)
            part = wheel.contacts[0]
            self.assertGreater(wheel.rail_arc(cells.rail[0], part["first_u"]), -0.5 * cells.dy)
            self.assertLess(wheel.rail_arc(cells.rail[-1], part["last_u"]), 0.5 * cells.dy)
            self.assertGreater(cells.rows * cells.dx, part["half_length"])

    def test_two_contacts_have_cells_of_the_same_length(self):
        place = gaps.compute(WheelsetContact([PROFILES, {"track": {"rail_inclination": 0.05}}]), 6e-3, [LOAD], (8, 12))
        first, second = place.cells
        self.assertEqual(first.dx, second.dx)
        self.assertLess(first.rail[-1], second.rail[0])
