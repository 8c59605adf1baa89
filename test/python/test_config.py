# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of WheelsetContact."""
import functools
import pathlib
import tempfile
import unittest
import warnings

import numpy as np
from wheel_rail_contact import WheelsetContact

YAML = "track: {gauge: 1.432}\nwheel: {profile: S1002}\nrail: {profile: UIC60_manchester}\nmaterial: {wheel: {young: 205e9}}\n"
DICT = {"track": {"gauge": 1.432}, "rail": {"profile": "UIC60_manchester"}, "material": {"wheel": {"young": "205e9"}}}


class Config(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name) / "my.yaml"
        self.file.write_text(YAML)

    def test_file_path_dict_and_overlays_are_equal(self):
        pressures = [WheelsetContact(config).evaluate(y=1e-3, force_z=-2e5).patches[0].pressure
                     for config in (str(self.file), self.file, DICT, [{"track": {"gauge": 1.5}}, str(self.file)])]
        for pressure in pressures[1:]:
            np.testing.assert_array_equal(pressure, pressures[0])
        default = WheelsetContact().evaluate(y=1e-3, force_z=-2e5).patches[0]
        self.assertNotEqual(default.max_pressure, pressures[0].max())

    def test_numbers_of_numpy_and_paths_are_values(self):
        contact = WheelsetContact({"track": {"gauge": np.float32(1.4375)},
                                   "contact": {"grid": {"along": np.int64(8), "across": 8}},
                                   "rail_bending": {"model": "compliance",
                                                    "table": pathlib.Path("config/rails/pads_40_100.yaml")}})
        self.assertEqual(contact.evaluate(force_z=-2e5).patches[0].pressure.shape, (8, 8))

    def test_a_summary_has_all_parameters_and_the_profiles(self):
        contact = WheelsetContact([DICT, {"rail": {"left": {"profile": "60E1"}}}])
        self.assertEqual(contact.config["rail/profile"], "UIC60_manchester")
        self.assertEqual(contact.config["track/gauge"], "1.432")
        self.assertEqual(contact.config["contact/tolerance"], "0.01")
        self.assertEqual([profile.name for profile in contact.rail_profiles], ["60E1", "UIC60_manchester"])
        self.assertEqual([profile.name for profile in contact.wheel_profiles], ["S1002", "S1002"])
        self.assertEqual(contact.notes, [])
        self.assertIn("rails 60E1, UIC60_manchester", repr(contact))

    def test_faults_are_those_of_the_node_by_name(self):
        for config, text in (({"track": {"gauge": 9}}, "track/gauge = 9.*must be from 0.2 to 3"),
                             ({"track": {"gage": 1.4}}, "parameter track/gage is unknown"),
                             ({"contact": {"tolerance": "fine"}}, "contact/tolerance = fine"),
                             ({"wheel": {"profile": "none.prw"}}, "wheel/profile = none.prw: no such file"),
                             (["none.yaml"], "no such file: none.yaml"),
                             (functools.reduce(lambda group, _: {"track": group}, range(900), {}), "more than 16 nested")):
            with self.subTest(config=config), self.assertRaisesRegex(ValueError, text):
                WheelsetContact(config)

    def test_other_types_are_refused(self):
        for config, text in ((3, "config = 3: must be"), ([3], "config: 3 must be"),
                             ({"track": {"gauge": object()}}, "cannot be the value of a parameter")):
            with self.subTest(config=config), self.assertRaisesRegex(TypeError, text):
                WheelsetContact(config)

    def test_a_note_describes_each_profile_file(self):
        file = self.file.with_name("cone.csv")
        y = np.linspace(-60, 60, 241)
        flange = 28 * np.exp(-((y + 54) / 11) ** 4)
        file.write_text("y_mm,z_mm\n" + "".join(f"{a:.4f},{b:.5f}\n" for a, b in zip(y, 0.05 * y - flange)))
        contact = WheelsetContact({"wheel": {"profile": str(file)}})
        self.assertIn("cone.csv", contact.notes[0])
        self.assertIn("241 points", contact.notes[0])

    def test_neighbours_are_reported_because_they_are_not_used(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            WheelsetContact({"rail_bending": {"model": "compliance", "table": "config/rails/pads_40_100.yaml",
                                              "neighbours": [{"topic": "/front/contact", "distance": 2.5}]}})
        self.assertIn("rail_bending/neighbours is not used", str(caught[0].message))
