#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Gives a live node an hour of a hunting wheelset at 1 kHz, as fast as it answers; looks at its memory and its latency.

soak.py MINUTES, beside a running contact_node: soak.launch starts both. Each simulated minute of 60000 pairs prints the
node's resident memory, and median and 99 % of the time from a pair to its answer while 100 are on their way. Ends with 1
if an answer is missing, or if the memory is ever more than 2 MB off what it was after the first minute.
"""

import math
import pathlib
import struct
import sys
import threading
import time
import xmlrpc.client

import rosgraph
import rospy
from geometry_msgs.msg import PoseStamped, WrenchStamped

NODE = "/contact_node"
PER_MINUTE = 60000
ON_THEIR_WAY = 100  # half of what the node keeps waiting before it drops
PATIENCE = 60  # [s]
MOST_GROWTH = 2.0  # [MB]


def resident(pid):
    """Resident memory of a process [MB]."""
    return int(pathlib.Path(f"/proc/{pid}/statm").read_text().split()[1]) * 4096e-6


def pair(index):
    """Pose and load of a hunting wheelset at `index` milliseconds."""
    seconds = 1 + 1e-3 * index
    phase = 2 * math.pi * seconds / 0.7
    pose, load = PoseStamped(), WrenchStamped()
    pose.header.frame_id = "track"
    pose.header.stamp = load.header.stamp = rospy.Time(1 + index // 1000, index % 1000 * 1000000)
    pose.pose.position.y = 5e-3 * math.sin(phase)
    yaw = 2e-3 * math.cos(phase)
    pose.pose.orientation.z, pose.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    load.wrench.force.z = -1e5 * (1 + 0.2 * math.sin(2 * math.pi * seconds))
    load.wrench.torque.x = 1e4 * math.sin(phase)
    return pose, load


class Soak:
    def __init__(self):
        self.room = threading.Semaphore(ON_THEIR_WAY)
        self.sent = [0.0] * ON_THEIR_WAY * 2
        self.latencies = []
        self.answers = 0
        self.pose = rospy.Publisher("wheelset/pose", PoseStamped, queue_size=1000, tcp_nodelay=True)
        self.load = rospy.Publisher("wheelset/load", WrenchStamped, queue_size=1000, tcp_nodelay=True)
        self.subscriber = rospy.Subscriber(NODE + "/contact", rospy.AnyMsg, self.receive, tcp_nodelay=True)

    def receive(self, message):
        _, seconds, nanoseconds = struct.unpack_from("<III", message._buff)
        index = (seconds - 1) * 1000 + nanoseconds // 1000000
        self.latencies.append(time.monotonic() - self.sent[index % len(self.sent)])
        self.answers += 1
        self.room.release()

    def connect(self):
        """Process id of the node, once everything is connected to it."""
        connections = (self.pose, self.load, self.subscriber)
        while not all(c.get_num_connections() for c in connections) and not rospy.is_shutdown():
            time.sleep(0.1)
        uri = rosgraph.Master(rospy.get_name()).lookupNode(NODE)
        return xmlrpc.client.ServerProxy(uri).getPid(rospy.get_name())[2]

    def minute(self, number):
        """Sends a minute's pairs. True if there was room for all."""
        for index in range(number * PER_MINUTE, (number + 1) * PER_MINUTE):
            if not self.room.acquire(timeout=PATIENCE) or rospy.is_shutdown():
                return False
            self.sent[index % len(self.sent)] = time.monotonic()
            pose, load = pair(index)
            self.pose.publish(pose)
            self.load.publish(load)
        return True

    def take_latencies(self):
        """Median and 99 % of the last minute's [ms]."""
        latencies, self.latencies = sorted(self.latencies), []
        return [1e3 * latencies[int(share * (len(latencies) - 1))] for share in (0.5, 0.99)]


def main():
    minutes = int(sys.argv[1])
    rospy.init_node("soak")
    soak = Soak()
    pid = soak.connect()
    settled, worst = None, 0.0
    for number in range(minutes):
        begin = time.monotonic()
        complete = soak.minute(number)
        memory = resident(pid)
        settled = settled or memory
        worst = max(worst, abs(memory - settled))
        median, late = soak.take_latencies()
        print(f"minute {number + 1:3d}: {memory:7.2f} MB, latency {median:6.2f} ms, 99 % {late:7.2f} ms, "
              f"{time.monotonic() - begin:6.1f} s", flush=True)
        if not complete:
            print(f"no answer for {PATIENCE} s after {soak.answers} answers")
            return 1
    print(f"{minutes * PER_MINUTE} pairs, memory within {worst:.2f} MB of that after the first minute")
    return 0 if worst <= MOST_GROWTH else 1


if __name__ == "__main__":
    sys.exit(main())
