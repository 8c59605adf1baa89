# SPDX-License-Identifier: BSD-3-Clause
"""contact_node works without its master and after malformed messages, and ends on signals, even during an evaluation."""

import inspect
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

import rospy
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped, WrenchStamped
from wheel_rail_contact.msg import WheelsetContact

NODE = os.environ["CONTACT_NODE"]
SCRIPTS = pathlib.Path(__file__).resolve().parents[3] / "scripts"
TIMEOUT = 60   # [s] for each expected event
PROFILES = ["_wheel/profile:=S1002", "_rail/profile:=60E1"]
PAIRS = 150  # less than the largest number of inputs that the node queues
QUEUE = 2 * PAIRS  # of the publishers: large enough for all messages
IN_TRANSIT = 3  # results that may be lost between a node that ends and its subscriber
FAST = ["_contact/method:=seidel", "_contact/grid/along:=64", "_contact/grid/across:=64"]
# The slowest method on its largest grid: an evaluation takes minutes, which is longer than TIMEOUT.
SLOW = ["_contact/method:=seidel", "_contact/grid/along:=256", "_contact/grid/across:=256"]


def wait_for(condition):
    end = time.monotonic() + TIMEOUT
    while not condition() and time.monotonic() < end:
        time.sleep(0.02)
    return condition()


def accepts_connections(address):
    with socket.socket() as probe:
        return probe.connect_ex(address) == 0


def free_address():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()


class MalformedPose(PoseStamped):
    """A message that is sent as the given bytes."""

    _has_header = False  # otherwise rospy would fill in the header

    def __init__(self, content):
        super().__init__()
        self.content = content

    def serialize(self, buff):
        buff.write(self.content)


