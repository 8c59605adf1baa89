# SPDX-License-Identifier: BSD-3-Clause
import math
import sys
from pathlib import Path

import numpy as np

from wheel_rail_contact.csv_table import CsvTable
from wheel_rail_contact.geometry.command_line import main
from wheel_rail_contact.geometry.tables import CONICITY, GEOMETRY

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "replay"))
from commands import FolderCase, error_without_space, is_drawn, running  # noqa: E402  (in the folder of other tests)

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
CONE = 0.05  # slope of the conical wheels [-]

run = running(main)


def read(path):
    return CsvTable(path, texts=("reason", "loaded_reason"))


def write_cones(folder, hollow=0.0, gap=0.0):
    """Writes a wheel with a conical tread and a short flange, and parameters with different wheels left and right.

    hollow: curvature added to the tread [1/mm]. gap: half the width without points about the running circle [mm].
    """
    y = np.arange(-45, 61, 0.5)
    y = y[abs(y) >= gap]
    z = CONE * y - np.maximum(-35 - y, 0) ** 2 / 5 + 0.5 * hollow * y ** 2
    table = "\n".join(f"{a:.4f},{b:.6f}" for a, b in zip(y, z))
    Path(folder, "cone.csv").write_text(f"y_mm,z_mm\n{table}\n", encoding="ascii")
    config = Path(folder, "cones.yaml")
    config.write_text(f"wheel: {{profile: {folder}/cone.csv, left: {{rolling_radius: 0.4601}}, "
                      "right: {rolling_radius: 0.4600}}\n", encoding="ascii")
    return config


