# SPDX-License-Identifier: BSD-3-Clause
"""Quantities of the wheels and the axle that EN 14363 limits, from results in the order of their stamps.

All are causal: a value depends on earlier results only. A check of a running node and a report of its recording are equal.
"""
import math
from collections import Counter, namedtuple
from dataclasses import dataclass, field

import numpy as np

from . import low_pass
from .low_pass import LowPass, SlidingMean
from .parameters import BadParameter, bound, group, number, not_negative, positive

QUANTITIES = {  # name -> symbol, unit
    "vertical_force": ("Q", "N"),      # of each wheel, down positive
    "lateral_force": ("Y", "N"),       # of each wheel, outward positive
    "quotient": ("Y/Q", "-"),          # of each wheel
    "unloading": ("dQ/Q0", "-"),       # of each wheel: (Q0 - Q) / Q0
    "lateral_sum": ("sum Y", "N"),     # of the axle: Y_left - Y_right, the force to the left; its magnitude is limited
}
OVER_WAY = ("quotient", "lateral_sum")                   # have a sliding mean
OF_Y = ("lateral_force", "quotient", "lateral_sum")      # lack friction if there are no creep forces
PLACES = ("distance", "x", "time")
LONGEST_STEP = 1 / 4   # [-] of the length of the mean: a longer step of way is a gap
ROUNDING = 1e-6        # [s] of stamps
LEAST_RETURN = 1 / 100  # [-] of the length of the mean: a wheelset that goes back by less stands
CONSTANT_FORCE = 10e3  # [N] of the limit k1 (10 kN + P0 / 3), with the static axle load P0 = 2 Q0

Sample = namedtuple("Sample", "stamp x distance lateral vertical friction usable")
Sample.__doc__ = """Stamp [s], places [m], forces Y and Q and the part of Y by friction of both wheels [N], whether usable."""

History = namedtuple("History", "stamps places values counts friction")
History.__doc__ = """Quantities of all results: values by their name in QUANTITIES, (n, 2) of the wheels or (n, 1) of the axle, NaN
where there is none; counts of results without values and of restarts, by reason; whether any result has friction."""


@dataclass
class AxleLimits:
    """Limits and their parameters. The names of the fields are those of the parameters."""
    low_pass: float = 0.0         # cut-off frequency for Y and Q [Hz]; 0: not filtered
    mean_length: float = 0.0      # way of the sliding mean of Y/Q and sum Y [m]; 0: none
    place: str = "distance"       # place on the way: distance or x of the results, or time (stamp times speed)
    speed: float = 0.0            # for place: time [m/s]
    static_load: float = 0.0      # static wheel load Q0 [N]; 0: not known
    percentile: float = 100.0     # share of the values of the run that must be inside each limit [%]
    bounds: dict = field(default_factory=dict)  # name in QUANTITIES -> (min, max)

    def where(self, sample):
        """Place of a result on the way [m]."""
        return self.speed * sample.stamp if self.place == "time" else getattr(sample, self.place)


def read_axle_limits(parameters):
    """AxleLimits from the group axle of the parameters. Raises BadParameter."""
    names = {"low_pass": not_negative, "mean_length": not_negative, "speed": positive, "static_load": positive,
             "percentile": number}
    group("axle", parameters, [*names, "place", "bounds"])
    limits = AxleLimits(**{name: read(f"axle/{name}", parameters[name]) for name, read in names.items() if name in parameters})
    limits.place = parameters.get("place", limits.place)
    if limits.place not in PLACES:
        raise BadParameter(f"axle/place = {limits.place!r}: must be one of {', '.join(PLACES)}")
    if (limits.place == "time") != (limits.speed > 0):
        raise BadParameter(f"axle/speed = {limits.speed:g}: is required with place: time, and with nothing else")
    if not 50 < limits.percentile <= 100:
        raise BadParameter(f"axle/percentile = {limits.percentile:g}: must be above 50 and at most 100")
    for name, ends in group("axle/bounds", parameters.get("bounds", {}), QUANTITIES).items():
        if name == "lateral_sum":
            ends = _both_signs(f"axle/bounds/{name}", ends, limits.static_load)
        elif name == "unloading" and not limits.static_load:
            raise BadParameter("axle/bounds/unloading: requires axle/static_load")
        limits.bounds[name] = bound(f"axle/bounds/{name}", ends)
    return limits


def _both_signs(name, ends, static_load):
    """The limit of a magnitude: max, or k1 for k1 (10 kN + 2 Q0 / 3)."""
    if not isinstance(ends, dict) or set(ends) not in ({"max"}, {"k1"}):
        raise BadParameter(f"{name} = {ends!r}: must contain either max or k1")
    if "k1" in ends and not static_load:
        raise BadParameter(f"{name}/k1: requires axle/static_load")
    most = (positive(name + "/max", ends["max"]) if "max" in ends
            else positive(name + "/k1", ends["k1"]) * (CONSTANT_FORCE + 2 * static_load / 3))
    return {"min": -most, "max": most}


