# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the stress in contact_report: which patches they show, on which surfaces, and what replaces them."""
import subprocess
import sys
import unittest
from unittest import mock

import numpy as np
import rosbag
from sweep_case import PACKAGE, SWEEP, SweepCase
from wheel_rail_contact.message_constants import SIDES
from wheel_rail_contact.report import stress
from wheel_rail_contact.report.results import read, read_full

try:
    from wheel_rail_contact import WheelsetContact
except ImportError:
    WheelsetContact = None  # the module is optional in a build

PARAMETERS = f"""\
rail: {{profile: UIC60_manchester, right: {{profile: 60E1, inclination: 1:20}}}}
rail_bending: {{model: compliance, table: {PACKAGE / "config" / "rails" / "pads_40_100.yaml"}}}
material: {{rail: {{poisson: 0.3, yield: 5.0e+8}}}}
stress: {{depths: 8}}
"""
STEP = 20  # of the messages of the sweep that are replayed
WITHOUT_MODULE = """\
import sys
sys.modules["wheel_rail_contact._core"] = None
from wheel_rail_contact.report import results, stress
print(*stress.items(results.Results(), {0: 0}, {}, str, None), sep="\\n")
"""


def thinned(path):
    """Writes each 20th pair of the sweep to a bag."""
    with rosbag.Bag(str(SWEEP)) as sweep, rosbag.Bag(str(path), "w") as bag:
        stamps = sorted({message.header.stamp for _, message, _ in sweep.read_messages()})
        kept = set(stamps[::STEP])
        for topic, message, time in sweep.read_messages():
            if message.header.stamp in kept:
                bag.write(topic, message, time)
    return path


class StressPictures(SweepCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "stress.yaml").write_text(PARAMETERS)
        cls.states = cls.folder / "stress.yaml", thinned(cls.folder / "states.bag")
        cls.bag = cls.replay("results.bag", *cls.states)
        cls.results, cls.topic = read(str(cls.bag))

    @unittest.skipUnless(WheelsetContact, "needs the Python module")
    def test_each_wheel_has_a_picture_of_its_highest_stress(self):
        worst = stress.worst_patches(self.results)
        wanted = {int(self.results.patches["result"][patch]) for patch in worst.values()}
        drawn = []
        with mock.patch.object(stress, "save", side_effect=lambda figure, path: drawn.append(figure) or path):
            found = stress.items(self.results, worst, read_full(str(self.bag), self.topic, wanted), "result {}".format,
                                 self.folder)
        self.assertEqual(found, [self.folder / "stress_0.png", self.folder / "stress_1.png"])
        for side, (figure, patch) in enumerate(zip(drawn, worst.values())):
            title = figure.axes[0].get_title().splitlines()
            self.assertEqual(title[0], f"result {self.results.patches['result'][patch]}")
            self.assertIn(f"{SIDES[side]} wheel and rail", title[1])
            self.assertIn("ν = 0.28 and 0.3", title[2])

    def test_the_chosen_patches_are_the_worst_of_their_wheels_and_none_without_stress(self):
        (self.folder / "none.yaml").write_text("stress: {depths: 0}\n")
        results, _ = read(str(self.replay("none.bag", *self.states, "--config", self.folder / "none.yaml")))
        self.assertEqual(stress.worst_patches(results), {})
        worst = stress.worst_patches(self.results)
        self.assertEqual(set(worst), {0, 1})
        with rosbag.Bag(str(self.bag)) as bag:
            patches = [patch for _, message, _ in bag.read_messages() for patch in message.patches]
        for side, index in worst.items():
            highest = max(max(p.wheel_stress.von_mises.value, p.rail_stress.von_mises.value) for p in patches if p.side == side)
            chosen = patches[index]
            self.assertEqual((chosen.side, max(chosen.wheel_stress.von_mises.value, chosen.rail_stress.von_mises.value)),
                             (side, highest))

    @unittest.skipUnless(WheelsetContact, "needs the Python module")
    def test_surfaces_of_the_outlines_are_those_of_the_profiles(self):
        from wheel_rail_contact.core import stress_picture
        contact = WheelsetContact(self.folder / "stress.yaml")
        index = int(self.results.patches["result"][stress.worst_patches(self.results)[1]])
        message = read_full(str(self.bag), self.topic, {index})[index]
        result = contact.evaluate(y=message.wheelset.position.y, force_z=-2e5)
        first = int(np.searchsorted(self.results.patches["result"], index))
        for k, (patch, sent) in enumerate(zip(result.patches, message.patches)):
            side = SIDES.index(patch.side)
            of_bag = stress._surfaces(self.results, side, first + k, sent)(0.01)
            of_python = stress_picture._of_model(contact, patch)[0](0.01)
            for body, found in of_bag.items():
                expected = of_python[body]
                inside = abs(found.s) < 1.5 * patch.semi_axis_across
                height = np.interp(found.points[inside, 0], *expected.points.T)
                # The outlines of the bag are lines between points up to 0.5 mm apart, on arcs of down to 13 mm radius.
                np.testing.assert_allclose(found.points[inside, 1], height, atol=1e-5, err_msg=f"{patch.side} {body}")

    @unittest.skipUnless(WheelsetContact, "needs the Python module")
    def test_without_grids_a_sentence_replaces_each_picture(self):
        bag = str(self.replay("no_grids.bag", *self.states, "--no-grids"))
        results, topic = read(bag)
        worst = stress.worst_patches(results)
        messages = read_full(bag, topic, {int(results.patches["result"][patch]) for patch in worst.values()})
        found = stress.items(results, worst, messages, lambda index: "1.0 s", self.folder)
        self.assertEqual(found, [f"{side} wheel, 1.0 s: no picture of the stress (the bag contains no grids)"
                                 for side in SIDES])

    def test_without_the_module_a_sentence_gives_the_reason(self):
        printed = subprocess.run([sys.executable, "-c", WITHOUT_MODULE], check=True, stdout=subprocess.PIPE,
                                 universal_newlines=True).stdout
        self.assertRegex(printed, "^The pictures of the stress are left out: the Python module .* was not found.*\n$")

    @unittest.skipUnless(WheelsetContact, "needs the Python module")
    def test_poissons_ratios_are_those_of_the_replay(self):
        self.assertEqual(stress.poisson_ratios(self.results.parameters, "left"), {"wheel": 0.28, "rail": 0.3})
        self.assertEqual(stress.poisson_ratios("", "left"), {"wheel": 0.28, "rail": 0.28})
        one_side = "material/wheel/poisson: 0.3\nwheel/right/material/poisson: 0.4\n"
        self.assertEqual(stress.poisson_ratios(one_side, "left"), {"wheel": 0.3, "rail": 0.28})
        self.assertEqual(stress.poisson_ratios(one_side, "right"), {"wheel": 0.4, "rail": 0.28})