class Command(FolderCase):
    def test_conicity_of_cones_with_unequal_radii_is_their_slope_about_a_shifted_centre(self):
        status, out, err = run("--config", write_cones(self.folder), "--out", Path(self.folder, "new"), "--roll", "none",
                               "--y", -5, 5, "--amplitudes", 1, 3)
        self.assertEqual(status, 0, err)
        # The only other text: what was understood of the file.
        self.assertRegex(err, r"\Acontact_geometry: wheel/profile = .*/cone\.csv: table, .*unit mm.*\n\Z")
        points, conicity = (read(Path(self.folder, "new", name)) for name in (GEOMETRY, CONICITY))
        np.testing.assert_allclose(points["y"], np.linspace(-5e-3, 5e-3, 101), atol=1e-12)
        np.testing.assert_allclose(points["rolling_radius_difference"], 2 * CONE * points["y"] + 1e-4, atol=1e-7)
        np.testing.assert_allclose(points["left_rolling_radius"] - points["right_rolling_radius"],
                                   points["rolling_radius_difference"], atol=1e-8)
        np.testing.assert_allclose(conicity["amplitude"], np.linspace(1e-3, 3e-3, 21), atol=1e-12)
        np.testing.assert_allclose(conicity["equivalent_conicity"], CONE, atol=1e-4)
        np.testing.assert_allclose(conicity["centre"], -1e-3, atol=1e-5)
        np.testing.assert_allclose(conicity["wavelength"], 2 * math.pi * math.sqrt(1.5 * 0.46005 / (2 * CONE)), rtol=1e-3)
        self.assertIn("             2               0.0500           16.51                   -1.000\n", out)

    def test_picture_is_drawn(self):
        status, out, err = run("--out", self.folder, "--step", 0.5, "--title", "S1002 on 60E1", "--amplitudes", 0.5, 0.5,
                               "--load", 100e3)
        self.assertEqual((status, err), (0, ""))
        self.assertRegex(out, r"\n +0\.5 +0\.\d{4} [^$]*under 100 kN .*\n.*\n +0\.5 +0\.\d{4} ",
                         "all are printed if none is whole")
        points, conicity = (read(Path(self.folder, name)) for name in (GEOMETRY, CONICITY))
        np.testing.assert_allclose(points["loaded_left_rolling_radius"] - points["loaded_right_rolling_radius"],
                                   points["loaded_rolling_radius_difference"], atol=1e-8)
        self.assertEqual((points["loaded_reason"], conicity["loaded_reason"]), ([""] * 41, [""]))
        self.assertAlmostEqual(conicity["loaded_equivalent_conicity"][0], 0.17, delta=0.01)
        self.assertTrue(is_drawn(Path(self.folder, "contact_geometry.png")))

    def test_missing_results_have_an_empty_cell_and_a_printed_reason(self):
        status, out, _ = run("--out", self.folder, "--y", -4.2, 90, "--step", 1, "--amplitudes", 3, 5)
        self.assertEqual(status, 0)
        points, conicity = (read(Path(self.folder, name)) for name in (GEOMETRY, CONICITY))
        self.assertNotEqual(points["reason"][-1], "")
        self.assertTrue(math.isnan(points["rolling_radius_difference"][-1]))
        self.assertEqual(points["reason"][0], "")
        self.assertEqual(conicity["reason"], ["", "", "the wave leaves the computed range of y"])
        np.testing.assert_array_equal(np.isnan(conicity["equivalent_conicity"]), [False, False, True])
        self.assertIn("5  none: the wave leaves the computed range of y", out)
        self.assertRegex(out, r"no result for \d+ of 95 values of the y, .*: (off_profile|beside_rail)")

    def test_amplitudes_end_at_half_the_range_unless_given(self):
        status, out, err = run("--out", self.folder, "--y", -2, 2, "--step", 0.5)
        self.assertEqual((status, err), (0, ""))
        self.assertIn("equivalent_conicity.csv contains all 3 amplitudes", out)
        np.testing.assert_allclose(read(Path(self.folder, CONICITY))["amplitude"], [1e-3, 1.5e-3, 2e-3], atol=1e-12)

    def test_contacts_on_missing_points_have_a_reason_instead_of_a_conicity(self):
        config = write_cones(self.folder, hollow=1e-3, gap=8)  # the ends of a straight gap would define it
        status, out, err = run("--config", config, "--out", self.folder, "--y", -3, 3, "--step", 1, "--amplitudes", 1, 2)
        self.assertEqual(status, 0, err)
        points, conicity = (read(Path(self.folder, name)) for name in (GEOMETRY, CONICITY))
        self.assertRegex(err, "points missing over 1[^$]*contact_geometry: no amplitude has an equivalent conicity\n")
        self.assertEqual(points["reason"], ["points_missing"] * 7)
        self.assertTrue(np.all(np.isnan(points["rolling_radius_difference"])))
        self.assertTrue(np.all(np.isnan(conicity["equivalent_conicity"])))
        self.assertIn("no result for 7 of 7 values of the y, -3 mm to 3 mm: points_missing", out)

    def test_rails_that_deflect_are_reported_as_rigid_without_load(self):
        config = Path(self.folder, "bending.yaml")
        config.write_text("rail_bending: {model: compliance, table: config/rails/paper.yaml}\n", encoding="ascii")
        for load, is_rigid in (((), True), (("--load", 100e3), False)):
            status, _, err = run("--config", config, "--out", self.folder, "--step", 1, *load)
            self.assertEqual(status, 0, err)
            self.assertEqual("rail_bending/model is not used" in err, is_rigid)

    def test_wrong_options_are_refused_with_name_and_value(self):
        for arguments, message in ((("--y", "5e0", "-5e0"), "--y 5 -5: must increase, within ±100 mm"),
                                   (("--y", -6e-3, 6e-3), "must be a range of at least one --step, 0.1 mm; both are in mm"),
                                   (("--distance", 3), "--distance 3: must be omitted, because no rail has a profile that"),
                                   (("--y", 0, 101), "--y 0 101: must increase"),
                                   (("--y", "nan", 1), "--y nan 1: must be a number"),
                                   (("--load", -1e5), "--load -100000: must be above 0"),
                                   (("--step", 0), "--step 0: must be above 0"),
                                   (("--step", 1e-6), "--step 1e-06: gives more than 20000 steps from -10 mm to 10 mm"),
                                   (("--amplitudes", 0, 5), "--amplitudes 0 5: must be above 0"),
                                   (("--amplitudes", 5, 4), "--amplitudes 5 4: must be above 0, and not decrease"),
                                   (("--amplitudes", 1, 1e9), "--amplitudes 1 1e+09: must be at most 10 mm, half of"),
                                   (("--y", 0, 8, "--amplitudes", 1, 4.1), "--amplitudes 1 4.1: must be at most 4 mm"),
                                   (("--config", "missing.yaml"), "missing.yaml")):
            status, out, err = run("--out", Path(self.folder, "new"), *arguments)
            self.assertEqual(list(Path(self.folder).iterdir()), [], arguments)
            self.assertEqual((status, out), (1, ""), arguments)
            self.assertIn(message, err)

    def test_full_disk_is_reported_with_the_name_of_the_file(self):
        self.assertIn("contact_geometry.csv: File too large",
                      error_without_space(2**10, sys.executable, SCRIPTS / "contact_geometry", "--out", self.folder))
