# SPDX-License-Identifier: BSD-3-Clause
"""Values of parameters of contact_check with their rules, and the text of a value that is outside its bounds."""
import math

UNBOUNDED = 1e300  # magnitude of an end of a bound that is not given


class BadParameter(ValueError):
    """Invalid parameter. The message contains its name, its value and the violated rule."""


def number(name, value):
    """A finite number. May be given as a string, because YAML 1.1 reads 2e9 as a string."""
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


def positive(name, value):
    result = number(name, value)
    if not result > 0:
        raise BadParameter(f"{name} = {value!r}: must be a number > 0")
    return result


def not_negative(name, value):
    result = number(name, value)
    if result < 0:
        raise BadParameter(f"{name} = {value!r}: must be a number >= 0")
    return result


def yes_or_no(name, value):
    if not isinstance(value, bool):
        raise BadParameter(f"{name} = {value!r}: must be true or false")
    return value


def group(name, value, known):
    """A group of parameters, all with known names."""
    if not isinstance(value, dict):
        raise BadParameter(f"{name} = {value!r}: must be a group of parameters")
    for entry in value:
        if entry not in known:
            raise BadParameter(f"{name}/{entry}: unknown name; valid names are {', '.join(known)}")
    return value


def bound(name, ends):
    """Lowest and highest allowed value, from a group with min, max or both."""
    if not isinstance(ends, dict) or not ends or not set(ends) <= {"min", "max"}:
        raise BadParameter(f"{name} = {ends!r}: must contain min, max or both, and nothing else")
    low = number(name + "/min", ends.get("min", -UNBOUNDED))
    high = number(name + "/max", ends.get("max", UNBOUNDED))
    if low > high:
        raise BadParameter(f"{name}: min = {low:g} must not be above max = {high:g}")
    return low, high


def merged(common, own):
    """Parameters with those of one node over the common ones, also in their groups."""
    return {**common, **{name: merged(common[name], value) if isinstance(value, dict) and isinstance(common.get(name), dict)
                         else value for name, value in own.items()}}


def broken(quantity, value, low, high, unit):
    """Text of a value that is not inside its bounds."""
    end = (f"below {low:g}" if value < low else f"not above {low:g}" if value == low
           else f"not below {high:g}" if value == high else f"above {high:g}")
    return f"{quantity} {value:.6g} {unit} is {end} {unit}"
