# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of contact_report: scales, gaps, marks and labels of the figures, before they are written to files."""
import copy
import html
import subprocess
import sys
import types
import unittest
from unittest import mock

import genpy
import numpy as np
import rosbag
from sweep_case import PACKAGE, SweepCase
from wheel_rail_contact.checking.axle import history
from wheel_rail_contact.checking.bounds import judge, read_limits, sample
from wheel_rail_contact.command import pyplot
from wheel_rail_contact.msg import WheelsetContact
from wheel_rail_contact.report import axle, drawing, histories, marks, positions, pressure, running_band
from wheel_rail_contact.report.command_line import main
from wheel_rail_contact.report.loops import loop_of, loops
from wheel_rail_contact.report.results import WHEEL_FIELDS, read, read_full

TOPIC = "/contact_node/contact"
STAMPS = np.array([1.0, 1.5, 2.0, 1.0, 1.5, 0.5])  # of three loops


def recording(path, messages):
    """Writes results as rosbag records them from a live node: without outlines of the profiles."""
    with rosbag.Bag(str(path), "w") as bag:
        for k, message in enumerate(messages):
            bag.write(TOPIC, message, genpy.Time(100 + k))
    return path


def drawn(module, function, *arguments):
    """The figure that a function of a module of the report would write to a file."""
    figures = []
    with mock.patch.object(module, "save", side_effect=lambda figure, path: figures.append(figure) or path):
        function(*arguments, "none.png")
    figures[0].canvas.draw()
    return figures[0]


def overlaps(axis):
    """Labels of neighbouring ticks that overlap, on both sides of an axis of a figure."""
    boxes = [[label.get_window_extent() for label in labels if label.get_text() and label.get_visible()]
             for labels in (axis.get_xticklabels(), axis.get_yticklabels())]
    return [(one, other) for row in boxes for one, other in zip(row, row[1:]) if one.overlaps(other)]


class Loops(unittest.TestCase):
    def test_recording_is_split_at_each_step_back_of_the_stamps(self):
        self.assertEqual([STAMPS[piece].tolist() for piece in loops(STAMPS)], [[1.0, 1.5, 2.0], [1.0, 1.5], [0.5]])
        self.assertEqual([loop_of(STAMPS, k) for k in range(len(STAMPS))], [1, 1, 1, 2, 2, 3])
        self.assertEqual(len(loops(np.array([1.0, 1.0, 2.0]))), 1, "equal stamps do not go back")

    def test_no_line_connects_two_loops(self):
        for repeats in (1, 3000):  # drawn by points and by columns
            x = np.concatenate([np.linspace(1, 2, 2 * repeats), np.linspace(0, 2, 3 * repeats)])
            axis = pyplot().figure().add_subplot()
            drawing.draw_history(axis, x, 10 * x, types.SimpleNamespace(stamp=x))
            shown_x, shown_y = axis.lines[0].get_data()
            connected = np.isfinite(shown_x[1:]) & np.isfinite(shown_x[:-1])
            self.assertTrue((np.diff(shown_x)[connected] > 0).all())
            self.assertEqual((np.isnan(shown_x).sum(), len(axis.collections)), (1, repeats > 1))  # one gap; the range
            np.testing.assert_allclose((np.nanmin(shown_y), np.nanmax(shown_y)), (0, 20), atol=0.02)  # a column


class Spans(unittest.TestCase):
    def test_spans_reach_half_way_to_the_neighbours_and_not_into_pauses(self):
        x = np.array([0.0, 1.0, 2.0, 3.0, 50.0])
        chosen = np.array([False, True, True, False, True])
        np.testing.assert_allclose(marks.spans(x, chosen, [slice(0, 5)]), [[0.5, 2.5], [49.5, 50.5]])
        np.testing.assert_allclose(marks.spans(-x, chosen, [slice(0, 5)]), [[-50.5, -49.5], [-2.5, -0.5]])
        x = np.array([0.0, 1.0, 2.0, 0.0, 1.0, 2.0])  # of loops: drawn once
        self.assertEqual(marks.spans(x, x == 1, loops(x)).tolist(), [[0.5, 1.5]])


