# SPDX-License-Identifier: BSD-3-Clause
"""The study: each place by finite elements and by half-spaces, and the tables of its results."""
from dataclasses import dataclass, field

import numpy as np

from ..core.contact import WheelsetContact
from . import cases, gaps
from .finite_elements import Sizes, corrections

LEAST_CELLS = 6  # in each direction: the correction is a polynomial of the fourth degree over them


@dataclass
class Settings:
    """Accuracy of the study.

    element_cells   number of cells of each contact on which the elements are loaded, approximately
    solution_cells  rows and columns of the cells of the solutions
    sizes           of the elements
    """
    element_cells: int = 180
    solution_cells: tuple = (28, 56)
    sizes: Sizes = field(default_factory=Sizes)


QUICK = Settings(element_cells=60, solution_cells=(14, 24),
                 sizes=Sizes(near=1.6, growth=0.6, far=0.018, half_length=0.04))


@dataclass
class PlaceResult:
    """Results of one place.

    gaps         PlaceGaps of the solutions
    cases        list of Case, one for each load
    corrections  of the rail and of the wheel
    """
    place: object
    gaps: gaps.PlaceGaps
    cases: list
    corrections: list


def solve_place(place, settings, folder, progress):
    """Result of a place.

    @param folder    receives all files of the place (pathlib.Path); it is made if necessary
    @param progress  is called with the name of each step when it begins

    Raises Failure if a program is missing or fails, or if there is no solution.
    """
    folder.mkdir(parents=True, exist_ok=True)
    progress(f"{place.title}: half-spaces")
    contact = WheelsetContact(place.parameters(folder))
    solution = gaps.compute(contact, place.y, place.loads, settings.solution_cells)
    loaded = gaps.compute(contact, place.y, place.loads, square_cells(solution.cells, settings.element_cells))
    found = corrections(loaded, place.inclination, settings.sizes, folder, lambda step: progress(f"{place.title}: {step}"))
    return PlaceResult(place, solution, cases.solve(solution, found), found)


def square_cells(cells, count):
    """Rows and columns of about `count` cells on the contacts of other cells. They are nearly squares, as the elements on
    them should be, unless that leaves less than LEAST_CELLS in a direction."""
    length = cells[0].rows * cells[0].dx
    width = max(one.columns * one.dy for one in cells)
    columns = int(np.clip(round(np.sqrt(count * width / length)), LEAST_CELLS, count // LEAST_CELLS))
    return count // columns, columns
