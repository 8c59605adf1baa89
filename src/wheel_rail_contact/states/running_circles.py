# SPDX-License-Identifier: BSD-3-Clause
"""Distance of the running circles of a wheelset, which converts wheel loads to a force and a moment."""
from dataclasses import dataclass
from typing import Optional, Tuple

from ..command import running_circles

SHORTEST, LONGEST = 0.2, 3  # distances [m]; none in this range is a usual length in millimetres


@dataclass(frozen=True)
class RunningCircles:
    """Source of the distance: a given value [m], or parameter files over config/default.yaml."""
    given: Optional[float] = None
    configs: Tuple[str, ...] = ()

    def distance(self):
        """Distance [m], and its source for a message.

        @throw Failure if a parameter or a file is refused
        """
        if self.given is not None:
            return self.given, "--running-circles"
        distance, _ = running_circles(self.configs)
        return distance, ", ".join(self.configs) or "config/default.yaml; --config or --running-circles selects another one"