class Axle:
    """Takes the results of one wheelset in their order, and gives the quantities of each."""

    def __init__(self, limits):
        self.limits = limits
        self.counts = Counter()  # results without values or restarts, by reason
        self.friction = False    # whether any result has friction
        self.last = None         # stamp of the last usable result [s]
        self.longest = low_pass.LONGEST_STEP / limits.low_pass if limits.low_pass else math.inf  # step of time [s]
        self.settling = low_pass.SETTLING / limits.low_pass if limits.low_pass else 0.0          # [s]

    def _restart(self, sample):
        self.start = sample.stamp
        unfiltered = (*sample.lateral, *sample.vertical) if self.limits.low_pass else ()
        self.filters = [LowPass(self.limits.low_pass, force) for force in unfiltered]
        self.touched = [-math.inf, -math.inf]  # stamps since which the wheels may have a quotient
        self._restart_way(self.limits.where(sample))

    def _restart_way(self, place):
        self.place, self.direction = place, 0
        self.means = [SlidingMean(self.limits.mean_length) for _ in range(3)]

    def add(self, sample):
        """Q, Y, Y/Q of both wheels, and sum Y; NaN where there is no value, which is counted with its reason."""
        if not sample.usable:
            self.counts["results that are not usable"] += 1
            return [math.nan] * 7
        self.friction = self.friction or any(sample.friction)
        duration = 0.0 if self.last is None else sample.stamp - self.last
        if self.last is None or duration < 0 or duration > self.longest + ROUNDING:
            if self.last is not None:
                self.counts["restarts because time goes back" if duration < 0
                            else f"restarts because a step of time is longer than {1e3 * self.longest:g} ms"] += 1
            self._restart(sample)
            duration = 0.0
        self.last = sample.stamp
        forces = [one.step(duration, force) for one, force in zip(self.filters, (*sample.lateral, *sample.vertical))]
        if sample.stamp - self.start < self.settling - ROUNDING:
            self.counts["results while the low-pass settles"] += 1
            self.place = self.limits.where(sample)
            return [math.nan] * 7
        lateral, vertical = (forces[:2], forces[2:]) if forces else (sample.lateral, sample.vertical)
        quotients = [self._quotient(side, sample, lateral[side], vertical[side]) for side in (0, 1)]
        over_way = [*quotients, lateral[0] - lateral[1]]
        if self.limits.mean_length:
            over_way = self._means(self.limits.where(sample), over_way)
        return [*vertical, *lateral, *over_way]

    def _quotient(self, side, sample, lateral, vertical):
        """Y/Q; NaN of a wheel that carries no load, also while the low-pass settles after this."""
        if sample.vertical[side] <= 0:
            self.touched[side] = sample.stamp + self.settling - ROUNDING
        if vertical > 0 and sample.vertical[side] > 0 and sample.stamp >= self.touched[side]:
            return lateral / vertical
        self.counts["values of Y/Q that are undefined because the wheel carries no load"] += 1
        self.means[side] = SlidingMean(self.limits.mean_length)
        return math.nan

    def _means(self, place, values):
        step = place - self.place
        if abs(step) > LONGEST_STEP * self.limits.mean_length:
            self.counts[f"restarts because a step of way is longer than {LONGEST_STEP * self.limits.mean_length:g} m"] += 1
            self._restart_way(place)
        elif step * self.direction < -LEAST_RETURN * self.limits.mean_length:
            self.counts["restarts because the wheelset changes its direction"] += 1
            self._restart_way(place)
        elif step * self.direction < 0 or (step == 0 and self.means[2].points):
            self.counts["results that do not advance on the way"] += 1
            return [math.nan] * 3
        else:
            self.direction = math.copysign(1, step) if step else self.direction
            self.place = place
        means = [math.nan if math.isnan(value) else mean.step(abs(step) if mean.points else 0.0, value)
                 for mean, value in zip(self.means, values)]
        if any(math.isnan(mean) and not math.isnan(value) for mean, value in zip(means, values)):
            self.counts["results before the length of the mean is travelled"] += 1
        return means


def history(limits, samples):
    """History of the results of one wheelset."""
    axle, rows, at = Axle(limits), [], []
    for sample in samples:
        rows.append(axle.add(sample))
        at.append((sample.stamp, limits.where(sample)))
    table, at = np.reshape(rows, (-1, 7)), np.reshape(at, (-1, 2))
    values = dict(zip(("vertical_force", "lateral_force", "quotient", "lateral_sum"), np.split(table, (2, 4, 6), axis=1)))
    if limits.static_load:
        values["unloading"] = 1 - table[:, :2] / limits.static_load
    return History(at[:, 0], at[:, 1], values, axle.counts, axle.friction)
