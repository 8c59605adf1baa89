#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""rviz loads the display and draws an answer: the colours of its pressure appear on the screen, and nothing is wrong."""

import math
import os
import re
import subprocess
import tempfile
import time
import unittest

import numpy
import rospkg
import rospy
import rostest
from wheel_rail_contact.msg import ContactPatch, WheelsetContact

SCREEN = (1280, 720)
PANEL = 175     # rows at the top that hold the panel with its own colours
PRESSURE = 1e9  # in the middle of the scale of 2 GPa: drawn in green blue
PATIENCE = 60   # for rviz on a busy machine without graphics hardware [s]


def elliptic_patch(side, y):
    """Hertz's pressure over semi-axes of 8 mm and 4 mm, on cells of 1 mm."""
    patch = ContactPatch(side=side, method="hertz", normal_force=1e5, area=math.pi * 32e-6, max_pressure=PRESSURE)
    patch.pose.position.y = y
    patch.pose.orientation.w = 1
    grid = patch.grid
    grid.nx, grid.ny, grid.dx, grid.dy, grid.x0, grid.y0 = 20, 10, 1e-3, 1e-3, -9.5e-3, -4.5e-3
    x, y = numpy.meshgrid(numpy.arange(20) - 9.5, numpy.arange(10) - 4.5)
    grid.pressure = (PRESSURE * numpy.sqrt(numpy.maximum(0, 1 - (x / 8) ** 2 - (y / 4) ** 2))).ravel().tolist()
    return patch


def answer():
    message = WheelsetContact(status=WheelsetContact.OK)
    message.header.stamp = rospy.Time.now()
    message.header.frame_id = "track"
    message.wheelset.position.z = 0.46
    message.wheelset.orientation.w = 1
    message.patches = [elliptic_patch(ContactPatch.LEFT, 0.75), elliptic_patch(ContactPatch.RIGHT, -0.75)]
    return message


def screenshot():
    """The screen as rows of pixels of red, green, blue."""
    command = ["convert", "x:root", "-depth", "8", "rgb:-"]
    raw = subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout
    return numpy.frombuffer(raw, numpy.uint8).reshape(SCREEN[1], SCREEN[0], 3).astype(int)


def coloured(picture, half):
    """Pixels in the colours of half the scale's pressure in the left (0) or right (1) half, beneath the panel."""
    width = SCREEN[0] // 2
    red, green, blue = numpy.moveaxis(picture[PANEL:, half * width:(half + 1) * width], 2, 0)
    return int(numpy.count_nonzero((green - red > 60) & (blue < 170) & (abs(green - blue) < 40)))


class RvizDisplay(unittest.TestCase):
    def setUp(self):
        self.log = tempfile.TemporaryFile("w+")
        self.screen = subprocess.Popen(
            ["Xvfb", "-displayfd", "1", "-screen", "0", f"{SCREEN[0]}x{SCREEN[1]}x24", "-nolisten", "tcp"],
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.addCleanup(self.end, self.screen)
        os.environ["DISPLAY"] = ":" + self.screen.stdout.readline().strip()
        config = os.path.join(rospkg.RosPack().get_path("wheel_rail_contact"), "launch", "track.rviz")
        self.rviz = subprocess.Popen(["rosrun", "rviz", "rviz", "--display-config", config, "--fullscreen"],
                                     stdout=self.log, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(self.end, self.rviz)

    def end(self, process):
        process.terminate()
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def output(self):
        self.log.seek(0)
        return self.log.read()

    def wait_for(self, condition, what):
        end = time.time() + PATIENCE
        while not condition():
            self.assertIsNone(self.rviz.poll(), "rviz has ended:\n" + self.output())
            self.assertLess(time.time(), end, what + "; rviz says:\n" + self.output())
            time.sleep(0.5)

    def publish_and_count(self, publisher):
        publisher.publish(answer())
        picture = screenshot()
        return [coloured(picture, half) for half in (0, 1)]

    def test_pressure_is_on_the_screen(self):
        publisher = rospy.Publisher("contact_node/contact", WheelsetContact, queue_size=1)
        self.wait_for(publisher.get_num_connections, "rviz has not subscribed")
        before = screenshot()
        self.assertEqual([coloured(before, half) for half in (0, 1)], [0, 0], "colours without an answer")

        self.wait_for(lambda: min(self.publish_and_count(publisher)) > 1000, "no pressure is drawn")
        publisher.publish(WheelsetContact(header=answer().header, status=WheelsetContact.OFF_PROFILE))
        self.wait_for(lambda: sum(coloured(screenshot(), half) for half in (0, 1)) == 0,
                      "an answer that is not usable is drawn")
        faults = [line for line in self.output().splitlines() if re.search(r"\[ ?(ERROR|FATAL|WARN)|Ogre.*Exception", line)]
        self.assertEqual(faults, [])


if __name__ == "__main__":
    rospy.init_node("test_display", anonymous=True)
    rostest.rosrun("wheel_rail_contact", "rviz_display", RvizDisplay)