class Pictures(SweepCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.messages = read_full(cls.rigid, TOPIC, set(range(201)))
        # Contact of the flange, at 70°: the narrowest patch.
        cls.steepest = max(cls.messages, key=lambda index: cls.messages[index].patches[-1].contact_angle)

    def message(self, index, status=WheelsetContact.OK, sides=(0, 1)):
        """Copy of a result of the sweep with another status, with the patches of some sides only. Each rail bends under the
        forces of its contacts."""
        message = copy.deepcopy(self.messages[index])
        message.status = status
        message.patches = [patch for patch in message.patches if patch.side in sides]
        for wheel, rail in ((message.left_wheel, message.left_rail), (message.right_wheel, message.right_rail)):
            wheel.lateral_force, wheel.vertical_force = rail.lateral_force, rail.vertical_force
        for patch in message.patches:
            patch.wheel_s = patch.rail_s = abs(patch.pose.position.y) - 0.75
        return message

    def results(self, messages):
        return read(recording(self.folder / "some.bag", messages))[0]

    def test_all_patches_have_one_scale_of_lengths_and_one_of_colours(self):
        steep = self.message(self.steepest)
        figure = drawn(pressure, pressure.figure, steep, "title")
        maps = [axis for axis in figure.axes if axis.get_ylabel() == "y [mm]"]
        self.assertEqual(len(maps), len(steep.patches))
        self.assertGreater(steep.patches[-1].contact_angle, 1)
        inches = [(axis.get_window_extent().width / np.ptp(axis.get_xlim()),
                   axis.get_window_extent().height / np.ptp(axis.get_ylim())) for axis in maps]
        np.testing.assert_allclose(inches, inches[0][0])
        highest = max(max(patch.grid.pressure) for patch in steep.patches)
        for axis, patch in zip(maps, steep.patches):
            cells = axis.collections[0]
            self.assertEqual(cells.get_clim(), (0, 1e-6 * highest))
            self.assertEqual(np.nanmax(cells.get_array()), 1e-6 * float(max(patch.grid.pressure)))

    def test_narrow_patches_are_readable_and_the_size_of_their_cells_is_stated(self):
        for index in (0, 150, self.steepest):
            message = self.message(index)
            figure = drawn(pressure, pressure.figure, message, "title")
            for axis in figure.axes:
                self.assertEqual(overlaps(axis), [])
            for axis, patch in zip(figure.axes, message.patches):
                self.assertGreater(axis.get_window_extent().height / figure.dpi, 0.4)
                self.assertIn(f"cells of {1e3 * patch.grid.dx:.2f} mm × {1e3 * patch.grid.dy:.3f} mm",
                              axis.get_title(loc="left"))

    def test_positions_of_a_recording_of_a_live_node_are_readable(self):
        results = self.results([self.message(index) for index in range(0, 201, 10)])
        self.assertFalse(any(results.outlines))
        figure = drawn(positions, positions.figure, results)
        profiles = figure.axes[:4]
        for axis in profiles:
            self.assertEqual(overlaps(axis), [])
            self.assertGreater(axis.get_window_extent().height / figure.dpi, 1.5)
        for axis, side, name in zip(profiles, (0, 1, 0, 1), ("wheel_s", "wheel_s", "rail_s", "rail_s")):
            chosen = results.patches["side"] == side
            np.testing.assert_allclose(axis.collections[0].get_offsets(), np.column_stack(
                [1e3 * results.patches[name][chosen], 1e-6 * results.patches["max_pressure"][chosen]]))
            self.assertEqual(axis.xaxis_inverted(), side == 0, "field sides are outside")

    def test_quantities_that_are_zero_throughout_are_listed_and_not_drawn(self):
        messages = [self.message(index) for index in range(20)]
        rigid = self.results(messages)
        labels = [axis.get_ylabel() for axis in drawn(histories, histories.histories, rigid, None).axes]
        _, left_out = histories.histories(rigid, None, self.folder / "some.png")
        self.assertIn("y [mm]", labels)
        self.assertFalse([label for label in labels if "rail" in label])
        self.assertIn("rail roll [mrad], outward", left_out)
        messages[3].left_rail.roll = 1e-3
        bent = self.results(messages)
        for pair in ((bent, None), (rigid, bent)):
            labels = [axis.get_ylabel() for axis in drawn(histories, histories.histories, *pair).axes]
            self.assertEqual([label for label in labels if "rail" in label], ["rail roll [mrad],\noutward"])

    def test_lift_off_and_refusals_are_marked_in_every_history(self):
        refused = self.message(3, WheelsetContact.NOT_CONVERGED, ())
        lifted = [self.message(index, WheelsetContact.LIFT_OFF, (0,)) for index in (1, 2)]
        results = self.results([self.message(0), *lifted, refused, self.message(4)])
        self.assertEqual([(label, chosen.tolist()) for label, _, chosen in marks.marks(results)],
                         [("right wheel lifted off", [False, True, True, False, False]),
                          ("refused", [False, False, False, True, False])])
        figure = drawn(histories, histories.histories, results, None)
        names = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
        self.assertEqual(names, ["left", "right", "y of a refusal", "right wheel lifted off", "refused"])
        for axis in figure.axes:
            ends = [path.vertices[:, 0] for bars in axis.collections for path in bars.get_paths()]
            step = results.stamp[1] - results.stamp[0]
            np.testing.assert_allclose([(x.min(), x.max()) for x in ends],
                                       results.stamp[0] + step * np.array([[0.5, 2.5], [2.5, 3.5]]), rtol=1e-9)

    def test_held_results_are_marked_without_patches_and_the_pose_of_a_rejected_input_is_not_drawn(self):
        held = self.message(1, WheelsetContact.NOT_CONVERGED, (0,))
        held.held = True
        results = self.results([self.message(0), held, self.message(2)])
        self.assertEqual([(m[0], m[2].tolist()) for m in marks.marks(results)], [("refused and held", [False, True, False])])
        self.assertNotIn(1, results.patches["result"])
        rejected = [WheelsetContact(status=status, header=self.messages[1].header)
                    for status in (WheelsetContact.INVALID_INPUT, WheelsetContact.NO_TRANSFORM, WheelsetContact.INVALID_INPUT)]
        rejected[2].wheelset.orientation.w = 1  # by the evaluation, at the origin
        results = self.results([self.message(0), *rejected, self.message(2, WheelsetContact.OFF_PROFILE, ())])
        self.assertEqual(np.isnan(results.y).tolist(), [False, True, True, False, False])
        self.assertEqual(np.isnan(results.yaw).tolist(), [False, True, True, False, False])
        self.assertTrue(np.isnan(results.wheel[1:]).all())

    def test_loads_on_a_rail_that_changes_are_not_added_over_the_loops(self):
        results = self.results([self.message(index) for index in (0, 1, 2, 0, 1, 2)])
        results.distance = np.array([0.0, 0.05, 0.1] * 2)
        y = np.linspace(0.72, 0.79, 100)
        head = np.column_stack([y, -10 * (y - 0.755)**2])
        results.sections[0] = [(0.0, head), (0.1, head)]
        figure = drawn(running_band, running_band.figure, results, 0)
        line, = figure.axes[1].lines
        load = 1e-3 * results.wheel[0, 0, WHEEL_FIELDS.index("vertical_force")]
        # The sweep begins with equal loads on both wheels.
        np.testing.assert_allclose(line.get_ydata(), [load, load, load, np.nan, load, load, load], rtol=1e-3)
        np.testing.assert_array_equal(line.get_xdata(), [0, 0.05, 0.1, np.nan, 0, 0.05, 0.1])

    def test_page_of_a_looped_recording_states_the_loops(self):
        order = [*range(100, 201, 20), *range(0, 201, 20), *range(0, 61, 20)]
        looped = recording(self.folder / "looped.bag", [self.message(index) for index in order])
        out = self.folder / "looped"
        self.run_command(main, looped, "--out", out)
        text = (out / "report.html").read_text(encoding="utf-8")
        first, last = (self.messages[index].header.stamp.to_sec() for index in (0, 200))
        self.assertIn(f"{len(order)} results from {first:.3f} s to {last:.3f} s", text)
        self.assertIn("The recording has 3 loops: its stamps go back 2 times.", text)
        self.assertIn(f"<tr><td>2</td><td>{first:.3f}</td><td>{last:.3f}</td><td>11</td></tr>", text)
        results, _ = read(looped)
        highest = int(results.patches["result"][results.patches["max_pressure"].argmax()])
        loop = loop_of(results.stamp, highest)
        self.assertRegex(text, rf"<td>{results.stamp[highest]:.3f}</td><td>0.000</td><td>-?[\d.]+</td><td>{loop}</td>")

    def test_patch_with_the_largest_force_stands_for_the_wheel(self):
        message = self.message(0)
        message.patches.append(copy.deepcopy(message.patches[0]))
        message.patches[-1].normal_force *= 2
        message.patches[-1].rolling_radius = 0.47
        results = self.results([message, self.message(1, WheelsetContact.LIFT_OFF, (1,))])
        row = histories._rows(results)[-1]
        self.assertEqual(row.lines[0][0][0], 470)
        self.assertTrue(np.isnan(row.lines[0][0][1]))
        self.assertEqual(len(row.dots[0][0]), 1, "the other patch of the left wheel")

    def test_limits_of_wheels_and_axle_are_drawn_and_judged_as_by_contact_check(self):
        table, states, bounds = (self.folder / name for name in ("hunting.csv", "hunting.bag", "bounds.yaml"))
        for name, *files in (("make_hunting_states", table), ("contact_states", table, states)):
            subprocess.run([sys.executable, PACKAGE / "scripts" / name, *files], check=True, capture_output=True)
        bag = self.replay("hunted.bag", PACKAGE / "config" / "default.yaml", states)
        parameters = {"axle": {"low_pass": 20, "mean_length": 2, "static_load": 100e3, "bounds": {
            "lateral_force": {"max": 20e3}, "quotient": {"max": 0.1}, "unloading": {"max": 0.6}, "lateral_sum": {"k1": 1}}}}
        bounds.write_text(str({"nodes": {"other": {"topic": "other"}, "this": {"topic": TOPIC, **parameters}}}))
        self.run_command(main, bag, "--out", self.folder / "limits", "--limits", bounds)
        messages, results = list(read_full(bag, TOPIC, set(range(1000))).values()), read(bag)[0]
        texts, _ = judge(read_limits(parameters), messages)
        self.assertEqual(list(texts), ["axle_quotient"])
        self.assertRegex(texts["axle_quotient"], r"^Y/Q 0.104\d+ - is above .*, left wheel, distance = \d+.\d+ m .*no friction")
        self.assertIn(html.escape(texts["axle_quotient"]), (self.folder / "limits" / "report.html").read_text(encoding="utf-8"))
        limits = axle.read_limits(bounds, TOPIC)
        found, live = axle.of_results(limits, results), history(limits, map(sample, messages))
        np.testing.assert_equal((found.values, found.counts), (live.values, live.counts))
        drawing_of = drawn(axle, axle._figure, results, limits, found).axes[2]
        np.testing.assert_array_equal([line.get_ydata() for line in drawing_of.lines[:2]], found.values["quotient"].T)
        self.assertEqual(drawing_of.lines[2].get_ydata(), [0.1, 0.1])
        self.assertIn("is no parameter file", self.run_command(main, bag, "--out", "none", "--limits", table, status=1))
