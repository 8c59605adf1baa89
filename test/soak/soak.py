#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sends the states of a hunting wheelset to a live node, and measures its memory and latency.

soak.py [MINUTES [CONFIG.yaml]]: simulated minutes (default: 60), and a parameter file applied over config/default.yaml.

The stamps have a rate of 1 kHz. The pairs are sent as fast as the node evaluates them. The program starts its own ROS master
and node. For each simulated minute (60000 pairs) it prints the resident memory of the node, and the median and 99 % quantile
of the latency. Latency is the time from a pair to its result while 100 pairs are in transit.

The exit status is 1 in one of these cases:
* A pair has no result.
* The memory differs by more than 2 MB from its value after the first minute.
* The latency (median) in the last third of the minutes is more than 1.5 times that in the first third.
"""

import io
import math
import os
import pathlib
import socket
import statistics
import struct
import subprocess
import sys
import threading
import time
import xmlrpc.client

import rospy
import yaml
from geometry_msgs.msg import PoseStamped, WrenchStamped
from roslib.packages import find_node

DEFAULTS = pathlib.Path(__file__).resolve().parents[2] / "config" / "default.yaml"
NODE = "contact_node"
PER_MINUTE = 60000
PERIOD = 7000       # number of pairs after which the motion repeats: 10 waves of 0.7 s, 7 of 1 s, 1 of 7 s
IN_TRANSIT = 100    # half the number of inputs that the node queues before it drops any
TIMEOUT = 60        # [s]
MAX_GROWTH = 2.0    # of the memory [MB]
MAX_SLOWDOWN = 1.5  # ratio of latencies; large, because other work on the machine also changes the latency


def resident(pid):
    """Resident memory of a process [MB]."""
    return int(pathlib.Path(f"/proc/{pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") * 1e-6


class Prepared:
    """A serialized message, in which only the stamp is changed when it is sent."""

    _has_header = False  # otherwise rospy would fill in the header

    def prepare(self):
        buffer = io.BytesIO()
        super().serialize(buffer)
        self.wire = bytearray(buffer.getvalue())
        return self

    def stamped(self, index):
        """Sets the stamp to 1 s + `index` milliseconds."""
        struct.pack_into("<II", self.wire, 4, 1 + index // 1000, index % 1000 * 1000000)
        return self

    def serialize(self, buff):
        buff.write(self.wire)


class PreparedPose(Prepared, PoseStamped):
    pass


class PreparedLoad(Prepared, WrenchStamped):
    pass


def pair(index):
    """Pose and load at `index` milliseconds. The wheelset hunts with an amplitude of 2 to 5 mm; at 5 mm its flange touches."""
    seconds = 1e-3 * index
    phase = 2 * math.pi * seconds / 0.7
    pose, load = PreparedPose(), PreparedLoad()
    pose.header.frame_id = "track"
    pose.pose.position.y = (3.5e-3 + 1.5e-3 * math.sin(2 * math.pi * seconds / 7)) * math.sin(phase)
    yaw = 2e-3 * math.cos(phase)
    pose.pose.orientation.z, pose.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    load.wrench.force.z = -1e5 * (1 + 0.2 * math.sin(2 * math.pi * seconds))
    load.wrench.torque.x = 1e4 * math.sin(phase)
    return pose.prepare(), load.prepare()


def start_master():
    """Starts a ROS master on a free port, also for this process."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    os.environ["ROS_MASTER_URI"] = f"http://127.0.0.1:{port}"
    master = subprocess.Popen(["rosmaster", "--core", "-p", str(port)], stdout=subprocess.DEVNULL)
    while master.poll() is None:
        try:
            xmlrpc.client.ServerProxy(os.environ["ROS_MASTER_URI"]).getPid("/soak")
            break
        except ConnectionError:
            time.sleep(0.1)
    return master


def start_node(config):
    """Starts the node with the default parameters, and the parameters of a file applied over them."""
    for path in filter(None, (DEFAULTS, config)):
        for group, values in yaml.safe_load(pathlib.Path(path).read_text()).items():
            rospy.set_param(f"{NODE}/{group}", values)
    return subprocess.Popen([find_node("wheel_rail_contact", NODE)[0]])


