# SPDX-License-Identifier: BSD-3-Clause
"""Inputs that a contact node has dropped, from its diagnostics."""
import time

import rospy
from diagnostic_msgs.msg import DiagnosticArray

PERIOD = 1.0  # of the diagnostics [s]
UNNEEDED = "load not needed"


class DroppedInputs:
    """Keeps the last report of the node that publishes a topic of results."""

    def __init__(self, topic):
        self.node = rospy.resolve_name(topic).rpartition("/")[0]
        self.report = None
        self.subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, self.receive, queue_size=100)

    def receive(self, message):
        for status in message.status:
            if status.name == f"{self.node[1:]}: wheel-rail contact":
                self.report = {value.key: value.value for value in status.values}

    def text(self):
        """One line, after the next report of the node; empty if it has dropped nothing or does not report."""
        self.report = None
        end = time.monotonic() + 2 * PERIOD
        while self.report is None and time.monotonic() < end and not rospy.is_shutdown():
            time.sleep(0.05)
        counts = [f"{value} ({key.partition(': ')[2]})" for key, value in (self.report or {}).items()
                  if "s dropped: " in key and value != "0" and UNNEEDED not in key]
        return f"{self.node} has dropped inputs since its start: {', '.join(counts)}" if counts else ""
