# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay on bags whose loads have another rate than the poses, and on bags without stamps."""

import os
import subprocess

import genpy
from wheel_rail_contact.msg import WheelsetContact

from replay_case import FEW_RESULTS, ReplayCase, load, pairs, pose, stamp


def load_at(i, force, frame="track"):
    message = load(i)
    message.wrench.force.z = force
    message.header.frame_id = frame
    return message


class Interpolation(ReplayCase):
    def setUp(self):
        super().setUp()
        self.interpolated = self.config("sync: {load: interpolate}\n")

    def write(self, poses, loads, force=lambda i: -200e3, name="in.bag"):
        messages = [(i, 0, "/wheelset/pose", pose(i)) for i in poses] + [(i, 1, "/wheelset/load", load_at(i, force(i)))
                                                                        for i in loads]
        return self.write_bag([(topic, message, stamp(i)) for i, _, topic, message in
                               sorted(messages, key=lambda message: message[:2])], name)

    def test_every_pose_between_loads_of_a_lower_rate_has_a_result(self):
        bag = self.write(range(0, 400, 5), range(0, 420, 20))
        out, printed = self.replay(bag, "out.bag", "--config", self.interpolated)
        results = self.results(out)
        self.assertEqual([result.header.stamp for result in results], [stamp(i) for i in range(0, 400, 5)])
        self.assertIn("80 of 80 poses have a result", printed)
        self.assertNotIn("dropped", printed)
        _, printed = self.replay(bag, "matched.bag", status=FEW_RESULTS)
        self.assertIn("20 of 80 poses have a result", printed)
        self.assertIn("OK: 20 (25.0 %)", printed)
        self.assertIn("the stamps differ by 0.005 s or more: see sync/slop, or sync/load", printed)

    def test_load_that_varies_linearly_gives_the_results_of_the_load_at_each_pose(self):
        def force(i):
            return -100e3 - 500.0 * i

        bag = self.write(range(0, 200, 4), range(0, 201, 40), force)
        between, _ = self.replay(bag, "between.bag", "--config", self.interpolated)
        exact, _ = self.replay(self.write(range(0, 200, 4), range(0, 200, 4), force, "all.bag"), "exact.bag")
        pairs = list(zip(self.results(between), self.results(exact)))
        self.assertEqual(len(pairs), 50)
        for one, other in pairs:
            self.assertEqual(one.header, other.header)
            self.assertAlmostEqual(one.wheelset.position.z, other.wheelset.position.z, delta=1e-9)
            for patch, same in zip(one.patches, other.patches):
                self.assertAlmostEqual(patch.normal_force, same.normal_force, delta=1e-5 * same.normal_force)  # tolerance 1 %

    def test_poses_outside_the_loads_and_in_a_long_gap_are_dropped_and_counted(self):
        loads = [i for i in range(100, 700, 20) if not 300 < i < 420]
        out, printed = self.replay(self.write(range(0, 900, 10), loads), "out.bag", "--config", self.interpolated)
        expected = [i for i in range(100, 690, 10) if not 300 < i < 420]
        self.assertEqual([result.header.stamp for result in self.results(out)], [stamp(i) for i in expected])
        self.assertIn(f"{90 - len(expected)} messages dropped: no load before and after it within sync/longest_gap", printed)
        self.config("sync: {load: interpolate, longest_gap: 0.12}\n")
        out, _ = self.replay(self.folder / "in.bag", "wide.bag", "--config", self.interpolated)
        self.assertEqual([result.header.stamp for result in self.results(out)], [stamp(i) for i in range(100, 690, 10)])

    def test_loads_of_a_higher_rate_are_not_a_loss(self):
        out, printed = self.replay(self.write(range(5, 400, 20), range(0, 400, 2)), "out.bag", "--config", self.interpolated)
        self.assertEqual(len(self.results(out)), 20)
        self.assertIn("20 of 20 poses have a result", printed)
        self.assertIn("160 messages dropped: load not needed, because no pose is next to it", printed)

    def test_loads_in_different_frames_are_refused_by_name(self):
        bag = self.write([10, 30], [0, 20])
        self.write_bag([("/wheelset/load", load_at(40, -2e5, "axle"), stamp(40))], bag.name, "a")
        results = self.results(self.replay(bag, "out.bag", "--config", self.interpolated)[0])
        self.assertEqual([result.status for result in results], [WheelsetContact.OK, WheelsetContact.INVALID_INPUT])
        self.assertIn("frame_id is 'track' before the pose and 'axle' after it", results[1].status_text)

    def test_joined_parts_are_those_of_the_whole_bag(self):
        bag = self.write(range(0, 9000, 25), range(0, 9000, 60))
        whole, _ = self.replay(bag, "whole.bag", "--config", self.interpolated, "--no-grids")
        self.assertGreater(len(self.results(whole)), 350)
        parts = self.replay_parts(bag, [None, "6.013", "8.5", None], "--config", self.interpolated, "--no-grids")
        for part in parts:
            self.assertGreater(len(self.results(part)), 50)
        joined = self.folder / "joined.bag"
        subprocess.run([os.environ["CONTACT_JOIN"], joined, *parts], check=True)
        self.assert_same_file(joined, whole)


