# SPDX-License-Identifier: BSD-3-Clause
"""Errors and times of the methods for creep forces, on ellipses with the pressure of Hertz."""
import math
from collections import namedtuple
from dataclasses import dataclass
from statistics import median

import numpy as np

from ..command import Failure
from ..core.creep import kalker_coefficients
from ..core.extension import core

GRIDS = {"linear": ((8, 16),),  # any: it has no cells
         "fastsim": ((8, 16), (12, 24), (16, 32), (24, 64), (48, 48)),
         "exact": ((8, 16), (12, 24), (16, 32), (24, 64), (48, 48))}
RATIOS = (0.2, 0.5, 1.0, 2.0, 5.0)  # a/b, along the track over across it
MEAN_AXIS, NORMAL_FORCE = 6e-3, 1e5  # sqrt(a b) [m], [N]; relative errors depend on neither
# Linear force by the creepages along x and y, and spin: over their values that saturate the patch, or nearly so. The force
# of the linear law is 0.70, 0.96 and 1 of the friction limit at 1, 2 and 3.
DIRECTIONS = ((1, 0), (0.6, 0.8), (0, 1))
WITHOUT_SPIN = [(e * x, e * y, 0) for e in (0.5, 1.5, 3) for x, y in DIRECTIONS]
WITH_SPIN = [(x, y, spin) for spin in (0.5, 2)
             for x, y in ((0, 0), *((e * x, e * y) for e in (1, 3) for x, y in ((1, 0), (0, 1), (0, -1))))]
STATES = WITHOUT_SPIN + WITH_SPIN
SHORTEST_TIME = 3e-4  # of the solutions that are timed together [s]

Extent = namedtuple("Extent", "truth rounds")  # grid of the reference solution, by `exact`; measurements of each time
FULL, QUICK = Extent((96, 96), 3), Extent((48, 64), 1)


@dataclass(frozen=True)
class CreepRow:
    """One method on one grid, on one ellipse with one creepage. Fields are the columns of the table."""

    a_over_b: float
    creepage_x: float  # [-]
    creepage_y: float
    spin: float  # [1/m]
    method: str
    cells_along: int
    cells_across: int
    time: float  # median CPU time of a solution from a cold start [s]
    error_force: float  # distance of the forces along x and y from the reference, over the friction limit [-]
    error_moment: float  # difference of the moments, over the friction limit and sqrt(a b) [-]
    truth_error: float  # estimated error of the reference [-]

    @property
    def error(self):
        return max(self.error_force, self.error_moment)


def measure(extent, progress):
    """Rows of all methods on all ellipses; calls progress(title) once for each ellipse."""
    rows = []
    for ratio in RATIOS:
        progress(f"creep forces, a/b = {ratio:g}")
        rows += _measure_ellipse(ratio, extent)
    return rows


def _measure_ellipse(ratio, extent):
    ellipse = MEAN_AXIS * ratio ** 0.5, MEAN_AXIS / ratio ** 0.5, NORMAL_FORCE
    limit = core.DEFAULT_FRICTION * NORMAL_FORCE
    creepages = np.array(STATES) * limit / _stiffness(ratio)
    truth, rows = core.CreepRun("exact", ellipse, extent.truth, creepages), []
    truths = [(_solve(truth, state) / limit, truth.outcome().estimate) for state in range(len(STATES))]
    for method, grids in GRIDS.items():
        for grid in grids:
            run = core.CreepRun(method, ellipse, grid, creepages)
            for state, (creepage, (forces, estimate)) in enumerate(zip(creepages, truths)):
                x, y, moment = _solve(run, state) / limit - forces
                rows.append(CreepRow(ratio, *creepage, method, *grid, _time(run, state, extent.rounds), math.hypot(x, y),
                                     abs(moment) / MEAN_AXIS, estimate))
    return rows


def _stiffness(ratio):
    """Linear force over the creepages along x and y [N], and friction limit over the spin that saturates a patch [N m]."""
    shear = core.DEFAULT_YOUNG / (2 + 2 * core.DEFAULT_POISSON)
    c11, c22, _, _ = kalker_coefficients(ratio)
    return shear * MEAN_AXIS ** 2 * np.array([c11, c22, 1.5 * MEAN_AXIS])


def _solve(run, state):
    run.solve(state)
    if not run.outcome().usable:
        raise Failure(f"creep forces, state {state}: {run.outcome().reason}")
    return np.array(run.force())


def _time(run, state, rounds):
    """Median time of a solution [s]. The grid was solved before."""
    together = [state] * max(1, round(SHORTEST_TIME / run.time([state])))
    return median(run.time(together) for _ in range(rounds))


def summary(rows, spin):
    """{(method, grid): (median time [s]; median and largest error, largest error of the force [-])} with or without spin."""
    groups = {}
    for row in rows:
        if (row.spin != 0) == spin:
            groups.setdefault((row.method, (row.cells_along, row.cells_across)), []).append(row)
    return {key: (median(row.time for row in group), median(row.error for row in group), max(row.error for row in group),
                  max(row.error_force for row in group))
            for key, group in groups.items()}