class Soak:
    def __init__(self):
        self.pairs = [pair(index) for index in range(PERIOD)]
        self.capacity = threading.Semaphore(IN_TRANSIT)
        self.sent = [0.0] * IN_TRANSIT * 2
        self.latencies = []
        self.results = 0
        self.pose = rospy.Publisher("wheelset/pose", PreparedPose, queue_size=1000, tcp_nodelay=True)
        self.load = rospy.Publisher("wheelset/load", PreparedLoad, queue_size=1000, tcp_nodelay=True)
        self.subscriber = rospy.Subscriber(NODE + "/contact", rospy.AnyMsg, self.receive, tcp_nodelay=True)

    def receive(self, message):
        _, seconds, nanoseconds = struct.unpack_from("<III", message._buff)
        index = (seconds - 1) * 1000 + nanoseconds // 1000000
        self.latencies.append(time.monotonic() - self.sent[index % len(self.sent)])
        self.results += 1
        self.capacity.release()

    def connect(self, node):
        """Waits until all topics are connected to the node."""
        connections = (self.pose, self.load, self.subscriber)
        while not all(c.get_num_connections() for c in connections) and node.poll() is None:
            time.sleep(0.1)
        time.sleep(0.5)  # the connection is complete at the node a moment later

    def minute(self, number):
        """Sends the pairs of one minute. @return False if no result was received for TIMEOUT seconds"""
        for index in range(number * PER_MINUTE, (number + 1) * PER_MINUTE):
            if not self.capacity.acquire(timeout=TIMEOUT):
                return False
            pose, load = self.pairs[index % PERIOD]
            self.sent[index % len(self.sent)] = time.monotonic()
            self.pose.publish(pose.stamped(index))
            self.load.publish(load.stamped(index))
        return True

    def drain(self):
        """Waits for the results in transit, each for at most TIMEOUT seconds."""
        all(self.capacity.acquire(timeout=TIMEOUT) for _ in range(IN_TRANSIT))

    def take_latencies(self):
        """Median and 99 % quantile of the latencies of the last minute [ms]."""
        latencies, self.latencies = sorted(self.latencies), []
        return [1e3 * latencies[int(share * (len(latencies) - 1))] for share in (0.5, 0.99)]


def run(minutes, node):
    """@return True if no limit was exceeded"""
    soak = Soak()
    soak.connect(node)
    memories, medians = [], []
    for number in range(minutes):
        begin = time.monotonic()
        if not soak.minute(number):
            print(f"no result for {TIMEOUT} s after {soak.results} results")
            return False
        memories.append(resident(node.pid))
        median, late = soak.take_latencies()
        medians.append(median)
        print(f"minute {number + 1:3d}: {memories[-1]:7.2f} MB, latency {median:6.2f} ms, 99 % {late:7.2f} ms, "
              f"duration {time.monotonic() - begin:6.1f} s", flush=True)
    soak.drain()
    growth = max(abs(memory - memories[0]) for memory in memories)
    third = max(minutes // 3, 1)
    slowdown = statistics.median(medians[-third:]) / statistics.median(medians[:third])
    print(f"{minutes * PER_MINUTE} pairs, {soak.results} results, memory within {growth:.2f} MB of that after the first minute, "
          f"latency of the last third of the minutes {slowdown:.2f} times that of the first third")
    return soak.results == minutes * PER_MINUTE and growth <= MAX_GROWTH and slowdown <= MAX_SLOWDOWN


def main():
    minutes = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    processes = [start_master()]
    try:
        rospy.init_node("soak", disable_signals=True, disable_rosout=True)
        processes.append(start_node(sys.argv[2] if len(sys.argv) > 2 else None))
        return 0 if run(minutes, processes[-1]) else 1
    finally:
        for process in reversed(processes):
            process.terminate()
            process.wait()


if __name__ == "__main__":
    sys.exit(main())
