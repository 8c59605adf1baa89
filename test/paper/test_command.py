# SPDX-License-Identifier: BSD-3-Clause
import dataclasses
import sys
from pathlib import Path
from unittest import mock

from coarse_ranges import COARSE, NEAR_FLANGE
from commands import FolderCase, error_without_space, running
from wheel_rail_contact.paper import study
from wheel_rail_contact.paper.command_line import main
from wheel_rail_contact.paper.scan import Scan

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
PICTURES = ("figure_3.png", "scan.png", "forces.png", "stress.png")
TABLES = ("figures.csv", "methods.csv", "profiles.csv", "contacts.csv", "patches.csv", "forces.csv", "scan.csv",
          "search.csv", "stress.csv", "stress_patches.csv")
# Both regions of the pictures, in a few seconds.
FEW = dataclasses.replace(COARSE, positions=COARSE.positions + NEAR_FLANGE.positions,
                          free_inclinations=NEAR_FLANGE.free_inclinations, free_positions=(0.0, 3.6e-3),
                          free_turns=(0.0, 14e-3))

run = running(main)


class Command(FolderCase):
    def test_command_prints_the_values_of_both_calculations_and_draws_the_pictures(self):
        from matplotlib import image
        with mock.patch.object(study, "Scan", lambda: Scan(FEW)), \
                mock.patch.object(study, "SEARCH_POSITIONS", (5.5e-3, 6.5e-3)):
            status, out, err = run("--out", str(Path(self.folder, "new")))
        self.assertEqual(status, 0, err)
        self.assertRegex(out, r"without bending +1175 / 185\.0 +11\d\d / 18\d\.\d")
        self.assertRegex(out, r"the same, 13 mrad inward +1330 / 127\.0 +13\d\d / 1[23]\d\.\d")
        self.assertRegex(out, r"pads 40/100 kN/mm +30 +1[23]\d\d / 1[67]\d\.\d +7\d\d +1\.\d\d ")
        for name in TABLES:
            self.assertGreater(len(Path(self.folder, "new", name).read_text(encoding="ascii").splitlines()), 1, name)
        for name in PICTURES:
            pixels = image.imread(str(Path(self.folder, "new", name)))[:, :, :3]
            # The standard deviation of a blank picture is 0, of thin lines on white 0.1, of coloured areas more.
            self.assertGreater(pixels.std(), 0.05, name)
            self.assertGreater(len({tuple(row) for row in pixels.reshape(-1, 3)[::7]}), 50, name)

    def test_full_disk_is_reported_with_the_name_of_the_file(self):
        self.assertIn("methods.csv: File too large",
                      error_without_space(2**10, sys.executable, SCRIPTS / "paper_study", "--out", self.folder))
