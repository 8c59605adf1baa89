# SPDX-License-Identifier: BSD-3-Clause
"""The commands of the closed loop: the launch file, the loop in Python, and the pictures."""
import contextlib
import io
import os
import socket
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

from wheel_rail_contact.command import Failure
from wheel_rail_contact.csv_table import CsvTable
from wheel_rail_contact.simulation.command_line import main
from wheel_rail_contact.simulation.contact import open_contact
from wheel_rail_contact.simulation.parameters import read_parameters

PROGRAM = os.environ["SIMULATE_WHEELSET"]
PYTHON_LOOP = Path(__file__).resolve().parents[2] / "scripts" / "simulate_wheelset_python"
TIMEOUT = 120  # [s] for a command of a few seconds; builds with sanitizers are slow
HAS_MODULE = os.environ["HAS_PYTHON_MODULE"] == "1"


def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, timeout=TIMEOUT, check=False)
    return done.returncode, done.stdout, done.stderr


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

    @unittest.skipUnless(HAS_MODULE, "the Python module is not built")
    def test_python_loop_has_the_motion_of_the_program(self):
        config = self.config("run: {speed: 40, y: 0.003, yaw: 0.001, duration: 0.4}\n"
                             "suspension: {lateral_damping: 2.0e+3, longitudinal_damping: 1.0e+3}\n")
        tables = []
        for program in (PROGRAM, PYTHON_LOOP):
            path = self.folder / "run.csv"
            status, _, error = run(program, "--config", config, "--out", path)
            self.assertEqual((status, error), (0, ""))
            tables.append(CsvTable(path))
        # Both evaluate the same formulas in the same states. Rounding may change the number of iterations of a solver, and so
        # the forces by far less than contact/tolerance, 1 %: see contact_ways_test.cpp.
        np.testing.assert_allclose(tables[1]["y"], tables[0]["y"], atol=1e-6)
        np.testing.assert_allclose(tables[1]["yaw"], tables[0]["yaw"], atol=1e-6)
        self.assertGreater(np.ptp(tables[0]["y"]), 3e-3)

    def test_python_loop_and_program_refuse_parameters_with_one_text(self):
        for text in ("run: {sped: 3}\n", "runs: {step: 3}\n", "run: {step: -0.001}\n", "run: {step: 20}\n",
                     "run: {duration: 1.0e+9}\n", "run: {held_steps: 2.5}\n", "run: {speed: fast}\n", "run: {speed: true}\n",
                     "run: {yaw: .nan}\n", "wheelset: {mass: 0}\n", "suspension: {lateral_damping: -1}\n",
                     "wheelset: {gyroscopic: 0.6}\n", "run: 3\n", "run:\n", "hello\n", ""):
            path = self.config(text)
            status, _, error = run(PROGRAM, "--config", path)
            self.assertEqual(status, 1, text)
            with self.assertRaises(Failure) as failure:
                read_parameters(path)
            self.assertEqual(error, f"simulate_wheelset: {failure.exception}\n", text)

    def test_python_loop_refuses_files_that_are_no_yaml(self):
        for content in (b"run: [\n", b"run: \xff\n"):
            path = self.folder / "config.yaml"
            path.write_bytes(content)
            with self.assertRaisesRegex(Failure, "config.yaml: "):
                read_parameters(path)

    @unittest.skipUnless(HAS_MODULE, "the Python module is not built")
    def test_python_loop_refuses_contact_parameters_that_it_is_not_written_for(self):
        for text, message in (("wheelset: {balance: wheel_loads}\n", "wheelset/balance = wheel_loads must be moments"),
                              ("wheelset: {free: []}\n", r"wheelset/free = \[\] must be \[z, roll\]"),
                              ("track: {displacement: topic}\n", "rail_displacement is missing"),
                              ("wheel: NOSUCH\n", "wheel"), ("hello\n", "config.yaml")):
            with self.assertRaisesRegex(Failure, message):
                open_contact(self.config(text))
        status, out, error = run(PYTHON_LOOP, "--contact-config", self.config("wheelset: {balance: wheel_loads}\n"))
        self.assertEqual((status, out), (1, ""))
        self.assertRegex(error, "^simulate_wheelset_python: wheelset/balance = wheel_loads must be")

    def test_program_reports_mistakes_and_a_full_folder(self):
        for arguments, message in ((("--speed", "fast"), "('fast') for option '--speed' is invalid: must be a number"),
                                   (("--config", "missing.yaml"), "missing.yaml"),
                                   (("--duration", "0.01", "--out", self.folder / "no" / "run.csv"), "cannot be written")):
            status, out, error = run(PROGRAM, *arguments)
            self.assertEqual((status, out), (1, ""), arguments)
            self.assertIn(message, error)

    def test_derailment_ends_with_the_reason(self):
        config = self.config("run: {yaw: 0.02, speed: 60, duration: 2}\nwheelset: {mass: 20.0e+3}\n")
        status, _, error = run(PROGRAM, "--config", config)
        self.assertEqual(status, 1)
        self.assertRegex(error, r"no usable contact in 21 successive steps, at \d.* mm: "
                                r"OFF_PROFILE: (a wheel is beside its rail|contact lies beyond)")

    def test_pictures_are_drawn(self):
        from matplotlib import image
        table = self.folder / "run.csv"
        self.assertEqual(run(PROGRAM, "--duration", "0.5", "--out", table)[0], 0)
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
