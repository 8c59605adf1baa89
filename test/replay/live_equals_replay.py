#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A bag played through the live node gives the results of contact_replay: the same bytes in the same order."""

import io
import math
import pathlib
import subprocess
import sys
import tempfile
import time

import rosbag
import roslib.packages
import rospkg
import rospy
import rostest
from commands import FolderCase
from geometry_msgs.msg import PointStamped, TwistStamped, WrenchStamped
from wheel_rail_contact.msg import RailDisplacements, WheelsetContact

PACKAGE = pathlib.Path(rospkg.RosPack().get_path("wheel_rail_contact"))
BAG = PACKAGE / "bags" / "manchester_sweep.bag"
CONFIG = PACKAGE / "config" / "manchester.yaml"
ALL_INPUTS = PACKAGE / "test" / "replay" / "inputs.yaml"
LOCKSTEP = PACKAGE / "test" / "ros" / "live" / "holding.yaml"
SLOW_LOADS = PACKAGE / "test" / "replay" / "slow_loads.yaml"
SHIFT = rospy.Duration(0, 3_000_000)  # of the stamps of the loads
TIMEOUT = 60  # [s] of wall time
BESIDE = 0.09  # y of a wheelset beside the rails, for which there is no usable result [m]


def wait_for(condition):
    end = time.monotonic() + TIMEOUT
    while not condition() and time.monotonic() < end:
        time.sleep(0.01)
    return condition()


def replayed(bag, config, wheelset):
    """Results of contact_replay as bytes."""
    program = roslib.packages.find_node("wheel_rail_contact", "contact_replay")[0]
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.bag"
        subprocess.run([program, bag, out, "--config", config, *(("--wheelset", wheelset) if wheelset else ())], check=True)
        with rosbag.Bag(str(out)) as results:
            return [raw[1] for _, raw, _ in results.read_messages(raw=True)]


def additional_inputs(number, header):
    """Displacements of the rails, distance, and forces on the rails for a pose of the sweep, as pairs of topic and message."""
    turn = 0.1 * number
    displacements = RailDisplacements(header=header)
    displacements.left.lateral, displacements.left.vertical = 1e-3 * math.sin(turn), 5e-4 * math.cos(turn)
    displacements.right.lateral, displacements.right.roll = 1e-3 * math.cos(turn), 2e-3 * math.sin(turn)
    distance = PointStamped(header=header)
    distance.point.x = 1000 + 0.5 * number
    left, right = WrenchStamped(header=header), WrenchStamped(header=header)
    left.wrench.force.y, right.wrench.force.y = 5e3 * math.sin(turn), 5e3 * math.cos(turn)
    twist = TwistStamped(header=header)
    twist.twist.linear.x = (20 if number % 50 < 40 else -15) + math.sin(number)
    twist.twist.linear.y = 0.02 * math.sin(number)
    return (("rail_displacement", displacements), ("distance", distance), ("left_rail_force", left),
            ("right_rail_force", right), ("twist", twist))


def write_slow_loads(path):
    """Writes the poses of the sweep, and loads at a third of their rate whose stamps are between those of the poses."""
    with rosbag.Bag(str(BAG)) as source, rosbag.Bag(str(path), "w") as bag:
        for _, pose, at in source.read_messages(topics="wheelset/pose"):
            bag.write("/slow_loads/wheelset/pose", pose, at)
        for number, (_, load, at) in enumerate(source.read_messages(topics="wheelset/load")):
            if number % 3 == 0:
                load.header.stamp += SHIFT
                load.wrench.force.z *= 1 + 0.2 * math.sin(0.3 * number)
                bag.write("/slow_loads/wheelset/load", load, at + SHIFT)


