# SPDX-License-Identifier: BSD-3-Clause
import os
from pathlib import Path
from unittest import mock

import yaml
from rails import HAVE_PROGRAMS, needs_programs
from commands import FolderCase, running
from wheel_rail_contact.rail_fe.command_line import main

run = running(main)


class Misuse(FolderCase):
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
        for program, package in ("gmsh", "gmsh"), ("CalculiX (ccx)", "calculix-ccx"):
            with mock.patch.dict(os.environ, PATH=str(self.folder)):
                status, _, err = run("--supports", "foot_clamped", "--out", "never_written.yaml")
            missing = f"rail_compliance: {program} is not installed; on Debian: apt install {package}\n"
            self.assertEqual((status, err), (1, missing))
            self.config("#!/bin/sh\n", "gmsh").chmod(0o755)


@needs_programs
class WholeRun(FolderCase):
    def test_run_writes_table_deck_and_picture_and_reports_progress(self):
        table_path, picture, deck = (self.folder / name for name in ("soft.yaml", "soft.png", "deck"))
        status, out, err = run("--supports", "seats", "--pad-lateral", "4e7", "--pad-vertical", "1e8", "--bays", "4",
                               "--neighbours", "0.9", "--mesh-size", "0.03", "--force-height", "0.1624", "--out", table_path,
                               "--picture", picture, "--keep-deck", deck)
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
        status, _, err = run("--supports", "seats", "--pad-lateral", "4e7", "--pad-vertical", "1e8", "--pad-roll", "1e6",
                             "--bays", "2", "--mesh-size", "0.04", "--out", self.folder / "t.yaml")
        self.assertEqual(status, 1)
        self.assertIn("--pad-roll is 1e+06 N m/rad", err)
        self.assertIn("must be between", err)
