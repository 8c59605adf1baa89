# SPDX-License-Identifier: BSD-3-Clause
"""Measures times and errors of all methods on a scene."""
import itertools
import time
from dataclasses import dataclass, field

import numpy as np

from ..command import Failure
from .scenes import LONGEST_REACH, STEP
from .table import SOLVED, Row

WARM_UP = 4 * LONGEST_REACH  # untimed messages at the start, within WARM_UP_TIME
WARM_UP_TIME = 0.1  # [s]
FAST = 5e-3  # mean time of a result up to which timing and inspection are separate [s]
VISIT_TIME = 1e-3  # time of one visit [s]
ENOUGH_TIME = 0.05  # time after which few results are sufficient [s]
FEW = 3
ENOUGH_SWEEP_TIME = 0.1  # time of the sweeps of a method after which no other one begins [s]
COLD_GROUP = 4  # results from a cold start that are timed together


@dataclass(frozen=True)
class Plan:
    """Extent of the measurement."""

    rounds: int = 3  # each round runs every method once
    slowest: float = 0.05  # methods with a longer expected time are not run [s per result]
    truth: tuple = (256, 512)  # grid of the reference solution, by conjugate gradients
    coarser: tuple = (128, 256)  # the error of the reference solution is its difference from this grid
    reach: int = LONGEST_REACH  # steps of the messages to either side of the scene, 1 to LONGEST_REACH

    @property
    def facts(self):
        """What the pictures state about the plan, as {name: text}."""
        return {"truth": f"{self.truth[0]} x {self.truth[1]}", "reach": f"{1e3 * self.reach * STEP:g} mm"}

    @property
    def steps(self):
        """Number of calls of progress() in a scene."""
        return 2 + len(VISITS) * self.rounds


QUICK = Plan(2, 0.005, (128, 256), (64, 128), 1)


@dataclass
class Series:
    """Measurements of one method, either all from a cold start or all from the previous result."""

    status: str = SOLVED  # see table.Row
    reason: str = ""
    times: list = field(default_factory=list)  # CPU time per result or failure [s]; if not run, the expected time
    sweeps: list = field(default_factory=list)  # CPU time of each state of the warm sweep, one list for each round [s]
    errors: list = field(default_factory=list)  # (maximum pressure, area, approach) of each inspected result [-]
    estimates: list = field(default_factory=list)  # error estimates of these results [-]
    grid: tuple = (0, 0)  # of the last result

    @property
    def longest(self):
        """Longest time of a state of the sweep, each the median of its rounds [s]; None without a sweep."""
        return max(quantile(times, 0.5) for times in zip(*self.sweeps)) if self.sweeps else None

    @property
    def estimate(self):
        """Error estimate of the result with the largest error, of the last one of equal ones [-]."""
        largest = np.max(self.errors, axis=1)
        return self.estimates[np.flatnonzero(largest == largest.max())[-1]]


def quantile(values, share):
    """Quantile of the values, without interpolation."""
    return sorted(values)[int(share * (len(values) - 1) + 0.5)]


def errors_of(found, truth):
    """Relative errors of maximum pressure, area and approach [-], each the largest of all wheels.

    None if other wheels have a contact than in the reference solution `truth`.
    """
    if [wheel.index for wheel in found.wheels] != [wheel.index for wheel in truth.wheels]:
        return None
    errors = [[abs(getattr(wheel, name) / getattr(should, name) - 1) for name in ("max_pressure", "area", "approach")]
              for wheel, should in zip(found.wheels, truth.wheels)]
    return np.max(errors, axis=0, initial=0.0)


