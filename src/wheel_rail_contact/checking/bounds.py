# SPDX-License-Identifier: BSD-3-Clause
"""Bounds on the answers of a contact node, as parameters give them, and what breaks them. Knows no ROS node."""
import math
from dataclasses import dataclass, field

from ..message_constants import SIDES, STATUSES, USABLE

QUANTITIES = {  # of each patch, with units
    "max_pressure": "Pa",
    "area": "m^2",
    "contact_angle": "rad",
    "normal_force": "N",
    "approach": "m",
    "error_estimate": "-",
}


class BadParameter(ValueError):
    """A parameter that cannot be used; the message has its name, its value and the rule."""


def number(name, value):
    """A finite number, or a string that is one: YAML 1.1 reads 2e9 as a string."""
    try:
        if isinstance(value, bool):
            raise ValueError
        result = float(value)
        if not math.isfinite(result):
            raise ValueError
        return result
    except (TypeError, ValueError):
        raise BadParameter(f"{name} = {value!r}: must be a finite number") from None


def whole_number(name, value):
    result = number(name, value)
    if result < 0 or result != int(result):
        raise BadParameter(f"{name} = {value!r}: must be a whole number >= 0")
    return int(result)


def seconds(name, value):
    result = number(name, value)
    if not result > 0:
        raise BadParameter(f"{name} = {value!r}: must be a number of seconds > 0")
    return result


def yes_or_no(name, value):
    if not isinstance(value, bool):
        raise BadParameter(f"{name} = {value!r}: must be true or false")
    return value


@dataclass
class Limits:
    """What is asked of the answers. The fields' names are those of the parameters."""
    answers: int = 1              # least number
    refusals: int = 0             # largest number of answers that are not usable
    lift_offs: int = 0            # largest number of answers with a wheel that carries nothing
    flange_contact: bool = True   # False: no patch may have flange_angle or more
    flange_angle: float = 0.7     # contact angle from which a patch counts as on the flange [rad]
    patience: float = 60.0        # for the first answer [s] of wall time
    idle: float = 3.0             # the run is over when no answer has come for so long [s] of wall time
    bounds: dict = field(default_factory=dict)  # of QUANTITIES: (min, max)


PARSERS = {"answers": whole_number, "refusals": whole_number, "lift_offs": whole_number, "flange_contact": yes_or_no,
           "flange_angle": number, "patience": seconds, "idle": seconds}


def read_limits(parameters):
    """Limits from the node's private parameters; raises BadParameter for a wrong value or an unknown name."""
    limits = Limits()
    for name, value in parameters.items():
        if name == "bounds":
            limits.bounds = _read_bounds(value)
        elif name in PARSERS:
            setattr(limits, name, PARSERS[name](name, value))
        else:
            raise BadParameter(f"{name} = {value!r}: there is no such parameter; known are "
                               + ", ".join([*PARSERS, "bounds"]))
    return limits


def _read_bounds(groups):
    if not isinstance(groups, dict):
        raise BadParameter(f"bounds = {groups!r}: must be a group of quantities")
    bounds = {}
    for quantity, ends in groups.items():
        name = f"bounds/{quantity}"
        if quantity not in QUANTITIES:
            raise BadParameter(f"{name}: there is no such quantity; known are {', '.join(QUANTITIES)}")
        if not isinstance(ends, dict) or not ends or not set(ends) <= {"min", "max"}:
            raise BadParameter(f"{name} = {ends!r}: must have min, max or both, and nothing else")
        low = number(name + "/min", ends.get("min", -1e300))
        high = number(name + "/max", ends.get("max", 1e300))
        if low > high:
            raise BadParameter(f"{name}: min = {low:g} is above max = {high:g}")
        bounds[quantity] = (low, high)
    return bounds


def check_names(limits):
    """What is checked, one name for each result."""
    flange = [] if limits.flange_contact else ["flange_contact"]
    return ["answers", "refusals", "lift_offs", *flange, *limits.bounds]


def complaint(check, limits, answers):
    """Why the answers break a check, as text; empty if they do not."""
    if check == "answers":
        return _too_few(limits, answers)
    if check == "refusals":
        return _too_many("refused", limits.refusals, [a for a in answers if a.status not in USABLE])
    if check == "lift_offs":
        return _too_many("with a wheel off the rail", limits.lift_offs,
                         [a for a in answers if STATUSES[a.status] == "LIFT_OFF"])
    if check == "flange_contact":
        return _outside("contact_angle", lambda angle: angle < limits.flange_angle, -1e300, limits.flange_angle, answers,
                        "flange contact: ")
    low, high = limits.bounds[check]
    return _outside(check, lambda value: low <= value <= high, low, high, answers, "")


def _too_few(limits, answers):
    return "" if len(answers) >= limits.answers else f"{len(answers)} answers, at least {limits.answers} are asked for"


def _when(answer):
    """The stamp to the millisecond, also where it is the time of day."""
    return f"at {answer.header.stamp.to_sec():.3f} s"


def _too_many(what, allowed, answers):
    if len(answers) <= allowed:
        return ""
    first = answers[0]
    return (f"{len(answers)} answers {what}, {allowed} allowed; the first {_when(first)}: "
            f"{STATUSES[first.status]}: {first.status_text}")


def _outside(quantity, is_inside, low, high, answers, prefix):
    patches = [(getattr(p, quantity), a, p) for a in answers for p in a.patches]
    outside = [entry for entry in patches if not is_inside(entry[0])]
    if not outside:
        return ""
    value, answer, patch = max(outside, key=lambda entry: max(low - entry[0], entry[0] - high))
    unit = QUANTITIES[quantity]
    end = f"below {low:g}" if value < low else f"not below {high:g}" if value == high else f"above {high:g}"
    return (f"{prefix}{quantity} {value:.6g} {unit} is {end} {unit} {_when(answer)}, "
            f"{SIDES[patch.side]} wheel, y = {1e3 * answer.wheelset.position.y:.4g} mm "
            f"({len(outside)} of {len(patches)} patches are outside; this is the worst)")
