# SPDX-License-Identifier: BSD-3-Clause
"""The example in doc/tools.md runs all wheelsets of vehicle.launch on another machine."""
import pathlib
import re
import tempfile
import unittest

import roslaunch.config

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