class Runner:
    """A method on a scene: warm messages to and fro, cold results at the scene, and a sweep."""

    def __init__(self, choice, scene, truths):
        self.choice, self.cold, self.warm = choice, Series(), Series()
        self._truths, self._per_step, self._reach = truths, scene.states_per_step, len(truths) // 2
        self._run = scene.run(choice, self._reach)
        last = 2 * self._reach
        self._messages = itertools.cycle([*range(self._reach + 1, last), *range(last, 0, -1), *range(self._reach + 1)])
        self._sweep_time, self._slow = 0.0, False

    def warm_up(self):
        """Evaluates the first result from a cold start, and some more.

        Returns the longest time of a result: a method that fails at once on the scene may take long at the next position.
        """
        start = time.thread_time()
        times = [self._run.time([self._state(self._reach)])]
        while len(times) <= WARM_UP and time.thread_time() - start < WARM_UP_TIME:
            times.append(self._run.time([self._state(next(self._messages))]))
        self._slow = sum(times) > FAST * len(times)
        return max(times)

    def visit_warm(self):
        """Warm results at all positions, to and fro."""
        self._visit(self.warm, list(itertools.islice(self._messages, 4 * self._reach)), False)

    def visit_cold(self):
        """Cold results at the position of the scene."""
        self._visit(self.cold, [self._reach] * (1 if self._slow else COLD_GROUP), True)

    def sweep_warm(self):
        """Times each state of the path to and fro, in small steps and in those of the messages."""
        if self._slow or self._sweep_time > ENOUGH_SWEEP_TIME:
            return
        times = []
        for step in (1, self._per_step):
            path = range(0, 2 * self._reach * self._per_step + 1, step)
            self._run.solve(0)
            times += [self._run.time([state]) for state in (*path[1:], *path[-2::-1])]
        self._sweep_time += sum(times)
        self.warm.sweeps.append(times)

    def _state(self, place):
        """Index of the state at a place, counted in steps from the first."""
        return place * self._per_step

    def _visit(self, series, places, cold):
        """Times groups of results at these places.

        A group before them only fills the caches. The results of one group after them are inspected. Each result of a slow
        method is both timed and inspected.
        """
        if sum(series.times) * len(places) > ENOUGH_TIME and len(series.times) * len(places) >= FEW:
            return
        states = [self._state(place) for place in places]
        if not self._slow:
            self._run.time(states, cold)
            begin = time.thread_time()
            while True:
                series.times.append(self._run.time(states, cold))
                if time.thread_time() - begin >= VISIT_TIME:
                    break
        times = []
        for place, state in zip(places, states):
            times.append(self._run.time([state], cold))
            self._inspect(series, self._truths[place])
        if self._slow:
            series.times.append(sum(times) / len(times))
            if not cold:
                series.sweeps.append(times)

    def _inspect(self, series, truth):
        """Inspects the last result. The first position without a comparable result determines the status."""
        if series.status != SOLVED:
            return
        outcome = self._run.outcome()
        series.grid = outcome.grid
        errors = errors_of(outcome, truth)
        if not outcome.usable:
            series.status, series.reason = "refused", outcome.reason
        elif errors is None:
            series.status = "other_wheels"
            series.reason = f"{len(outcome.wheels)} wheels have a contact, in the reference solution {len(truth.wheels)}"
        else:
            series.errors.append(errors)
            series.estimates.append(outcome.estimate)


VISITS = (Runner.visit_warm, Runner.visit_cold, Runner.sweep_warm)


class NotRun:
    """A method that is not run, because it is expected to take too long."""

    def __init__(self, choice, expected):
        self.choice = choice
        self.cold = self.warm = Series("not_run", "expected to take too long", [expected])


def compare(scene, choices, plan, progress):
    """Runs all methods on a scene, in turns, so that disturbances affect all of them alike. Returns the rows of the table.

    Cold: each result after discarding the previous one.
    Warm: messages to and fro about the scene, one step apart. Errors are determined for all of them, each against the
    reference solution at its own position. At a single position a coarse grid may be accurate by chance: the error depends on
    the position of its cells on a narrow pressure lobe.
    Sweep: warm over the same path, each state timed alone, so that no spike hides in the mean of a path: at the messages, and
    in wheelset scenes also in steps of a tenth. Slow methods are timed at the messages only.

    Calls progress(title) plan.steps times. Raises Failure if the scene has no reference solution.
    """
    truths, coarser = ([scene.reference(grid, offset) for offset in range(-plan.reach, plan.reach + 1)]
                       for grid in (plan.truth, plan.coarser))
    truth_error = _error_of(truths, coarser, scene.name)
    progress(scene.title)
    entries = _runners(scene, choices, plan, truths)
    progress(scene.title)
    for visit in VISITS:
        for _ in range(plan.rounds):
            for entry in entries:
                if isinstance(entry, Runner):
                    visit(entry)
            progress(scene.title)
    return [_row(scene, truth_error, entry.choice, start, series)
            for entry in entries for start, series in (("cold", entry.cold), ("warm", entry.warm))]


def _error_of(truths, coarser, name):
    """Error of the reference solutions: their largest difference from those on a coarser grid [-]."""
    errors = []
    for place, (truth, other) in enumerate(zip(truths, coarser)):
        own = errors_of(other, truth) if truth.usable else None
        if own is None:
            raise Failure(f"no reference solution for {name}, {place - len(truths) // 2} steps from it: {truth.reason} "
                          f"{other.reason}")
        errors.append(own.max())
    return max(errors)


def _runners(scene, choices, plan, truths):
    """A Runner for each choice, or a NotRun.

    The time of a Seidel method increases with the square of the number of cells: it is expected from that on the last grid.
    """
    entries, before, before_time = [], None, 0.0
    for choice in choices:
        if choice.method.startswith("seidel") and before and before.method == choice.method:
            expected = before_time * (np.prod(choice.grid) / np.prod(before.grid)) ** 2
            if expected > plan.slowest:
                entries.append(NotRun(choice, expected))
                continue
        runner = Runner(choice, scene, truths)
        before, before_time = choice, runner.warm_up()
        entries.append(runner)
    return entries


def _row(scene, truth_error, choice, start, series):
    along, across = series.grid if choice.method == "auto" else choice.grid
    errors = [None] * 5
    if series.status == SOLVED:
        each = np.max(series.errors, axis=0)
        errors = [each.max(), *each, series.estimate]
    return Row(scene.name, scene.title, scene.kind, choice.method, along, across, choice.tolerance, start, series.status,
               series.reason, *(quantile(series.times, share) for share in (0.5, 0.25, 0.75)), series.longest,
               0 if series.status == "not_run" else len(series.times), *errors, truth_error)
