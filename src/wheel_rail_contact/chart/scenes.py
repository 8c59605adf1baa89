# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of the chart: the contacts on which the methods are compared, each with the methods that run on it.

A scene has `states_per_step` states for each step between two messages, from `reach` steps to its right to as many to its left.
"""
import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Callable

import numpy as np

from ..core.contact import sources
from ..core.extension import core

STEP = 0.05e-3  # lateral distance of consecutive messages [m]
# Largest number of steps from the scene to a message: 0.2 mm. Over this distance a narrow pressure lobe takes all positions
# relative to the cells of a coarse grid.
LONGEST_REACH = 4
TOLERANCES = (0.1, 0.03, 0.01, 0.003)  # contact/tolerance of auto [-]
FIXED = ("hertz", "kik_piotrowski", "seidel_printed", "seidel", "conjugate_gradient")
COARSEST = (8, 16)  # cells of a grid that is too coarse for auto: what it would save
LOAD = 100e3  # of each wheel [N]


@dataclass(frozen=True)
class Choice:
    """Setting to be compared: a method on one grid, or auto at one tolerance."""

    method: str
    grid: tuple = (0, 0)  # cells (along, across) of a fixed method
    tolerance: float = 0.0  # contact/tolerance [-]; 0: the default, for fixed methods only

    @property
    def parameters(self):
        """Group `contact` of the parameters of a node."""
        tolerance = {"tolerance": self.tolerance} if self.tolerance else {}
        return {"contact": {"method": self.method, "grid": dict(zip(("along", "across"), self.grid)), **tolerance}}


@lru_cache(maxsize=None)
def levels_of(choice):
    """Grids of a choice with their solver, which is costly to prepare: each is made once."""
    return core.GridLevels(choice.method, choice.grid, choice.tolerance)


def all_choices():
    """Every method on one coarser grid than those of auto and on each of these, then auto at each of the tolerances."""
    autos = [Choice("auto", tolerance=tolerance) for tolerance in TOLERANCES]
    grids = dict.fromkeys([COARSEST, *(grid for auto in autos for grid in levels_of(auto).grids)])
    return [Choice(method, grid) for method in FIXED for grid in grids] + autos


@dataclass(frozen=True)
class Patch:
    """Patch of a gap scene. The gap [m] is a function of arrays x and y [m], even in x."""

    gap: Callable
    first_touch: float = 0.0  # least gap [m]
    weight: float = 1.0  # opening of the gap per movement of the bodies along the load [-]


@dataclass
class Box:
    """Region of a patch that contains the overlap of the undeformed bodies."""

    length: float  # along the track, about x = 0 [m]
    y_begin: float  # across the track [m]
    y_end: float


class GapScene:
    """A contact given by its gap: normal problem only, on a grid laid closely around the overlap of the undeformed bodies."""

    kind = "normal"
    states_per_step = 1
    MARGIN = 1.04  # size of the grid over that of the overlap, at all positions [-]
    BOXING_GRID, BOXINGS = (32, 128), 3

    def __init__(self, name, title, *patches):
        self.name, self.title, self._patches = name, title, patches
        self._boxes = [Box(0.050, -0.016, 0.016) for _ in patches]
        for _ in range(self.BOXINGS):
            self._tighten()

    def reference(self, grid, offset):
        """Outcome of conjugate gradients, `offset` steps across the track."""
        return core.gap_reference(self._problem(grid, offset))[1]

    def run(self, choice, reach):
        """Run of a method, which starts cold. Runs of equal choices share their solver: only the latest may be used."""
        levels = levels_of(choice)
        offsets = range(-reach, reach + 1)
        return core.GapRun(levels, [[self._problem(grid, offset) for offset in offsets] for grid in levels.grids])

    def _problem(self, grid, offset):
        problem = core.GapProblem(LOAD)
        for patch, box in zip(self._patches, self._boxes):
            cell, x, y = self._cells(box, grid)
            problem.add(cell, y[0], patch.gap(x[:, np.newaxis], y - offset * STEP), patch.weight, patch.first_touch)
        return problem

    def _cells(self, box, grid):
        """Cell of a grid about a box, and the centres of its rows with x > 0 and of its columns [m]."""
        along, across = grid
        width = self.MARGIN * (box.y_end - box.y_begin) + 2 * LONGEST_REACH * STEP
        cell = core.covering_cell(self.MARGIN * box.length, width, along, across)
        first = 0.5 * (box.y_begin + box.y_end - (across - 1) * cell.dy)
        return cell, (np.arange(along // 2) + 0.5) * cell.dx, first + np.arange(across) * cell.dy

    def _tighten(self):
        """Lays the boxes around the overlap that is found in them."""
        approach, _ = core.gap_reference(self._problem(self.BOXING_GRID, 0))
        boxes = []
        for patch, box in zip(self._patches, self._boxes):
            cell, x, y = self._cells(box, self.BOXING_GRID)
            rows, columns = np.nonzero(patch.gap(x[:, np.newaxis], y) < patch.weight * approach)
            boxes.append(Box(2 * x[rows.max()] + cell.dx, y[columns.min()] - 0.5 * cell.dy, y[columns.max()] + 0.5 * cell.dy))
        self._boxes = boxes


class Wheelsets:
    """Wheelsets of one configuration by choice. Each is made once."""

    def __init__(self, **parameters):
        self._parameters, self._made = parameters, {}

    def sources(self, *groups):
        """Parameters of the configuration, with further groups, for the core."""
        return sources([self._parameters, *groups])

    def find(self, choice):
        if choice not in self._made:
            self._made[choice] = core.TimedWheelset(self.sources(choice.parameters))
        return self._made[choice]


@dataclass
class WheelsetScene:
    """A wheelset at one pose under one load: whole calculation."""

    name: str
    title: str
    wheelsets: Wheelsets
    y: float  # of the axle centre, to the left positive [m]

    kind = "wheelset"
    states_per_step = 10
    REFERENCE_TOLERANCE = 1e-4  # of height and roll [-]

    def reference(self, grid, offset):
        """Outcome of conjugate gradients, `offset` steps across the track."""
        levels = levels_of(Choice("conjugate_gradient", grid, self.REFERENCE_TOLERANCE))
        return core.wheelset_reference(self.wheelsets.sources(), levels, self.y + offset * STEP, -2 * LOAD,
                                       self.REFERENCE_TOLERANCE)

    def run(self, choice, reach):
        """Run of a method, which starts cold. Runs of equal choices share their wheelset: only the latest may be used."""
        last = 2 * reach * self.states_per_step
        lateral = [self.y + (state / self.states_per_step - reach) * STEP for state in range(last + 1)]
        return core.WheelsetRun(self.wheelsets.find(choice), lateral, -2 * LOAD)


def gap_scenes():
    """Hertz 1:1 and 1:5, a curvature discontinuity, two patches, merged lobes, nearly conformal arcs."""
    later = 20e-6  # [m]
    flange = _paraboloid(ALONG, _arc(0.020))
    yield GapScene("hertz_1_1", "Hertz, ellipse 1:1", Patch(_paraboloid(ALONG, ALONG)))
    yield GapScene("hertz_1_5", "Hertz, ellipse 1:5", Patch(_paraboloid(ALONG, _across_for_ratio(5))))
    yield GapScene("discontinuity", "Curvature discontinuity 300/80 mm", Patch(_discontinuity))
    # One patch on the tread and one on a flange inclined by 35 degrees, whose first touch is at 20 µm.
    yield GapScene("two_patches", "Two patches", Patch(_paraboloid(ALONG, _arc(0.200))),
                   Patch(lambda x, y: flange(x, y) + later, later, math.cos(35 * math.pi / 180)))
    yield GapScene("lobes", "Merged lobes", Patch(_lobes))
    yield GapScene("conformal", "Nearly conformal arcs", Patch(_conformal))


def wheelset_scenes():
    """Wheelset scenes, 100 kN per wheel.

    Wheel S1002 on rail UIC60 with the track of the Manchester contact benchmark (Shackleton and Iwnicki 2008, Vehicle System
    Dynamics 46: rail inclination 1:40, gauge 1435 mm, back-to-back distance 1360 mm, rolling radius 460 mm); the same on rail
    60E1, where a second contact begins at the gauge corner; the case of the paper, with both rails displaced outward as in
    Golubenko et al. 2011 (TEKA XI, 78–84); and rails that bend: on pads under the flange, and that of the paper with balanced
    moments.
    """
    rail = {"profile": "UIC60_manchester"}
    manchester = Wheelsets(rail=rail)
    for y in (0, 0.5, 3, 5, 6.5):
        yield WheelsetScene(f"manchester_{y}", f"Manchester, y = {y} mm", manchester, 1e-3 * y)
    yield WheelsetScene("onset_4.38", "60E1, onset at y = 4.38 mm", Wheelsets(), 4.38e-3)
    bent = {"model": "prescribed", "prescribed": {"lateral": 0.2435e-3}}
    yield WheelsetScene("paper", "Paper's case, rails bent", Wheelsets(rail=rail, rail_bending=bent), 0.572e-3)
    pads, paper = ({"model": "compliance", "table": f"config/rails/{name}.yaml"} for name in ("pads_40_100", "paper"))
    yield WheelsetScene("pads_5", "60E1 on pads 40/100, y = 5 mm", Wheelsets(rail_bending=pads), 5e-3)
    moments = Wheelsets(rail=rail, rail_bending=paper, wheelset={"balance": "moments"})
    yield WheelsetScene("moments_2", "Paper's rail, moments, y = 2 mm", moments, 2e-3)


def all_scenes():
    return [*gap_scenes(), *wheelset_scenes()]


def _arc(radius):
    """Half the curvature of an arc [1/m]: its distance from its tangent is this value times the square of the position."""
    return 0.5 / radius


ALONG = _arc(0.46)  # coefficient of the gap along x for a wheel of 0.46 m [1/m]


def _paraboloid(a, b):
    return lambda x, y: a * x * x + b * y * y


def _across_for_ratio(ratio):
    """Coefficient across the track for which the contact ellipse is `ratio` times as long as wide, by bisection."""
    low, high = ALONG, ALONG * ratio * ratio
    for _ in range(60):
        middle = math.sqrt(low * high)
        along, across = core.hertz_semi_axes(ALONG, middle)
        low, high = (middle, high) if along < ratio * across else (low, middle)
    return low


def _discontinuity(x, y):
    """Transition between two arcs of the rail head (300 mm on the crown, 80 mm beside it) under a conical tread."""
    return ALONG * x * x + np.where(y < 0, _arc(0.300), _arc(0.080)) * y * y


def _lobes(x, y):
    """Two minima 8 mm apart, 10 µm below the saddle between them, loaded until their contacts merge."""
    depth, half = 10e-6, 4e-3
    q = y / half
    well = q * q - 1
    return ALONG * x * x + depth * well * well


def _conformal(x, y):
    """An arc of 13.0 mm in one of 13.2 mm; both end 12.5 mm from the middle."""
    inner, outer, end = 0.0130, 0.0132, 0.0125
    t = np.minimum(np.abs(y), end)
    between = (inner - np.sqrt(inner * inner - t * t)) - (outer - np.sqrt(outer * outer - t * t))
    return ALONG * x * x + between + (np.abs(y) - t)
