# SPDX-License-Identifier: BSD-3-Clause
"""make_irregular_line: the lines have the power spectral densities of ORE B176."""
import filecmp

import numpy as np
from line_case import LineCase, columns_of
from wheel_rail_contact.line.command_line import main

# ORE B176 RP1 (1989): factors for alignment and level [rad m].
FACTORS = {"low": (2.119e-7, 4.032e-7), "high": (6.125e-7, 1.080e-6)}
D1 = (3.0, 25.0)  # wavelengths [m], EN 13848-1
BASE = 1.5        # [m] 2 b


def expected_densities(w, level):
    """One-sided densities of alignment, level and height of the cross level [m² / (rad/m)] at wavenumbers [rad/m]."""
    a, v = FACTORS[level]
    common = 0.8246**2 / ((w**2 + 0.0206**2) * (w**2 + 0.8246**2))
    angle = v / 0.75**2 * common * w**2 / (w**2 + 0.4380**2)
    return {"alignment": a * common, "level": v * common, "cross_level": BASE**2 * angle}


def measured_density(values, length):
    """One-sided density of periodic values [m² / (rad/m)], and its wavenumbers [rad/m]."""
    step = 2 * np.pi / length
    amplitudes = 2 * np.abs(np.fft.rfft(values)) / len(values)
    return step * np.arange(len(amplitudes)), amplitudes**2 / 2 / step


class IrregularLine(LineCase):
    def line(self, *options, name="line.csv"):
        self.run_command(main, self.folder / name, *options)
        return columns_of(self.folder / name)

    def refusal(self, *options):
        printed = self.run_command(main, self.folder / "refused.csv", *options, status=1)
        self.assertFalse((self.folder / "refused.csv").exists())
        return printed

    def test_spectrum_is_that_of_the_formula_within_the_wavelengths_and_zero_outside(self):
        length = 2000.0
        for level in FACTORS:
            line = self.line("--length", length, "--level", level, "--columns", "track", name=f"{level}.csv")
            for name, density in expected_densities(measured_density(line["level"][:-1], length)[0][1:], level).items():
                w, measured = measured_density(line[name][:-1], length)
                w, measured = w[1:], measured[1:]
                inside = (w > 2 * np.pi / D1[1] + w[0]) & (w < 2 * np.pi / D1[0] - w[0])
                outside = (w < 2 * np.pi / D1[1] - w[0]) | (w > 2 * np.pi / D1[0] + w[0])
                self.assertGreater(inside.sum(), 500)
                # 3 %: values are rounded to 0.1 um; the smallest amplitude is 6 um. Change of the density within an interval.
                np.testing.assert_allclose(measured[inside], density[inside], rtol=0.03, err_msg=f"{level} {name}")
                self.assertLess(measured[outside].max(), 1e-4 * density[inside].min(), f"{level} {name}")

    def test_standard_deviations_in_d1_are_those_of_the_formula_for_all_seeds(self):
        w = np.linspace(2 * np.pi / D1[1], 2 * np.pi / D1[0], 200001)
        for level in FACTORS:
            for seed in (1, 2, 3):
                line = self.line("--level", level, "--seed", seed, "--columns", "track", name=f"{level}{seed}.csv")
                for name, density in expected_densities(w, level).items():
                    variance = ((density[1:] + density[:-1]) / 2).sum() * (w[1] - w[0])
                    # 0.1 %: values are rounded to 0.1 um.
                    self.assertAlmostEqual(np.std(line[name][:-1]) / np.sqrt(variance), 1, delta=1e-3)
                    self.assertAlmostEqual(line[name][:-1].mean(), 0, delta=1e-7)

    def test_same_seed_gives_the_same_file_and_another_seed_another_line(self):
        first, again, other = (self.line("--seed", seed, name=name) for seed, name in ((5, "a.csv"), (5, "b.csv"), (6, "c.csv")))
        self.assertTrue(filecmp.cmp(self.folder / "a.csv", self.folder / "b.csv", shallow=False))
        self.assertTrue(all((first[name] == again[name]).all() for name in first))
        for name in ("gauge", "alignment_left", "level_left", "cross_level"):
            self.assertLess(abs(np.corrcoef(first[name], other[name])[0, 1]), 0.5, name)

    def test_quantities_do_not_depend_on_each_other(self):
        line = self.line("--length", 5000, "--columns", "track")
        correlations = np.corrcoef([line[name] for name in ("gauge", "alignment", "level", "cross_level")])
        # 500 waves: a correlation of random phases has a standard deviation of about 0.05.
        self.assertLess(np.abs(correlations - np.eye(4)).max(), 0.2)

    def test_columns_of_the_rails_are_those_of_the_track(self):
        track, rails = (self.line("--columns", columns, name=f"{columns}.csv") for columns in ("track", "rails"))
        for middle in ("alignment", "level"):
            mean = (rails[f"{middle}_left"] + rails[f"{middle}_right"]) / 2
            np.testing.assert_allclose(mean, track[middle], atol=1.1e-7)  # rounded to 0.1 um
        for name in ("gauge", "cross_level", "x"):
            np.testing.assert_array_equal(rails[name], track[name])
        np.testing.assert_allclose(rails["alignment_left"] - rails["alignment_right"], rails["gauge"] - 1.435, atol=1.6e-7)
        np.testing.assert_allclose(rails["level_left"] - rails["level_right"], rails["cross_level"], atol=1.6e-7)

    def test_options_set_length_spacing_wavelengths_and_gauge(self):
        line = self.line("--length", 90, "--spacing", 0.5, "--wavelengths", 9, 30, "--gauge", 1, "--gauge-variation", 2)
        np.testing.assert_allclose(line["x"], 0.5 * np.arange(181), atol=1e-12)
        for name in line:
            if name != "x":
                self.assertEqual(line[name][0], line[name][-1], "the line can be repeated")
        self.assertAlmostEqual(line["gauge"][:-1].mean(), 1, delta=1e-7)
        self.assertAlmostEqual(np.std(line["gauge"][:-1]), 2e-3, delta=1e-7)
        w, density = measured_density(line["alignment_left"][:-1], 90)
        self.assertLess(density[(w > 1.2 * 2 * np.pi / 9)].max(), 1e-4 * density.max())
        constant = self.line("--gauge-variation", 0, name="constant.csv")
        self.assertTrue((constant["gauge"] == 1.435).all())

    def test_invalid_options_are_refused(self):
        for options, reason in ((("--length", 0), "--length 0.0: must be above 0"), (("--length", "nan"), "must be above 0"),
                                (("--spacing", -1), "--spacing"), (("--gauge", 0), "--gauge"),
                                (("--gauge-variation", -1), "must not be negative"),
                                (("--wavelengths", 25, 3), "the first one must be the shorter one"),
                                (("--spacing", 1), "at least 4 times the spacing"),
                                (("--length", 20), "must not be above the length")):
            with self.subTest(options=options):
                printed = self.refusal(*options)
                self.assertIn(reason, printed)
                self.assertEqual(printed.count("\n"), 1, printed)

    def test_existing_files_are_kept_and_paths_that_cannot_be_written_are_reported(self):
        (self.folder / "line.csv").write_text("precious")
        self.assertIn("line.csv", self.run_command(main, self.folder / "line.csv", status=1))
        self.assertEqual((self.folder / "line.csv").read_text(), "precious")
        self.assertIn("/sys/line.csv", self.run_command(main, "/sys/line.csv", status=1))
