# SPDX-License-Identifier: BSD-3-Clause
import os
import shutil
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from wheel_rail_contact.half_space import results
from wheel_rail_contact.half_space.command_line import main

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "replay"))
from commands import running  # noqa: E402  (in the folder of other tests)

HAVE_PROGRAMS = shutil.which("gmsh") is not None and shutil.which("ccx") is not None

run = running(main)


@unittest.skipUnless(HAVE_PROGRAMS, "gmsh or ccx is not installed")
class QuickStudy(unittest.TestCase):
    def test_elements_confirm_turned_normals_and_not_one_plane_in_the_flange_root(self):
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory, "new")
            status, out, err = run("--quick", "--places", "flange_root", "--out", str(folder))
            self.assertEqual(status, 0, err)
            rows = results.read_comparisons(folder / "comparisons.csv")
            self.assertEqual([row.load for row in rows], [20e3, 60e3, 120e3])
            for row in rows:
                # The study itself has 1 %, and coarse elements add as much.
                self.assertLess(row.error("turned"), 0.02, row)
                self.assertGreater(row.error("planar"), 0.05, row)
                self.assertEqual(row.package, "turned")
            for name in ("half_space_error.png", "half_space_pressures.png"):
                self.assertEqual((folder / name).read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertIn("| flange_root | 120 |", out)
        self.assertIn("solving", err)


class Misuse(unittest.TestCase):
    def test_unknown_place_is_refused_with_the_known_ones(self):
        status, _, err = run("--places", "crown", "--out", "never_made")
        self.assertEqual(status, 1)
        self.assertIn("--places has crown: must be one of tread, gauge_corner", err)
        self.assertFalse(Path("never_made").exists())

    def test_chart_of_another_kind_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            chart = Path(folder, "chart.csv")
            chart.write_text("time,error\n1,2\n", encoding="ascii")
            status, _, err = run("--chart", str(chart), "--out", "never_made")
        self.assertEqual(status, 1)
        self.assertIn("chart.csv: is not a table of contact_chart", err)
        self.assertFalse(Path("never_made").exists())

    def test_missing_program_is_reported_in_one_sentence(self):
        with tempfile.TemporaryDirectory() as empty, mock.patch.dict(os.environ, PATH=empty):
            status, _, err = run("--out", "never_made")
        self.assertEqual((status, err), (1, "half_space_study: gmsh is not installed; on Debian: apt install gmsh\n"))
        self.assertFalse(Path("never_made").exists())
