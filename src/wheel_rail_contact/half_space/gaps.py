# SPDX-License-Identifier: BSD-3-Clause
"""Cells on the contacts of one place, and the gaps of the bodies there at each load."""
from dataclasses import dataclass

import numpy as np

from ..command import Failure
from ..core.extension import core
from ..core.one_wheel import OneWheel

FINE_CELLS, FINE_RESIDUAL, CLOSE = (80, 96), 1e-5, 1e-4  # errors of pressure and area below 0.1 %
MARGIN = 1.25           # length and width of the cells over those of the pressure: the bodies may touch on a larger area [-]
OUTLINE_STEP = 0.25e-3  # distance of the points of an outline along its parameter [m]
NO_BODY_GAP = 0.1       # gap where wheel or rail has no point [m]
MOST_STEPS = 30         # of Newton's method
NEAREST = 1e-12         # largest distance from a place along a plane [m]


@dataclass
class Cells:
    """Cells of one contact on the surface of the rail, x > 0: rows along the track, columns across it.

    dx, dy       length and width of a cell [m]
    rail, wheel  parameters of both profiles at the middle of each column [m]
    place        y and z of the rail there (columns, 2) [m]
    angle        of the tangent of the rail about x (columns) [rad]
    opposite     y and z of the wheel on the normal there (columns, 2) [m]
    """
    rows: int
    columns: int
    dx: float
    dy: float
    rail: np.ndarray
    wheel: np.ndarray
    place: np.ndarray
    angle: np.ndarray
    opposite: np.ndarray

    @property
    def arc(self):
        """Arc of the rail from the middle of the cells to that of each column [m]."""
        return (np.arange(self.columns) - 0.5 * (self.columns - 1)) * self.dy

    @property
    def x(self):
        """x of the middle of each row [m]."""
        return (np.arange(self.rows) + 0.5) * self.dx


@dataclass
class LoadCase:
    """Gaps at one load. Lists have an entry for each contact; arrays are (rows, columns), or (columns).

    gaps      along the normals of the rail, at the height of the half-space solution [m]
    planar    over the tangent plane [m]
    up        opening of the gap per displacement of the wheel up [-]
    outward   the same, outward [-]
    planar_up opening of the planar gap per displacement of the wheel up, a number for each contact [-]
    ratios    half_space_ratio of each contact [-]
    turned    whether the package projects the displacements of each contact onto turned normals
    stated    model error of each contact that the package states [-]
    """
    load: float
    gaps: list
    planar: list
    up: list
    outward: list
    planar_up: list
    ratios: list
    turned: list
    stated: list


@dataclass
class PlaceGaps:
    """One place.

    modulus         contact modulus [Pa]
    young, poisson  of the rail [Pa], [-]
    axle_z          height of the axle at the largest load [m]
    outlines        of "rail" and "wheel" at the largest load, (n, 3): parameter, y, z [m]
    cells           list of Cells, one for each contact, at the largest load
    cases           list of LoadCase
    """
    modulus: float
    young: float
    poisson: float
    axle_z: float
    outlines: dict
    cells: list
    cases: list


@dataclass
class _Area:
    """Cells that cover the pressure of one contact under all loads. rail_u, wheel_u: parameters of both profiles at the middle;
    count: rows and columns; size: dx and dy [m]."""
    rail_u: float
    wheel_u: float
    count: tuple
    size: tuple

    @property
    def first(self):
        """Place of the first column along the arc of the rail, from the middle [m]."""
        return -0.5 * (self.count[1] - 1) * self.size[1]

    def gap(self, wheel):
        """Gap and columns of the cells: see OneWheel.gap_on."""
        return wheel.gap_on(self.rail_u, self.wheel_u, self.count, self.size, self.first)


def loaded_wheel(contact):
    """OneWheel of a WheelsetContact, for solve(). Its errors are negligible."""
    return OneWheel(contact, FINE_CELLS, stop=FINE_RESIDUAL)


def solve(wheel, y, load):
    """Solves the contact at a lateral position [m] under a load [N]. Raises Failure if there is none."""
    if not wheel.solve(y, 0.0, load, CLOSE):
        raise Failure(f"no contact was found for y = {y:g} m and a load of {load:g} N")


