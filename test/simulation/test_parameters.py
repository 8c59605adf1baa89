# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of the closed loop and of its contact; mistakes in them are refused by name."""
import os
import re
import tempfile
import unittest
from pathlib import Path

from wheel_rail_contact.command import Failure
from wheel_rail_contact.simulation.contact import open_contact
from wheel_rail_contact.simulation.parameters import read_parameters

MISTAKES = (
    ("run: {sped: 3}", "parameter run/sped has an unknown name"), ("runs: {step: 3}", "parameter runs/step has an unknown name"),
    ("wheelset: {mass: heavy}", "wheelset/mass = heavy must be a number"), ("run: {speed: true}", "run/speed = true must be a"),
    ("wheelset: {mass: 0}", "wheelset/mass = 0 must be a finite number > 0"), ("run: {yaw: .nan}", "run/yaw = nan must be a"),
    ("suspension: {lateral_damping: -1}", "suspension/lateral_damping = -1 must be"),
    ("wheelset: {gyroscopic: 0.6}", "wheelset/gyroscopic = 0.6 must be 0 or 1"), ("run: 3", "group run must be a map"),
    ("run:", "group run must be a map"), ("hello", "the file must be a map of groups"), ("", "the file must be a map of groups"),
    ("run: {held_steps: 2.5}", "run/held_steps = 2.5 must be a whole number from 0 to"),
    ("run: {held_steps: 1.0e+10}", "run/held_steps = 1e+10 must be a whole number from 0 to"),
    ("run: {duration: 1.0e+9}", "run/duration = 1e+09 must be at most"), ("run: {step: -0.001}", "run/step = -0.001 must be"),
    ("run: {step: 1.0e-9}", "run/step = 1e-09 must be at least 1e-06 s"), ("run: [", "while parsing"),
    ("run: {step: 20, duration: 10}", "run/step = 20 must be at least 1e-06 s, and at most run/duration"))
BENDING = "rail_bending: {model: compliance, table: package://wheel_rail_contact/config/rails/pads_10_25.yaml, "
CONTACT_MISTAKES = (
    ("wheelset: {balance: wheel_loads}", "wheelset/balance = wheel_loads must be moments: the load of this program is for it"),
    ("creep: {method: none}", "creep/method = none must be linear, fastsim or exact: this program has no friction of its own"),
    ("creep: {rotation: topic}", "creep/rotation = topic must be free: this program does not integrate the rotation"),
    ("track: {displacement: topic}", "track/displacement = topic must be none: this program does not move the rails"),
    (BENDING + "lateral_force: topic}", "rail_lateral_force is missing"),
    (BENDING + "neighbours: [{topic: /front, distance: 2.5}]}", "rail_bending/neighbours"),
    ("track: {gauge: wide}", "parameter track/gauge = wide must be a finite number"),
    ("wheel: NOSUCH", "parameter wheel is unknown"), ("hello", "the document must be a map"))


class Parameters(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "file.yaml"

    def file(self, text):
        self.path.write_text(text + "\n", encoding="ascii")
        return self.path

    def test_mistakes_are_refused_by_name(self):
        for text, message in MISTAKES:
            with self.assertRaisesRegex(Failure, "file.yaml: .*" + re.escape(message)):
                read_parameters(self.file(text))
        self.path.write_bytes(b"run: \xff\n")
        with self.assertRaisesRegex(Failure, "file.yaml"):
            read_parameters(self.path)
        with self.assertRaisesRegex(OSError, "missing.yaml"):
            read_parameters("missing.yaml")

    def test_given_values_are_over_the_file(self):
        run = read_parameters(self.file("run: {speed: 20, step: 0.002}"), {"speed": 30.0})["run"]
        self.assertEqual((run["speed"], run["step"]), (30, 0.002))
        with self.assertRaisesRegex(Failure, "^run/speed = -1 must be a finite number > 0"):
            read_parameters(self.path, {"speed": -1.0})

    @unittest.skipUnless(os.environ["HAS_PYTHON_MODULE"] == "1", "the Python module is not built")
    def test_contact_parameters_are_those_of_the_node_or_refused(self):
        contact = open_contact(self.file("wheel: {profile: cone_1_20}\nrail: {profile: 60E2}\ntrack: {gauge: 1.437}\n"
                                         "contact: {tolerance: 0.02}")).contact
        self.assertEqual((contact.config["track/gauge"], contact.config["contact/tolerance"]), ("1.437", "0.02"))
        self.assertEqual((contact.wheel_profiles[0].name, contact.rail_profiles[1].name), ("cone_1_20", "60E2"))
        for text, message in CONTACT_MISTAKES:
            with self.assertRaisesRegex(Failure, re.escape(message)):
                open_contact(self.file(text))
