# SPDX-License-Identifier: BSD-3-Clause
"""Hands slices to workers, and bags to be joined once their slices are there."""
import time

from ..command import Failure
from ..progress import Progress
from .folder import record_of
from .interrupts import Interrupts
from .work import answer_slice, join_slices

AHEAD = 3           # tasks at the scheduler for each core of the workers: none waits for the next, and few are listed
LOOK_PERIOD = 0.01  # for tasks that have ended [s]
COUNT_PERIOD = 5    # after which workers are counted again [s]
LINE_PERIOD = 10    # of progress where there is no terminal [s]
ENDED = ("finished", "error", "cancelled")  # statuses of a task that nobody is at any more
RETRIES = 2         # of a task that fails; those of lost workers are the scheduler's own


class Campaign:
    """One run over a plan (plan.plan_of) into a folder."""

    def __init__(self, client, plan, folder):
        self._client, self._plan, self._folder = client, plan, folder
        self._left = {name: len(entry["slices"]) for name, entry in plan["bags"].items()}  # slices to be answered
        self.failures = []   # sentences
        self._cores, self._counted = 0, -COUNT_PERIOD
        self._state = _State(sum(self._left.values()))

    def run(self):
        """Until nothing is left to do, or until SIGINT."""
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
            while running.count() < self._room() and (following := next(waiting, None)):
                submit(*following)
            if running.is_empty():
                break
            if not running.has_ready():
                time.sleep(LOOK_PERIOD)
                continue
            future = next(running)
            status = future.status
            if status not in ENDED:  # its worker was lost before the result was fetched: another one is at it
                running.add(future)
            elif following := self._take(future, status, *tasks.pop(future.key)):
                submit(*following)

    def _tasks(self, interrupts):
        """Functions with what they are to be given: slices that are not done, bag after bag."""
        for name, entry in self._plan["bags"].items():
            interrupts.raise_noted()
            if record_of(self._folder.answers(name)):
                self._state.found(self._left.pop(name))
                continue
            for number, span in enumerate(entry["slices"]):
                interrupts.raise_noted()
                part = self._folder.part(name, number)
                if record_of(part):
                    self._left[name] -= 1
                    self._state.found(1)
                else:
                    yield answer_slice, {"name": name, "bag": entry["bag"], "slice": span, "part": str(part),
                                         "folder": self._plan["folder"], "options": self._plan["options"]}
            if self._left.get(name) == 0:  # not known: its last slice has come back meanwhile, and it is being joined
                yield self._join(name)

    def _join(self, name):
        del self._left[name]
        parts = [str(self._folder.part(name, number)) for number in range(len(self._plan["bags"][name]["slices"]))]
        return join_slices, {"name": name, "parts": parts, "answers": str(self._folder.answers(name)),
                             "options": self._plan["options"]}

    def _room(self):
        if time.monotonic() - self._counted > COUNT_PERIOD:
            self._cores, self._counted = sum(self._client.nthreads().values()), time.monotonic()
        return AHEAD * max(self._cores, 1)

    def _take(self, future, status, function, task):
        """Notes what became of a task. @return what follows from it: a function with what it is to be given."""
        name = task["name"]
        if status == "cancelled":
            raise Failure("the scheduler was lost; the same command goes on")
        if status == "error":
            self.failures.append(f"{name}: {future.exception()}")
        elif function is answer_slice:
            self._state.answered(future.result()["answers"])
            self._left[name] -= 1
            if self._left[name] == 0:
                return self._join(name)
        return None


class _State:
    """How far a campaign is, for the one who waits."""

    def __init__(self, slices):
        self._slices, self._found, self._done, self._answers = slices, 0, 0, 0
        self._began = time.monotonic()
        self.progress = Progress(period=LINE_PERIOD)

    def found(self, slices):
        """Some were there already."""
        self._found += slices

    def answered(self, answers):
        """One more is done."""
        self._done += 1
        self._answers += answers
        seconds = time.monotonic() - self._began
        left = seconds * (self._slices - self._found - self._done) / self._done
        self.progress(self._found + self._done, self._slices,
                      f"{self._answers} answers, {self._answers / seconds:.0f}/s, {left:.0f} s left")
