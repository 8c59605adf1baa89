# SPDX-License-Identifier: BSD-3-Clause
"""Order of the tasks of a campaign, and its interruption. A replacement of Dask runs no task."""

import collections
import os
import signal
import tempfile
import types
import unittest
import unittest.mock

from campaign_case import skip_without_dask
from wheel_rail_contact.campaign.campaign import AHEAD, Campaign
from wheel_rail_contact.campaign.folder import Folder
from wheel_rail_contact.campaign.interrupts import Interrupts
from wheel_rail_contact.campaign.work import evaluate_slice, join_slices

setUpModule = skip_without_dask  # Order replaces a function of Dask


class InOrder:
    """Replaces Dask. It has one core. The tasks do nothing, and end in the order in which they were submitted.

    @param statuses of each task, in the order in which they are returned
    """

    def __init__(self, *statuses):
        self.submitted, self.running, self.statuses = [], collections.deque(), statuses
        self.add, self.count = self.running.append, self.running.__len__

    def nthreads(self):
        return {"worker": 1}

    def submit(self, function, task, **_):
        self.submitted.append((function, task["name"]))
        return types.SimpleNamespace(key=len(self.submitted), statuses=iter(self.statuses), result=lambda: {"results": 1})

    def is_empty(self):
        return not self.running

    def has_ready(self):
        return bool(self.running)

    def __next__(self):
        future = self.running.popleft()
        future.status = next(future.statuses)
        return future


def interrupt():
    os.kill(os.getpid(), signal.SIGINT)


class CtrlC(unittest.TestCase):
    def test_first_interrupt_is_noted_and_second_is_raised_immediately(self):
        with Interrupts() as interrupts:
            interrupts.raise_noted()
            interrupt()
            self.assertRaises(KeyboardInterrupt, interrupt)
            self.assertRaises(KeyboardInterrupt, interrupts.raise_noted)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def test_ignored_interrupt_stays_ignored(self):
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.SIG_IGN))
        with Interrupts() as interrupts:
            interrupt()
            interrupts.raise_noted()
        self.assertIs(signal.getsignal(signal.SIGINT), signal.SIG_IGN)


class InterruptedInADestructor:
    """Interrupts in its destructor, as may occur in a library. Python drops exceptions of destructors."""

    def __del__(self):
        interrupt()


class Order(unittest.TestCase):
    NAMES = [f"{k}.bag" for k in range(2 * AHEAD + 1)]  # more tasks than are submitted at a time

    def names_of_tasks(self, *statuses):
        """Names of the bags of all evaluate_slice tasks and of all join_slices tasks, in the order of their submission."""
        dask = InOrder(*statuses)
        plan = {"folder": "", "options": [], "bags": {name: {"bag": name, "slices": [[None, None]]} for name in self.NAMES}}
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch("distributed.as_completed", lambda: dask):
            campaign = Campaign(dask, plan, Folder(folder))
            campaign.run()
        self.assertEqual(campaign.failures, [])
        return [[name for done, name in dask.submitted if done is function] for function in (evaluate_slice, join_slices)]

    def test_each_of_many_short_bags_is_evaluated_and_joined_once(self):
        self.assertEqual(self.names_of_tasks("finished"), [self.NAMES, self.NAMES])

    def test_tasks_of_a_lost_worker_are_awaited_again(self):
        self.assertEqual([sorted(names) for names in self.names_of_tasks("lost", "pending", "finished")],
                         [self.NAMES, self.NAMES])

    def test_interrupt_in_a_destructor_ends_the_campaign(self):
        with unittest.mock.patch.object(InOrder, "is_empty", lambda _: InterruptedInADestructor() is None):
            self.assertRaises(KeyboardInterrupt, self.names_of_tasks, "finished")
