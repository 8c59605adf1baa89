# SPDX-License-Identifier: BSD-3-Clause
import io
import math
import unittest
from dataclasses import replace
from unittest import mock
from commands import FolderCase, running
from wheel_rail_contact.chart import front, summary_picture
from wheel_rail_contact.chart.command_line import main
from wheel_rail_contact.chart.table import SOLVED, Row
from wheel_rail_contact.command import Failure, finish, output_folder, pyplot
from wheel_rail_contact.progress import Progress

ROW = Row("scene", "Scene", "normal", "hertz", 8, 16, 0.0, "warm", SOLVED, "", 1e-3, 1e-3, 1e-3, 4e-3, 5, 0.01, 0.01,
          0.0, 0.0, 0.02, 1e-4)


class Misuse(FolderCase):
    def test_missing_folder_is_created_and_an_unusable_one_is_reported_by_name(self):
        output_folder(self.folder / "new" / "folder")
        self.assertEqual(list(self.folder.rglob("*")), [self.folder / "new", self.folder / "new" / "folder"])
        for out, reason in ((__file__, "is not a folder"), ("/proc", "no file can be written to this folder")):
            self.assertRegex(self.run_command(main, "--out", out, status=1), rf"\Acontact_chart: --out {out}: {reason}.*\n\Z")


class ExitStatus(unittest.TestCase):
    def end(self, work):
        return running(lambda _: finish("name", work))()[::2]

    def test_failure_and_interruption_are_reported_in_one_line(self):
        self.assertEqual(self.end(lambda: None), (0, ""))
        self.assertEqual(self.end(mock.Mock(side_effect=Failure("why"))), (1, "name: why\n"))
        status, err = self.end(lambda: open("/nowhere/absent", encoding="ascii"))
        self.assertEqual((status, err.count("\n")), (1, 1))
        self.assertEqual(self.end(mock.Mock(side_effect=KeyboardInterrupt)), (130, "\nname: interrupted\n"))

    def test_missing_matplotlib_is_reported_in_one_line(self):
        with mock.patch.dict("sys.modules", {"matplotlib": None}):
            status, err = self.end(pyplot)
        self.assertEqual((status, err), (1, "name: matplotlib is not installed; on Debian: apt install python3-matplotlib\n"))


class ProgressBar(unittest.TestCase):
    def test_progress_is_a_bar_on_a_terminal_and_lines_elsewhere(self):
        for terminal in (True, False):
            stream = io.StringIO()
            stream.isatty = lambda terminal=terminal: terminal
            progress = Progress(stream)
            for done in (1, 2, 3):
                progress(done, 4, "first" if done < 3 else "second")
            progress.end()
            self.assertEqual(stream.getvalue().count("\r"), 3 if terminal else 0)
            self.assertEqual(stream.getvalue().count("\n"), 1 if terminal else 2)
            self.assertIn("75 %", stream.getvalue())


class Front(unittest.TestCase):
    def test_pareto_front_contains_the_points_that_no_other_point_improves(self):
        self.assertEqual(front.pareto([(3, 1), (1, 5), (2, 6), (2, 3), (4, 1)]), [(1, 5), (2, 3), (3, 1)])

    def test_missing_result_counts_as_the_largest_error_in_the_median(self):
        solved = [replace(ROW, scene=str(k), error=error) for k, error in enumerate((1e-3, 1e-2, 1e-1))]
        refused = replace(ROW, scene="3", status="refused", reason="why", error=None)
        time, error = front.over_scenes([*solved, refused])["hertz", (8, 16)]
        self.assertAlmostEqual(time, 1e-3)
        self.assertAlmostEqual(error, math.sqrt(1e-2 * 1e-1))
        _, error = front.over_scenes([solved[0], refused, replace(refused, scene="4")])["hertz", (8, 16)]
        self.assertEqual(error, math.inf)

    def test_longest_time_is_that_of_the_worst_scene(self):
        rows = [replace(ROW, scene="1", time_longest=7e-3), replace(ROW, scene="2"),
                replace(ROW, scene="3", time=8e-3, time_longest=None)]
        self.assertEqual(front.longest_times(rows[:2])["hertz", (8, 16)], 7e-3)
        self.assertEqual(front.longest_times(rows)["hertz", (8, 16)], 8e-3)

    def test_auto_is_compared_with_the_fastest_method_within_the_tolerance(self):
        fixed = [replace(ROW, time=time, error=error) for time, error in ((1.0, 0.02), (2.0, 0.008), (4.0, 0.001))]
        auto = replace(ROW, method="auto", tolerance=0.01, time=3.0, error=0.004)
        [found] = front.compare_auto([*fixed, auto])
        self.assertEqual((found.scenes, found.met, found.ratio, found.on_front), (1, 1, 1.5, 1))
        [found] = front.compare_auto([*fixed, replace(auto, error=0.02)])
        self.assertEqual((found.met, found.on_front), (0, 0))
        missed = replace(auto, scene="hard", error=0.02)
        [found] = front.compare_auto([*fixed, auto, replace(fixed[0], scene="hard"), missed])
        self.assertEqual((found.scenes, found.met, found.ratio, found.largest_ratio), (2, 1, 1.5, 1.5))

    def test_medians_of_auto_are_compared_with_those_of_the_same_accuracy(self):
        fixed = [replace(ROW, cells_along=along, time=time, error=error)
                 for along, time, error in ((8, 1.0, 0.02), (16, 2.0, 0.008), (32, 4.0, 0.001))]
        autos = [replace(ROW, method="auto", tolerance=tolerance, time=3.0, error=error)
                 for tolerance, error in ((0.01, 0.004), (0.1, 0.03))]
        for (tolerance, factor), expected in zip(front.compare_medians([*fixed, *autos]), ((0.1, 3.0), (0.01, 0.75))):
            self.assertEqual(tolerance, expected[0])
            self.assertAlmostEqual(factor, expected[1])


class Summary(unittest.TestCase):
    def test_scenes_with_exact_hertz_formula_are_excluded_from_the_normal_problems(self):
        def scene(name, kind, error):
            return [replace(ROW, scene=name, kind=kind, error=error),
                    replace(ROW, scene=name, kind=kind, method="auto", tolerance=0.01)]
        ellipse, lobes = scene("ellipse", "normal", 1e-4), scene("lobes", "normal", 0.2)
        wheelset = scene("wheelset", "wheelset", 0.2)
        rows = [*ellipse, *lobes, *wheelset]
        self.assertEqual(summary_picture.general_gaps(rows), lobes)
        self.assertEqual(summary_picture.wheelsets(rows), wheelset)

    def test_points_are_medians_in_ms_and_percent_without_missing_results(self):
        refused = replace(ROW, cells_along=16, status="refused", reason="why", error=None)
        auto = replace(ROW, method="auto", tolerance=0.003, time=2e-3, error=0.002)
        points = summary_picture.medians([ROW, refused, auto])
        self.assertEqual(set(points), {"hertz", "auto"})
        for method, expected, label in (("hertz", (1.0, 1.0, 4.0), "8×16"), ("auto", (2.0, 0.2, 4.0), "0.3 %")):
            [(time, error, text, longest)] = points[method]
            for value, target in zip((time, error, longest), expected):
                self.assertAlmostEqual(value, target)
            self.assertEqual(text, label)
