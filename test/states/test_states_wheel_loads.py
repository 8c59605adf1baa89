# SPDX-License-Identifier: BSD-3-Clause
"""contact_states: wheel loads act at the running circles of the parameters, as in contact_replay."""
import os
import subprocess

import rosbag
from states_case import StatesCase

TABLE = "time [s],y [mm],Q_left [kN],Q_right [kN]\n1,0,40,30\n"
METRE_GAUGE = ("track: {gauge: 1.000}\nwheelset: {flange_back_distance: 0.925, rolling_radius: 0.30}\n"
               "wheel: {profile: S1002}\nrail: {profile: 60E1}\n")


class WheelLoads(StatesCase):
    def assert_distance(self, distance, source, *options):
        """The wheel loads act at this distance [m], which is printed with its source."""
        (state,), printed = self.convert(TABLE, *options)
        self.assertEqual(state.force_z, -70e3)
        self.assertAlmostEqual(state.torque_x, -10e3 * distance / 2, delta=1e-9)
        self.assertIn(f"distance of the running circles: {distance} m ({source}", printed)

    def test_distance_is_that_of_the_parameters(self):
        # From flange back to flange back, and from each flange back to its running circle.
        self.assert_distance(1.5, "config/default.yaml; --config or --running-circles")
        metre = self.config(METRE_GAUGE)
        self.assert_distance(1.065, metre, "--config", metre)
        flat = self.config("wheelset/tape_circle: '7.1e-2'\n", "b.yaml")
        self.assert_distance(1.067, f"{metre}, {flat}", "--config", metre, "--config", flat)
        self.assert_distance(1.502, flat, "--config", flat)
        self.assert_distance(1.067, "--running-circles", "--running-circles", 1.067)

    def test_parameter_files_are_found_as_those_of_a_replay(self):
        for name in ("config/paper.yaml", "package://wheel_rail_contact/config/paper.yaml"):
            self.assert_distance(1.5, name, "--config", name)

    def test_evaluation_has_the_wheel_loads_of_the_table_on_each_gauge(self):
        self.write(TABLE)
        for name, text in (("metre", METRE_GAUGE), ("standard", "wheel: {profile: S1002}\nrail: {profile: 60E1}\n")):
            with self.subTest(gauge=name):
                config = self.config(text, f"{name}.yaml")
                self.run_states("in.csv", f"{name}.bag", "--config", config)
                results = self.replayed(self.folder / f"{name}.bag", "--config", config, name=f"{name}_results.bag")
                with rosbag.Bag(str(results)) as bag:
                    (_, result, _), = bag.read_messages()
                self.assertEqual(result.status, 0, result.status_text)
                # The balance meets the loads to a tenth of the tolerance of 1 %.
                self.assertAlmostEqual(result.left_rail.vertical_force, 40e3, delta=40)
                self.assertAlmostEqual(result.right_rail.vertical_force, 30e3, delta=30)

    def test_loads_of_another_unit_or_sign_are_named(self):
        for loads, words in (("60,40", "the mean wheel load is 50 N: loads must be in N"),
                             ("-60e3,-40e3", "the mean wheel load is -50 kN, upward")):
            self.assertIn(words, self.convert(f"time [s],y [mm],Q_left [N],Q_right [N]\n1,0,{loads}\n")[1])

    def test_tables_without_wheel_loads_need_no_parameters(self):
        printed = self.convert("time [s],y [mm],force_z [N]\n1,0,-9\n", "--config", self.folder / "none.yaml")[1]
        self.assertNotIn("running circles", printed)

    def test_invalid_parameters_are_refused_as_by_a_replay(self):
        for text, reason in (("wheelset: {flange_back_distance: 0}\n", "flange_back_distance = 0.000000 must be from 0.2 to 3"),
                             ("wheelset: {tape_circle: 70}\n", "wheelset/tape_circle = 70.000000 must be from 0.005 to 0.5"),
                             ("wheelset: {flange_back_distance: .nan}\n", "/flange_back_distance = .nan must be"),
                             ("wheelset: {tape_circle: wide}\n", "wheelset/tape_circle = wide must be"),
                             ("wheelset: {tape_circle: true}\n", "wheelset/tape_circle = true must be"),
                             ("wheelset: {flange_back: 0.925}\n", "parameter wheelset/flange_back is unknown"),
                             ("wheelset: 1\n", "parameter wheelset is unknown"),
                             ("[]\n", "my.yaml: parameters: the document must be a map"), ("a: [\n", "my.yaml: ")):
            with self.subTest(text=text):
                config = self.config(text)
                printed = self.error_of(TABLE, "--config", config)
                self.assertIn(reason, printed)
                refused = self.replay(config).stderr.splitlines()[0] + "\n"
                self.assertEqual(printed.replace("contact_states", "contact_replay"), refused)
        self.assertIn("no such file: none.yaml", self.error_of(TABLE, "--config", "none.yaml"))
        self.assertIn("there is no ROS package 'none'", self.error_of(TABLE, "--config", "package://none/a.yaml"))

    def test_lengths_at_the_ends_of_their_ranges_are_compared_with_the_others(self):
        for name, value in (("flange_back_distance", 0.2), ("flange_back_distance", 3), ("tape_circle", 0.005),
                            ("tape_circle", 0.5)):
            with self.subTest(name=name, value=value):
                config = self.config(f"wheelset: {{{name}: {value}}}\n")
                self.assertNotIn(f"{name} = {value:f} must be", self.error_of(TABLE, "--config", config))
                self.assertIn(f"{name} = {value:g} m", self.replay(config).stderr)
        for name, value in (("flange_back_distance", 0.19), ("flange_back_distance", 3.01), ("tape_circle", 0.0049),
                            ("tape_circle", 0.51)):
            with self.subTest(name=name, value=value):
                config = self.config(f"wheelset: {{{name}: {value}}}\n")
                self.assertIn(f"wheelset/{name} = {value}", self.error_of(TABLE, "--config", config))
                self.assertEqual(self.replay(config).returncode, 2)

    def replay(self, config):
        """contact_replay reads the parameters before the bag, which does not exist."""
        return subprocess.run([os.environ["CONTACT_REPLAY"], self.folder / "none.bag", self.folder / "results.bag",
                               "--config", config], capture_output=True, text=True, check=False)

    def test_invalid_options_are_refused(self):
        for value in ("0", "-1.5", "nan", "inf", "0.199", "3.001", "1500"):
            self.assertIn(f"--running-circles {float(value)}: must be a number from 0.2 to 3, in metres",
                          self.misuse_of("--running-circles", value))
        self.assertIn("exclude one another", self.misuse_of("--running-circles", "1.5", "--config", "a.yaml"))
