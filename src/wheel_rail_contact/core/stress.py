# SPDX-License-Identifier: BSD-3-Clause
"""Stress in wheel and rail beneath a patch, and numbers of stresses, as arrays.

A stress is an array whose last dimension has the components xx, yy, zz, yz, xz, xy [Pa], tension positive. Axes: x and y of
the grid of the pressure (forward, left), z into the body. In the patch frame, whose z points out of the rail, xz and yz of the
rail change their sign.
"""
import numpy as np

from .extension import core
from .pressure import grid_of

COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")


def stress_at(patch, x, y, depth, poisson=core.DEFAULT_POISSON):
    """Stress by the pressure of a patch in an elastic half-space, at points.

    The sum of the closed forms of all cells is exact for a pressure that is constant on each cell (Love 1929). The time grows
    with the number of points times that of the loaded cells. Other threads run meanwhile.

    patch: PatchResult, or message ContactPatch
    x: along the track, forward, in the patch frame [m]
    y: across the track, left, along the arc of the rail's section [m]
    depth: below the surface, at least 0 [m]; at 0 the stress jumps from cell to cell
    poisson: Poisson's ratio of the body [-]; default: that of config/default.yaml

    x, y and depth are numbers or arrays that broadcast to one shape. Returns an array of this shape and (6,): see the module.

    Raises ValueError for a message without its grid, a negative depth, or poisson outside (-1, 0.5].
    """
    places = np.broadcast_arrays(*(np.asarray(value, dtype=float) for value in (x, y, depth)))
    points = np.stack([place.ravel() for place in places], axis=1)
    pressure, first, size = grid_of(patch)
    return core.stress_at(*first, *size, pressure, poisson, points).reshape(places[0].shape + (len(COMPONENTS),))


def stress_layers(patch, depths, poisson=core.DEFAULT_POISSON):
    """Stress by the pressure of a patch below the centres of all its cells: that of stress_at(), faster.

    depths: (n,) below the surface, each at least 0 [m]
    patch, poisson: as for stress_at()

    Returns (n, 6, nx, ny): components as in the module, cells as in patch.pressure. Raises as stress_at().
    """
    pressure, first, size = grid_of(patch)
    return core.stress_layers(*first, *size, pressure, poisson, np.atleast_1d(np.asarray(depths, dtype=float)))


def von_mises(stress):
    """Von Mises stress [Pa] of stresses (..., 6): an array (...). Raises ValueError for another last dimension."""
    return _each(core.von_mises, stress)


def max_shear(stress):
    """Highest shear stress [Pa] of stresses (..., 6): half the difference of the largest and the smallest principal stress, an
    array (...). Raises ValueError for another last dimension."""
    return _each(core.max_shear, stress)


def principal_stresses(stress):
    """Principal stresses [Pa] of stresses (..., 6): an array (..., 3), the largest first. Raises ValueError for another last
    dimension."""
    return _each(core.principal_stresses, stress)


def strain(stress, young, poisson):
    """Strains [-] of stresses (..., 6) by Hooke's law: an array (..., 6) with the same components, lengthening positive. yz, xz
    and xy are those of the tensor: half the change of the angle.

    young: Young's modulus [Pa]
    poisson: Poisson's ratio [-]

    Raises ValueError for another last dimension, or a constant out of range.
    """
    return _each(core.strain, stress, young, poisson)


def _each(function, stress, *constants):
    """Applies a function of the module to each stress."""
    array = np.asarray(stress, dtype=float)
    if array.shape[-1:] != (len(COMPONENTS),):
        raise ValueError(f"stress: has the shape {array.shape}, but its last dimension must be {len(COMPONENTS)}: "
                         f"{', '.join(COMPONENTS)}")
    numbers = function(array.reshape(-1, len(COMPONENTS)), *constants)
    return numbers.reshape(array.shape[:-1] + numbers.shape[1:])
