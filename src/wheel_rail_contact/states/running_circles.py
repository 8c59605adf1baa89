# SPDX-License-Identifier: BSD-3-Clause
"""Distance of the running circles of a wheelset, which converts wheel loads to a force and a moment."""
import math
from dataclasses import dataclass
from typing import Optional, Tuple

from ..command import Failure
from ..parameters import read_parameters

BACK_TO_BACK = "wheelset/flange_back_distance"
TAPE_CIRCLE = "wheelset/tape_circle"


@dataclass(frozen=True)
class RunningCircles:
    """Source of the distance: a given value [m], or parameter files over config/default.yaml."""
    given: Optional[float] = None
    configs: Tuple[str, ...] = ()

    def distance(self):
        """Distance [m], and its source for a message.

        It is twice the half base of the core (wheel_rail_contact/core/track.h, WheelsetConfig::halfBase).

        @throw Failure if a file cannot be read, or if a parameter is not a number above 0
        """
        if self.given is not None:
            return self.given, "--running-circles"
        parameters = read_parameters(self.configs)
        distance = _length(parameters, BACK_TO_BACK) + 2 * _length(parameters, TAPE_CIRCLE)
        source = ", ".join(self.configs) or "config/default.yaml; --config or --running-circles selects another one"
        return distance, source


def _length(parameters, name):
    value = parameters.get(name)
    try:
        length = math.nan if isinstance(value, bool) else float(value)
    except (TypeError, ValueError):
        length = math.nan
    if not (math.isfinite(length) and length > 0):
        raise Failure(f"parameter {name} = {value} must be a finite number > 0")
    return length
