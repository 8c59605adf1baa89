#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""rviz loads the display and draws the results of a bag played by replay.launch.

The colours of the pressure and of the stress appear on the screen, and the logs contain no warnings or errors. A result that
is not usable leaves the rails, and is red in the panel.
"""

import math
import os
import pathlib
import re
import subprocess
import tempfile
import time
import unittest

import numpy
import rosbag
import rospkg
import rospy
import rostest
from wheel_rail_contact.msg import ContactPatch, PatchStress, StressPeak, WheelsetContact

SCREEN = (1280, 720)
PANEL = 260       # height of the panel at the top, which has other colours [px]
PRESSURE = 1.1e9  # [Pa] middle of the scale, which follows it to 2 GPa: drawn in blue-green
STRESS = 0.99e9   # [Pa] close to the end of the scale, which follows it to 1 GPa: drawn in yellow
TIMEOUT = 60      # [s] for rviz on a busy machine without graphics hardware


def uniform_stress(grid):
    """Stress of a body with the same von Mises stress everywhere, with layers at depths of 0, 4 and 8 mm."""
    stress = PatchStress(depths=[0, 4e-3, 8e-3])
    stress.von_mises = StressPeak(value=STRESS, depth=4e-3)
    components = numpy.zeros((3, 6, grid.ny, grid.nx))
    components[:, 2] = -STRESS
    stress.stress = components.ravel().tolist()
    return stress


def elliptic_patch(side, y):
    """Patch with a Hertzian pressure, semi-axes of 8 mm and 4 mm, cells of 1 mm, and a uniform stress beneath it."""
    patch = ContactPatch(side=side, method="hertz", normal_force=1e5, area=math.pi * 32e-6, max_pressure=PRESSURE)
    patch.pose.position.y = y
    patch.pose.orientation.w = 1
    grid = patch.grid
    grid.nx, grid.ny, grid.dx, grid.dy, grid.x0, grid.y0 = 20, 10, 1e-3, 1e-3, -9.5e-3, -4.5e-3
    x, y = numpy.meshgrid(numpy.arange(20) - 9.5, numpy.arange(10) - 4.5)
    grid.pressure = (PRESSURE * numpy.sqrt(numpy.maximum(0, 1 - (x / 8) ** 2 - (y / 4) ** 2))).ravel().tolist()
    patch.wheel_stress = patch.rail_stress = uniform_stress(grid)
    return patch


def result():
    message = WheelsetContact(status=WheelsetContact.OK)
    message.header.stamp = rospy.Time.now()
    message.header.frame_id = "track"
    message.wheelset.position.z = 0.46
    message.wheelset.orientation.w = 1
    message.patches = [elliptic_patch(ContactPatch.LEFT, 0.75), elliptic_patch(ContactPatch.RIGHT, -0.75)]
    return message


def screenshot():
    """Picture of the screen: array of rows, columns and red, green, blue."""
    command = ["convert", "x:root", "-depth", "8", "rgb:-"]
    raw = subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout
    return numpy.frombuffer(raw, numpy.uint8).reshape(SCREEN[1], SCREEN[0], 3).astype(int)


def counts_below(picture):
    """Numbers of pixels in the left and right half below the panel: two with the colour of the middle of the scale, two with
    that of its end, two with that of the rails."""
    halves = numpy.split(picture[PANEL:], 2, axis=1)
    parts = [numpy.moveaxis(half, 2, 0) for half in halves]
    found = [(green - red > 60) & (blue < 170) & (abs(green - blue) < 40) for red, green, blue in parts]
    found += [(red > 200) & (green > 190) & (blue < 110) for red, green, blue in parts]
    found += [(half.min(axis=2) > 110) & (half.max(axis=2) < 200) & (numpy.ptp(half, axis=2) < 20) for half in halves]
    return [int(numpy.count_nonzero(pixels)) for pixels in found]


def red(picture):
    """Number of red pixels in the panel."""
    red_part, green, blue = numpy.moveaxis(picture[:PANEL], 2, 0)
    return int(numpy.count_nonzero((red_part > 180) & (green < 120) & (blue < 120)))


class RvizDisplay(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        bag = self.folder / "results.bag"
        with rosbag.Bag(str(bag), "w") as file:
            for i in range(20):
                file.write("/contact_node/contact", result(), rospy.Time(1 + 0.1 * i))
        self.screen = subprocess.Popen(
            ["Xvfb", "-displayfd", "1", "-screen", "0", f"{SCREEN[0]}x{SCREEN[1]}x24", "-nolisten", "tcp"],
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.addCleanup(self.end, self.screen)
        os.environ["DISPLAY"] = ":" + self.screen.stdout.readline().strip()
        config = pathlib.Path(rospkg.RosPack().get_path("wheel_rail_contact")) / "config" / "manchester.yaml"
        with open(self.folder / "roslaunch.log", "w", encoding="utf-8") as log:
            self.launch = subprocess.Popen(
                ["roslaunch", "wheel_rail_contact", "replay.launch", f"bag:={bag}", f"config:={config}",
                 "view_options:=--fullscreen"],
                stdout=log, stderr=subprocess.STDOUT, env={**os.environ, "ROS_LOG_DIR": str(self.folder)})
        self.addCleanup(self.end, self.launch)

    def end(self, process):
        process.terminate()
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def output(self):
        return "\n".join(path.read_text(errors="replace") for path in sorted(self.folder.rglob("*.log")))

    def wait_for(self, condition, failure):
        end = time.time() + TIMEOUT
        while not condition():
            self.assertIsNone(self.launch.poll(), "roslaunch has ended:\n" + self.output())
            self.assertLess(time.time(), end, failure + "; logs:\n" + self.output())
            time.sleep(0.5)

    def test_pressure_and_stress_are_drawn_and_an_unusable_result_leaves_the_rails_and_a_red_reason(self):
        red_before = []  # number of red pixels in the panel

        def drawn():
            picture = screenshot()
            red_before[:] = [red(picture)]
            return min(counts_below(picture)[:4]) > 1000

        self.wait_for(drawn, "no pressure or no stress is drawn")
        self.assertEqual(rospy.get_param("contact_node/rail/profile"), "UIC60_manchester")
        publisher = rospy.Publisher("contact_node/contact", WheelsetContact, queue_size=1)
        self.wait_for(publisher.get_num_connections, "rviz has not subscribed")

        refused = WheelsetContact(status=WheelsetContact.OFF_PROFILE, status_text="beyond the end of the profile",
                                  wheelset=result().wheelset)

        def cleared():
            # The dots of the trail remain: some pixels.
            refused.header = result().header
            publisher.publish(refused)
            picture = screenshot()
            return sum(counts_below(picture)[:4]) < 20 and red(picture) > red_before[0] + 100

        self.wait_for(cleared, "a result that is not usable has a pressure or a stress, or its reason is not red")
        self.assertGreater(min(counts_below(screenshot())[4:]), 1000, "the rails have vanished")
        faults = [line for line in self.output().splitlines() if re.search(r"\[ ?(ERROR|FATAL|WARN)|Ogre.*Exception", line)]
        self.assertEqual(faults, [])


if __name__ == "__main__":
    rospy.init_node("test_display", anonymous=True)
    rostest.rosrun("wheel_rail_contact", "rviz_display", RvizDisplay)
