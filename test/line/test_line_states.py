# SPDX-License-Identifier: BSD-3-Clause
"""The example of doc/line.md: states of a wheelset on a line with irregularities, their results and the report."""
from unittest import mock

import numpy as np
import rosbag
from line_case import LineCase, columns_of
from matplotlib import image
from wheel_rail_contact.line import command_line, running
from wheel_rail_contact.report import along_line, command_line as report_command
from wheel_rail_contact.report.results import read
from wheel_rail_contact.states import command_line as states_command

STIFFNESS = 0.05 / (0.75 * 0.46)  # conicity / (half base × radius) [1/m²]
DAMPING = 2 * 0.15 * np.sqrt(STIFFNESS)


class LineStates(LineCase):
    def setUp(self):
        super().setUp()
        self.run_command(command_line.main, self.folder / "line.csv")

    def states(self, *options):
        (self.folder / "states.csv").unlink(missing_ok=True)
        self.run_command(running.main, self.folder / "line.csv", self.folder / "states.csv", *options)
        return columns_of(self.folder / "states.csv")

    def replay(self, *options):
        """Results of the states on the line."""
        self.run_command(states_command.main, self.folder / "states.csv", self.folder / "states.bag")
        config = self.config(f"wheel: {{profile: S1002}}\nrail: {{profile: 60E1}}\ntrack: {{line: {self.folder}/line.csv}}\n")
        return self.replayed(self.folder / "states.bag", "--config", config, *options)

    def test_path_follows_the_alignment_by_the_equation_of_klingel(self):
        line, states = columns_of(self.folder / "line.csv"), self.states()
        x, y = states["x"], states["y"]
        step = x[1] - x[0]
        self.assertAlmostEqual(step, 0.1, delta=1e-12)
        self.assertEqual((x[0], x[-1]), (0, 200))
        tilt = np.interp(x, line["x"], line["cross_level"]) / 1.507
        # On a tilted track a wheelset in its middle has its centre 0.46 m above the slope.
        alignment = np.interp(x, line["x"], (line["alignment_left"] + line["alignment_right"]) / 2) - 0.46 * tilt
        slope, bend = (y[2:] - y[:-2]) / (2 * step), (y[2:] - 2 * y[1:-1] + y[:-2]) / step**2
        # Differences over 0.1 m; the alignment has kinks every 0.25 m. The curvatures are up to 5e-4 1/m.
        np.testing.assert_allclose(bend, -STIFFNESS * (y - alignment)[1:-1] - DAMPING * slope, atol=6e-6)
        np.testing.assert_allclose(states["yaw"][1:-1], 1e3 * slope, atol=2e-3)  # [mrad], pure rolling
        # Moments of the inertia force of 200 kN, 1.2 m above the axle, at 40 m/s, and of the weight [kN m].
        np.testing.assert_allclose(states["torque_x"][1:-1], 1.2 * 200 * (40**2 / 9.81 * bend + tilt[1:-1]), atol=0.3)

    def test_columns_of_the_track_give_the_same_path(self):
        expected = self.states()
        (self.folder / "line.csv").unlink()
        self.run_command(command_line.main, self.folder / "line.csv", "--columns", "track")
        np.testing.assert_allclose(self.states()["y"], expected["y"], atol=2e-7)  # lines are rounded to 0.1 um

    def test_results_have_the_displacements_of_the_line(self):
        states, line = self.states("--step", 0.25), columns_of(self.folder / "line.csv")
        np.testing.assert_allclose(states["x"], line["x"], atol=1e-12)
        with rosbag.Bag(str(self.replay("--no-grids"))) as bag:
            results = [message for _, message, _ in bag.read_messages()]
        self.assertEqual({result.status for result in results}, {0})
        tilt = line["cross_level"] / 1.5075  # distance of the reference points, 0.1 %
        for side, sign in (("left", 1), ("right", -1)):
            rails = [getattr(result, f"{side}_rail") for result in results]
            # The reference point is 14 mm below the plane of the rail tops: a tilt to the right moves it to the left.
            lateral = sign * line[f"alignment_{side}"] + sign * 0.014 * tilt
            vertical = (line["level_left"] + line["level_right"]) / 2 + sign * line["cross_level"] / 2
            # 10 um: products of the tilt (up to 3 mrad) and the level (up to 3 mm).
            np.testing.assert_allclose([rail.given_lateral for rail in rails], lateral, atol=1e-5)
            np.testing.assert_allclose([rail.given_vertical for rail in rails], vertical, atol=1e-5)
            np.testing.assert_allclose([rail.given_roll for rail in rails], -sign * tilt, atol=1e-5)

    def test_report_has_a_picture_along_the_line_if_the_wheelset_travels(self):
        self.states()
        bag, out = self.replay(), self.folder / "report"
        self.run_command(report_command.main, bag, "--out", out)
        self.assertIn("<h2>Along the line</h2>", (out / "report.html").read_text(encoding="utf-8"))
        pixels = image.imread(str(out / "along_line.png"))
        self.assertGreater(len(np.unique(pixels.reshape(-1, pixels.shape[2]), axis=0)), 100)
        results, _ = read(bag)
        for side in (0, 1):
            contacts = 1e3 * along_line.contacts_on_rail(results, side)
            self.assertEqual(len(contacts), (results.patches["side"] == side).sum())
            # The wheelset moves up to 5 mm towards a rail: contacts from the gauge corner to the crown.
            self.assertTrue(-20 < contacts.min() < -10 < 0 < contacts.max() < 10, (contacts.min(), contacts.max()))
        self.assertTrue(along_line.travels(results))
        results.x = np.linspace(0, 0.9, len(results.x))
        self.assertFalse(along_line.travels(results))
        # Rejected inputs may have no pose.
        results.x[0], results.status[0] = 100, 4
        results.patches = {name: values[2:] for name, values in results.patches.items()}
        self.assertFalse(along_line.travels(results))

    def test_pictures_of_several_passes_have_equal_scales_and_no_empty_panel(self):
        forth = np.linspace(0, 30, 301)
        for x, expected in ((np.r_[forth, forth], [(0, 301), (301, 602)]), (np.r_[forth[::-1], forth], [(0, 301), (301, 602)]),
                            (np.r_[np.nan, forth + 0.4 * np.sin(9 * forth), np.nan, forth + 40], [(0, 604)])):
            self.assertEqual([(part.start, part.stop) for part in along_line.passes(x)], expected)
        self.states()
        results, _ = read(self.replay("--no-grids"))
        results.x[1200:] -= 120
        right = results.patches["side"] == 1
        results.patches = {name: values[~right] for name, values in results.patches.items()}
        with mock.patch.object(along_line, "save", lambda figure, _: figure):
            drawn = along_line.figures(results, self.folder)
        panels = [figure.axes[:-1] for figure in drawn]  # the last one is the scale of the colours
        self.assertEqual([panel.has_data() for row in panels for panel in row], 2 * 4 * [True])
        for one, other in zip(*panels):
            self.assertEqual((one.get_xlim(), one.get_ylim()), ((0, results.x[1199]), other.get_ylim()))

    def test_invalid_options_and_tables_are_refused(self):
        for name, quantity in (("other", "level [mm]"), ("empty", ""), ("curve", "curvature [1/km]")):
            (self.folder / f"{name}.csv").write_text(f"x [m],{quantity}\n0,1\n1,2\n2,1\n" if quantity else "")
        for line, options, reason in (("line.csv", ("--speed", 0), "--speed 0.0: must be above 0"),
                                      ("line.csv", ("--step", "nan"), "--step nan: must be above 0"),
                                      ("line.csv", ("--step", 500), "is longer than the line"),
                                      ("other.csv", (), "not a table of make_irregular_line"),
                                      ("curve.csv", (), "has a column 'curvature [1/km]', but"),
                                      ("empty.csv", (), "not a table of make_irregular_line"),
                                      ("absent.csv", (), "No such file")):
            with self.subTest(line=line, options=options):
                printed = self.run_command(running.main, self.folder / line, self.folder / "states.csv", *options, status=1)
                self.assertIn(reason, printed)
                self.assertFalse((self.folder / "states.csv").exists())
