# SPDX-License-Identifier: BSD-3-Clause
import contextlib
import io
import math
import os
import tempfile
import unittest
from dataclasses import replace
from pathlib import Path
from unittest import mock

from wheel_rail_contact.chart import front
from wheel_rail_contact.chart.command_line import main
from wheel_rail_contact.chart.measuring import RUNNER, measure
from wheel_rail_contact.chart.table import Row
from wheel_rail_contact.command import Failure, finish, pyplot, runner
from wheel_rail_contact.progress import Progress

ROW = Row("scene", "Scene", "normal", "hertz", 8, 16, 0.0, "warm", "answered", "", 1e-3, 1e-3, 1e-3, 5, "hertz", 0.01,
          0.01, 0.0, 0.0, 0.02, 1e-4)


class Misuse(unittest.TestCase):
    def check(self, complaint, out):
        err = io.StringIO()
        with contextlib.redirect_stderr(err):
            status = main(["--out", str(out)])
        self.assertEqual(status, 1)
        self.assertIn(complaint, err.getvalue())
        self.assertIn(str(out), err.getvalue())
        self.assertEqual(err.getvalue().count("\n"), 1, "one sentence, at once")

    def test_a_place_that_cannot_be_written_to_is_named(self):
        with tempfile.TemporaryDirectory() as place:
            file = Path(place, "file")
            file.touch()
            self.check("there is no such folder", Path(place, "absent"))
            self.check("there is no such folder", file)
        self.check("cannot be written to", "/proc")

    def test_a_missing_or_failing_runner_is_a_sentence(self):
        with mock.patch.dict(os.environ, {"CMAKE_PREFIX_PATH": ""}), mock.patch("sys.argv", ["nowhere/contact_chart"]):
            with self.assertRaisesRegex(Failure, "was not found"):
                runner(RUNNER)
        with self.assertRaisesRegex(Failure, "failed"):
            measure("false", False, mock.Mock())


class Ending(unittest.TestCase):
    def end(self, work):
        err = io.StringIO()
        with contextlib.redirect_stderr(err):
            return finish("name", work), err.getvalue()

    def test_a_failure_is_a_sentence_and_an_interruption_is_told(self):
        self.assertEqual(self.end(lambda: None), (0, ""))
        self.assertEqual(self.end(mock.Mock(side_effect=Failure("why"))), (1, "name: why\n"))
        status, err = self.end(lambda: open("/nowhere/absent", encoding="ascii"))
        self.assertEqual((status, err.count("\n")), (1, 1))
        self.assertEqual(self.end(mock.Mock(side_effect=KeyboardInterrupt)), (130, "\nname: interrupted\n"))

    def test_missing_matplotlib_is_a_sentence(self):
        with mock.patch.dict("sys.modules", {"matplotlib": None}):
            status, err = self.end(pyplot)
        self.assertEqual((status, err), (1, "name: matplotlib is not installed; on Debian: "
                                            "apt install python3-matplotlib\n"))


class ProgressBar(unittest.TestCase):
    def test_bar_on_a_terminal_lines_elsewhere(self):
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
    def test_pareto_front_keeps_what_nothing_beats(self):
        self.assertEqual(front.pareto([(3, 1), (1, 5), (2, 6), (2, 3), (4, 1)]), [(1, 5), (2, 3), (3, 1)])

    def test_median_counts_no_answer_as_the_largest_error(self):
        answers = [replace(ROW, scene=str(k), error=error) for k, error in enumerate((1e-3, 1e-2, 1e-1))]
        refusal = replace(ROW, scene="3", status="refused", reason="why", error=None)
        time, error, answered, scenes = front.over_scenes([*answers, refusal])["hertz", (8, 16)]
        self.assertAlmostEqual(time, 1e-3)
        self.assertAlmostEqual(error, math.sqrt(1e-2 * 1e-1))
        self.assertEqual((answered, scenes), (3, 4))
        _, error, _, _ = front.over_scenes([answers[0], refusal, replace(refusal, scene="4")])["hertz", (8, 16)]
        self.assertEqual(error, math.inf)

    def test_standing_compares_with_the_cheapest_that_will_do(self):
        fixed = [replace(ROW, time=time, error=error) for time, error in ((1.0, 0.02), (2.0, 0.008), (4.0, 0.001))]
        auto = replace(ROW, method="auto", tolerance=0.01, time=3.0, error=0.004)
        [stand] = front.standing([*fixed, auto])
        self.assertEqual((stand.scenes, stand.met, stand.ratio, stand.on_front), (1, 1, 1.5, 1))
        [stand] = front.standing([*fixed, replace(auto, error=0.02)])
        self.assertEqual((stand.met, stand.on_front), (0, 0))
        beyond_all = replace(auto, scene="hard", error=0.02)
        [stand] = front.standing([*fixed, auto, replace(fixed[0], scene="hard"), beyond_all])
        self.assertEqual((stand.scenes, stand.met, stand.ratio, stand.largest_ratio), (2, 1, 1.5, 1.5))


if __name__ == "__main__":
    unittest.main()
