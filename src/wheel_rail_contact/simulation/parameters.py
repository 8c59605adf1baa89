# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of the closed loop; config/simulate_wheelset.yaml describes them."""
import math

import yaml

from ..command import Failure, shipped

DEFAULTS = "config/simulate_wheelset.yaml"
MOST_STEPS = 10_000_000
SHORTEST_STEP = 1e-6  # [s]

FINITE = ("a finite number", math.isfinite)
POSITIVE = ("a finite number > 0", lambda value: math.isfinite(value) and value > 0)
NOT_NEGATIVE = ("a finite number >= 0", lambda value: math.isfinite(value) and value >= 0)
ON_OFF = ("0 or 1", lambda value: value in (0, 1))
COUNT = (f"a whole number from 0 to {MOST_STEPS}", lambda value: 0 <= value <= MOST_STEPS and value == math.floor(value))

RULES = {
    "wheelset": {**dict.fromkeys(("mass", "yaw_inertia", "spin_inertia", "axle_load"), POSITIVE),
                 **dict.fromkeys(("gyroscopic", "line_inertia"), ON_OFF)},
    "suspension": {"half_spacing": POSITIVE,
                   **dict.fromkeys(("longitudinal_stiffness", "lateral_stiffness", "vertical_stiffness",
                                    "longitudinal_damping", "lateral_damping"), NOT_NEGATIVE)},
    "run": {**dict.fromkeys(("speed", "duration", "step"), POSITIVE), **dict.fromkeys(("start", "y", "yaw"), FINITE),
            "held_steps": COUNT},
}


def read_parameters(path=None, run=()):
    """Groups of the parameters, {group: {name: number}}: those of a file over the shipped ones. SI units.

    run: values over those in the group run of the file. Raises Failure with the file, the name, the value and the broken rule.
    """
    groups = _read(shipped(DEFAULTS))
    if path:
        for group, values in _read(path).items():
            groups[group].update(values)
        try:
            _check(groups)
        except Failure as failure:
            raise Failure(f"{path}: {failure}") from failure
    groups["run"].update(run)
    _check(groups)
    return groups


def step_nanoseconds(run):
    """Time step, rounded to the resolution of stamps [ns]."""
    return round(1e9 * run["step"])


def step_count(run):
    """Number of steps that cover the duration."""
    return math.ceil(1e9 * run["duration"] / step_nanoseconds(run) - 1e-9)


def _read(path):
    try:
        with open(path, encoding="utf-8") as stream:
            document = yaml.safe_load(stream)
        if not isinstance(document, dict):
            raise Failure("the file must be a map of groups")
        return {group: _group(group, values) for group, values in document.items()}
    except (Failure, UnicodeDecodeError, yaml.YAMLError) as error:
        raise Failure(f"{path}: {error}") from error


def _group(group, values):
    if not isinstance(values, dict):
        raise Failure(f"group {group} must be a map of names and values")
    for name in values:
        if name not in RULES.get(group, {}):
            raise Failure(f"parameter {group}/{name} has an unknown name")
    return {name: _number(f"{group}/{name}", value) for name, value in values.items()}


def _number(name, value):
    try:
        if not isinstance(value, bool):
            return float(value)
    except (TypeError, ValueError):
        pass
    text = yaml.safe_dump(value).splitlines()[0]
    raise Failure(f"{name} = {text} must be a number")


def _check(groups):
    for group, rules in RULES.items():
        for name, (text, holds) in rules.items():
            _require(holds(groups[group][name]), f"{group}/{name}", groups[group][name], text)
    run = groups["run"]
    _require(SHORTEST_STEP <= run["step"] <= run["duration"], "run/step", run["step"],
             f"at least {SHORTEST_STEP:g} s, and at most run/duration")
    _require(run["duration"] / run["step"] <= MOST_STEPS, "run/duration", run["duration"],
             f"at most {MOST_STEPS} times run/step")


def _require(holds, name, value, rule):
    if not holds:
        raise Failure(f"{name} = {value:g} must be {rule}")
