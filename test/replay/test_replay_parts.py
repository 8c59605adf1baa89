# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay --from --to: the joined parts of a bag are the file that one replay of the whole bag writes."""

import os
import subprocess

import rosbag
from std_msgs.msg import Header, String
from tf2_msgs.msg import TFMessage
from wheel_rail_contact.msg import RailDeflection, WheelsetContact

from replay_case import FEW_RESULTS, MISUSED, ReplayCase, load, pose, time, transform

JOIN = os.environ["CONTACT_JOIN"]
START = 1_700_000_000 * 10**9  # recording time of the first message [ns]
STEP = 10**9 // 20             # of the stamps [ns]
CUTS = (4.013, 7.5, 7.6, 9.0)  # [s] after the start: within chunks, within seconds, and between the messages of a pair
LATE = 12_000_000              # time from the recording of a pose to that of its load [ns]
GRID = "contact: {method: conjugate_gradient, grid: {along: 8, across: 24}}\n"  # short start time


class Parts(ReplayCase):
    def setUp(self):
        super().setUp()
        self.bag = self.folder / "in.bag"
        self.options = ["--no-grids", "--config", self.config(GRID, "grid.yaml")]

    def write(self, seconds=11, pace=1, inputs=("/wheelset",), frame="track", left_out=(), back_at=None, refused=(), step=STEP,
              **also):
        """Writes pairs with stamps from 100 s on. `pace` is the rate of the recorder clock relative to the stamps. The
        wheelset is beside the rails in the pairs with the numbers `refused`."""
        with rosbag.Bag(str(self.bag), "w", chunk_threshold=3000) as bag:
            for name, messages in also.items():
                for at, message in messages:
                    bag.write("/" + name, message, time(START + at))
            for i in range(seconds * 10**9 // step):
                jump = 0 if back_at is None or i < back_at else 7.3e9
                for wheelset in inputs:
                    for topic, message, late in (("pose", pose(i, frame), 0), ("load", load(i), LATE)):
                        if topic == "pose" and i in refused:
                            message.pose.position.y = 0.09
                        message.header.stamp = time(100 * 10**9 + i * step - int(jump))
                        if (i, topic) not in left_out:
                            bag.write(f"{wheelset}/{topic}", message, time(START + pace * i * step + late))

    def parts(self, *options, cuts=CUTS, status=0):
        """Replays the parts. @return paths of their results"""
        at = [None, *(f"{(START + round(1e9 * cut)) // 10**9}.{round(1e9 * cut) % 10**9:09}" for cut in cuts), None]
        return self.replay_parts(self.bag, at, *self.options, *options, status=status)

    def join(self, parts, *options, status=0):
        out = self.folder / "joined.bag"
        run = subprocess.run([JOIN, *options, out, *parts], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, status, run.stdout + run.stderr)
        return out, run.stderr

    def assert_parts_equal_the_whole(self, *options, cuts=CUTS, join=()):
        whole, printed = self.replay(self.bag, "whole.bag", *self.options, *options)
        joined, _ = self.join(self.parts(*options, cuts=cuts), *join)
        self.assert_same_file(whole, joined)
        return whole, printed

    def test_joined_parts_equal_the_replay_of_the_whole_bag(self):
        self.write(left_out={(i, "load") for i in range(3, 220, 17)})
        whole, printed = self.assert_parts_equal_the_whole()
        self.assertIn("207 pairs", printed)
        self.assertIn("13 messages dropped: no message with a matching stamp", printed)
        self.assertEqual(len(self.results(whole)), 207)

    def test_stamps_may_advance_at_another_rate_than_the_recorder_clock(self):
        self.write(seconds=4, pace=12)
        self.assert_parts_equal_the_whole(cuts=(20.3, 31, 40.001))

    def test_joined_parts_equal_the_whole_bag_if_stamps_go_back(self):
        self.write(back_at=139)
        self.assert_parts_equal_the_whole(cuts=(6.955, 7.2, 8.5))

    def test_results_that_are_held_in_a_part_are_those_of_the_whole_bag(self):
        # Runs of refused states at the cuts, across whole seconds, and one that is longer than HoldLast::memory.
        refused = {*range(75, 86), *range(149, 153), *range(250, 455), *range(530, 560)}
        self.write(seconds=31, refused=refused)
        whole, printed = self.assert_parts_equal_the_whole("--config", self.config("contact: {hold_last: 8}\n"),
                                                           cuts=(4.013, 7.52, 7.6, 22.3, 22.6, 26.72, 27.0))
        held = [i for i, result in enumerate(self.results(whole)) if result.held]
        self.assertEqual(held, [*range(75, 83), *range(149, 153), *range(250, 258), *range(530, 538)])
        self.assertIn("held: 28 (4.5 %)", printed)
        heights = [result.wheelset.position.z for result in self.results(whole)]
        self.assertEqual([heights[449], heights[450]], [heights[249], 0], "forgotten after 200 results")

    def test_parts_of_a_fast_input_by_several_threads_equal_the_whole_by_one(self):
        # At 500 Hz, the slices of each second begin at its inputs 0, 200 and 400. The result of 1199 is held up to 1389; at
        # the second cut (1385), it is repeated from the beginning of its slice, 385 inputs before.
        refused = range(1200, 1390)
        self.write(seconds=4, step=2_000_000, refused=refused)
        options = ["--config", self.config("contact: {hold_last: 190}\n"), "--threads"]
        whole, _ = self.replay(self.bag, "whole.bag", *self.options, *options, 1)
        joined, _ = self.join(self.parts(*options, 3, cuts=(2.3, 2.77, 3.71)))
        self.assert_same_file(whole, joined)
        self.assertEqual([i for i, result in enumerate(self.results(whole)) if result.held], [*refused])

    def test_parts_with_several_wheelsets_kept_topics_and_compression_are_joined(self):
        remarks = [(k * 10**9 + 1, String(f"remark {k}")) for k in range(11)]
        self.write(inputs=("/a/wheelset", "/b/wheelset"), remark=remarks)
        whole, _ = self.assert_parts_equal_the_whole("--wheelset", "a", "b", "--keep-topics", "--lz4",
                                                     cuts=(4.013, 8), join=["--lz4"])
        self.assertEqual(len(self.results(whole, "/remark")), 11)

    def test_results_of_neighbours_in_the_previous_second_are_used(self):
        self.write(neighbour=[(i * STEP + LATE, WheelsetContact(header=Header(stamp=time(100 * 10**9 + i * STEP)),
                                                                left_rail=RailDeflection(lateral_force=20e3),
                                                                right_rail=RailDeflection(lateral_force=100 * i)))
                              for i in range(11 * 20)])
        config = self.config("rail_bending: {model: compliance, table: config/rails/pads_10_25.yaml,"
                             " neighbours: [{topic: /neighbour, distance: 2.5}]}\n")
        self.assert_parts_equal_the_whole("--config", config, cuts=(7.513,))

    def test_parts_with_transforms_and_slop_equal_the_replay_of_the_whole_bag(self):
        self.write(frame="survey", tf_static=[(0, TFMessage([transform(1e-3)]))])
        whole, _ = self.assert_parts_equal_the_whole("--config", self.config("sync: {slop: 0.06}\n"), cuts=(7.513,))
        self.assertEqual({r.status for r in self.results(whole)}, {WheelsetContact.OK})

    def test_static_transforms_of_a_first_part_are_read_before_a_later_one(self):
        self.write(seconds=1, frame="survey", tf_static=[(0, TFMessage([transform(1e-3)]))])
        whole, _ = self.replay(self.bag, "whole.bag", *self.options)
        first = self.bag.rename(self.folder / "first.bag")
        self.write(seconds=1, frame="survey")
        self.replay(self.bag, "alone.bag", *self.options, status=FEW_RESULTS)
        later, _ = self.replay(self.bag, "later.bag", *self.options, "--tf-static", first)
        self.assertEqual(self.results(later), self.results(whole))
        self.replay(first, "none.bag", *self.options, "--tf-static", self.bag, status=1)

    def test_results_of_an_earlier_replay_are_kept_unchanged(self):
        wheelsets = "first", "second", "third"
        self.write(seconds=2, inputs=[f"/{wheelset}/wheelset" for wheelset in wheelsets])
        self.bag, _ = self.replay(self.bag, "before.bag", *self.options, "--wheelset", *wheelsets[:2], "--keep-topics")
        whole, _ = self.assert_parts_equal_the_whole("--wheelset", "third", "--keep-topics", cuts=(0.005, 0.013, 0.7))
        for wheelset in wheelsets:
            self.assertEqual(len(self.results(whole, f"/{wheelset}/contact_node/contact")), 40)

    def test_parts_with_a_wheelset_without_results_are_joined(self):
        self.write(seconds=1, inputs=("/a/wheelset",), **{"b/wheelset/pose": [(0, pose(0))],
                                                          "b/wheelset/load": [(0, load(500))]})
        whole, _ = self.assert_parts_equal_the_whole("--wheelset", "a", "b", "--keep-topics", cuts=(0.5,))
        self.assertEqual(len(self.results(whole, "/a/contact_node/contact")), 20)

    def test_part_without_results_is_empty(self):
        self.write(seconds=1)
        whole, _ = self.replay(self.bag, "whole.bag", *self.options)
        parts = self.parts(cuts=(5, 9))
        self.assertEqual([len(self.results(part)) for part in parts], [20, 0, 0])
        self.assert_same_file(whole, self.join(parts)[0])

    def test_part_can_be_resumed_only_as_the_same_part(self):
        self.write(seconds=1)
        parts = self.parts(cuts=(0.5,))
        _, printed = self.replay(self.bag, parts[0].name, *self.options, "--resume", status=1)
        self.assertIn("cannot be resumed", printed)

    def test_parts_that_are_not_consecutive_are_not_joined(self):
        self.write(seconds=2)
        parts = self.parts(cuts=(0.7,))
        _, printed = self.join([parts[0], parts[0]], status=1)
        self.assertIn("is not a later part of the same replay", printed)
        parts[1].write_bytes(parts[1].read_bytes()[:-100])
        _, printed = self.join(parts, status=1)
        self.assertIn("part_1.bag", printed)

    def test_join_requires_an_output_and_a_part(self):
        self.assertIn("at least one PART.bag", self.join([], status=2)[1])
        self.assertIn("unrecognised option '--bz2'", self.join(["part.bag"], "--bz2", status=2)[1])

    def test_missing_parts_are_reported(self):
        self.write(seconds=2)
        parts = self.parts(cuts=(0.7, 1.3))
        first, second = (f"{START + round(1e9 * cut)} ns" for cut in (0.7, 1.3))
        for wrong, reported, missing, position in ((parts[1:], "part_1.bag", "0 ns", f"this part begins at {first}"),
                (parts[::2], "part_2.bag", first, f"this part begins at {second}"),
                (parts[:2], "part_1.bag", second, "this is the last part")):
            _, printed = self.join(wrong, status=1)
            self.assertIn(f"{reported}: the part that begins at {missing} is missing; {position}", printed)

    def test_invalid_times_are_refused(self):
        self.write(seconds=1)
        for options, reason in ((["--from", "soon"], "--from = soon: must be a recording time"),
                                (["--from", "5", "--to", "4.9"], "--from: must be before --to")):
            _, printed = self.replay(self.bag, "out.bag", *options, status=MISUSED)
            self.assertIn(reason, printed)
