# SPDX-License-Identifier: BSD-3-Clause
"""The case by several methods and on several grids, at roll 0."""
import math

import numpy as np

from ..command import Failure
from ..core.one_wheel import OneWheel
from .case import INCLINATION, LOAD, POSITION, contact

ACCURATE_CELLS = (64, 128)
ACCURATE_RESIDUAL = 1e-5
LATE_STOP = 1e-4
EARLY_STOPS = (1e-1, 3e-2, 1e-2, 1e-3)
COLUMNS = (8, 12, 16, 24, 32)
USUAL_COLUMNS = 24


def compare(deflection):
    """Rows of methods.csv for one wheel at the position of the case, without the name of the case: the accurate solution, the
    repaired iteration of the paper, and the printed one on nearly square cells (within a few per cent) of several sizes, with
    a late and an early stop.

    deflection: (lateral, vertical, roll) of the reference point of the rail head [m, m, rad]

    Raises Failure if the accurate solution fails.
    """
    parameters = contact()
    rows = [_row(parameters, deflection, ACCURATE_CELLS, "conjugate_gradient", ACCURATE_RESIDUAL)]
    if not rows[0]["area"]:
        raise Failure("the accurate solution of the paper's case failed")
    squares = {columns: _squares(parameters, deflection, columns) for columns in COLUMNS}
    rows.append(_row(parameters, deflection, squares[USUAL_COLUMNS], "seidel", LATE_STOP))
    for columns, stop in [(columns, LATE_STOP) for columns in COLUMNS] + [(USUAL_COLUMNS, stop) for stop in EARLY_STOPS]:
        rows.append(_row(parameters, deflection, squares[columns], "seidel_printed", stop))
    return rows


def _solved(wheel, deflection):
    wheel.set_rail(INCLINATION, *deflection)
    return wheel.solve(POSITION, 0.0, LOAD)


def _row(parameters, deflection, cells, method, stop):
    wheel = OneWheel(parameters, cells, method, stop)
    row = {"method": method, "cells_along": cells[0], "cells_across": cells[1], "cell_along": 0.0, "cell_across": 0.0,
           "stop": stop, "iterations": 0, "max_pressure": 0.0, "area": 0.0, "counted_area": 0.0}
    if _solved(wheel, deflection):
        patches = wheel.patches
        row.update(cell_along=patches[0]["dx"], cell_across=patches[0]["dy"], iterations=wheel.iterations,
                   counted_area=sum(np.count_nonzero(patch["pressure"]) * patch["cell_area"] for patch in patches))
        row["max_pressure"], row["area"] = wheel.figures
    return row


def _squares(parameters, deflection, columns):
    """Cells along and across the track that are nearly square. How far a grid reaches beyond the contact depends on its number
    of cells, so all numbers of rows are tried."""
    def stretch(rows):
        wheel = OneWheel(parameters, (rows, columns))
        if not _solved(wheel, deflection):
            return np.inf
        patch = wheel.patches[0]
        return abs(math.log(patch["dx"] / patch["dy"]))
    return min(range(columns // 4 * 2, 2 * columns + 1, 2), key=stretch), columns
