#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Gives a live node a hunting wheelset at 1 kHz, as fast as it answers; looks at its memory and its latency.

soak.py [MINUTES [CONFIG.yaml]]: simulated minutes (60), and parameters laid over config/default.yaml. Starts a master and a
node of its own. Each simulated minute of 60000 pairs prints the node's resident memory, and median and 99 % of the time from
a pair to its answer while 100 are on their way. Ends with 1 if a pair is left without an answer, if the memory is ever more
than 2 MB off what it was after the first minute, or if the latency (its median) of the last third of the minutes is more than
half as long again as that of the first.
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
PERIOD = 7000       # pairs until the motion repeats: 10 waves of 0.7 s, 7 of 1 s, one of 7 s
ON_THEIR_WAY = 100  # half of what the node keeps waiting before it drops
PATIENCE = 60       # [s]
MOST_GROWTH = 2.0   # of memory [MB]
MOST_SLOWING = 1.5  # of latency, for other work on the machine comes and goes


def resident(pid):
    """Resident memory of a process [MB]."""
    return int(pathlib.Path(f"/proc/{pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") * 1e-6


class Prepared:
    """A message as it goes over the wire; only its stamp is set each time it is sent."""

    _has_header = False  # which rospy would fill in

    def prepare(self):
        buffer = io.BytesIO()
        super().serialize(buffer)
        self.wire = bytearray(buffer.getvalue())
        return self

    def stamped(self, index):
        """At `index` milliseconds."""
        struct.pack_into("<II", self.wire, 4, 1 + index // 1000, index % 1000 * 1000000)
        return self

    def serialize(self, buff):
        buff.write(self.wire)


class PreparedPose(Prepared, PoseStamped):
    pass


class PreparedLoad(Prepared, WrenchStamped):
    pass


def pair(index):
    """Pose and load at `index` milliseconds of a wheelset whose hunting swells from 2 mm to 5 mm, where its flange touches."""
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
    """On a free port, and this process's own."""
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
    """With the default parameters, and over them those of a file."""
    for path in filter(None, (DEFAULTS, config)):
        for group, values in yaml.safe_load(pathlib.Path(path).read_text()).items():
            rospy.set_param(f"{NODE}/{group}", values)
    return subprocess.Popen([find_node("wheel_rail_contact", NODE)[0]])


class Soak:
    def __init__(self):
        self.pairs = [pair(index) for index in range(PERIOD)]
        self.room = threading.Semaphore(ON_THEIR_WAY)
        self.sent = [0.0] * ON_THEIR_WAY * 2
        self.latencies = []
        self.answers = 0
        self.pose = rospy.Publisher("wheelset/pose", PreparedPose, queue_size=1000, tcp_nodelay=True)
        self.load = rospy.Publisher("wheelset/load", PreparedLoad, queue_size=1000, tcp_nodelay=True)
        self.subscriber = rospy.Subscriber(NODE + "/contact", rospy.AnyMsg, self.receive, tcp_nodelay=True)

    def receive(self, message):
        _, seconds, nanoseconds = struct.unpack_from("<III", message._buff)
        index = (seconds - 1) * 1000 + nanoseconds // 1000000
        self.latencies.append(time.monotonic() - self.sent[index % len(self.sent)])
        self.answers += 1
        self.room.release()

    def connect(self, node):
        """Waits until everything is connected to the node."""
        connections = (self.pose, self.load, self.subscriber)
        while not all(c.get_num_connections() for c in connections) and node.poll() is None:
            time.sleep(0.1)
        time.sleep(0.5)  # the node learns of its listener a moment later

    def minute(self, number):
        """Sends a minute's pairs. True if there was room for all."""
        for index in range(number * PER_MINUTE, (number + 1) * PER_MINUTE):
            if not self.room.acquire(timeout=PATIENCE):
                return False
            pose, load = self.pairs[index % PERIOD]
            self.sent[index % len(self.sent)] = time.monotonic()
            self.pose.publish(pose.stamped(index))
            self.load.publish(load.stamped(index))
        return True

    def drain(self):
        """Waits for the answers that are on their way, unless one does not come."""
        all(self.room.acquire(timeout=PATIENCE) for _ in range(ON_THEIR_WAY))

    def take_latencies(self):
        """Median and 99 % of the last minute's [ms]."""
        latencies, self.latencies = sorted(self.latencies), []
        return [1e3 * latencies[int(share * (len(latencies) - 1))] for share in (0.5, 0.99)]


def run(minutes, node):
    """True if the node stood it."""
    soak = Soak()
    soak.connect(node)
    memories, medians = [], []
    for number in range(minutes):
        begin = time.monotonic()
        if not soak.minute(number):
            print(f"no answer for {PATIENCE} s after {soak.answers} answers")
            return False
        memories.append(resident(node.pid))
        median, late = soak.take_latencies()
        medians.append(median)
        print(f"minute {number + 1:3d}: {memories[-1]:7.2f} MB, latency {median:6.2f} ms, 99 % {late:7.2f} ms, "
              f"{time.monotonic() - begin:6.1f} s", flush=True)
    soak.drain()
    growth = max(abs(memory - memories[0]) for memory in memories)
    third = max(minutes // 3, 1)
    slowing = statistics.median(medians[-third:]) / statistics.median(medians[:third])
    print(f"{minutes * PER_MINUTE} pairs, {soak.answers} answers, memory within {growth:.2f} MB of that after the first "
          f"minute, latency of the last third of the minutes {slowing:.2f} times that of the first")
    return soak.answers == minutes * PER_MINUTE and growth <= MOST_GROWTH and slowing <= MOST_SLOWING


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
