# SPDX-License-Identifier: BSD-3-Clause
"""The example of doc/python.md."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "python_example"


class Example(unittest.TestCase):
    def test_the_command_writes_its_pictures(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, EXAMPLE, "--out", f"{folder}/out"], check=True, stdout=subprocess.PIPE,
                                 universal_newlines=True)
            pictures = {path.name: path.read_bytes()[:4] for path in pathlib.Path(folder, "out").iterdir()}
        self.assertEqual(pictures, {f"{name}.png": b"\x89PNG" for name in ("python_sweep", "python_patches", "python_map",
                                                                    "stress_section")})
        self.assertIn("2106 states in", run.stdout)

    def test_an_unknown_option_is_refused(self):
        run = subprocess.run([sys.executable, EXAMPLE, "--output", "x"], stderr=subprocess.PIPE, universal_newlines=True,
                             check=False)
        self.assertEqual(run.returncode, 2)
        self.assertIn("unrecognized arguments: --output", run.stderr)

    def test_a_file_in_place_of_the_folder_is_reported(self):
        run = subprocess.run([sys.executable, EXAMPLE, "--out", EXAMPLE], stderr=subprocess.PIPE, universal_newlines=True,
                             check=False)
        self.assertEqual((run.returncode, run.stderr), (1, f"python_example: --out {EXAMPLE}: is not a folder\n"))
