# SPDX-License-Identifier: BSD-3-Clause
"""Bars whose compliance has a closed form."""
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
    # the whole section counts as head, so that its motion is that of the beam's section
    return Study(bar(WIDTH, HEIGHT), kind, length=LENGTH, mesh_size=0.03, head_depth=HEIGHT, **more)


@needs_programs
class Bar(unittest.TestCase):
    def test_hinged_bar_sinks_like_a_timoshenko_beam(self):
        inertia = WIDTH * HEIGHT**3 / 12
        expected = LENGTH**3 / (48 * YOUNG * inertia) + LENGTH / (4 * SHEAR * SHEAR_AREA)
        for element_type in ("C3D20", "C3D10"):
            found = solved(bar_study("ends_hinged", element_type=element_type)).compliance["vertical_vertical"]
            # 0.5 %: local deformation of the loaded and of the held sections, which no beam knows
            self.assertAlmostEqual(found / expected, 1, delta=5e-3)

    def test_hinged_bar_twists_by_saint_venant(self):
        found = solved(bar_study("ends_hinged")).compliance["roll_roll"]
        expected = LENGTH / (4 * SHEAR * TORSION)
        # 1.5 %: warping is held by symmetry in the loaded section, over about a height of the bar
        self.assertAlmostEqual(found / expected, 1, delta=1.5e-2)

    def test_clamped_bar_bends_like_a_timoshenko_beam_both_ways(self):
        # without lateral contraction, because a clamped end holds it and a beam does not know it
        compliance = solved(bar_study("ends_clamped", poisson=0.0)).compliance
        lever = HEIGHT / 2 - 0.014  # of the reference point above the axis: the lateral force also twists the bar
        sideways = compliance["lateral_lateral"] - lever**2 * compliance["roll_roll"]
        shear = LENGTH / (4 * YOUNG / 2 * WIDTH * HEIGHT * 10 / 12)
        for found, inertia in ((sideways, HEIGHT * WIDTH**3 / 12), (compliance["vertical_vertical"],
                                                                    WIDTH * HEIGHT**3 / 12)):
            # 0.5 %: discretisation; the difference falls to 0.1 % at half the mesh size
            self.assertAlmostEqual(found / (LENGTH**3 / (192 * YOUNG * inertia) + shear), 1, delta=5e-3)

    def test_stiff_bar_on_pads_moves_as_the_springs_say(self):
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

    def test_seat_under_the_load_counts_half_in_the_half_model(self):
        pads = Pads(lateral=4e7, vertical=1e8, spacing=0.8, bays=3)
        solution = solved(bar_study("seats", pads=pads, young=1e6 * YOUNG))
        self.assertAlmostEqual(solution.compliance["vertical_vertical"] * 3e8, 1, delta=1e-4)


if __name__ == "__main__":
    unittest.main()
