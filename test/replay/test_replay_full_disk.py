# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay on outputs that cannot be written: it says which, ends non-zero, and can be resumed."""

import subprocess
import unittest

from full_disk import no_file_larger_than
from replay_case import PROGRAM, ReplayCase

PAIRS = 1500


class FullDisk(ReplayCase):
    def setUp(self):
        super().setUp()
        self.bag = self.make_bag(PAIRS)

    def run_out_of_space(self, out, size, *options):
        run = subprocess.run([PROGRAM, self.bag, out, *options], capture_output=True, text=True, check=False,
                             preexec_fn=no_file_larger_than(size))
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        return run.stderr

    def test_bag_that_cannot_grow_is_named_and_can_be_resumed(self):
        whole, _ = self.replay(self.bag, "whole.bag")
        self.assertIn("out.bag: File too large", self.run_out_of_space(self.folder / "out.bag", 6 * 2**20))
        out, printed = self.replay(self.bag, "out.bag", "--resume")
        self.assertRegex(printed, r"; [1-9]\d+ were there already")
        self.assert_same_file(whole, out)

    def test_table_that_cannot_grow_is_named_and_can_be_resumed(self):
        # Without grids the rows are as long as the answers, and go to their file earlier.
        options = ["--no-grids", "--csv", self.folder / "whole.csv"]
        whole, _ = self.replay(self.bag, "whole.bag", *options)
        options[-1] = self.folder / "out.csv"
        self.assertIn("out.csv: cannot be written", self.run_out_of_space(self.folder / "out.bag", 2**18, *options))
        out, _ = self.replay(self.bag, "out.bag", *options, "--resume")
        self.assert_same_file(whole, out)
        self.assert_same_file(whole.with_suffix(".csv"), out.with_suffix(".csv"))

    def test_places_that_cannot_be_written_are_named_before_the_work(self):
        # Nobody may make files in /sys, nor root.
        for place in ("/dev/full", "/sys/out.bag", self.folder / "nowhere" / "out.bag"):
            with self.subTest(place=place):
                run = subprocess.run([PROGRAM, self.bag, place], capture_output=True, text=True, check=False)
                self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
                self.assertIn(str(place), run.stderr)
                run = subprocess.run([PROGRAM, self.bag, self.folder / "out.bag", "--csv", place], capture_output=True,
                                     text=True, check=False)
                self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
                self.assertIn(str(place), run.stderr)
                self.assertFalse((self.folder / "out.bag").exists())


if __name__ == "__main__":
    unittest.main()
