# SPDX-License-Identifier: BSD-3-Clause
"""The commands of the closed loop: the launch file, the program, and the pictures."""
import contextlib
import io
import os
import runpy
import socket
import subprocess
import tempfile
import unittest
import unittest.mock
from pathlib import Path

import numpy as np

from wheel_rail_contact.csv_table import CsvTable
from wheel_rail_contact.simulation.command_line import main

PROGRAM = Path(__file__).resolve().parents[2] / "scripts" / "simulate_wheelset"
TIMEOUT = 120  # [s] for a command of a few seconds; builds with sanitizers are slow
needs_module = unittest.skipUnless(os.environ["HAS_PYTHON_MODULE"] == "1", "the Python module is not built")


def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, timeout=TIMEOUT, check=False)
    return done.returncode, done.stdout, done.stderr


def run_here(*arguments):
    """Runs the program in this process, which saves the time of its start."""
    out, error = io.StringIO(), io.StringIO()
    with unittest.mock.patch("sys.argv", [str(word) for word in (PROGRAM, *arguments)]), contextlib.redirect_stdout(out), \
            contextlib.redirect_stderr(error):
        try:
            runpy.run_path(str(PROGRAM), run_name="__main__")
        except SystemExit as end:
            return end.code, out.getvalue(), error.getvalue()
    raise AssertionError("the program does not end with a status")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Commands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def config(self, text):
        path = self.folder / "config.yaml"
        path.write_text(text, encoding="ascii")
        return path

    def test_launch_file_runs_the_loop_with_a_node_and_ends(self):
        table = self.folder / "run.csv"
        for way in ("topics", "service"):
            status, _, error = run("roslaunch", "--port", free_port(), "wheel_rail_contact", "simulate_wheelset.launch",
                                   f"contact:={way}", f"options:=--duration 0.2 --out {table}")
            self.assertEqual(status, 0, error)
            self.assertEqual(len(CsvTable(table)), 200)
            table.unlink()

    @needs_module
    def test_table_has_a_row_per_step_with_the_summary_of_the_loop(self):
        table = self.folder / "run.csv"
        status, out, error = run_here("--duration", "1", "--speed", "30", "--step", "0.002", "--contact", "process", "--out",
                                 table)
        self.assertEqual((status, error), (0, ""))
        self.assertRegex(out, r"^500 steps, 0 with a held contact, \d+ at the friction limit\nlast third: largest \|y\| \d.* mm, "
                              r".*wave.*\n\d+ steps/s; step: median \d.* ms, 95 % \d.* ms, longest \d.* ms\n$")
        rows = CsvTable(table)
        np.testing.assert_allclose(rows["time"], 0.002 * np.arange(1, 501), atol=1e-9)
        np.testing.assert_allclose(rows["distance"], 30 * rows["time"], atol=1e-6)
        self.assertGreater(np.ptp(rows["y"]), 3e-3)
        self.assertFalse(np.any(rows["held"]))
        # The contacts carry the axle load: 200 kN, less the cosine of angles up to 0.1 rad.
        np.testing.assert_allclose(rows["left_normal_force"] + rows["right_normal_force"], 200e3, rtol=0.01)

    @needs_module
    def test_stability_is_printed_with_the_critical_speed(self):
        status, out, error = run_here("--stability", 20, 60)
        self.assertEqual((status, error), (0, ""))
        self.assertRegex(out, r"^speed.*\n +20\.00 +-0\.\d+ +2\.\d+\n(.*\n){7} +60\.00 +2\.\d+ +6\.\d+\n"
                              r"critical speed: 3\d\.\d m/s\n$")
        self.assertIn("no critical speed from 20 to 21 m/s", run_here("--stability", 20, 21)[1])
        self.assertIn("critical speed: below 59 m/s, where motions already grow", run_here("--stability", 59, 60)[1])

    @needs_module
    def test_program_reports_mistakes_and_a_full_disk(self):
        short, curve = ("--duration", "0.01"), self.folder / "curve.csv"
        curve.write_text("x [m],curvature [1/km]\n0,1\n9,1\n")
        (self.folder / "curve.yaml").write_text(f"track: {{line: {curve}}}\n")
        for arguments, status, message in (
                (("--speed", "fast"), 2, "argument --speed: invalid float value: 'fast'"),
                (("--speed",), 2, "argument --speed: expected one argument"), (("--fast", "1"), 2, "unrecognized arguments: --fast 1"),
                (("--contact", "radio"), 2, "argument --contact: invalid choice: 'radio'"),
                (("--speed", "-1"), 1, "simulate_wheelset: run/speed = -1 must be a finite number > 0\n"),
                (("--contact", "topics", "--contact-config", "a.yaml"), 1, "a.yaml: only with --contact process"),
                (("--stability", "5", "5"), 1, "--stability 5 5: must be above 0, and increase"),
                (("--stability", "1", "5", "--out", "a.csv"), 1, "--out a.csv: must be omitted with --stability"),
                (("--config", "missing.yaml"), 1, "missing.yaml: No such file"),
                (("--contact-config", self.config("wheelset: {balance: wheel_loads}\n")), 1, "balance = wheel_loads must be"),
                (("--contact-config", self.folder / "curve.yaml"), 1, "no forces of curvature, cant or gradient"),
                ((*short, "--out", self.folder / "no" / "run.csv"), 1, "no/run.csv: No such file"),
                ((*short, "--out", "/dev/full"), 1, "/dev/full: No space left on device")):
            result, out, error = run_here(*arguments)
            self.assertEqual((result, out), (status, ""), arguments)
            self.assertIn(message, error)

    @needs_module
    def test_derailment_ends_with_the_reason(self):
        config = self.config("run: {yaw: 0.02, speed: 60, duration: 2}\nwheelset: {mass: 20.0e+3}\n")
        status, _, error = run_here("--config", config)
        self.assertEqual(status, 1)
        self.assertRegex(error, r"no usable contact in 21 successive steps, at \d.* mm: "
                                r"OFF_PROFILE: (a wheel is beside its rail|contact lies beyond)")

    @needs_module
    def test_pictures_are_drawn(self):
        from matplotlib import image
        table = self.folder / "run.csv"
        self.assertEqual(run_here("--duration", "0.5", "--out", table)[0], 0)
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(main([str(table), str(table), "--out", str(self.folder), "--length", "10"]), 0)
        for name in ("simulation_motion.png", "simulation_phase.png"):
            # The standard deviation of a blank picture is 0, of thin lines on white 0.1.
            self.assertGreater(image.imread(str(self.folder / name))[:, :, :3].std(), 0.05)

    def test_other_tables_are_refused(self):
        path = self.config("y [m],x [m]\n1,2\n2,3\n")
        error = io.StringIO()
        with contextlib.redirect_stderr(error):
            self.assertEqual(main([str(path), "--out", str(self.folder)]), 1)
        self.assertIn("is no table of simulate_wheelset", error.getvalue())
