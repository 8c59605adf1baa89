# SPDX-License-Identifier: BSD-3-Clause
import contextlib
import importlib.util
import io
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from wheel_rail_contact.paper import pictures
from wheel_rail_contact.paper.command_line import main

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "replay"))
from full_disk import no_file_larger_than  # noqa: E402  (in the folder of other tests)

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
# The picture of the stress requires the Python module, which is optional in a build.
STRESS = ("stress.png",) if importlib.util.find_spec("wheel_rail_contact._core") else ()
PICTURES = ("figure_3.png", "scan.png", "forces.png", *STRESS)
TABLES = ("figures.csv", "methods.csv", "profiles.csv", "contacts.csv", "patches.csv", "forces.csv", "scan.csv",
          "search.csv", "stress.csv", "stress_patches.csv")


def run(*arguments):
    """Runs the command. @return exit status, standard output and standard error"""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        status = main(list(arguments))
    return status, out.getvalue(), err.getvalue()


class Command(unittest.TestCase):
    def test_command_prints_the_values_of_both_calculations_and_draws_the_pictures(self):
        from matplotlib import image
        with tempfile.TemporaryDirectory() as folder:
            status, out, err = run("--out", str(Path(folder, "new")))
            self.assertEqual(status, 0, err)
            self.assertRegex(out, r"without bending +1175 / 185\.0 +11\d\d / 18\d\.\d")
            self.assertRegex(out, r"the same, 13 mrad inward +1330 / 127\.0 +13\d\d / 1[23]\d\.\d")
            self.assertRegex(out, r"pads 40/100 kN/mm +30 +1[23]\d\d / 1[67]\d\.\d +7\d\d +1\.\d\d ")
            for name in TABLES:
                self.assertGreater(len(Path(folder, "new", name).read_text(encoding="ascii").splitlines()), 1, name)
            for name in PICTURES:
                pixels = image.imread(str(Path(folder, "new", name)))[:, :, :3]
                # The standard deviation of a blank picture is 0, of thin lines on white 0.1, of coloured areas more.
                self.assertGreater(pixels.std(), 0.05, name)
                self.assertGreater(len({tuple(row) for row in pixels.reshape(-1, 3)[::7]}), 50, name)

    def test_without_the_python_module_a_sentence_replaces_the_picture_of_the_stress(self):
        module = mock.Mock(figure=mock.Mock(side_effect=ImportError("built without its Python module")))
        with mock.patch.object(pictures, "PICTURES", ((module, "stress.png"),)):
            self.assertEqual(list(pictures.draw(None, Path("never_made"))),
                             ["left out stress.png: built without its Python module"])

    def test_full_disk_is_reported_with_the_name_of_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            run_study = subprocess.run([sys.executable, SCRIPTS / "paper_study", "--out", folder], capture_output=True,
                                       text=True, check=False, preexec_fn=no_file_larger_than(2**10))
        self.assertEqual(run_study.returncode, 1, run_study.stdout + run_study.stderr)
        self.assertIn("methods.csv: cannot be written", run_study.stderr)

    def test_missing_program_is_reported_in_one_sentence(self):
        with mock.patch.dict(os.environ, CMAKE_PREFIX_PATH=""):
            status, out, err = run("--out", "never_made")
        self.assertEqual((status, out), (1, ""))
        self.assertEqual(err, "paper_study: paper_study_runner was not found; source the workspace's setup.bash first\n")
        self.assertFalse(Path("never_made").exists())


if __name__ == "__main__":
    unittest.main()
