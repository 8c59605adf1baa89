# SPDX-License-Identifier: BSD-3-Clause
"""Bars with a closed-form compliance."""
import unittest

from rails import bar, needs_programs, solved

from wheel_rail_contact.rail_fe.study import Study
from wheel_rail_contact.rail_fe.supports import Pads

WIDTH, HEIGHT, LENGTH = 0.06, 0.12, 2.4  # [m]
YOUNG, POISSON = 2.1e11, 0.28
SHEAR = YOUNG / (2 * (1 + POISSON))
SHEAR_AREA = WIDTH * HEIGHT * 10 * (1 + POISSON) / (12 + 11 * POISSON)  # Cowper 1966, rectangle
TORSION = 0.2287 * HEIGHT * WIDTH**3  # de Saint-Venant, sides 2:1


def bar_study(kind, **more):
    # The head is the whole section: its motion is that of the section of the beam.
    return Study(bar(WIDTH, HEIGHT), kind, length=LENGTH, mesh_size=0.03, head_depth=HEIGHT, **more)


@needs_programs
class Bar(unittest.TestCase):
    def test_hinged_bar_deflects_vertically_like_a_timoshenko_beam(self):
        inertia = WIDTH * HEIGHT**3 / 12
        expected = LENGTH**3 / (48 * YOUNG * inertia) + LENGTH / (4 * SHEAR * SHEAR_AREA)
        for element_type in ("C3D20", "C3D10"):
            found = solved(bar_study("ends_hinged", element_type=element_type)).compliance["vertical_vertical"]
            # 0.5 %: beam theory does not include the local deformation of the loaded and of the supported sections
            self.assertAlmostEqual(found / expected, 1, delta=5e-3)

    def test_hinged_bar_twists_as_in_saint_venant_torsion(self):
        found = solved(bar_study("ends_hinged")).compliance["roll_roll"]
        expected = LENGTH / (4 * SHEAR * TORSION)
        # 1.5 %: symmetry prevents warping of the loaded section; this affects about one bar height
        self.assertAlmostEqual(found / expected, 1, delta=1.5e-2)

    def test_clamped_bar_bends_like_a_timoshenko_beam_in_both_directions(self):
        # Without lateral contraction: a clamped end prevents it, and beam theory does not include it.
        compliance = solved(bar_study("ends_clamped", poisson=0.0)).compliance
        lever = HEIGHT / 2 - 0.014  # height of the reference point above the axis: the lateral force also twists the bar
        sideways = compliance["lateral_lateral"] - lever**2 * compliance["roll_roll"]
        shear = LENGTH / (4 * YOUNG / 2 * WIDTH * HEIGHT * 10 / 12)
        for found, inertia in ((sideways, HEIGHT * WIDTH**3 / 12), (compliance["vertical_vertical"],
                                                                    WIDTH * HEIGHT**3 / 12)):
            # 0.5 %: discretisation; the difference is 0.1 % at half the mesh size
            self.assertAlmostEqual(found / (LENGTH**3 / (192 * YOUNG * inertia) + shear), 1, delta=5e-3)

    def test_stiff_bar_on_pads_has_the_compliance_of_the_springs(self):
        pads = Pads(lateral=4e7, vertical=1e8, roll=3e4, spacing=1.2, bays=2)
        study = bar_study("seats", pads=pads, young=1e6 * YOUNG, neighbours=(0.9,))
        solution = solved(study)
        reference = HEIGHT - 0.014
        for name, expected in (("lateral_lateral", 1 / 8e7 + reference**2 / 6e4), ("lateral_roll", reference / 6e4),
                               ("roll_roll", 1 / 6e4), ("vertical_vertical", 1 / 2e8)):
            # 1e-4: the bar is only about 1e5 times as stiff as the pads
            self.assertAlmostEqual(solution.compliance[name] / expected, 1, delta=1e-4, msg=name)
            self.assertAlmostEqual(solution.neighbours[0][name] / expected, 1, delta=1e-4, msg=name)
        self.assertLess(solution.asymmetry, 1e-4)

    def test_half_model_contains_half_of_a_seat_under_the_load(self):
        pads = Pads(lateral=4e7, vertical=1e8, spacing=0.8, bays=3)
        solution = solved(bar_study("seats", pads=pads, young=1e6 * YOUNG))
        self.assertAlmostEqual(solution.compliance["vertical_vertical"] * 3e8, 1, delta=1e-4)
