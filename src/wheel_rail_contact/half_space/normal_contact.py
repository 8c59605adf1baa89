# SPDX-License-Identifier: BSD-3-Clause
"""Frictionless contact on cells with any influence matrix, and the measures of its pressure."""
from dataclasses import dataclass

import numpy as np

from ..command import Failure

MOST_STEPS = 100


@dataclass
class Contact:
    """Pressures (n) [Pa], and the rigid motions of the wheel along the given openings [m]."""
    pressure: np.ndarray
    motion: np.ndarray


def solve(matrix, gap, openings, forces, cell_areas):
    """Pressure p >= 0 with w = matrix p + gap + openings motion >= 0 and p w = 0, under given forces (Johnson 1985, 5.3).

    The set of loaded cells is changed until it agrees with its own solution.

    @param matrix      influence matrix (n, n) [m/Pa], positive definite
    @param gap         (n) [m]
    @param openings    of the gap per rigid motion of the wheel (n, k) [-]
    @param forces      against each motion (k) [N]
    @param cell_areas  of the whole contact that each cell represents (n) [m^2]

    Raises Failure if no set is found.
    """
    loaded = gap < np.quantile(gap, 0.4)
    count = len(forces)
    for _ in range(MOST_STEPS):
        n = np.flatnonzero(loaded)
        if len(n) < count:
            break
        system = np.zeros((len(n) + count, len(n) + count))
        system[:len(n), :len(n)] = matrix[np.ix_(n, n)]
        system[:len(n), len(n):] = openings[n]
        system[len(n):, :len(n)] = (openings[n] * cell_areas[n, None]).T
        solution = np.linalg.solve(system, np.concatenate([-gap[n], forces]))
        pressure = np.zeros(len(gap))
        pressure[n] = solution[:len(n)]
        motion = solution[len(n):]
        distance = matrix @ pressure + gap + openings @ motion
        following = np.where(loaded, pressure > 0, distance < 0)
        if (following == loaded).all():
            return Contact(pressure, motion)
        loaded = following
    raise Failure("the contact on cells was not found: the loaded cells do not settle, or none remains")


def highest(pressure):
    """Highest pressure [Pa] between the cells, from parabolas through the squared pressures (rows, columns).

    Row 0 lies half a cell from the plane of symmetry.
    """
    squared = pressure**2
    ridge = (9 * squared[0] - squared[1]) / 8
    top = int(ridge.argmax())
    before, here, after = ridge[max(top - 1, 0)], ridge[top], ridge[min(top + 1, len(ridge) - 1)]
    bend = before - 2 * here + after
    return np.sqrt(here - (after - before)**2 / (8 * bend) if bend < 0 else here)


def area(pressure, dx, dy):
    """Contact area [m^2] of both halves. In a column the squared pressure is taken to be linear in x^2 at its edge."""
    x = (np.arange(len(pressure)) + 0.5) * dx
    total = 0.0
    for column in pressure.T:
        last = int(np.count_nonzero(column))
        if last == 0:
            continue
        end = last * dx
        if last > 1 and column[last - 2] > column[last - 1]:
            steep = (column[last - 2]**2 - column[last - 1]**2) / (x[last - 1]**2 - x[last - 2]**2)
            end = np.sqrt(x[last - 1]**2 + column[last - 1]**2 / steep)
        total += 2 * min(end, (last + 0.5) * dx) * dy
    return total
