# SPDX-License-Identifier: BSD-3-Clause
"""static_start: height and roll under a load, whatever wheelset/free is, and refused options."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

NOT_USABLE = 4  # exit status
LOAD_ERROR = 1  # of a wheel [N]: it is solved under its load, which the balance leaves open by less than 1e-5


class StaticStart(unittest.TestCase):
    def run_command(self, *arguments, status=0):
        """@return output of the command, and its lines as a dictionary: the text after the first word by this word"""
        run = subprocess.run([sys.executable, os.environ["STATIC_START"], *arguments], capture_output=True, text=True,
                             check=False)
        self.assertEqual(run.returncode, status, run.stdout + run.stderr)
        return run.stdout + run.stderr, dict(line.split(" ", 1) for line in run.stdout.splitlines())

    def values(self, *arguments):
        _, lines = self.run_command(*arguments)
        self.assertEqual(lines.pop("status"), "OK")
        return {name: float(text.split()[0]) for name, text in lines.items()}

    def test_loads_of_the_wheels_are_those_of_force_and_moment(self):
        values = self.values("--load", "200e3", "--torque", "-10e3")
        # Half the distance of the running circles is 0.75 m.
        self.assertAlmostEqual(values["left_vertical_force"], 100e3 + 10e3 / 1.5, delta=LOAD_ERROR)
        self.assertAlmostEqual(values["right_vertical_force"], 100e3 - 10e3 / 1.5, delta=LOAD_ERROR)
        self.assertLess(values["roll"], -1e-6, "the right wheel is unloaded, and therefore higher")

    def test_wheelset_sinks_under_a_higher_load(self):
        low, high = (self.values("--load", load)["z"] for load in ("50e3", "200e3"))
        self.assertTrue(1e-5 < low - high < 1e-3, (low, high))

    def test_height_is_solved_also_where_the_node_takes_it_from_the_pose(self):
        with tempfile.TemporaryDirectory() as folder:
            config = pathlib.Path(folder) / "given.yaml"
            config.write_text("wheelset: {free: []}\n", encoding="utf-8")
            given = self.values("--load", "200e3", "--y", "1e-3", "--config", str(config))
        self.assertEqual(given, self.values("--load", "200e3", "--y", "1e-3"))

    def test_state_without_a_usable_result_has_its_status_and_no_height(self):
        _, lines = self.run_command("--load", "200e3", "--y", "0.09", status=NOT_USABLE)
        self.assertNotIn(lines["status"], ("OK", "LIFT_OFF"))
        self.assertNotEqual(lines["status_text"], "")
        self.assertNotIn("z", lines)

    def test_a_zero_has_no_sign(self):
        self.assertNotIn("-0.0", self.run_command("--load", "0")[0])

    def test_inputs_of_a_node_that_the_command_lacks_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            config = pathlib.Path(folder) / "inputs.yaml"
            config.write_text("track: {displacement: topic, distance: topic}\n"
                              "rail_bending: {model: compliance, table: config/rails/pads_10_25.yaml,\n"
                              "  neighbours: [{topic: /front/contact_node/contact, distance: 2.5}]}\n", encoding="utf-8")
            output, _ = self.run_command("--load", "200e3", "--distance", "7", "--config", str(config))
        for note in ("rail_bending/neighbours: the forces of the neighbours are unknown, and taken as zero",
                     "track/displacement = topic: the displacements of the rails are unknown, and taken as zero",
                     "track/distance = topic: the place on the line is that of --distance, 7 m"):
            self.assertIn(f"static_start: {note}\n", output)
        self.assertNotIn("topic", self.run_command("--load", "200e3")[0])

    def test_mistakes_are_named(self):
        self.assertIn("--load nan: must be a finite number", self.run_command("--load", "nan", status=1)[0])
        for option in ("--left-force", "--right-force", "--distance"):
            self.assertIn(f"{option} -1000: must be omitted, because it would not be used",
                          self.run_command("--load", "1e5", option, "-1e3", status=1)[0])
        self.assertIn("nowhere.yaml", self.run_command("--load", "1e5", "--config", "nowhere.yaml", status=1)[0])
