# SPDX-License-Identifier: BSD-3-Clause
"""The package without its extension module, as in builds with sanitizers; its commands, and its import."""
import subprocess
import sys
import unittest
from pathlib import Path

WITHOUT_MODULE = "import sys; sys.modules['wheel_rail_contact._core'] = None; import wheel_rail_contact as package; "


def run(code):
    """Output of a program that must end without an error."""
    return subprocess.run([sys.executable, "-c", code], check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout


class WithoutModule(unittest.TestCase):
    def test_an_import_error_names_the_packages_to_install(self):
        for name in ("WheelsetContact", "read_profile", "read_compliance_table"):
            printed = run(f"{WITHOUT_MODULE}\ntry:\n    package.{name}\nexcept ImportError as error:\n    print(error)")
            self.assertIn("source its setup.bash", printed)

    def test_a_command_ends_with_one_sentence_and_the_exit_status_1(self):
        for name, module, arguments in (("static_start", "static_start", ["--load", "1e5"]),
                                        ("contact_geometry", "geometry.command_line", ["--out", "never_made"]),
                                        ("check_profile", "profile_check.command_line", ["60E1", "--out", "never_made"])):
            done = subprocess.run([sys.executable, "-c", f"{WITHOUT_MODULE}from wheel_rail_contact.{module} import main; "
                                   f"sys.exit(main({arguments}))"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                  universal_newlines=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertEqual(done.stderr, f"{name}: the Python module wheel_rail_contact._core was not found; build the package "
                             "and source its setup.bash (builds with sanitizers have no such module)\n")
        self.assertFalse(Path("never_made").exists())

    def test_pictures_of_messages_do_not_require_the_module(self):
        printed = run(f"{WITHOUT_MODULE}from wheel_rail_contact.msg import PressureGrid\n"
                      "print(package.to_array(PressureGrid(nx=1, ny=2, pressure=[3, 4])).tolist())")
        self.assertEqual(printed, "[[3.0, 4.0]]\n")


class Import(unittest.TestCase):
    def test_importing_the_package_does_not_import_numpy(self):
        self.assertEqual(run("import sys, wheel_rail_contact; print('numpy' in sys.modules)"), "False\n")

    def test_the_names_are_listed_and_others_are_refused(self):
        import wheel_rail_contact
        self.assertLess({"WheelsetContact", "plot_pressure"}, set(dir(wheel_rail_contact)))
        with self.assertRaisesRegex(AttributeError, "no attribute 'Wheel'"):
            wheel_rail_contact.Wheel  # pylint: disable=pointless-statement
