# SPDX-License-Identifier: BSD-3-Clause
"""Submits the slices of a campaign to workers, and joins each bag when its slices are evaluated."""
import time

from ..command import Failure
from ..progress import Progress
from .folder import record_of
from .interrupts import Interrupts
from .work import evaluate_slice, join_slices

AHEAD = 3           # submitted tasks per core: workers are never idle, and the scheduler has few tasks to manage
POLL_PERIOD = 0.01  # between checks for tasks that have ended [s]
COUNT_PERIOD = 5    # after which the cores of the workers are counted again [s]
LINE_PERIOD = 10    # between progress lines without a terminal [s]
ENDED = ("finished", "error", "cancelled")  # statuses of a task that has ended
RETRIES = 2         # repetitions of a failed task; the scheduler itself repeats the tasks of lost workers


class Campaign:
    """One run of a plan (plan.plan_of), with its results in a folder."""

    def __init__(self, client, plan, folder):
        self._client, self._plan, self._folder = client, plan, folder
        self._left = {name: len(entry["slices"]) for name, entry in plan["bags"].items()}  # slices to be evaluated
        self.failures = []   # sentences
        self._cores, self._counted = 0, -COUNT_PERIOD
        self._state = _State(sum(self._left.values()))

    def run(self):
        """Runs until all tasks have ended, or until SIGINT."""
        try:
            with Interrupts() as interrupts:
                self._run(interrupts)
                interrupts.raise_noted()
        finally:
            self._state.progress.end()

    def _run(self, interrupts):
        from distributed import as_completed
        waiting, running, tasks = self._tasks(interrupts), as_completed(), {}

        def submit(function, task):
            future = self._client.submit(function, task, retries=RETRIES, pure=False)
            tasks[future.key] = function, task
            running.add(future)

        while True:
            interrupts.raise_noted()
            while running.count() < self._capacity() and (following := next(waiting, None)):
                submit(*following)
            if running.is_empty():
                break
            if not running.has_ready():
                time.sleep(POLL_PERIOD)
                continue
            future = next(running)
            status = future.status
            if status not in ENDED:  # the worker was lost before its result was fetched: another one repeats the task
                running.add(future)
            elif following := self._take(future, status, *tasks.pop(future.key)):
                submit(*following)

    def _tasks(self, interrupts):
        """Yields functions with their argument: one per slice that is not done, bag after bag."""
        for name, entry in self._plan["bags"].items():
            interrupts.raise_noted()
            if record_of(self._folder.results(name)):
                self._state.add_found(self._left.pop(name))
                continue
            for number, span in enumerate(entry["slices"]):
                interrupts.raise_noted()
                part = self._folder.part(name, number)
                if record_of(part):
                    self._left[name] -= 1
                    self._state.add_found(1)
                else:
                    yield evaluate_slice, {"name": name, "bag": entry["bag"], "slice": span, "part": str(part),
                                           "folder": self._plan["folder"], "options": self._plan["options"]}
            if self._left.get(name) == 0:  # None: the last slice has ended in the meantime, and _take joins the bag
                yield self._join(name)

    def _join(self, name):
        del self._left[name]
        parts = [str(self._folder.part(name, number)) for number in range(len(self._plan["bags"][name]["slices"]))]
        return join_slices, {"name": name, "parts": parts, "results": str(self._folder.results(name)),
                             "options": self._plan["options"]}

    def _capacity(self):
        """Number of tasks to keep submitted."""
        if time.monotonic() - self._counted > COUNT_PERIOD:
            self._cores, self._counted = sum(self._client.nthreads().values()), time.monotonic()
        return AHEAD * max(self._cores, 1)

    def _take(self, future, status, function, task):
        """Takes the outcome of a task. @return the next task that it makes possible: a function with its argument"""
        name = task["name"]
        if status == "cancelled":
            raise Failure("the connection to the scheduler was lost; run the same command again to continue")
        if status == "error":
            self.failures.append(f"{name}: {future.exception()}")
        elif function is evaluate_slice:
            self._state.add_done(future.result()["results"])
            self._left[name] -= 1
            if self._left[name] == 0:
                return self._join(name)
        return None


class _State:
    """Counts slices and results for the progress display."""

    def __init__(self, slices):
        self._slices, self._found, self._done, self._results = slices, 0, 0, 0
        self._began = time.monotonic()
        self.progress = Progress(period=LINE_PERIOD)

    def add_found(self, slices):
        """Counts slices that an earlier run has evaluated."""
        self._found += slices

    def add_done(self, results):
        """Counts one slice that was evaluated now, with its number of results."""
        self._done += 1
        self._results += results
        seconds = time.monotonic() - self._began
        left = seconds * (self._slices - self._found - self._done) / self._done
        self.progress(self._found + self._done, self._slices,
                      f"{self._results} results, {self._results / seconds:.0f}/s, {left:.0f} s left")
