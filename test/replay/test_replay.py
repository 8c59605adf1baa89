# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay on complete bags: every pair has a result, and each run gives the same bytes."""

import math
import pty
import os
import subprocess

import rosbag
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage
from wheel_rail_contact.msg import WheelsetContact
from replay_case import (FEW_RESULTS, MISUSED, PROGRAM, SHIPPED, ReplayCase, pairs, pose, rows_of, stamp, time, transform)


class WholeBags(ReplayCase):
    def test_every_pair_of_the_shipped_bag_has_a_result_with_its_stamp(self):
        out, _ = self.replay(SHIPPED)
        with rosbag.Bag(str(SHIPPED)) as bag:
            poses = [message for _, message, _ in bag.read_messages("wheelset/pose")]
        results = self.results(out)
        self.assertEqual([r.header.stamp for r in results], [p.header.stamp for p in poses])
        self.assertEqual([r.header.seq for r in results], list(range(len(poses))))
        self.assertEqual([r.wheelset.position.y for r in results], [p.pose.position.y for p in poses])
        for result in results:
            self.assertEqual(result.status, WheelsetContact.OK, result.status_text)
            for patch in result.patches:
                self.assertEqual(len(patch.grid.pressure), patch.grid.nx * patch.grid.ny)

    def test_runs_with_any_number_of_threads_write_the_same_bytes(self):
        bag = self.make_bag(1100)
        runs = [self.replay(bag, f"{i}.bag", "--threads", n, "--csv", self.folder / f"{i}.csv")[0]
                for i, n in enumerate((1, 2, 3, 3))]
        self.assertEqual(len(self.results(runs[0])), 1100)
        for run in runs[1:]:
            self.assert_same_file(runs[0], run)
            self.assert_same_file(runs[0].with_suffix(".csv"), run.with_suffix(".csv"))

    def test_compression_of_input_or_output_does_not_change_the_results(self):
        plain, _ = self.replay(self.make_bag(300), "plain.bag", "--no-grids")
        for compression in ("bz2", "lz4"):
            bag = self.make_bag(300, compression + ".bag", compression=compression, chunk_threshold=10000)
            out, _ = self.replay(bag, compression + "_out.bag", "--lz4", "--no-grids")
            self.assertEqual(self.results(out), self.results(plain))
            self.assertLess(out.stat().st_size, plain.stat().st_size)

    def test_order_of_the_messages_in_the_file_does_not_matter(self):
        sorted_bag = self.make_bag(1500)
        messages = list(pairs(range(1500)))
        by_topic = self.write_bag([*messages[::2], *messages[::-2]], "by_topic.bag", chunk_threshold=20000)
        out, _ = self.replay(sorted_bag, "out.bag", "--no-grids")
        other, _ = self.replay(by_topic, "other.bag", "--no-grids")
        self.assertEqual(len(self.results(out)), 1500)
        self.assertEqual(self.results(out), self.results(other))

    def test_replay_of_a_later_beginning_gives_the_same_results_from_the_next_second_on(self):
        late = self.write_bag(pairs(range(950, 1300)), "late.bag")

        def from_next_second(bag, name):
            results = [r for r in self.results(self.replay(bag, name)[0]) if r.header.stamp >= time(2 * 10**9)]
            for result in results:
                result.header.seq = 0
            return results

        results = from_next_second(late, "late_out.bag")
        self.assertEqual(len(results), 300)
        self.assertEqual(results, from_next_second(self.make_bag(1300), "out.bag"))

    def test_invalid_inputs_have_a_status_and_unmatched_messages_are_counted(self):
        def change(i, there, _):
            there.header.frame_id = "nowhere" if i == 3 else "track"
            there.pose.position.y = math.nan if i == 5 else 0

        path = self.write_bag(message for message in pairs(range(10), change=change)
                              if message[::2] != ("/wheelset/load", stamp(7)))
        out, printed = self.replay(path, "out.bag", "--csv", self.folder / "out.csv")
        expected = [WheelsetContact.OK] * 9
        expected[3] = WheelsetContact.NO_TRANSFORM
        expected[5] = WheelsetContact.INVALID_INPUT
        self.assertEqual([r.status for r in self.results(out)], expected)
        self.assertIn("1 messages dropped: no message with a matching stamp", printed)
        self.assertIn("INVALID_INPUT: 1", printed)
        self.assertIn("; first reason: pose: no transform from frame 'nowhere' to 'track' at the stamp", printed)
        rows = rows_of(self.folder / "out.csv")
        self.assertEqual([r["status"] for r in rows if r["side"] == ""], ["NO_TRANSFORM", "INVALID_INPUT"])

    def test_table_has_one_row_per_patch(self):
        out, _ = self.replay(SHIPPED, "out.bag", "--csv", self.folder / "out.csv")
        rows = rows_of(self.folder / "out.csv")
        patches = [(r, p) for r in self.results(out) for p in r.patches]
        self.assertEqual(len(rows), len(patches))
        for row, (result, patch) in zip(rows, patches):
            self.assertEqual(row["side"], ("left", "right")[patch.side])
            self.assertEqual((row["held [-]"], row["implausible_force [-]"]), ("0", "0"))
            for column, value in (("y [m]", result.wheelset.position.y), ("area [m^2]", patch.area),
                                  ("z [m]", result.wheelset.position.z), ("normal_force [N]", patch.normal_force),
                                  ("max_pressure [Pa]", patch.max_pressure),
                                  ("roll [rad]", 2 * math.asin(result.wheelset.orientation.x)),
                                  ("right_lateral_force [N]", result.right_rail.lateral_force)):
                # The table has nine digits.
                self.assertAlmostEqual(float(row[column]), value, delta=1e-8 * abs(value) + 1e-15)

    def test_results_of_a_wheelset_do_not_depend_on_other_wheelsets(self):
        path = self.write_bag([*pairs(range(250), "/front/wheelset"), *pairs(range(120), "/rear/wheelset")])
        out, _ = self.replay(path, "out.bag", "--threads", 2, "--wheelset", "front", "/rear")
        alone, _ = self.replay(self.make_bag(250), "alone.bag")
        self.assertEqual(self.results(out, "/front/contact_node/contact"), self.results(alone))
        self.assertEqual(self.results(out, "/rear/contact_node/contact"), self.results(alone)[:120])

    def test_other_topics_are_kept_but_not_results_of_an_earlier_run(self):
        path = self.write_bag([*pairs(range(20)), ("/remark", String("dry rail"), stamp(10)),
                               ("/contact_node/contact", WheelsetContact(), stamp(10))])
        out, _ = self.replay(path, "out.bag", "--keep-topics")
        self.assertEqual(len(self.results(out)), 20)
        self.assertEqual([m.data for m in self.results(out, "/remark")], ["dry rail"])
        self.assertEqual([m.header.stamp for m in self.results(out, "/wheelset/load")], [stamp(i) for i in range(20)])

    def test_poses_wait_for_transforms_as_in_the_live_node(self):
        def change(_, there, __):
            there.header.frame_id = "survey"

        # The stamps of the first 51 pairs are between two transforms.
        transforms = [("/tf", TFMessage([transform(1e-5 * i, stamp(i).to_nsec())]), stamp(i)) for i in (0, 50)]
        path = self.write_bag([*pairs(range(200), change=change), *transforms])
        results = self.results(self.replay(path, status=FEW_RESULTS)[0])
        self.assertEqual([r.status for r in results], [WheelsetContact.OK] * 51 + [WheelsetContact.NO_TRANSFORM] * 149)
        for i in range(51):
            self.assertAlmostEqual(results[i].wheelset.position.y, pose(i).pose.position.y + 1e-5 * i, delta=1e-12)

    def test_parameter_files_are_applied_over_the_defaults(self):
        first = self.config("contact: {tolerance: 0.1}\nrail: {profile: UIC60_manchester}\n", "a.yaml")
        out, _ = self.replay(SHIPPED, "out.bag", "--config", first, "--config", self.config("contact: {method: hertz}\n"))
        self.assertEqual({p.method for r in self.results(out) for p in r.patches}, {"hertz"})
        _, printed = self.replay(SHIPPED, "bad.bag", "--config", self.config("contact: {tolerence: 0.1}\n"), status=MISUSED)
        self.assertIn("contact/tolerence", printed)

    def test_existing_files_are_not_overwritten(self):
        for name in ("out.bag", "out.csv"):
            (self.folder / name).write_text("precious")
            options = ["--csv", self.folder / "out.csv"] if name == "out.csv" else []
            target = "other.bag" if name == "out.csv" else "out.bag"
            _, printed = self.replay(SHIPPED, target, *options, status=1)
            self.assertIn("already exists", printed)
            self.assertEqual((self.folder / name).read_text(), "precious")
        self.assertFalse((self.folder / "other.bag").exists())

    def test_wrong_arguments_are_reported_by_name(self):
        for options, reason in ((["--threads", "0"], "--threads = 0"), (["--colour"], "--colour"), (["third.bag"], "two bags"),
                                (["--csv"], "'--csv' is missing"), (["--csv", "--lz4"], "--csv: requires a value"),
                                (["--csv", "a", "--csv", "b"], "--csv"), (["--wheelset", "a", "/a"], "given twice")):
            _, printed = self.replay(SHIPPED, "out.bag", *options, status=MISUSED)
            self.assertIn(reason, printed)
        _, printed = self.replay(SHIPPED, "out.bag", "--wheelset", "front", status=1)
        self.assertIn("no topic /front/wheelset/", printed)
        self.assertIn("wheelset/load", printed.split("its topics")[1])

    def test_progress_on_a_terminal_is_a_bar_with_rate_and_remaining_time(self):
        outer, inner = pty.openpty()
        subprocess.run([PROGRAM, SHIPPED, self.folder / "out.bag"], stderr=inner, stdout=subprocess.DEVNULL, check=True)
        os.close(inner)
        shown = os.read(outer, 65536).decode()
        os.close(outer)
        self.assertRegex(shown.split("\r")[-2], r"\[#{30}\] 100\.0 %  201 results, \d+/s, 0 s left")
