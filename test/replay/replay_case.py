# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of contact_replay: bags of a wheelset with a periodic lateral motion, and runs of the program."""

import csv
import math
import os
import pathlib
import subprocess

import genpy
import rosbag
from commands import FolderCase
from geometry_msgs.msg import PoseStamped, TransformStamped, WrenchStamped
from std_msgs.msg import Header

PROGRAM = os.environ["CONTACT_REPLAY"]
SHIPPED = pathlib.Path(__file__).resolve().parents[2] / "bags" / "manchester_sweep.bag"
RESULTS = "/contact_node/contact"
DAMAGED, MISUSED, INTERRUPTED, FEW_RESULTS, DOUBTFUL_LOADS = 3, 2, 130, 4, 5  # exit statuses


def time(nanoseconds):
    return genpy.Time(nanoseconds // 10**9, nanoseconds % 10**9)


def stamp(i):
    """Stamp of pair i: 1000 pairs per second, from 1 s on."""
    return time(10**9 + i * 10**6)


def pose(i, frame="track"):
    message = PoseStamped(header=Header(stamp=stamp(i), frame_id=frame))
    message.pose.position.y = 5e-3 * math.sin(0.01 * i)
    message.pose.orientation.w = 1
    return message


def load(i):
    message = WrenchStamped(header=Header(stamp=stamp(i)))
    message.wrench.force.z = -200e3
    return message


def transform(y, nanoseconds=0):
    """Transform of the frame "survey" to the track."""
    message = TransformStamped(header=Header(stamp=time(nanoseconds), frame_id="track"), child_frame_id="survey")
    message.transform.translation.y, message.transform.rotation.w = y, 1
    return message


def pairs(numbers, inputs="/wheelset", change=lambda i, pose, load: None):
    """Yields poses and loads with their topics and stamps. `change` may alter the messages of a pair."""
    for i in numbers:
        messages = pose(i), load(i)
        change(i, *messages)
        for topic, message in zip(("pose", "load"), messages):
            yield f"{inputs}/{topic}", message, stamp(i)


def rows_of(path):
    with open(path, encoding="utf-8") as table:
        return list(csv.DictReader(table))


class ReplayCase(FolderCase):
    def write_bag(self, messages, name="in.bag", mode="w", **options):
        """Writes messages with their topics and stamps. @return path of the bag"""
        with rosbag.Bag(str(self.folder / name), mode, **options) as bag:
            for message in messages:
                bag.write(*message)
        return self.folder / name

    def make_bag(self, count, name="in.bag", **options):
        return self.write_bag(pairs(range(count)), name, **options)

    def replay(self, bag, name="out.bag", *options, status=0):
        """Runs contact_replay. @return path of the bag of results, and the output of the program"""
        out = self.folder / name
        run = subprocess.run([PROGRAM, bag, out, *map(str, options)], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, status, run.stdout + run.stderr)
        return out, run.stdout + run.stderr

    def replay_parts(self, bag, at, *options, status=0):
        """Replays the parts of a bag between the times `at`; None: an end of the bag. @return paths of their results"""
        return [self.replay(bag, f"part_{k}.bag", *(("--from", start) if start else ()), *(("--to", end) if end else ()),
                            *options, status=status)[0] for k, (start, end) in enumerate(zip(at, at[1:]))]

    def results(self, bag, topic=RESULTS):
        with rosbag.Bag(str(bag)) as opened:
            return [message for _, message, _ in opened.read_messages(topic)]

    def assert_same_file(self, a, b):
        # assertEqual would print the contents.
        self.assertTrue(a.read_bytes() == b.read_bytes(), f"{a.name} differs from {b.name}")
