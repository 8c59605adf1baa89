# SPDX-License-Identifier: BSD-3-Clause
"""Distance of the running circles of a wheelset, which converts wheel loads to a force and a moment."""
import math
from dataclasses import dataclass
from typing import NamedTuple, Optional, Tuple

from ..command import Failure
from ..parameters import read_parameters

BACK_TO_BACK = "wheelset/flange_back_distance"
TAPE_CIRCLE = "wheelset/tape_circle"


class LengthRange(NamedTuple):
    """Range of a length [m]; both limits are valid."""
    least: float
    most: float

    def contains(self, length):
        """False for a length outside, and for NaN."""
        return self.least <= length <= self.most

    def rule(self):
        """The range as the end of a message. It gives the unit, because lengths are often given in millimetres."""
        return f"must be a number from {self.least} to {self.most}, in metres"


# Ranges of the core (src/core/track/track.cpp). None contains a usual length in millimetres.
DISTANCES = LengthRange(0.2, 3)  # from flange back to flange back, and between the running circles
TAPE_CIRCLES = LengthRange(0.005, 0.5)


@dataclass(frozen=True)
class RunningCircles:
    """Source of the distance: a given value [m], or parameter files over config/default.yaml."""
    given: Optional[float] = None
    configs: Tuple[str, ...] = ()

    def distance(self):
        """Distance [m], and its source for a message.

        It is twice the half base of the core (wheel_rail_contact/core/track.h, WheelsetConfig::halfBase).

        @throw Failure if a file cannot be read, or if a length is not a number in its range
        """
        if self.given is not None:
            return self.given, "--running-circles"
        parameters = read_parameters(self.configs)
        distance = _length(parameters, BACK_TO_BACK, DISTANCES) + 2 * _length(parameters, TAPE_CIRCLE, TAPE_CIRCLES)
        source = ", ".join(self.configs) or "config/default.yaml; --config or --running-circles selects another one"
        return distance, source


def _length(parameters, name, valid):
    value = parameters.get(name)
    try:
        length = math.nan if isinstance(value, bool) else float(value)
    except (TypeError, ValueError):
        length = math.nan
    if not valid.contains(length):
        raise Failure(f"parameter {name} = {value} {valid.rule()}")
    return length
