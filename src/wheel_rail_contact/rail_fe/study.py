# SPDX-License-Identifier: BSD-3-Clause
"""What is asked of the finite elements: the rail, its supports, the loads and the mesh."""
import math
from dataclasses import dataclass

from ..command import Failure
from .loads import REFERENCE_DEPTH
from .mesh import FACES
from .supports import ENDS, KINDS, Pads
from .section import Section


@dataclass
class Study:
    """One rail on its supports; lengths in metres, the whole rail (the model is the half x >= 0)."""
    section: Section
    supports: str
    pads: Pads = None            # for the supports `seats` only
    length: float = 1.0
    young: float = 2.1e11        # [Pa]
    poisson: float = 0.28
    element_type: str = "C3D20"
    mesh_size: float = 0.012     # of an element in the section
    neighbours: tuple = ()       # distances [m] at which another wheel's influence is asked
    head_depth: float = 0.0385   # the head, for its rigid motion, ends this far below the crown
    force: float = 30e3          # of the check load: outward, on the gauge face [N]
    force_height: float = None   # of the check load above the foot's underside [m]; None: the reference point's

    def validate(self):
        """Raises Failure that names the value and the broken rule."""
        _demand(self.supports in KINDS, f"--supports is {self.supports}: must be one of {', '.join(KINDS)}")
        _demand(self.element_type in FACES, f"--element is {self.element_type}: must be one of {', '.join(FACES)}")
        for option, value in (("--length", self.length), ("--young", self.young), ("--mesh-size", self.mesh_size),
                              ("--head-depth", self.head_depth), ("--force", self.force)):
            _demand_positive(option, value)
        _demand(0 <= self.poisson < 0.5, f"--poisson is {self.poisson:g}: must be at least 0 and below 0.5")
        _demand(self.mesh_size <= 0.25 * self.section.height,
                f"--mesh-size is {self.mesh_size:g} m: must be at most a quarter of the section's height "
                f"({self.section.height:g} m)")
        _demand(self.head_depth <= self.section.height,
                f"--head-depth is {self.head_depth:g} m: must be at most the section's height")
        _demand(self.supports not in ENDS or self.length >= self.section.height,
                f"--length is {self.length:g} m: with held ends must be at least the section's height")
        _demand((self.pads is not None) == (self.supports == "seats"),
                "pads belong to --supports seats, and only to it")
        self._validate_neighbours()
        if self.pads:
            self._validate_pads()

    def _validate_neighbours(self):
        _demand(not self.neighbours or self.pads, "--neighbours belongs to --supports seats")
        for distance in self.neighbours:
            _demand(0 < distance < 0.5 * self.length, f"--neighbours has {distance:g} m: must be above 0 and below "
                    f"half the rail's length ({0.5 * self.length:g} m)")

    def _validate_pads(self):
        pads = self.pads
        for option, value in (("--pad-lateral", pads.lateral), ("--pad-vertical", pads.vertical),
                              ("--pad-length", pads.seat_length), ("--spacing", pads.spacing), ("--bays", pads.bays)):
            _demand_positive(option, value)
        _demand(pads.roll is None or pads.roll > 0, f"--pad-roll is {pads.roll}: must be above 0")
        _demand(pads.bays > 1, f"--bays is {pads.bays}: must be at least 2")
        _demand(pads.seat_length < pads.spacing, f"--pad-length is {pads.seat_length:g} m: must be less than --spacing "
                f"({pads.spacing:g} m)")
        _demand(self.length >= 2 * pads.edges()[-1] - 1e-9, f"--length is {self.length:g} m: the seats reach over "
                f"{2 * pads.edges()[-1]:g} m")

    @property
    def check_height(self):
        """Height of the check load above the foot's underside [m]."""
        return self.section.height - REFERENCE_DEPTH if self.force_height is None else self.force_height

    @property
    def linear_range(self):
        """Largest |Y|/Q for which the table holds: clamped supports pull as well as push, seats let the foot lift."""
        return 0.6 if self.supports == "seats" else math.inf


def _demand(rule, message):
    if not rule:
        raise Failure(message)


def _demand_positive(option, value):
    _demand(math.isfinite(value) and value > 0, f"{option} is {value:g}: must be above 0 and finite")
