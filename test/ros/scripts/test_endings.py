# SPDX-License-Identifier: BSD-3-Clause
"""contact_node outlives its master and garbled messages, and ends when it is told to, also in the middle of an evaluation."""

import os
import re
import signal
import socket
import subprocess
import tempfile
import time
import unittest

import rospy
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped, WrenchStamped
from wheel_rail_contact.msg import WheelsetContact

NODE = os.environ["CONTACT_NODE"]
PATIENCE = 60   # [s] for what must happen
EXIT_TIME = float(os.environ["EXIT_TIME"])  # [s] for a node to end; the evaluation that is going on takes minutes
TRIES = 3  # of which one must end in that time: the machine may be busy
PROFILES = ["_wheel/profile:=S1002", "_rail/profile:=60E1"]
PAIRS = 150  # fewer than the node keeps waiting
QUEUE = 2 * PAIRS  # of publishers, so that they drop none
ON_THE_WAY = 3  # answers that may be lost between a node that ends and its listener
BRISK = ["_contact/method:=seidel", "_contact/grid/along:=64", "_contact/grid/across:=64"]
# The slowest method on its largest grid.
SLOW = ["_contact/method:=seidel", "_contact/grid/along:=256", "_contact/grid/across:=256"]


def wait_for(condition):
    end = time.monotonic() + PATIENCE
    while not condition() and time.monotonic() < end:
        time.sleep(0.02)
    return condition()


def is_listened_to(address):
    with socket.socket() as probe:
        return probe.connect_ex(address) == 0


def free_address():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()


class GarbledPose(PoseStamped):
    """Goes over the wire as the bytes given, whatever they are."""

    _has_header = False  # which rospy would fill in

    def __init__(self, content):
        super().__init__()
        self.content = content

    def serialize(self, buff):
        buff.write(self.content)


class Node:
    """A contact node in a namespace of its own, and its client."""

    def __init__(self, name, parameters):
        self.answers = []
        self.report = {}
        self.poses = rospy.Publisher(f"/{name}/wheelset/pose", PoseStamped, queue_size=QUEUE)
        self.loads = rospy.Publisher(f"/{name}/wheelset/load", WrenchStamped, queue_size=QUEUE)
        self.listeners = [rospy.Subscriber(f"/{name}/contact_node/contact", WheelsetContact, self.answers.append),
                          rospy.Subscriber("/diagnostics", DiagnosticArray, self.take_report)]
        self.topic = f"{name}/contact_node"
        self.log = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen([NODE, f"__ns:=/{name}", *PROFILES, *parameters], stdout=subprocess.DEVNULL,
                                        stderr=self.log)

    def take_report(self, message):
        for status in message.status:
            if status.name.startswith(self.topic):
                self.report = {value.key: value.value for value in status.values}

    def is_connected(self):
        return all(end.get_num_connections() > 0 for end in (self.poses, self.loads, *self.listeners))

    def send(self, seconds):
        pose, load = PoseStamped(), WrenchStamped()
        pose.header.stamp = load.header.stamp = rospy.Time(seconds)
        pose.header.frame_id = "track"
        pose.pose.orientation.w = 1
        load.wrench.force.z = -200e3
        self.poses.publish(pose)
        self.loads.publish(load)

    def end(self, signal_number):
        """@return exit status"""
        self.process.send_signal(signal_number)
        return self.process.wait(PATIENCE)

    def said(self):
        self.log.seek(0)
        return self.log.read()

    def unanswered(self):
        """As told at its end."""
        found = re.search(rf"/{self.topic} ends, inputs unanswered: (\d+)", self.said())
        return int(found[1]) if found else 0

    def clean_up(self):
        self.process.kill()
        self.process.wait()
        print(self.said(), end="")
        self.log.close()


