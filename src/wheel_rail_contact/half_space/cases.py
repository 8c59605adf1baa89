# SPDX-License-Identifier: BSD-3-Clause
"""Contacts of one place under each load, by finite elements and by half-spaces, on the same cells."""
from dataclasses import dataclass

import numpy as np

from ..command import Failure
from . import normal_contact
from .half_space import influence


@dataclass
class Figures:
    """Result of one model for one contact.

    pressure      (rows, columns) [Pa]
    max_pressure  [Pa]
    area          [m^2]
    force         sum over the columns of the normal forces [N]
    """
    pressure: np.ndarray
    max_pressure: float
    area: float
    force: float


@dataclass
class Case:
    """One load. Lists have an entry for each contact.

    load       vertical [N]
    ratios     half_space_ratio [-]
    turned     whether the package uses the turned model; otherwise the curved one
    stated     model error that the package states [-]
    models     name -> list of Figures: planar, curved, turned; elements (same vertical and lateral force as turned); held
               (elements, without lateral displacement between the surroundings of the contact)
    lateral    lateral forces of the models turned and held [N]
    shift      lateral displacement of the wheel between held and elements [m]
    """
    load: float
    ratios: list
    turned: list
    stated: list
    models: dict
    lateral: tuple
    shift: float


def solve(gaps, corrections):
    """Cases of a place.

    @param gaps         PlaceGaps with the cells of the solutions
    @param corrections  of the rail and of the wheel, on the same contacts
    """
    cells = gaps.cells
    areas = np.concatenate([np.full(one.rows * one.columns, 2 * one.dx * one.dy) for one in cells])
    plane, turned = (influence(cells, gaps.modulus, flag) for flag in (False, True))
    real = turned + sum(one.on(cells) for one in corrections) * 0.5 * areas
    return [_case(case, cells, areas, plane, turned, real) for case in gaps.cases]


def _case(case, cells, areas, plane, turned, real):
    gap, planar_gap = _flat(case.gaps), _flat(case.planar)
    up, outward = (_columns(values, cells) for values in (case.up, case.outward))
    planar_up = np.concatenate([np.full(one.rows * one.columns, weight) for one, weight in zip(cells, case.planar_up)])
    load = [case.load]
    found = {"planar": normal_contact.solve(_separate(plane, cells), planar_gap, planar_up[:, None], load, areas),
             "curved": normal_contact.solve(plane, gap, up[:, None], load, areas),
             "turned": normal_contact.solve(turned, gap, up[:, None], load, areas),
             "held": normal_contact.solve(real, gap, up[:, None], load, areas)}
    lateral = [float((found[name].pressure * outward * areas).sum()) for name in ("turned", "held")]
    both = np.column_stack([up, outward])
    found["elements"] = normal_contact.solve(real, gap, both, [case.load, lateral[0]], areas)
    models = {name: _figures(contact.pressure, cells) for name, contact in found.items()}
    return Case(case.load, case.ratios, case.turned, case.stated, models, tuple(lateral),
                float(found["elements"].motion[1]))


def _flat(arrays):
    return np.concatenate([array.T.ravel() for array in arrays])


def _columns(values, cells):
    return np.concatenate([np.repeat(value, one.rows) for value, one in zip(values, cells)])


def _separate(matrix, cells):
    """The matrix without the influence of contacts on one another: each has its own plane."""
    contact = np.repeat(np.arange(len(cells)), [one.rows * one.columns for one in cells])
    return np.where(contact[:, None] == contact, matrix, 0)


def _split(pressure, cells):
    ends = np.cumsum([one.rows * one.columns for one in cells])[:-1]
    return [part.reshape(one.columns, one.rows).T for part, one in zip(np.split(pressure, ends), cells)]


def _figures(pressure, cells):
    parts = _split(pressure, cells)
    if any(part[-1].any() or part[:, 0].any() or part[:, -1].any() for part in parts):
        raise Failure("the pressure reaches the edge of the cells: they must be larger (MARGIN of half_space/gaps.py)")
    return [Figures(part, float(normal_contact.highest(part)), normal_contact.area(part, one.dx, one.dy),
                    float(2 * one.dx * one.dy * part.sum())) for part, one in zip(parts, cells)]
