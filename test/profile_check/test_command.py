# SPDX-License-Identifier: BSD-3-Clause
"""check_profile: report, picture and clean table of profile files, and refusals."""
import math
import os
import sys
from pathlib import Path

import numpy as np
from commands import FolderCase, error_without_space, is_drawn, running
from wheel_rail_contact.profile_check.command_line import main

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
TITLES = "y_mm,z_mm"

run = running(main)


def read_table(path):
    """Points of a table [mm], without comments and titles."""
    lines = [line for line in Path(path).read_text(encoding="utf-8").splitlines() if line[0] not in "#y"]
    return np.array([[float(number) for number in line.split(",")] for line in lines])


def write_table(path, points, titles=TITLES, separator=","):
    rows = [separator.join(f"{number:.9f}" for number in point) for point in points]
    Path(path).write_text("\n".join([titles] * bool(titles) + rows) + "\n", encoding="ascii")
    return path


def wheel_points():
    """Wheel [mm] of straight lines and arcs: flange tip R10 at y = -55, 28 mm below the running circle; cone 1:20."""
    y = np.concatenate([np.linspace(-64.5, -45.5, 60), np.linspace(-45, -30, 40), np.linspace(-29.5, 60, 200)])
    z = np.where(y < -45.2, -18 - np.sqrt(np.maximum(100 - (y + 55)**2, 0)), 0)
    side = (y >= -45.2) & (y <= -30)
    z = np.where(side, -14.5 + 13 * np.sin((y + 45) / 15 * math.pi / 2), z)
    return np.column_stack([y, np.where(y > -30, y / 20, z)])


