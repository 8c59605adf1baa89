# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay on whole bags: every pair answered, the same each time."""

import csv
import math
import pty
import os
import subprocess

import rosbag
from std_msgs.msg import String
from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage
from wheel_rail_contact.msg import WheelsetContact

from replay_case import MISUSED, PROGRAM, SHIPPED, ReplayCase, load, pose, stamp, time, write_pairs


class WholeBags(ReplayCase):
    def test_every_pair_of_the_shipped_bag_is_answered_with_its_stamp(self):
        out, _ = self.replay(SHIPPED)
        with rosbag.Bag(str(SHIPPED)) as bag:
            poses = [message for _, message, _ in bag.read_messages("wheelset/pose")]
        answers = self.answers(out)
        self.assertEqual([a.header.stamp for a in answers], [p.header.stamp for p in poses])
        self.assertEqual([a.header.seq for a in answers], list(range(len(poses))))
        self.assertEqual([a.wheelset.position.y for a in answers], [p.pose.position.y for p in poses])
        for answer in answers:
            self.assertEqual(answer.status, WheelsetContact.OK, answer.status_text)
            for patch in answer.patches:
                self.assertEqual(len(patch.grid.pressure), patch.grid.nx * patch.grid.ny)

    def test_number_of_threads_and_runs_change_no_byte(self):
        bag = self.make_bag(1100)
        runs = [self.replay(bag, f"{i}.bag", "--threads", n, "--csv", self.folder / f"{i}.csv")[0]
                for i, n in enumerate((1, 2, 3, 3))]
        self.assertEqual(len(self.answers(runs[0])), 1100)
        for run in runs[1:]:
            self.assert_same_file(runs[0], run)
            self.assert_same_file(runs[0].with_suffix(".csv"), run.with_suffix(".csv"))

    def test_compression_of_either_bag_changes_no_answer(self):
        plain, _ = self.replay(self.make_bag(300), "plain.bag", "--no-grids")
        for compression in ("bz2", "lz4"):
            bag = self.make_bag(300, compression + ".bag", compression=compression, chunk_threshold=10000)
            out, _ = self.replay(bag, compression + "_out.bag", "--lz4", "--no-grids")
            self.assertEqual(self.answers(out), self.answers(plain))
            self.assertLess(out.stat().st_size, plain.stat().st_size)

    def test_messages_count_by_their_time_wherever_they_stand_in_the_file(self):
        sorted_bag = self.make_bag(1500)
        by_topic = self.folder / "by_topic.bag"
        with rosbag.Bag(str(by_topic), "w", chunk_threshold=20000) as bag:
            for i in range(1500):
                bag.write("/wheelset/pose", pose(i), stamp(i))
            for i in reversed(range(1500)):
                bag.write("/wheelset/load", load(i), stamp(i))
        out, _ = self.replay(sorted_bag, "out.bag", "--no-grids")
        other, _ = self.replay(by_topic, "other.bag", "--no-grids")
        self.assertEqual(len(self.answers(out)), 1500)
        self.assertEqual(self.answers(out), self.answers(other))

    def test_who_begins_in_the_middle_agrees_from_the_next_second_on(self):
        late = self.folder / "late.bag"
        with rosbag.Bag(str(late), "w") as bag:
            for i in range(950, 1300):
                bag.write("/wheelset/pose", pose(i), stamp(i))
                bag.write("/wheelset/load", load(i), stamp(i))

        def from_next_second(bag, name):
            answers = [a for a in self.answers(self.replay(bag, name)[0]) if a.header.stamp >= time(2 * 10**9)]
            for answer in answers:
                answer.header.seq = 0
            return answers

        answers = from_next_second(late, "late_out.bag")
        self.assertEqual(len(answers), 300)
        self.assertEqual(answers, from_next_second(self.make_bag(1300), "out.bag"))

    def test_bad_input_is_answered_by_name_and_lonely_messages_are_counted(self):
        path = self.folder / "in.bag"
        with rosbag.Bag(str(path), "w") as bag:
            for i in range(10):
                message = pose(i, "nowhere" if i == 3 else "track")
                message.pose.position.y = math.nan if i == 5 else 0
                bag.write("/wheelset/pose", message, stamp(i))
                if i != 7:
                    bag.write("/wheelset/load", load(i), stamp(i))
        out, printed = self.replay(path, "out.bag", "--csv", self.folder / "out.csv")
        expected = [WheelsetContact.OK] * 9
        expected[3] = WheelsetContact.NO_TRANSFORM
        expected[5] = WheelsetContact.INVALID_INPUT
        self.assertEqual([a.status for a in self.answers(out)], expected)
        self.assertIn("1 messages dropped: no partner", printed)
        self.assertIn("INVALID_INPUT: 1", printed)
        self.assertIn("; the first: pose: no transform from its frame 'nowhere' to 'track' (track/frame)", printed)
        with open(self.folder / "out.csv", encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual([r["status"] for r in rows if r["side"] == ""], ["NO_TRANSFORM", "INVALID_INPUT"])

    def test_table_has_a_row_for_each_patch(self):
        out, _ = self.replay(SHIPPED, "out.bag", "--csv", self.folder / "out.csv")
        with open(self.folder / "out.csv", encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        patches = [(a, p) for a in self.answers(out) for p in a.patches]
        self.assertEqual(len(rows), len(patches))
        for row, (answer, patch) in zip(rows, patches):
            self.assertEqual(row["side"], ("left", "right")[patch.side])
            for column, value in (("y [m]", answer.wheelset.position.y), ("area [m^2]", patch.area),
                                  ("z [m]", answer.wheelset.position.z), ("normal_force [N]", patch.normal_force),
                                  ("max_pressure [Pa]", patch.max_pressure),
                                  ("roll [rad]", 2 * math.asin(answer.wheelset.orientation.x)),
                                  ("right_lateral_force [N]", answer.right_rail.lateral_force)):
                # Nine digits are printed.
                self.assertAlmostEqual(float(row[column]), value, delta=1e-8 * abs(value) + 1e-15)

    def test_each_wheelset_is_answered_as_if_it_were_alone(self):
        path = self.folder / "both.bag"
        with rosbag.Bag(str(path), "w") as bag:
            write_pairs(bag, 250, "/front/wheelset")
            write_pairs(bag, 120, "/rear/wheelset")
        out, _ = self.replay(path, "out.bag", "--threads", 2, "--wheelset", "front", "/rear")
        alone, _ = self.replay(self.make_bag(250), "alone.bag")
        self.assertEqual(self.answers(out, "/front/contact_node/contact"), self.answers(alone))
        self.assertEqual(self.answers(out, "/rear/contact_node/contact"), self.answers(alone)[:120])

    def test_other_topics_are_kept_but_not_answers_of_an_earlier_run(self):
        path = self.make_bag(20)
        with rosbag.Bag(str(path), "a") as bag:
            bag.write("/remark", String("dry rail"), stamp(10))
            bag.write("/contact_node/contact", WheelsetContact(), stamp(10))
        out, _ = self.replay(path, "out.bag", "--keep-topics")
        self.assertEqual(len(self.answers(out)), 20)
        self.assertEqual([m.data for m in self.answers(out, "/remark")], ["dry rail"])
        self.assertEqual([m.header.stamp for m in self.answers(out, "/wheelset/load")], [stamp(i) for i in range(20)])

    def test_poses_wait_for_transforms_as_in_the_live_node(self):
        def transform(nanoseconds, y):
            message = TransformStamped()
            message.header.stamp = time(nanoseconds)
            message.header.frame_id, message.child_frame_id = "track", "survey"
            message.transform.translation.y = y
            message.transform.rotation.w = 1
            return message

        path = self.folder / "in.bag"
        with rosbag.Bag(str(path), "w") as bag:
            for i in range(200):
                bag.write("/wheelset/pose", pose(i, "survey"), stamp(i))
                bag.write("/wheelset/load", load(i), stamp(i))
                if i % 50 == 0 and i <= 50:  # stamps of the first 51 pairs lie between two transforms
                    bag.write("/tf", TFMessage([transform(stamp(i).to_nsec(), 1e-5 * i)]), stamp(i))
        answers = self.answers(self.replay(path)[0])
        self.assertEqual([a.status for a in answers],
                         [WheelsetContact.OK] * 51 + [WheelsetContact.NO_TRANSFORM] * 149)
        for i in range(51):
            self.assertAlmostEqual(answers[i].wheelset.position.y, pose(i).pose.position.y + 1e-5 * i, delta=1e-12)

    def test_parameters_are_laid_over_the_defaults(self):
        (self.folder / "a.yaml").write_text("contact: {tolerance: 0.1}\nrail: {profile: UIC60_manchester}\n")
        (self.folder / "b.yaml").write_text("contact: {method: hertz}\n")
        out, _ = self.replay(SHIPPED, "out.bag", "--config", self.folder / "a.yaml", "--config", self.folder / "b.yaml")
        self.assertEqual({p.method for a in self.answers(out) for p in a.patches}, {"hertz"})
        (self.folder / "bad.yaml").write_text("contact: {tolerence: 0.1}\n")
        _, printed = self.replay(SHIPPED, "bad.bag", "--config", self.folder / "bad.yaml", status=MISUSED)
        self.assertIn("contact/tolerence", printed)

    def test_nothing_is_overwritten(self):
        for name in ("out.bag", "out.csv"):
            (self.folder / name).write_text("precious")
            options = ["--csv", self.folder / "out.csv"] if name == "out.csv" else []
            target = "other.bag" if name == "out.csv" else "out.bag"
            _, printed = self.replay(SHIPPED, target, *options, status=1)
            self.assertIn("exists already", printed)
            self.assertEqual((self.folder / name).read_text(), "precious")
        self.assertFalse((self.folder / "other.bag").exists())

    def test_misuse_is_named(self):
        for options, reason in ((["--threads", "0"], "--threads = 0"), (["--colour"], "--colour"),
                                (["third.bag"], "two bags"), (["--csv"], "--csv needs a value"),
                                (["--wheelset", "a", "/a"], "given twice")):
            _, printed = self.replay(SHIPPED, "out.bag", *options, status=MISUSED)
            self.assertIn(reason, printed)
        _, printed = self.replay(SHIPPED, "out.bag", "--wheelset", "front", status=1)
        self.assertIn("no topic /front/wheelset/", printed)
        self.assertIn("wheelset/load", printed.split("its topics")[1])

    def test_a_terminal_shows_a_bar_with_rate_and_time_left(self):
        outer, inner = pty.openpty()
        subprocess.run([PROGRAM, SHIPPED, self.folder / "out.bag"], stderr=inner, stdout=subprocess.DEVNULL, check=True)
        os.close(inner)
        shown = os.read(outer, 65536).decode()
        os.close(outer)
        self.assertRegex(shown.split("\r")[-2], r"\[#{30}\] 100\.0 %  201 answers, \d+/s, 0 s left")


if __name__ == "__main__":
    import unittest
    unittest.main()
