# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay with outputs that cannot be written: it reports the file, exits with 1, and can be resumed."""

import subprocess

from commands import error_without_space
from replay_case import PROGRAM, ReplayCase

PAIRS = 1500


class FullDisk(ReplayCase):
    def setUp(self):
        super().setUp()
        self.bag = self.make_bag(PAIRS)

    def test_full_disk_of_the_bag_is_reported_and_the_run_can_be_resumed(self):
        whole, _ = self.replay(self.bag, "whole.bag")
        self.assertIn("out.bag: File too large", error_without_space(6 * 2**20, PROGRAM, self.bag, self.folder / "out.bag"))
        out, printed = self.replay(self.bag, "out.bag", "--resume")
        self.assertRegex(printed, r"; [1-9]\d+ results were already in the output")
        self.assert_same_file(whole, out)

    def test_full_disk_of_the_table_is_reported_and_the_run_can_be_resumed(self):
        # Without grids the rows are as long as the results, and are written earlier.
        options = ["--no-grids", "--csv", self.folder / "whole.csv"]
        whole, _ = self.replay(self.bag, "whole.bag", *options)
        options[-1] = self.folder / "out.csv"
        self.assertIn("out.csv: cannot be written",
                      error_without_space(2**18, PROGRAM, self.bag, self.folder / "out.bag", *options))
        out, _ = self.replay(self.bag, "out.bag", *options, "--resume")
        self.assert_same_file(whole, out)
        self.assert_same_file(whole.with_suffix(".csv"), out.with_suffix(".csv"))

    def test_paths_that_cannot_be_written_are_reported_before_the_evaluation(self):
        # Not even root can create files in /sys.
        for path in ("/dev/full", "/sys/out.bag", self.folder / "nowhere" / "out.bag"):
            for outputs in ([path], [self.folder / "out.bag", "--csv", path]):
                run = subprocess.run([PROGRAM, self.bag, *outputs], capture_output=True, text=True, check=False)
                self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
                self.assertIn(str(path), run.stderr)
                self.assertFalse((self.folder / "out.bag").exists())
