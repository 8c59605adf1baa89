# SPDX-License-Identifier: BSD-3-Clause
"""Rostest node contact_check."""
import sys
import time
import unittest

import rospy
import rostest
from wheel_rail_contact.msg import WheelsetContact

from ..dropped_inputs import DroppedInputs
from .bounds import BadParameter, check_names, violation, read_limits

NAME = "contact_check"


def collect(limits, topic="contact"):
    """Results received until none has been received for limits.idle seconds. Their grids are removed."""
    results = []
    last = [time.monotonic()]

    def receive(result):
        for patch in result.patches:
            patch.grid.pressure = patch.creep.traction_x = patch.creep.traction_y = ()
        results.append(result)
        last[0] = time.monotonic()

    subscriber = rospy.Subscriber(topic, WheelsetContact, receive, queue_size=1000, tcp_nodelay=True)
    dropped = DroppedInputs(topic)
    while not rospy.is_shutdown() and time.monotonic() - last[0] < (limits.idle if results else limits.patience):
        time.sleep(0.02)
    subscriber.unregister()
    if text := dropped.text():
        print(text, flush=True)
    return results


def case_for(limits):
    """A test case with one test per check."""

    class ContactCheck(unittest.TestCase):
        longMessage = False

        @classmethod
        def setUpClass(cls):
            cls.results = collect(limits)

    for name in check_names(limits):
        def test(self, name=name):
            reason = violation(name, limits, self.results)
            if reason:
                self.fail(reason)
        setattr(ContactCheck, f"test_{name}", test)
    return ContactCheck


def failing_case(reason):
    """A test case that fails because of invalid parameters."""

    class ContactCheck(unittest.TestCase):
        def test_parameters(self):
            self.fail(reason)

    return ContactCheck


def main():
    """Runs the rostest node."""
    rospy.init_node(NAME)
    try:
        case = case_for(read_limits(rospy.get_param("~", {})))
    except BadParameter as error:
        case = failing_case(f"parameter {rospy.get_name()}/{error}")
    rostest.rosrun("wheel_rail_contact", NAME, case, sys.argv)