class Endings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.address = free_address()
        os.environ["ROS_MASTER_URI"] = f"http://127.0.0.1:{cls.address[1]}"
        cls.start_master()
        rospy.init_node("endings", disable_signals=True, disable_rosout=True)

    @classmethod
    def start_master(cls):
        cls.master = subprocess.Popen(["rosmaster", "--core", "-p", str(cls.address[1])], stdout=subprocess.DEVNULL,
                                      stderr=subprocess.DEVNULL)
        assert wait_for(lambda: is_listened_to(cls.address)), "the master does not start"

    @classmethod
    def tearDownClass(cls):
        cls.master.kill()
        cls.master.wait()

    def start_node(self, name, *parameters):
        node = Node(name, parameters)
        self.addCleanup(node.clean_up)
        self.assertTrue(wait_for(node.is_connected), "the node does not come up")
        time.sleep(0.2)  # the node learns of its listener a moment later
        return node

    def end_busy_node(self, name, signal_number):
        """@return time that it takes to end [s]"""
        node = self.start_node(name, *SLOW)
        for seconds in (1, 2, 3):
            node.send(seconds)
        self.assertTrue(wait_for(lambda: node.report.get("messages received") == "6"), node.report)
        self.assertEqual(node.report["messages waiting for a partner"], "0")
        begin = time.monotonic()
        self.assertEqual(node.end(signal_number), 0)
        taken = time.monotonic() - begin
        self.assertEqual(node.answers, [], "the evaluation had ended")
        self.assertEqual(node.unanswered(), 3)
        return taken

    # unittest goes by the alphabet: the master is killed last, for rospy registers its old topics with no other.

    def test_ends_at_signals_in_the_middle_of_an_evaluation(self):
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=signal_number):
                times = []
                while not times or (times[-1] > EXIT_TIME and len(times) < TRIES):
                    times.append(self.end_busy_node(f"busy_{signal_number}_{len(times)}", signal_number))
                self.assertLess(min(times), EXIT_TIME)

    def test_goes_on_after_bytes_that_are_no_message(self):
        node = self.start_node("garbled")
        garbled = [filling * length for length in (0, 3, 12, 16, 40) for filling in (b"\0", b"\xff")]
        for content in garbled:
            node.poses.publish(GarbledPose(content))
        node.send(1)
        self.assertTrue(wait_for(lambda: len(node.answers) == 1), "no answer after garbled messages")
        self.assertEqual(node.answers[0].status, WheelsetContact.OK)
        self.assertTrue(wait_for(lambda: node.report.get("messages received") == "2"), node.report)
        self.assertEqual(node.end(signal.SIGINT), 0)
        self.assertEqual(node.said().count("Buffer Overrun"), len(garbled), "each is told in the log, by roscpp")
        self.assertEqual(node.unanswered(), 0)

    def test_leaves_no_input_unmentioned_at_its_end(self):
        node = self.start_node("leaving", *BRISK)
        for i in range(PAIRS):
            node.send(1 + i)
        self.assertTrue(wait_for(lambda: node.report.get("messages received") == str(2 * PAIRS)), node.report)
        self.assertEqual(node.end(signal.SIGINT), 0)
        self.assertGreater(node.unanswered(), 0, "all were answered before the end")
        self.assertTrue(wait_for(lambda: PAIRS - len(node.answers) - node.unanswered() <= ON_THE_WAY))
        self.assertLessEqual(len(node.answers) + node.unanswered(), PAIRS)

    def test_outlives_its_master(self):
        node = self.start_node("alone")
        node.send(1)
        self.assertTrue(wait_for(lambda: len(node.answers) == 1))
        self.master.kill()
        self.master.wait()
        node.send(2)
        self.assertTrue(wait_for(lambda: len(node.answers) == 2), "no answer without a master")
        self.start_master()
        node.send(3)
        self.assertTrue(wait_for(lambda: len(node.answers) == 3), "no answer beside another master")
        self.assertEqual([answer.status for answer in node.answers], [WheelsetContact.OK] * 3)
        self.assertEqual(node.end(signal.SIGTERM), 0)
        self.assertEqual(node.unanswered(), 0)


if __name__ == "__main__":
    unittest.main()
