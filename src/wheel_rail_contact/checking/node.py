# SPDX-License-Identifier: BSD-3-Clause
"""The rostest node contact_check."""
import sys
import time
import unittest

import rospy
import rostest
from wheel_rail_contact.msg import WheelsetContact

from .bounds import BadParameter, check_names, complaint, read_limits

NAME = "contact_check"


def collect(limits, topic="contact"):
    """The answers that come until none has come for a while; without their grids."""
    answers = []
    last = [time.monotonic()]

    def receive(answer):
        for patch in answer.patches:
            patch.grid.pressure = ()
        answers.append(answer)
        last[0] = time.monotonic()

    subscriber = rospy.Subscriber(topic, WheelsetContact, receive, queue_size=1000)
    while not rospy.is_shutdown() and time.monotonic() - last[0] < (limits.idle if answers else limits.patience):
        time.sleep(0.02)
    subscriber.unregister()
    return answers


def case_for(limits):
    """A test case with one test for each check."""

    class ContactCheck(unittest.TestCase):
        longMessage = False

        @classmethod
        def setUpClass(cls):
            cls.answers = collect(limits)

    for name in check_names(limits):
        def test(self, name=name):
            reason = complaint(name, limits, self.answers)
            if reason:
                self.fail(reason)
        setattr(ContactCheck, f"test_{name}", test)
    return ContactCheck


def case_refusing(reason):
    """A test case that fails: the parameters cannot be used."""

    class ContactCheck(unittest.TestCase):
        def test_parameters(self):
            self.fail(reason)

    return ContactCheck


def main():
    """Runs as a rostest node."""
    rospy.init_node(NAME)
    try:
        case = case_for(read_limits(rospy.get_param("~", {})))
    except BadParameter as error:
        case = case_refusing(f"parameter {rospy.get_name()}/{error}")
    rostest.rosrun("wheel_rail_contact", NAME, case, sys.argv)
