# SPDX-License-Identifier: BSD-3-Clause
"""Interrupted contact_replay: the bag is readable after Ctrl-C, and --resume gives the file of an uninterrupted run."""

import shutil
import signal
import subprocess
import time

import rosbag

from replay_case import INTERRUPTED, PROGRAM, RESULTS, ReplayCase, pairs

PAIRS = 3000
REFUSED = 20  # length of a run of refused states
HELD = 15     # of them
CHUNK = 2**22  # size at which contact_replay closes a chunk


class Interrupted(ReplayCase):
    def setUp(self):
        super().setUp()
        self.bag = self.make_bag(PAIRS)
        self.options = ["--keep-topics", "--threads", "2", "--config", self.config(f"contact: {{hold_last: {HELD}}}\n")]

    def make_bag(self, count, name="in.bag"):
        """Writes pairs; in half of them the wheelset is beside the rails. Most of their results are held.

        At 0.09 m the search for the contact ends without one, which takes 20 times the time of another state: one run of ten.
        The other runs are beyond the accepted positions."""
        def change(i, there, _):
            if i % (2 * REFUSED) >= REFUSED:
                there.pose.position.y = 0.12 if i // (2 * REFUSED) % 10 else 0.09

        return self.write_bag(pairs(range(count), change=change), name)

    def interrupt(self, name, signal_number, size=1.5 * CHUNK):
        """Starts a run, and ends it when its bag is larger than `size` [B]. @return path of the bag, and the exit status"""
        out = self.folder / name
        with subprocess.Popen([PROGRAM, self.bag, out, *self.options, "--csv", out.with_suffix(".csv")],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as run:
            while run.poll() is None and not (out.exists() and out.stat().st_size > size):
                time.sleep(0.002)
            run.send_signal(signal_number)
            return out, run.wait()

    def resume(self, out, *more, status=0):
        return self.replay(self.bag, out.name, *self.options, "--csv", out.with_suffix(".csv"), "--resume", *more,
                           status=status)[1]

    def test_resumed_run_writes_the_same_bytes_as_an_uninterrupted_run(self):
        whole, _ = self.replay(self.bag, "whole.bag", *self.options, "--csv", self.folder / "whole.csv")
        for signal_number in (signal.SIGINT, signal.SIGKILL):
            with self.subTest(signal=signal_number):
                out, status = self.interrupt(f"{signal_number}.bag", signal_number)
                self.assertEqual(status, INTERRUPTED if signal_number == signal.SIGINT else -signal_number)
                if signal_number == signal.SIGINT:
                    with rosbag.Bag(str(out)) as bag:
                        results = bag.get_message_count(RESULTS)
                    self.assertTrue(200 < results < PAIRS, results)
                printed = self.resume(out)
                self.assertRegex(printed, r"; [1-9]\d+ results were already in the output")
                self.assert_same_file(whole, out)
                self.assert_same_file(whole.with_suffix(".csv"), out.with_suffix(".csv"))
        self.resume(whole)
        self.assert_same_file(whole, out)

    def test_table_is_continued_if_the_bag_contains_no_complete_chunk(self):
        self.bag = self.make_bag(300, "short.bag")  # its results do not fill a chunk
        whole, _ = self.replay(self.bag, "whole.bag", *self.options, "--csv", self.folder / "whole.csv")
        killed, _ = self.interrupt("killed.bag", signal.SIGKILL, size=4096)  # the header of the bag is written
        copy = self.folder / "copy.bag"
        for suffix in (".bag", ".csv"):
            shutil.copy(whole.with_suffix(suffix), copy.with_suffix(suffix))
        for out in (killed, copy):
            self.resume(out)
            self.assert_same_file(whole, out)
            self.assert_same_file(whole.with_suffix(".csv"), out.with_suffix(".csv"))

    def test_file_that_is_not_the_table_is_reported_and_not_changed(self):
        out, _ = self.interrupt("out.bag", signal.SIGINT)
        bag, table = out.read_bytes(), out.with_suffix(".csv")
        header = table.read_text(encoding="utf-8").splitlines()[0]
        for content, reason in (("a table\n", "is not a table written by contact_replay"),
                                (header + "\nseven,\n", "does not begin with the number of a result: seven,"),
                                (header + "\n", "rows of results that are in the bag are missing")):
            out.write_bytes(bag)
            table.write_text(content, encoding="utf-8")
            self.assertIn(reason, self.resume(out, status=1))
            self.assertEqual(table.read_text(encoding="utf-8"), content)

    def test_resuming_with_other_parameters_is_refused(self):
        out, _ = self.interrupt("out.bag", signal.SIGINT)
        before = out.read_bytes()
        printed = self.resume(out, "--config", self.config("contact: {tolerance: 0.05}\n", "other.yaml"), status=1)
        self.assertIn("cannot be resumed", printed)
        self.assertTrue(out.read_bytes() == before)

    def test_input_is_not_accepted_as_output(self):
        before = self.bag.read_bytes()
        _, printed = self.replay(self.bag, self.bag.name, "--resume", status=1)
        self.assertIn("cannot be resumed", printed)
        self.assertTrue(self.bag.read_bytes() == before)

    def test_resuming_without_output_runs_from_the_beginning(self):
        bag = self.make_bag(30, "short.bag")
        once, _ = self.replay(bag, "once.bag")
        resumed, _ = self.replay(bag, "resumed.bag", "--resume")
        self.assert_same_file(once, resumed)
