# SPDX-License-Identifier: BSD-3-Clause
"""The shipped bag is the output of its script, and contains the documented sweep."""

import filecmp
import pathlib
import subprocess
import sys
import tempfile
import unittest

import rosbag

PACKAGE = pathlib.Path(__file__).resolve().parents[3]
SHIPPED = PACKAGE / "bags" / "manchester_sweep.bag"


class ManchesterBag(unittest.TestCase):
    def test_shipped_bag_is_the_output_of_the_script(self):
        with tempfile.TemporaryDirectory() as folder:
            made = pathlib.Path(folder) / "made.bag"
            subprocess.run([sys.executable, PACKAGE / "scripts" / "make_manchester_bag", made], check=True)
            self.assertTrue(filecmp.cmp(made, SHIPPED, shallow=False))

    def test_every_pose_has_a_load_with_the_same_stamp(self):
        with rosbag.Bag(str(SHIPPED)) as bag:
            poses = [message for _, message, _ in bag.read_messages("wheelset/pose")]
            loads = [message for _, message, _ in bag.read_messages("wheelset/load")]
        self.assertEqual([(m.header.stamp, m.header.frame_id) for m in poses],
                         [(m.header.stamp, m.header.frame_id) for m in loads])
        self.assertEqual({m.wrench.force.z for m in loads}, {-200e3})
        lateral = [m.pose.position.y for m in poses]
        self.assertEqual((lateral[0], min(lateral), max(lateral), lateral[-1]), (0, -0.010, 0, 0))
        largest_step = max(abs(a - b) for a, b in zip(lateral, lateral[1:]))
        self.assertAlmostEqual(largest_step, 1e-4, delta=1e-12)

    def test_shipped_bag_is_smaller_than_200_kilobytes(self):
        self.assertLess(SHIPPED.stat().st_size, 200e3)
