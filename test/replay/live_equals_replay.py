#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A bag played through the live node gives the results of contact_replay: the same bytes in the same order."""

import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import rosbag
import roslib.packages
import rospkg
import rospy
import rostest
from wheel_rail_contact.msg import WheelsetContact

PACKAGE = pathlib.Path(rospkg.RosPack().get_path("wheel_rail_contact"))
BAG = PACKAGE / "bags" / "manchester_sweep.bag"
CONFIG = PACKAGE / "config" / "manchester.yaml"
RESULTS = "/contact_node/contact"
TIMEOUT = 60    # [s] of wall time
SOLVE_TIME = 8  # size of solve_time at the end of a result [B]: wall time, 0 in a replay


def wait_for(condition):
    end = time.monotonic() + TIMEOUT
    while not condition() and time.monotonic() < end:
        time.sleep(0.01)
    return condition()


def replayed():
    """Results of contact_replay as bytes."""
    program = roslib.packages.find_node("wheel_rail_contact", "contact_replay")[0]
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.bag"
        subprocess.run([program, BAG, out, "--config", CONFIG], check=True)
        with rosbag.Bag(str(out)) as bag:
            return [raw[1] for _, raw, _ in bag.read_messages(RESULTS, raw=True)]


class LiveEqualsReplay(unittest.TestCase):
    def test_live_node_and_replay_give_the_same_bytes_in_the_same_order(self):
        live = []
        subscriber = rospy.Subscriber(RESULTS, rospy.AnyMsg, lambda message: live.append(message._buff))
        self.assertTrue(wait_for(lambda: subscriber.get_num_connections() > 0))
        play = roslib.packages.find_node("rosbag", "play")[0]
        subprocess.run([play, "--quiet", "--clock", "--wait-for-subscribers", "--delay=1", BAG], check=True)
        expected = replayed()
        self.assertTrue(wait_for(lambda: len(live) >= len(expected)), f"{len(live)} of {len(expected)} results")
        self.assertEqual(len(live), len(expected))
        for number, (one, other) in enumerate(zip(live, expected)):
            self.assertTrue(one[:-SOLVE_TIME] == other[:-SOLVE_TIME], f"result {number}:\n{difference(one, other)}")


def difference(one, other):
    """Fields in which two results differ, without the grids."""
    texts = []
    for data in (one, other):
        message = WheelsetContact().deserialize(data)
        for patch in message.patches:
            patch.grid.pressure = []
        texts.append(str(message).splitlines())
    return "\n".join(f"{a.strip()} | {b.strip()}" for a, b in zip(*texts) if a != b)


if __name__ == "__main__":
    rospy.init_node("live_equals_replay")
    rostest.rosrun("wheel_rail_contact", "live_equals_replay", LiveEqualsReplay, sys.argv)
