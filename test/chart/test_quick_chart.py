# SPDX-License-Identifier: BSD-3-Clause
"""The whole command with --quick, run once."""
import csv
import os
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

from matplotlib import image
from matplotlib.colors import to_rgb

from wheel_rail_contact.chart import creep, table
from wheel_rail_contact.chart.front import compare_auto
from wheel_rail_contact.chart.picture import METHODS

SCENES = {"hertz_1_1", "hertz_1_5", "discontinuity", "two_patches", "lobes", "conformal", "manchester_0",
          "manchester_0.5", "manchester_3", "manchester_5", "manchester_6.5", "onset_4.38", "paper", "pads_5", "moments_2"}
GRIDS = {(8, 16), (12, 24), (16, 32), (16, 48), (24, 64), (32, 96), (48, 128), (64, 192)}
TOLERANCES = {0.1, 0.03, 0.01, 0.003}
SVG = "{http://www.w3.org/2000/svg}"


def command():
    """Path of contact_chart in the workspace."""
    prefixes = os.environ["CMAKE_PREFIX_PATH"].split(os.pathsep)
    return next(path for path in (Path(prefix, "lib", "wheel_rail_contact", "contact_chart") for prefix in prefixes)
                if path.is_file())


def words(drawing):
    return " ".join("".join(text.itertext()) for text in drawing.iter(f"{SVG}text"))


class QuickChart(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.place.cleanup)
        cls.out = Path(cls.place.name)
        cls.ended = subprocess.run([command(), "--quick", "--out", cls.out], capture_output=True, text=True, check=False)
        if cls.ended.returncode != 0:
            raise AssertionError(cls.ended.stderr)
        cls.facts, cls.rows = table.read(cls.out / "chart.csv")

    def test_every_method_grid_and_scene_has_a_result_or_a_reason(self):
        keys = [(row.scene, row.method, row.setting, row.start) for row in self.rows]
        self.assertEqual(len(keys), len(set(keys)))
        expected = {(scene, method, setting, start) for scene in SCENES for method in METHODS
                    for setting in (TOLERANCES if method == "auto" else GRIDS) for start in ("cold", "warm")}
        self.assertEqual(set(keys), expected)
        for row in self.rows:
            with self.subTest(row=row):
                self.assertGreater(row.time, 0)
                self.assertLessEqual(row.time_quartile_1, row.time)
                self.assertLessEqual(row.time, row.time_quartile_3)
                self.assertEqual(row.time_longest is None, row.start == "cold" or row.status == "not_run")
                self.assertEqual(row.has_result, row.error is not None)
                self.assertEqual(row.has_result, not row.reason)
                self.assertEqual(row.samples == 0, row.status == "not_run")
                if row.has_result:
                    self.assertEqual(row.error, max(row.error_max_pressure, row.error_area, row.error_approach))

    def test_table_states_machine_and_build(self):
        self.assertEqual(set(self.facts), {"machine", "version", "compiler", "build", "truth", "reach"})
        self.assertTrue(all(self.facts.values()), self.facts)

    def test_auto_meets_its_tolerances(self):
        # Tolerances are met in nearly all scenes: one scene may miss.
        for start in ("cold", "warm"):
            for found in compare_auto([row for row in self.rows if row.start == start]):
                self.assertEqual(found.scenes, len(SCENES))
                self.assertGreaterEqual(found.met, found.scenes - 1, f"{start}, {found.tolerance}")

    def test_error_of_the_reference_is_small(self):
        for row in self.rows:
            self.assertLess(row.truth_error, 0.003, row.scene)

    def test_pictures_show_every_method(self):
        for name in ("chart.png", "chart_scenes.png"):
            pixels = image.imread(str(self.out / name))[..., :3]
            self.assertGreater(min(pixels.shape[:2]), 1000)
            for method, (_, colour, _) in METHODS.items():
                close = abs(pixels - to_rgb(colour)).max(axis=2) < 0.02
                self.assertGreater(close.sum(), 100, f"{name}, {method}")

    def panels(self, name):
        """Number of panels of an SVG picture, and its drawing."""
        drawing = xml.etree.ElementTree.parse(self.out / name).getroot()
        return sum(re.fullmatch(r"axes_\d+", group.get("id", "")) is not None for group in drawing.iter(f"{SVG}g")), drawing

    def test_summary_has_two_panels_readable_in_a_browser(self):
        number, drawing = self.panels("chart.svg")
        self.assertEqual(number, 2)
        width = float(drawing.get("viewBox").split()[2])
        sizes = [float(re.search(r"([\d.]+)px", text.get("style")).group(1)) for text in drawing.iter(f"{SVG}text")]
        self.assertGreaterEqual(830 / width * min(sizes), 11)  # [px] of a picture shown 830 px wide
        self.assertIn(self.facts["machine"], words(drawing))

    def test_picture_of_scenes_has_a_panel_for_each(self):
        number, drawing = self.panels("chart_scenes.svg")
        self.assertEqual(number, len(SCENES) + 3)  # two of medians, the legend
        for title in {row.title for row in self.rows}:
            self.assertIn(title, words(drawing))
        self.assertIn(self.facts["machine"], words(drawing))

    def test_creep_forces_have_a_row_for_every_state_and_the_errors_of_their_methods(self):
        lines = (self.out / "chart_creep.csv").read_text(encoding="utf-8").splitlines()
        rows = [creep.CreepRow(*(text if name == "method" else float(text) for name, text in record.items()))
                for record in csv.DictReader(line for line in lines if not line.startswith("# "))]
        self.assertEqual(len(rows), len(creep.RATIOS) * len(creep.STATES) * sum(map(len, creep.GRIDS.values())))
        without, with_spin = (creep.summary(rows, spin) for spin in (False, True))
        for points in without, with_spin:  # (median time, median, largest, largest of the force)
            self.assertLess(points["exact", (24, 64)][2], 0.03)
            self.assertLess(0, points["fastsim", (24, 64)][0], points["exact", (24, 64)][0])
        self.assertGreater(with_spin["linear", (8, 16)][1], 0.3)  # the linear law fails with spin

    def test_picture_of_creep_forces_has_a_panel_without_and_with_spin(self):
        number, drawing = self.panels("chart_creep.svg")
        self.assertEqual(number, 2)
        self.assertRegex(words(drawing), "Without spin.*With spin.*48 × 64 cells")

    def test_progress_names_every_scene(self):
        for title in {row.title for row in self.rows} | {f"creep forces, a/b = {ratio:g}" for ratio in creep.RATIOS}:
            self.assertIn(title, self.ended.stderr)