def write_lockstep(path):
    """Writes the sweep twice per stamp, as by a predictor and a corrector. Some states are not usable."""
    with rosbag.Bag(str(BAG)) as source, rosbag.Bag(str(path), "w") as bag:
        loads = {load.header.stamp: load for _, load, _ in source.read_messages(topics="wheelset/load")}
        for number, (_, pose, at) in enumerate(source.read_messages(topics="wheelset/pose")):
            for evaluation in range(2):
                if number % 20 in (7, 8, 12):
                    pose.pose.position.y = math.nan if number % 20 == 12 else BESIDE
                pose.pose.position.y += 1e-5 * evaluation
                bag.write("/lockstep/wheelset/pose", pose, at)
                bag.write("/lockstep/wheelset/load", loads[pose.header.stamp], at)


def write_all_inputs(path):
    """Writes the sweep with all input topics, each in turn as the last of its pair."""
    with rosbag.Bag(str(BAG)) as source, rosbag.Bag(str(path), "w") as bag:
        messages = list(source.read_messages())
        poses = [(message, at) for topic, message, at in messages if topic.endswith("pose")]
        loads = {message.header.stamp: message for topic, message, _ in messages if topic.endswith("load")}
        for number, (pose, at) in enumerate(poses):
            inputs = [("pose", pose), ("load", loads[pose.header.stamp]), *additional_inputs(number, pose.header)]
            for k in range(len(inputs)):
                topic, message = inputs[(number + k) % len(inputs)]
                bag.write(f"/all_inputs/wheelset/{topic}", message, at)


class LiveEqualsReplay(FolderCase):
    def compare(self, bag, config, wheelset=""):
        """Plays a bag through the live node of a wheelset. @return results of contact_replay"""
        live = []
        subscriber = rospy.Subscriber(f"{wheelset}/contact_node/contact", rospy.AnyMsg,
                                      lambda message: live.append(message._buff))
        self.assertTrue(wait_for(lambda: subscriber.get_num_connections() > 0))
        play = roslib.packages.find_node("rosbag", "play")[0]
        subprocess.run([play, "--quiet", "--clock", "--wait-for-subscribers", "--delay=1", bag], check=True)
        expected = replayed(bag, config, wheelset)
        self.assertTrue(wait_for(lambda: len(live) >= len(expected)), f"{len(live)} of {len(expected)} results")
        self.assertEqual(len(live), len(expected))
        for number, (one, other) in enumerate(zip(live, expected)):
            self.assertTrue(without_time(one) == without_time(other), f"result {number}:\n{difference(one, other)}")
        return [WheelsetContact().deserialize(data) for data in expected]

    def test_live_node_and_replay_give_the_same_bytes_in_the_same_order(self):
        self.compare(BAG, CONFIG)

    def test_same_with_loads_of_a_lower_rate_that_are_interpolated(self):
        bag = self.folder / "slow_loads.bag"
        write_slow_loads(bag)
        results = self.compare(bag, SLOW_LOADS, "/slow_loads")
        self.assertGreater(len(results), 190)
        self.assertEqual({result.status for result in results}, {WheelsetContact.OK})

    def test_same_with_repeated_stamps_and_held_results(self):
        bag = self.folder / "lockstep.bag"
        write_lockstep(bag)
        results = self.compare(bag, LOCKSTEP, "/lockstep")
        with rosbag.Bag(str(BAG)) as source:
            self.assertEqual(len(results), 2 * source.get_message_count("wheelset/pose"))
        self.assertGreater(sum(result.held for result in results), 20)
        self.assertGreater(sum(result.status > WheelsetContact.LIFT_OFF and not result.held for result in results), 5)

    def test_same_with_displacements_distances_and_forces_of_the_rails(self):
        bag = self.folder / "all_inputs.bag"
        write_all_inputs(bag)
        results = self.compare(bag, ALL_INPUTS, "/all_inputs")
        self.assertGreater(len([result for result in results if result.status == WheelsetContact.OK]), 0.9 * len(results))
        self.assertGreater(max(result.right_rail.given_roll for result in results), 1e-3)
        for direction in 1, -1:
            pulls = [abs(patch.creep.force_x) for result in results if result.speed * direction > 0 for patch in result.patches]
            self.assertGreater(max(pulls), 1e3)


def without_time(data):
    """A result without solve_time, which is wall time, and 0 in a replay."""
    message = WheelsetContact().deserialize(data)
    message.solve_time = 0
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


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