class Node:
    """A contact node in its own namespace, with publishers and subscribers."""

    def __init__(self, name, parameters):
        self.results = []
        self.diagnostics = {}
        self.poses = rospy.Publisher(f"/{name}/wheelset/pose", PoseStamped, queue_size=QUEUE)
        self.loads = rospy.Publisher(f"/{name}/wheelset/load", WrenchStamped, queue_size=QUEUE)
        self.subscribers = [rospy.Subscriber(f"/{name}/contact_node/contact", WheelsetContact, self.results.append),
                          rospy.Subscriber("/diagnostics", DiagnosticArray, self.take_diagnostics)]
        self.topic = f"{name}/contact_node"
        self.log = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen([NODE, f"__ns:=/{name}", *PROFILES, *parameters], stdout=subprocess.DEVNULL,
                                        stderr=self.log)

    def take_diagnostics(self, message):
        for status in message.status:
            if status.name == f"{self.topic}: wheel-rail contact":
                self.diagnostics = {value.key: value.value for value in status.values}

    def is_connected(self):
        return all(end.get_num_connections() > 0 for end in (self.poses, self.loads, *self.subscribers))

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
        return self.process.wait(TIMEOUT)

    def output(self):
        self.log.seek(0)
        return self.log.read()

    def not_evaluated(self):
        """Number of inputs that the node reports as not evaluated when it ends."""
        found = re.search(rf"/{self.topic} ends, inputs not evaluated: (\d+)", self.output())
        return int(found[1]) if found else 0

    def clean_up(self):
        self.process.kill()
        self.process.wait()
        print(self.output(), end="")
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
        assert wait_for(lambda: accepts_connections(cls.address)), "the master did not start"

    @classmethod
    def tearDownClass(cls):
        cls.master.kill()
        cls.master.wait()

    def start_node(self, name, *parameters):
        node = Node(name, parameters)
        self.addCleanup(node.clean_up)
        self.assertTrue(wait_for(node.is_connected), "the node did not start")
        time.sleep(0.2)  # the connection is complete at the node a moment later
        return node

    def end_busy_node(self, name, signal_number):
        """Ends a node during its evaluation, without waiting for the result."""
        node = self.start_node(name, *SLOW)
        for seconds in (1, 2, 3):
            node.send(seconds)
        self.assertTrue(wait_for(lambda: node.diagnostics.get("messages received") == "6"), node.diagnostics)
        self.assertEqual(node.diagnostics["messages waiting for a match"], "0")
        self.assertEqual(node.end(signal_number), 0)
        self.assertEqual(node.results, [], "the evaluation ended before the signal")
        self.assertEqual(node.not_evaluated(), 3)

    # unittest runs the tests in alphabetical order. The test that kills the master must be the last with a node: rospy does not
    # register its topics with a new master.

    def test_node_ends_on_signals_during_an_evaluation(self):
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=signal_number):
                self.end_busy_node(f"busy_{signal_number}", signal_number)

    def test_node_continues_after_malformed_messages(self):
        node = self.start_node("malformed")
        malformed = [filling * length for length in (0, 3, 12, 16, 40) for filling in (b"\0", b"\xff")]
        for content in malformed:
            node.poses.publish(MalformedPose(content))
        node.send(1)
        self.assertTrue(wait_for(lambda: len(node.results) == 1), "no result after malformed messages")
        self.assertEqual(node.results[0].status, WheelsetContact.OK)
        self.assertTrue(wait_for(lambda: node.diagnostics.get("messages received") == "2"), node.diagnostics)
        self.assertEqual(node.end(signal.SIGINT), 0)
        self.assertEqual(node.diagnostics["messages dropped: truncated or damaged"], str(len(malformed)))
        self.assertEqual(node.output().count("is truncated or damaged"), 1, "not one line for each of them")
        self.assertEqual(node.not_evaluated(), 0)

    def test_node_reports_all_inputs_that_are_not_evaluated_at_its_end(self):
        node = self.start_node("leaving", *FAST)
        for i in range(PAIRS):
            node.send(1 + i)
        self.assertTrue(wait_for(lambda: node.diagnostics.get("messages received") == str(2 * PAIRS)), node.diagnostics)
        self.assertEqual(node.end(signal.SIGINT), 0)
        self.assertGreater(node.not_evaluated(), 0, "all were evaluated before the end")
        self.assertTrue(wait_for(lambda: PAIRS - len(node.results) - node.not_evaluated() <= IN_TRANSIT))
        self.assertLessEqual(len(node.results) + node.not_evaluated(), PAIRS)

    def test_print_patches_without_a_master_ends_on_signals_in_one_sentence(self):
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            command = subprocess.Popen([sys.executable, "-u", SCRIPTS / "print_patches"], text=True,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                       env={**os.environ, "ROS_MASTER_URI": f"http://127.0.0.1:{free_address()[1]}"})
            self.addCleanup(command.kill)
            self.assertIn("master may not be running yet", command.stdout.readline())
            command.send_signal(signal_number)
            errors = command.communicate(timeout=TIMEOUT)[1]
            if "isAlive" in inspect.getsource(rospy.core.signal_shutdown):  # Debian 11: a traceback of rospy's own
                errors = errors[errors.rindex("\n", 0, -1):]
            self.assertEqual(errors, "\nprint_patches: interrupted\n")
            self.assertEqual(command.returncode, 130)

    def test_node_survives_its_master(self):
        node = self.start_node("alone")
        node.send(1)
        self.assertTrue(wait_for(lambda: len(node.results) == 1))
        self.master.kill()
        self.master.wait()
        node.send(2)
        self.assertTrue(wait_for(lambda: len(node.results) == 2), "no result without a master")
        self.start_master()
        node.send(3)
        self.assertTrue(wait_for(lambda: len(node.results) == 3), "no result with another master")
        self.assertEqual([result.status for result in node.results], [WheelsetContact.OK] * 3)
        self.assertEqual(node.end(signal.SIGTERM), 0)
        self.assertEqual(node.not_evaluated(), 0)
