# SPDX-License-Identifier: BSD-3-Clause
"""Rostest node contact_check."""
import sys
import time
import unittest

import rospy
import rostest
from wheel_rail_contact.msg import WheelsetContact

from ..dropped_inputs import DroppedInputs
from .bounds import check_names, judge, read_nodes
from .parameters import BadParameter

NAME = "contact_check"


def collect(nodes):
    """Results by the name of the node, received until none has been received for the time idle. Their grids are removed."""
    results = {name: [] for name in nodes}
    patience, idle = (max(getattr(limits, name) for _, limits in nodes.values()) for name in ("patience", "idle"))
    last = [time.monotonic()]

    def receive(result, name):
        for patch in result.patches:
            patch.grid.pressure = patch.creep.traction_x = patch.creep.traction_y = ()
        results[name].append(result)
        last[0] = time.monotonic()

    subscribers = [rospy.Subscriber(topic, WheelsetContact, receive, name, queue_size=1000, tcp_nodelay=True)
                   for name, (topic, _) in nodes.items()]
    dropped = [DroppedInputs(topic) for topic, _ in nodes.values()]
    while not rospy.is_shutdown() and time.monotonic() - last[0] < (idle if any(results.values()) else patience):
        time.sleep(0.02)
    for subscriber in subscribers:
        subscriber.unregister()
    for text in filter(None, (one.text() for one in dropped)):
        print(text, flush=True)
    return results


def case_for(nodes):
    """A test case with one test per node and check."""

    class ContactCheck(unittest.TestCase):
        longMessage = False

        @classmethod
        def setUpClass(cls):
            cls.violations = {}
            for name, results in collect(nodes).items():
                cls.violations[name], remarks = judge(nodes[name][1], results)
                for remark in remarks:
                    print(f"{NAME}{f' of {name}' if name else ''}: {remark}", flush=True)

    for name, (_, limits) in nodes.items():
        for check in check_names(limits):
            def test(self, name=name, check=check):
                if check in self.violations[name]:
                    self.fail(self.violations[name][check])
            setattr(ContactCheck, f"test_{name}_{check}" if name else f"test_{check}", test)
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
        case = case_for(read_nodes(rospy.get_param("~", {})))
    except BadParameter as error:
        case = failing_case(f"parameter {rospy.get_name()}/{error}")
    rostest.rosrun("wheel_rail_contact", NAME, case, sys.argv)
