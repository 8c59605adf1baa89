# SPDX-License-Identifier: BSD-3-Clause
"""The shipped bag of the paper's case is the output of its script, and gives the values of doc/paper.md."""
import filecmp
import pathlib
import subprocess
import sys

import rosbag
from commands import FolderCase

PACKAGE = pathlib.Path(__file__).resolve().parents[2]

SHIPPED = PACKAGE / "bags" / "paper.bag"
CONFIG = PACKAGE / "config" / "paper.yaml"


class PaperBag(FolderCase):
    def first_left_patch(self, name, *configs):
        options = [word for config in configs for word in ("--config", config)]
        with rosbag.Bag(str(self.replayed(SHIPPED, "--no-grids", *options, name=name))) as bag:
            results = [message for _, message, _ in bag.read_messages()]
        self.assertEqual(len(results), 66)
        return next(patch for patch in results[0].patches if patch.side == 0)

    def test_shipped_bag_is_the_output_of_the_script(self):
        subprocess.run([sys.executable, PACKAGE / "scripts" / "make_paper_bag", self.folder / "made.bag"], check=True)
        self.assertTrue(filecmp.cmp(self.folder / "made.bag", SHIPPED, shallow=False))
        self.assertLess(SHIPPED.stat().st_size, 50e3)

    def test_replay_gives_the_values_of_the_case(self):
        rigid = self.config("rail_bending: {model: none}\n")
        # The values of the table were computed on a finer grid. 0.3 %: the tolerance of paper.yaml is 0.2 %.
        for configs, pressure, area in (((CONFIG, rigid), 1182e6, 186.1e-6), ((CONFIG,), 1246e6, 180.1e-6)):
            patch = self.first_left_patch(f"{len(configs)}.bag", *configs)
            self.assertAlmostEqual(patch.max_pressure, pressure, delta=3e-3 * pressure)
            self.assertAlmostEqual(patch.area, area, delta=3e-3 * area)