def compute(contact, y, loads, counts):
    """PlaceGaps of a WheelsetContact at a lateral position [m] under vertical loads of the left wheel, in increasing order [N].

    counts: rows and columns of the cells of each contact

    Raises Failure if there is no solution, or a profile ends inside the cells.
    """
    wheel, parts = loaded_wheel(contact), {}
    for load in loads:
        solve(wheel, y, load)
        parts[load] = wheel.contacts
    areas = _areas(wheel, [part for of_load in parts.values() for part in of_load], counts)
    cases = []
    for load in loads:
        solve(wheel, y, load)
        cases.append(_case(wheel, areas, load, parts[load]))
    young, poisson = (float(contact.config[f"material/rail/{name}"]) for name in ("young", "poisson"))
    return PlaceGaps(wheel.modulus, young, poisson, wheel.height, _outlines(wheel), [_cells(wheel, area) for area in areas],
                     cases)


def _areas(wheel, parts, counts):
    """Areas of the parts of all loads, from the gauge side to the field side. Parts that overlap are in one area; all areas
    have the same length."""
    joined = []
    for part in sorted(parts, key=lambda part: part["first_u"]):
        if joined and part["first_u"] <= joined[-1]["last_u"]:
            joined[-1].update({name: max(part[name], joined[-1][name]) for name in ("last_u", "half_length")})
        else:
            joined.append(dict(part))
    rows, columns = counts
    length = MARGIN * max(part["half_length"] for part in joined)
    areas = []
    for part in joined:
        first, last = part["first_u"], part["last_u"]
        middle = 0.5 * (first + last)
        areas.append(_Area(middle, part["wheel_u"] + wheel.rail_arc(first, middle), (rows, columns),
                           (length / rows, MARGIN * wheel.rail_arc(first, last) / columns)))
    return areas


def _case(wheel, areas, load, parts):
    case = LoadCase(load, [], [], [], [], [], [], [], [])
    for area in areas:
        found = area.gap(wheel)
        case.gaps.append(found["gap"])
        case.up.append(found["per_up"])
        case.outward.append(found["per_outward"])
        touch = int(found["gap"].min(axis=0).argmin())
        case.planar.append(planar_gap(wheel, area.count, area.size, found, touch))
        case.planar_up.append(found["cosine"][touch])
        own = [part for part in parts if abs(wheel.rail_arc(area.rail_u, part["first_u"])) < -area.first]
        ratio, turned = max((part["half_space_ratio"] for part in own), default=0.0), any(part["turned"] for part in own)
        case.ratios.append(ratio)
        case.turned.append(turned)
        case.stated.append(core.model_error(ratio, turned))
    return case


def planar_gap(wheel, count, size, columns, touch):
    """Gap of the planar model, (rows, columns) [m], in place of that along the normals of the rail: wheel and rail are heights
    over the plane that touches the rail in one column, and cells lie on this plane (Johnson 1985, section 4.1).

    columns: of the cells on the surface of the rail; those on the plane have the same sizes and the same distances from the
        touching column
    touch: index of this column

    NO_BODY_GAP if wheel or rail has no point over a cell.
    """
    y, z, cosine, sine = plane = [float(columns[name][touch]) for name in ("y", "z", "cosine", "sine")]
    on_plane = wheel.gap_on(0.0, columns["wheel_u"][touch], count, size, -touch * size[1], plane)
    along, u = (np.arange(count[1]) - touch) * size[1], columns["rail_u"]
    for _ in range(MOST_STEPS):
        rail = wheel.rail_at(u)
        missing = along - (cosine * (rail[:, 0] - y) + sine * (rail[:, 1] - z))
        if (np.abs(missing) < NEAREST).all():
            break
        u = u + missing / (cosine * rail[:, 2] + sine * rail[:, 3])
    gap = on_plane["gap"] - (cosine * (rail[:, 1] - z) - sine * (rail[:, 0] - y))
    has_bodies = on_plane["has_bodies"].all() and (np.abs(missing) < NEAREST).all() and np.isfinite(gap).all()
    return gap if has_bodies else np.full(gap.shape, NO_BODY_GAP)


def _outlines(wheel):
    rail_u, wheel_u = (np.arange(0, length, OUTLINE_STEP) for length in (wheel.rail_length, wheel.wheel_length))
    return {"rail": np.column_stack([rail_u, wheel.rail_at(rail_u)[:, :2]]),
            "wheel": np.column_stack([wheel_u, wheel.wheel_at(wheel_u)])}


def _cells(wheel, area):
    columns = area.gap(wheel)
    if not columns["has_bodies"].all():
        raise Failure("a profile ends inside the cells")
    return Cells(*area.count, *area.size, columns["rail_u"], columns["wheel_u"],
                 np.column_stack([columns["y"], columns["z"]]), np.arctan2(columns["sine"], columns["cosine"]),
                 wheel.wheel_at(columns["wheel_u"]))