class Command(FolderCase):
    def run_check(self, *arguments, status=0):
        """Standard output and standard error of the command. Without a refusal, there is no error."""
        found, out, err = run(*arguments, "--out", self.folder / "pictures")
        self.assertEqual((found, err == ""), (status, status == 0), err)
        return out, err

    def standard_rail(self, name="60E1"):
        """Points of a standard rail [mm], written by the command itself."""
        clean = self.folder / f"{name}_clean.csv"
        if not clean.exists():
            self.run_check(name, "--write", clean)
        return read_table(clean)

    def test_inclined_rail_is_equivalent_to_its_standard_rotated(self):
        y, z = self.standard_rail().T
        c, s = math.cos(0.025), math.sin(0.025)
        rail = write_table(self.folder / "rail.csv", np.column_stack([c * y - s * z, s * y + c * z]))
        out, _ = self.run_check(rail)
        self.assertIn(f"{rail}: rail, by its content\n", out)
        self.assertRegex(out, r"  table, \d+ points, unit mm, y outward, z up, noise ")
        self.assertRegex(out, r"nearest standard profile: 60E1, rms [\d.e-]+ mm, .* rotated by 25\.0 mrad \(1:40\.0\) towards "
                              "the track centre")
        self.assertRegex(out, r"sides 1:40\.\d \(gauge side\) and 1:13\.\d \(field side\): .* 25\.0 mrad \(1:40\.0\)")

    def test_measures_of_a_standard_wheel_are_printed(self):
        out, _ = self.run_check("S1002")
        self.assertIn("flange height Sh 28.00 mm, flange thickness Sd 32.50 mm, qR 10.79 mm (EN 15313)", out)
        self.assertIn("width 130.00 mm, from y = -70.00 mm to 60.00 mm", out)

    def test_picture_is_drawn_beside_each_other_file(self):
        write_table(self.folder / "wheel.csv", wheel_points())
        out, _ = self.run_check(self.folder / "wheel.csv", "60E1")
        self.assertIn("wheel.csv: wheel, by its content", out)
        for name in ("wheel.csv.png", "60E1.png"):
            self.assertTrue(is_drawn(self.folder / "pictures" / name), name)

    def test_clean_table_gives_the_same_report_and_is_not_overwritten(self):
        rail = write_table(self.folder / "rail.txt", self.standard_rail() * [-1, -1], titles="", separator="\t")
        clean = self.folder / "clean.csv"
        axes = ("--unit", "mm", "--y", "inward", "--z", "down")
        out, _ = self.run_check(rail, "--rail", *axes, "--write", clean)
        text = clean.read_text()
        self.assertIn("# rail profile: y to the field side, z up\n", text)
        self.assertIn(f"# written by check_profile from '{rail}'\n# which was read as: table, ", text)
        self.assertIn(f"\n{TITLES}\n", text)
        np.testing.assert_allclose(read_table(clean), self.read_points(rail) * [-1, -1], atol=1e-9)
        again, _ = self.run_check(clean)
        measures = [line for line in out.splitlines() if line.startswith(("  top", "  width", "  sides", "  nearest"))]
        self.assertEqual(len(measures), 4)
        for line in measures:
            self.assertIn(line, again)
        _, err = self.run_check(rail, "--rail", *axes, "--write", clean, status=1)
        self.assertEqual(err, f"check_profile: {clean}: already exists and is not overwritten\n")
        self.assertEqual(clean.read_text(), text)

    @staticmethod
    def read_points(path):
        return np.array([[float(number) for number in line.split("\t")] for line in path.read_text().splitlines()])

    def test_smoothed_points_become_a_clean_table_along_the_curve(self):
        random = np.random.default_rng(3)
        points = self.standard_rail()
        rail = write_table(self.folder / "noisy.csv", points + random.normal(0, 5e-3, points.shape))
        clean = self.folder / "clean.csv"
        out, _ = self.run_check(rail, "--smoothing", 5, "--write", clean)
        self.assertIn("smoothed for 5 um", out)
        self.assertIn("# the points are on the smoothed curve", clean.read_text())
        out, _ = self.run_check(clean)
        self.assertIn("not smoothed", out)
        self.assertRegex(out, r"nearest standard profile: 60E1, rms 0\.00\d+ mm")

    def test_missing_points_are_reported_and_drawn(self):
        points = self.standard_rail()
        rail = write_table(self.folder / "gap.csv", points[(points[:, 0] < -5) | (points[:, 0] > 7)])
        out, _ = self.run_check(rail)
        self.assertRegex(out, r"points missing over 12\.\d+ mm from y = -5\.\d+ mm to 7\.\d+ mm")
        self.assertRegex(out, r"points missing over 1[3-6]\.\d % of it")

    def test_rail_with_wear_or_inclination_to_its_field_side_is_asked_about(self):
        y, z = self.standard_rail().T
        worn = np.column_stack([y, z - 3 * np.clip((-15 - y) / 20, 0, 1)**2])  # up to 3 mm at the gauge side
        c, s = math.cos(0.025), math.sin(0.025)
        inclined = np.column_stack([c * y - s * z, s * y + c * z])  # to the track centre
        hint = "if that is its gauge side, y points the other way (--y, --mirror)"
        for name, points in (("worn", worn), ("inclined", inclined)):
            outward = write_table(self.folder / f"{name}.csv", points)
            inward = write_table(self.folder / f"{name}_inward.csv", points * [-1, 1])
            self.assertNotIn(hint, self.run_check(outward)[0])
            self.assertIn(hint, self.run_check(inward)[0])
            self.assertNotIn(hint, self.run_check(inward, "--y", "inward")[0])

    def test_name_of_a_file_need_not_be_utf_8(self):
        self.standard_rail()
        rail = Path(os.fsdecode(os.fsencode(self.folder) + b"/\xe9.csv"))
        (self.folder / "60E1_clean.csv").rename(rail)
        out, _ = self.run_check(rail, "--write", self.folder / "clean.csv")
        self.assertIn("/\ufffd.csv: rail, by its content\n", out)
        self.assertTrue(Path(f"{self.folder / 'pictures' / rail.name}.png").is_file())
        self.assertIn("/\ufffd.csv'\n", (self.folder / "clean.csv").read_text(encoding="utf-8"))

    def test_refused_file_does_not_stop_the_others(self):
        bad = write_table(self.folder / "bad.csv", [[0, 0], [1, 0]])
        out, err = self.run_check(bad, "60E1", self.folder / "none.csv", status=1)
        self.assertIn("60E1: rail, by its content", out)
        self.assertIn(f"check_profile: {bad}: number of points is 2, must be at least 10", err)
        self.assertIn("none.csv: neither the name of a standard profile", err)
        self.assertIn("2 of 3 files refused", err)
        self.assertEqual([path.name for path in (self.folder / "pictures").iterdir()], ["60E1.png"])

    def test_table_without_titles_is_refused_with_the_fitting_options(self):
        rail = write_table(self.folder / "rail.txt", self.standard_rail() * [1, -1], titles="", separator=" ")
        _, err = self.run_check(rail, "--rail", status=1)
        self.assertIn("unit: mm, y: inward or outward, z: down", err)
        _, err = self.run_check(rail, status=1)
        self.assertIn("as a wheel: ", err)
        self.assertIn("as a rail: ", err)
        self.assertNotIn("give --wheel or --rail", err)

    def test_dimensions_of_the_vehicle_are_options(self):
        points = wheel_points()
        model = write_table(self.folder / "model.csv", 0.2 * points)
        self.run_check(model, "--wheel", status=1)
        self.assertIn("model.csv: wheel, by option", self.run_check(model, "--wheel", "--scale", 0.2)[0])
        back = write_table(self.folder / "back.csv", points + [77.8, 0])
        self.run_check(back, "--wheel", "--origin", "flange_back", "--tape-circle", 0.0778, "--write", self.folder / "clean.csv")
        shifted = np.genfromtxt(self.folder / "clean.csv", delimiter=",", skip_header=1, comments="#")
        self.assertAlmostEqual(np.nanmin(shifted[:, 0]), points[0, 0], delta=0.01)

    def test_reversed_wheel_is_not_taken_for_a_rail(self):
        points = wheel_points()
        # A rim falls at the field side, and would make the lowest point of the turned wheel lie at its end.
        rim = np.column_stack([np.linspace(60.2, 64, 30), 3 + np.linspace(0, 4.3, 30)**2])
        wheel = write_table(self.folder / "turned.csv", -np.vstack([points, rim]))
        out, err = self.run_check(wheel, status=1)
        self.assertEqual(out, "")
        self.assertIn("both axes are reversed", err)

    def test_kind_by_option_and_by_extension(self):
        rail = write_table(self.folder / "rail.csv", self.standard_rail())
        self.assertIn("rail.csv: rail, by option", self.run_check(rail, "--rail")[0])
        out, err = self.run_check(rail, "--wheel", status=1)
        self.assertEqual(out, "")
        self.assertIn("rail.csv: ", err)
        self.assertNotIn("as a rail", err)
        named = write_table(self.folder / "rail.ban", self.standard_rail())
        self.assertIn("rail.ban: rail, by its extension", self.run_check(named)[0])

    def test_wrong_options_are_refused_with_name_and_value(self):
        rail = write_table(self.folder / "rail.csv", self.standard_rail())
        for arguments, message in ((("--unit", "km"), "parameter unit = km must be one of m, cm, mm, um, in"),
                                   (("--origin", "top"), "parameter origin = top must be"),
                                   (("--shift", "-36e0", 0), "parameter shift/y = -36"),
                                   (("--smoothing", 0.001), "parameter smoothing = 0.001"),
                                   (("--rotate", "nan"), "parameter rotate"),
                                   (("--scale", 5), "parameter scale = 5.0 must be above 0, at most 1"),
                                   (("--tape-circle", 0), "parameter tape_circle = 0"), (("--unit", "m"), "contradicts")):
            out, err = self.run_check(rail, *arguments, status=1)
            self.assertEqual(out, "", arguments)
            self.assertIn(message, err)

    def test_shift_that_cannot_be_written_is_refused(self):
        rail = write_table(self.folder / "rail.csv", self.standard_rail())
        clean = self.folder / "clean.csv"
        _, err = self.run_check(rail, "--shift", 0.05, 0, "--write", clean, status=1)
        self.assertRegex(err, r"no table is written: read again, its curve deviates by \d+")
        self.assertFalse(clean.exists())

    def test_equal_names_of_pictures_and_several_files_for_one_table_are_refused(self):
        out, err = self.run_check("a/rail.csv", "b/rail.csv", status=1)
        self.assertEqual(out, "")
        self.assertIn("rail.csv.png: two pictures would have this name", err)
        _, err = self.run_check("60E1", "S1002", "--write", self.folder / "clean.csv", status=1)
        self.assertEqual(err, "check_profile: --write: give only one FILE\n")

    def test_full_disk_is_reported_with_the_name_of_the_file(self):
        self.assertIn("60E1.png: File too large",
                      error_without_space(2**10, sys.executable, SCRIPTS / "check_profile", "60E1", "--out", self.folder))