class WithoutStamps(ReplayCase):
    def write(self, unstamped, count=20):
        """Writes pairs. @param unstamped number of those whose stamps are 0"""
        def change(i, *messages):
            for message in messages if i < unstamped else ():
                message.header.stamp = genpy.Time()

        return self.write_bag(pairs(range(count), change=change))

    def test_messages_without_a_stamp_are_never_paired(self):
        out, printed = self.replay(self.write(20), status=1)
        self.assertFalse(out.exists(), "a run without any result leaves no file")
        self.assertIn("40 messages dropped: stamp 0, which means that the stamp is unknown", printed)
        self.assertIn("0 of 20 poses have a result", printed)
        self.assertIn("contains no pair of pose and load; 20 poses were dropped", printed)

    def test_exit_status_is_not_0_if_fewer_than_half_of_the_poses_have_a_result(self):
        _, printed = self.replay(self.write(11), "most.bag", status=FEW_RESULTS)
        self.assertIn("OK: 9 (45.0 %)", printed)
        self.assertIn("in.bag: only 9 of 20 poses have a result", printed.splitlines()[-1])
        _, printed = self.replay(self.write(10), "half.bag")
        self.assertIn("OK: 10 (50.0 %)", printed)
        self.assertIn("10 of 20 poses have a result", printed)

    def test_part_of_a_bag_may_have_few_results(self):
        self.replay(self.write(15), "part.bag", "--to", "1.016")

    def test_pose_alone_needs_a_stamp_too(self):
        _, printed = self.replay(self.write(3), "out.bag", "--config", self.config("wheelset: {free: []}\n"))
        self.assertIn("3 messages dropped: stamp 0", printed)
        self.assertIn("17 of 20 poses have a result", printed)

    def test_place_that_is_always_0_on_a_line_is_remarked(self):
        line = self.folder / "line.csv"
        line.write_text("x [m],rail_vertical_left [mm],rail_vertical_right [mm]\n0,0,0\n10,10,10\n")
        config = self.config(f"track: {{line: {line}}}\n")
        remark = "all results are at 0 m on the line"
        self.assertIn(remark, self.replay(self.write(0), "still.bag", "--config", config)[1])
        self.assertNotIn(remark, self.replay(self.write(0), "no_line.bag")[1])
        there = pose(50)
        there.pose.position.x = 1
        bag = self.write(0)
        self.write_bag([("/wheelset/pose", there, stamp(50)), ("/wheelset/load", load(50), stamp(50))], bag.name, "a")
        self.assertNotIn(remark, self.replay(bag, "moving.bag", "--config", config)[1])
