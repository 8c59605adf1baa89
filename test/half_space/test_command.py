# SPDX-License-Identifier: BSD-3-Clause
import os
import shutil
import unittest
from pathlib import Path
from unittest import mock
from commands import FolderCase, running
from wheel_rail_contact.half_space import results
from wheel_rail_contact.half_space.command_line import main

HAVE_PROGRAMS = shutil.which("gmsh") is not None and shutil.which("ccx") is not None

run = running(main)


@unittest.skipUnless(HAVE_PROGRAMS, "gmsh or ccx is not installed")
class QuickStudy(FolderCase):
    def test_elements_confirm_turned_normals_and_not_one_plane_in_the_flange_root(self):
        folder = self.folder / "new"
        status, out, err = run("--quick", "--places", "flange_root", "--out", folder)
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


class Misuse(FolderCase):
    def refusal(self, *arguments):
        """What the command prints, in one line, when it makes no folder and ends with 1, as it must."""
        status, _, err = run(*arguments, "--out", "never_made")
        self.assertEqual((status, err.count("\n"), Path("never_made").exists()), (1, 1, False))
        return err

    def test_unknown_place_is_refused_with_the_known_ones(self):
        self.assertIn("--places has crown: must be one of tread, gauge_corner", self.refusal("--places", "crown"))

    def test_chart_of_another_kind_is_refused(self):
        chart = self.config("time,error\n1,2\n", "chart.csv")
        self.assertIn("chart.csv: is not a table of contact_chart", self.refusal("--chart", chart))

    def test_missing_program_is_reported_in_one_sentence(self):
        with mock.patch.dict(os.environ, PATH=str(self.folder)):
            self.assertEqual(self.refusal(), "half_space_study: gmsh is not installed; on Debian: apt install gmsh\n")
