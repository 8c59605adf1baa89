# SPDX-License-Identifier: BSD-3-Clause
"""Input of the finite-element analysis: the rail, its supports, the loads and the mesh."""
import math
from dataclasses import dataclass

from ..command import Failure
from .loads import REFERENCE_DEPTH
from .mesh import FACES
from .supports import ENDS, KINDS, Pads
from .section import Section


@dataclass
class Study:
    """One rail on its supports. Lengths in metres, of the whole rail; the model is the half x >= 0."""
    section: Section
    supports: str
    pads: Pads = None            # only for the supports `seats`
    length: float = 1.0
    young: float = 2.1e11        # [Pa]
    poisson: float = 0.28
    element_type: str = "C3D20"
    mesh_size: float = 0.012     # of an element in the section
    neighbours: tuple = ()       # distances at which the influence of another wheel is computed [m]
    head_depth: float = 0.0385   # height of the head below the crown; its rigid motion is fitted
    force: float = 30e3          # check load: outward, on the gauge face [N]
    force_height: float = None   # of the check load, above the underside of the foot [m]; None: at the reference point

    def validate(self):
        """Raises Failure for an invalid value. The message contains the value and the violated rule."""
        _require(self.supports in KINDS, f"--supports is {self.supports}: must be one of {', '.join(KINDS)}")
        _require(self.element_type in FACES, f"--element is {self.element_type}: must be one of {', '.join(FACES)}")
        for option, value in (("--length", self.length), ("--young", self.young), ("--mesh-size", self.mesh_size),
                              ("--head-depth", self.head_depth), ("--force", self.force)):
            _require_positive(option, value)
        _require(0 <= self.poisson < 0.5, f"--poisson is {self.poisson:g}: must be at least 0 and below 0.5")
        _require(self.mesh_size <= 0.25 * self.section.height,
                f"--mesh-size is {self.mesh_size:g} m: must be at most a quarter of the section height "
                f"({self.section.height:g} m)")
        _require(self.head_depth <= self.section.height,
                f"--head-depth is {self.head_depth:g} m: must be at most the section height")
        _require(self.supports not in ENDS or self.length >= self.section.height,
                f"--length is {self.length:g} m: with clamped ends it must be at least the section height")
        _require((self.pads is not None) == (self.supports == "seats"),
                "pads must be given with --supports seats, and only with it")
        self._validate_neighbours()
        if self.pads:
            self._validate_pads()

    def _validate_neighbours(self):
        _require(not self.neighbours or self.pads, "--neighbours requires --supports seats")
        for distance in self.neighbours:
            _require(0 < distance < 0.5 * self.length, f"--neighbours has {distance:g} m: must be above 0 and below "
                    f"half the rail length ({0.5 * self.length:g} m)")

    def _validate_pads(self):
        pads = self.pads
        for option, value in (("--pad-lateral", pads.lateral), ("--pad-vertical", pads.vertical),
                              ("--pad-length", pads.seat_length), ("--spacing", pads.spacing), ("--bays", pads.bays)):
            _require_positive(option, value)
        _require(pads.roll is None or pads.roll > 0, f"--pad-roll is {pads.roll}: must be above 0")
        _require(pads.bays > 1, f"--bays is {pads.bays}: must be at least 2")
        _require(pads.seat_length < pads.spacing, f"--pad-length is {pads.seat_length:g} m: must be less than --spacing "
                f"({pads.spacing:g} m)")
        _require(self.length >= 2 * pads.edges()[-1] - 1e-9, f"--length is {self.length:g} m: the seats extend over "
                f"{2 * pads.edges()[-1]:g} m")

    @property
    def check_height(self):
        """Height of the check load above the underside of the foot [m]."""
        return self.section.height - REFERENCE_DEPTH if self.force_height is None else self.force_height

    @property
    def linear_range(self):
        """Largest |Y|/Q for which the table is valid: the foot may lift off its seats. Other supports transmit tension."""
        return 0.6 if self.supports == "seats" else math.inf


def _require(satisfied, message):
    if not satisfied:
        raise Failure(message)


def _require_positive(option, value):
    _require(math.isfinite(value) and value > 0, f"{option} is {value:g}: must be above 0 and finite")
