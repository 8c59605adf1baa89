# SPDX-License-Identifier: BSD-3-Clause
"""The wheelsets of vehicle.launch: on another machine, as in doc/tools.md, and in one view."""
import pathlib
import re
import tempfile
import unittest

import roslaunch.config
from wheel_rail_contact.vehicle_view import view_of

TOOLS = pathlib.Path(__file__).resolve().parents[3] / "doc" / "tools.md"


class Machines(unittest.TestCase):
    def test_example_of_the_documentation_runs_every_wheelset_on_the_other_machine(self):
        example = next(code for code in re.findall(r"```xml\n(.*?)```", TOOLS.read_text(encoding="utf-8"), re.DOTALL)
                       if "<machine" in code)
        with tempfile.TemporaryDirectory() as folder:
            launch = pathlib.Path(folder) / "two_machines.launch"
            launch.write_text(example)
            config = roslaunch.config.load_config_default([str(launch)], 11311)
        nodes = {node.namespace + node.name: node.machine.address for node in config.nodes}
        self.assertEqual(nodes, {"/contact_node": "192.168.1.2"})
        self.assertEqual(config.params["/contact_node/wheelsets"].value, [f"wheelset_{i}" for i in (1, 2, 3, 4)])

    def test_view_has_every_wheelset_at_its_place_with_a_panel_of_its_own(self):
        displays = view_of(["a", "b", "c", "d", "e"], [10, 8, 6, 2, 0], "/train/node")["Visualization Manager"]["Displays"]
        self.assertEqual([display["Topic"] for display in displays], [f"/train/{name}/node/contact" for name in "abcde"])
        self.assertEqual([display["Follow Wheelset"]["Place"] for display in displays], [5, 3, 1, -3, -5])
        self.assertEqual(len({(display["Panel"]["Left"], display["Panel"]["Top"]) for display in displays}), 5)
