# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay with neighbouring wheelsets, whose forces are read from their results in the bag."""

import math
import pathlib

import yaml
from std_msgs.msg import Header
from wheel_rail_contact.msg import RailDisplacements, WheelsetContact

from replay_case import MISUSED, RESULTS, ReplayCase, pairs, stamp

PAIRS = 30
INCLINATION = 0.025
TABLE = yaml.safe_load((pathlib.Path(__file__).parents[2] / "config" / "rails" / "pads_10_25.yaml").read_text())
SOFT = "rail_bending: {model: compliance, table: config/rails/pads_10_25.yaml}\n"
BEHIND = ("rail_bending: {model: compliance, table: config/rails/pads_10_25.yaml,"
          " neighbours: [{topic: /front/contact_node/contact, distance: 2.5}]}\n")


def deflection(compliance, rail):
    """Deflection (lateral, vertical, roll) due to the forces of a RailDeflection, track axes."""
    c, s = math.cos(INCLINATION), math.sin(INCLINATION)
    lateral_force = c * rail.lateral_force - s * rail.vertical_force
    axial_force = s * rail.lateral_force + c * rail.vertical_force
    lateral = compliance["lateral_lateral"] * lateral_force + compliance["lateral_roll"] * rail.moment
    axial = -compliance["vertical_vertical"] * axial_force
    roll = compliance["lateral_roll"] * lateral_force + compliance["roll_roll"] * rail.moment
    return c * lateral - s * axial, s * lateral + c * axial, roll


def offset(rail):
    """Part (lateral, vertical, roll) of the deflection that is not due to the forces of this wheelset."""
    own = deflection(TABLE, rail)
    return rail.lateral - own[0], rail.vertical - own[1], rail.roll - own[2]


class Neighbours(ReplayCase):
    def setUp(self):
        super().setUp()
        self.soft, self.behind = self.config(SOFT, "soft.yaml"), self.config(BEHIND, "behind.yaml")
        self.bag = self.write_bag([*pairs(range(PAIRS), "/front/wheelset"), *pairs(range(PAIRS), "/behind/wheelset")])

    def results_of_both(self):
        """Results of the front wheelset and of the one behind it, which reads the former, and what the second replay prints."""
        both, _ = self.replay(self.bag, "both.bag", "--config", self.soft, "--wheelset", "front", "--no-grids", "--keep-topics")
        out, printed = self.replay(both, "out.bag", "--config", self.behind, "--wheelset", "behind", "--no-grids")
        front, behind = self.results(both, "/front" + RESULTS), self.results(out, "/behind" + RESULTS)
        self.assertEqual(len(behind), PAIRS)
        for result in behind[1:]:
            self.assertEqual(result.status, WheelsetContact.OK, result.status_text)
        return front, behind, printed

    def test_forces_of_the_previous_step_of_the_neighbour_deflect_the_rails(self):
        front, behind, printed = self.results_of_both()
        self.assertIn("/behind/contact_node/contact: 1 results lack a neighbour's forces", printed)
        influence = TABLE["neighbours"][1]
        self.assertEqual(influence["distance"], 2.5)
        # Deflection and forces of a result agree with the table except for rounding: 1e-6 of some millimetres.
        self.assertEqual([result.status_text for result in behind[:2]],
                         ["forces of a neighbour are unknown, and taken as zero", ""])
        for found in offset(behind[0].left_rail):
            self.assertAlmostEqual(found, 0, delta=2e-9, msg="the first result has no earlier result of the neighbour")
        for before, result in zip(front, behind[1:]):
            for side in "left_rail", "right_rail":
                expected = deflection(influence, getattr(before, side))
                self.assertGreater(max(map(abs, expected)), 1e-5)
                for a, b in zip(offset(getattr(result, side)), expected):
                    self.assertAlmostEqual(a, b, delta=2e-9)

    def test_given_displacements_are_added_to_those_by_the_neighbour(self):
        given = {"left_rail": (4e-4, -1e-4, 5e-4), "right_rail": (-3e-4, 2e-4, -6e-4)}
        message = RailDisplacements()
        for rail, values in zip((message.left, message.right), given.values()):
            rail.lateral, rail.vertical, rail.roll = values
        messages = [RailDisplacements(Header(stamp=stamp(i)), message.left, message.right) for i in range(PAIRS)]
        self.write_bag([("/behind/wheelset/rail_displacement", one, one.header.stamp) for one in messages], self.bag.name, "a")
        self.behind.write_text(BEHIND + "track: {displacement: topic}\n")
        front, behind, _ = self.results_of_both()
        for before, result in zip(front, behind[1:]):
            for side, values in given.items():
                rail = getattr(result, side)
                by_neighbour = deflection(TABLE["neighbours"][1], getattr(before, side))
                whole = [a + b for a, b in zip(values, by_neighbour)]
                for a, b in zip((rail.given_lateral, rail.given_vertical, rail.given_roll), whole):
                    self.assertAlmostEqual(a, b, delta=1e-12)
                for a, b in zip(offset(rail), whole):
                    self.assertAlmostEqual(a, b, delta=2e-9)

    def test_neighbour_without_results_in_the_bag_is_reported_by_name(self):
        _, text = self.replay(self.bag, "out.bag", "--config", self.behind, "--wheelset", "behind", status=1)
        self.assertIn("/front/contact_node/contact", text)
        self.assertIn("wheel_rail_contact/WheelsetContact: none", text)

    def test_neighbour_evaluated_in_the_same_run_is_refused(self):
        _, text = self.replay(self.bag, "out.bag", "--config", self.behind, "--wheelset", "front", "behind", status=MISUSED)
        self.assertIn("is a result of this same run", text)
