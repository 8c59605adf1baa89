# SPDX-License-Identifier: BSD-3-Clause
import os
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import yaml
from rails import HAVE_PROGRAMS, needs_programs

from wheel_rail_contact.rail_fe.command_line import main

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "replay"))
from commands import running  # noqa: E402  (in the folder of other tests)

run = running(main)


class Misuse(unittest.TestCase):
    def check(self, reason, *arguments):
        status, _, err = run("--out", "never_written.yaml", *arguments)
        self.assertNotEqual(status, 0)
        self.assertIn(reason, err)
        self.assertFalse(Path("never_written.yaml").exists())

    def test_wrong_arguments_are_reported_by_name(self):
        clamped, seats = ("--supports", "foot_clamped"), ("--supports", "seats", "--pad-lateral", "4e7")
        seats_full = (*seats, "--pad-vertical", "1e8")
        self.check("invalid choice: 'glued'", "--supports", "glued")
        self.check("require --supports seats", *clamped, "--bays", "4")
        self.check("requires --pad-lateral and --pad-vertical", *seats)
        self.check("--pad-lateral is -1: must be above 0", "--supports", "seats", "--pad-lateral", "-1",
                   "--pad-vertical", "1e8")
        self.check("--length is 0.5 m: the seats extend over", *seats_full, "--length", "0.5")
        self.check("--neighbours has 7 m: must be above 0 and below half", *seats_full, "--neighbours", "7")
        self.check("--neighbours requires --supports seats", *clamped, "--neighbours", "0.3")
        self.check("--bays is 1: must be at least 2", *seats_full, "--bays", "1")
        self.check("--poisson is 0.5", *clamped, "--poisson", "0.5")
        self.check("--mesh-size is nan", *clamped, "--mesh-size", "nan")
        self.check("--mesh-size is 0.1 m: must be at most a quarter", *clamped, "--mesh-size", "0.1")
        self.check("nowhere.csv: cannot be read", *clamped, "--section", "nowhere.csv")
        if HAVE_PROGRAMS:
            self.check("folder nowhere does not exist", *clamped, "--picture", "nowhere/p.png")

    def test_missing_program_is_reported_in_one_sentence(self):
        with tempfile.TemporaryDirectory() as empty, mock.patch.dict(os.environ, PATH=empty):
            status, _, err = run("--supports", "foot_clamped", "--out", "never_written.yaml")
            self.assertEqual((status, err), (1, "rail_compliance: gmsh is not installed; on Debian: "
                                                "apt install gmsh\n"))
            gmsh = Path(empty) / "gmsh"
            gmsh.write_text("#!/bin/sh\n", encoding="ascii")
            gmsh.chmod(0o755)
            status, _, err = run("--supports", "foot_clamped", "--out", "never_written.yaml")
            self.assertEqual((status, err), (1, "rail_compliance: CalculiX (ccx) is not installed; on Debian: "
                                                "apt install calculix-ccx\n"))


@needs_programs
class WholeRun(unittest.TestCase):
    def test_run_writes_table_deck_and_picture_and_reports_progress(self):
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory)
            table_path, picture, deck = folder / "soft.yaml", folder / "soft.png", folder / "deck"
            status, out, err = run("--supports", "seats", "--pad-lateral", "4e7", "--pad-vertical", "1e8",
                                   "--bays", "4", "--neighbours", "0.9", "--mesh-size", "0.03",
                                   "--force-height", "0.1624", "--out", str(table_path), "--picture", str(picture),
                                   "--keep-deck", str(deck))
            self.assertEqual(status, 0, err)
            table = yaml.safe_load(table_path.read_text(encoding="utf-8"))
            for name in ("rail.geo", "rail.msh", "rail.inp", "rail.frd"):
                self.assertGreater((deck / name).stat().st_size, 0, name)
            self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(table["name"], "soft")
        self.assertEqual([entry["distance"] for entry in table["neighbours"]], [0.9])
        self.assertIn("--pad-lateral 4e7", table["provenance"]["command"])
        self.assertIn("solving load case 4 of 4", err)
        self.assertIn("estimated discretisation error", out)

    def test_roll_stiffness_impossible_for_the_foot_is_refused(self):
        with tempfile.TemporaryDirectory() as directory:
            status, _, err = run("--supports", "seats", "--pad-lateral", "4e7", "--pad-vertical", "1e8", "--pad-roll",
                                 "1e6", "--bays", "2", "--mesh-size", "0.04", "--out", str(Path(directory) / "t.yaml"))
        self.assertEqual(status, 1)
        self.assertIn("--pad-roll is 1e+06 N m/rad", err)
        self.assertIn("must be between", err)
