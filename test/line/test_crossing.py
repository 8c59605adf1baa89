# SPDX-License-Identifier: BSD-3-Clause
"""The example of a crossing: sections and states of make_crossing, their results and the report."""
import numpy as np
import rosbag
from line_case import LineCase
from matplotlib import image
from wheel_rail_contact.line import crossing
from wheel_rail_contact.report import command_line as report_command, running_band
from wheel_rail_contact.report.results import read
from wheel_rail_contact.states import command_line as states_command

LOAD = 80e3  # [N] of each wheel


class Crossing(LineCase):
    def make(self, *options):
        self.run_command(crossing.main, self.folder / "crossing", *options)

    def replay(self, *options):
        """Bag of the results on the crossing."""
        self.make("--step", 0.01)
        self.run_command(states_command.main, self.folder / "crossing" / "states.csv", self.folder / "states.bag")
        return self.replayed(self.folder / "states.bag", "--config", self.folder / "crossing" / "crossing.yaml", *options)

    def test_heads_have_the_given_size(self):
        for middle, top, half_width in ((0.0, 0.0, 0.036), (0.1, -0.004, 0.02)):
            points = crossing.head(middle, top, half_width, 0.12, 0.013)
            self.assertAlmostEqual(points[:, 0].min(), middle - half_width, delta=1e-12)
            self.assertAlmostEqual(points[:, 0].max(), middle + half_width, delta=1e-12)
            self.assertAlmostEqual(points[:, 1].max(), top, delta=1e-12)
            self.assertAlmostEqual(points[:, 1].min(), top - crossing.DEPTH, delta=1e-12)
            steps = np.hypot(*np.diff(points, axis=0).T)
            self.assertTrue(1e-4 < steps.min() and steps.max() <= crossing.SPACING + 1e-12)

    def test_wheel_goes_from_the_wing_rail_to_the_nose(self):
        results, _ = read(self.replay("--no-grids"))
        self.assertEqual(set(results.status), {0})
        np.testing.assert_allclose(results.distance, results.x, atol=1e-12)
        left = results.patches["side"] == 0
        result, y = results.patches["result"][left], results.patches["y"][left]
        force = results.patches["normal_force"][left] * np.cos(results.patches["contact_angle"][left])
        # The balance meets the load to a tenth of the tolerance of 1 %.
        np.testing.assert_allclose(np.bincount(result, force), LOAD, rtol=1e-3)
        place = results.distance[result]
        number = running_band.heads(place, y)
        self.assertEqual(number.max(), 1, "two heads")
        wing, nose = force * (number == 0), force * (number == 1)
        self.assertEqual(place[wing > 0].min(), place.min())
        self.assertEqual(place[nose > 0].max(), place.max())
        self.assertTrue(crossing.NOSE_BEGIN < place[nose > 0].min() <= place[wing > 0].max() < crossing.NOSE_END)
        # The wing rail moves outward by 1 in 10, the contact on it by at most as much.
        on_wing = (number == 0) & (place > 0)
        self.assertTrue(0 < np.ptp(y[on_wing]) < crossing.SLOPE * np.ptp(place[on_wing]) + 0.01)

    def test_outlines_of_the_results_are_those_of_the_sections(self):
        results, _ = read(self.replay("--no-grids"))
        self.assertEqual(results.sections[1], [])
        places = sorted({x for x, _ in results.sections[0]})
        self.assertEqual((places[0], places[-1]), (crossing.BEGIN, crossing.END))
        self.assertLessEqual(len(places), 201)
        # Placed by its gauge face: the innermost point down to 14 mm below the top, still on the corner.
        side = crossing.wing(crossing.BEGIN)[:100]
        offset = 0.7175 - np.interp(-0.014, side[:, 1], side[:, 0])
        for x in (-0.5, 0.0, 0.4, 1.0):
            outlines = [outline for place, outline in results.sections[0] if abs(place - x) < 1e-9]
            expected = [crossing.wing(x)] + ([crossing.nose(x)] if x >= crossing.NOSE_BEGIN else [])
            self.assertEqual(len(outlines), len(expected))
            for outline, points in zip(outlines, expected):
                self.assertEqual(outline.shape, (150, 2))
                # Rounded to 1 um; chords of 0.5 mm on a corner of 13 mm, at a slope of 1:8, are off by 0.3 um.
                np.testing.assert_allclose(outline[:, 0].min(), offset + points[:, 0].min(), atol=3e-6)
                np.testing.assert_allclose(outline[:, 0].max(), offset + points[:, 0].max(), atol=3e-6)
                self.assertTrue(-1e-5 < outline[:, 1].max() - points[:, 1].max() <= 2e-6)

    def test_surface_is_the_upper_side_of_the_outlines(self):
        square = np.array([[0.0, -1], [0, 0], [2, 0], [2, -1]])
        sections = [(0.0, square), (1.0, square + (0, 1)), (1.0, square + (1.0, 2))]
        across = np.linspace(-0.5, 3.5, 401)
        heights = running_band.surface(sections, np.array([0.0, 0.2, 1.0]), across)
        for y, *expected in ((-0.3, np.nan, np.nan, np.nan), (0.5, 0, 0, 1), (1.5, 0, 0, 2), (2.5, np.nan, np.nan, 2)):
            np.testing.assert_allclose(heights[np.argmin(abs(across - y))], expected, atol=1e-12)
        # Between two places with the same parts, the outlines are interpolated.
        shifted = running_band.surface([(0.0, square), (1.0, square + (0.01, 1))], np.array([0.5]), across)
        np.testing.assert_allclose(shifted[np.argmin(abs(across - 1))], 0.5, atol=1e-12)

    def test_contacts_far_apart_are_on_different_heads(self):
        place = np.array([0.0, 0.0, 0.01, 0.01, 0.02, 0.5])
        across = np.array([0.0, 0.02, 0.001, 0.021, 0.002, 0.002])
        np.testing.assert_array_equal(running_band.heads(place, across), [0, 1, 0, 1, 0, 2])

    def test_report_has_a_picture_from_above(self):
        bag, out = self.replay(), self.folder / "report"
        self.run_command(report_command.main, bag, "--out", out)
        self.assertIn("<h2>Running band from above</h2>", (out / "report.html").read_text(encoding="utf-8"))
        pixels = image.imread(str(out / "running_band_0.png"))
        self.assertGreater(len(np.unique(pixels.reshape(-1, pixels.shape[2]), axis=0)), 100)
        self.assertFalse((out / "running_band_1.png").exists(), "the right rail does not change")

    def test_results_on_constant_rails_have_no_sections(self):
        self.make("--step", 0.1)
        self.run_command(states_command.main, self.folder / "crossing" / "states.csv", self.folder / "states.bag")
        config = self.config("wheel: {profile: S1002}\nrail: {profile: 60E1}\n")
        plain = self.replayed(self.folder / "states.bag", "--config", config)
        results, _ = read(plain)
        self.assertEqual(results.sections, [[], []])
        self.assertFalse(running_band.can_draw(results, 0))
        with rosbag.Bag(str(plain)) as bag:
            _, message, _ = next(bag.read_messages())
        self.assertEqual(message.distance, message.wheelset.position.x)

    def test_invalid_options_are_refused(self):
        for options, reason in ((("--load", 0), "--load 0.0: must be above 0"), (("--step", "nan"), "--step nan"),
                                (("--y", "inf"), "--y inf: must be a finite number")):
            with self.subTest(options=options):
                printed = self.run_command(crossing.main, self.folder / "crossing", *options, status=1)
                self.assertIn(reason, printed)
                self.assertFalse((self.folder / "crossing").exists())
        (self.folder / "crossing").mkdir()
        self.run_command(crossing.main, self.folder / "crossing", status=1)
