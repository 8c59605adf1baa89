# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay broken off: a readable bag after Ctrl-C, and --resume ends as if nothing had happened."""

import shutil
import signal
import subprocess
import time

import rosbag

from replay_case import ANSWERS, BROKEN_OFF, PROGRAM, ReplayCase

PAIRS = 3000
CHUNK = 2**22  # size at which contact_replay closes a chunk


class BrokenOff(ReplayCase):
    def setUp(self):
        super().setUp()
        self.bag = self.make_bag(PAIRS)
        self.options = ["--keep-topics", "--threads", "2"]

    def break_off(self, name, signal_number, size=1.5 * CHUNK):
        """Starts a run and ends it when its bag is larger than this [B]: by itself, when chunks are in the file."""
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

    def test_resumed_run_equals_one_run(self):
        whole, _ = self.replay(self.bag, "whole.bag", *self.options, "--csv", self.folder / "whole.csv")
        for signal_number in (signal.SIGINT, signal.SIGKILL):
            with self.subTest(signal=signal_number):
                out, status = self.break_off(f"{signal_number}.bag", signal_number)
                self.assertEqual(status, BROKEN_OFF if signal_number == signal.SIGINT else -signal_number)
                if signal_number == signal.SIGINT:
                    with rosbag.Bag(str(out)) as bag:
                        answers = bag.get_message_count(ANSWERS)
                    self.assertTrue(200 < answers < PAIRS, answers)
                printed = self.resume(out)
                self.assertRegex(printed, r"; [1-9]\d+ were there already")
                self.assert_same_file(whole, out)
                self.assert_same_file(whole.with_suffix(".csv"), out.with_suffix(".csv"))
        self.resume(whole)
        self.assert_same_file(whole, out)

    def test_table_goes_on_where_no_whole_chunk_is_in_the_bag(self):
        self.bag = self.make_bag(300, "short.bag")  # its answers do not fill a chunk
        whole, _ = self.replay(self.bag, "whole.bag", *self.options, "--csv", self.folder / "whole.csv")
        killed, _ = self.break_off("killed.bag", signal.SIGKILL, size=4096)  # the bag's header stands
        copy = self.folder / "copy.bag"
        for suffix in (".bag", ".csv"):
            shutil.copy(whole.with_suffix(suffix), copy.with_suffix(suffix))
        for out in (killed, copy):
            self.resume(out)
            self.assert_same_file(whole, out)
            self.assert_same_file(whole.with_suffix(".csv"), out.with_suffix(".csv"))

    def test_what_is_no_table_is_told_and_left_alone(self):
        out, _ = self.break_off("out.bag", signal.SIGINT)
        bag, table = out.read_bytes(), out.with_suffix(".csv")
        header = table.read_text(encoding="utf-8").splitlines()[0]
        for content, reason in (("a table\n", "is not the table of a replay"),
                                (header + "\nseven,\n", "does not begin with the number of an answer: seven,"),
                                (header + "\n", "lacks rows of answers that are in the bag")):
            out.write_bytes(bag)
            table.write_text(content, encoding="utf-8")
            self.assertIn(reason, self.resume(out, status=1))
            self.assertEqual(table.read_text(encoding="utf-8"), content)

    def test_resuming_with_other_parameters_is_refused(self):
        out, _ = self.break_off("out.bag", signal.SIGINT)
        before = out.read_bytes()
        (self.folder / "other.yaml").write_text("contact: {tolerance: 0.05}\n")
        printed = self.resume(out, "--config", self.folder / "other.yaml", status=1)
        self.assertIn("cannot be resumed", printed)
        self.assertTrue(out.read_bytes() == before)

    def test_the_input_is_not_taken_for_an_output(self):
        before = self.bag.read_bytes()
        _, printed = self.replay(self.bag, self.bag.name, "--resume", status=1)
        self.assertIn("cannot be resumed", printed)
        self.assertTrue(self.bag.read_bytes() == before)

    def test_resuming_nothing_is_a_run_from_the_beginning(self):
        bag = self.make_bag(30, "short.bag")
        once, _ = self.replay(bag, "once.bag")
        resumed, _ = self.replay(bag, "resumed.bag", "--resume")
        self.assert_same_file(once, resumed)


if __name__ == "__main__":
    import unittest
    unittest.main()
