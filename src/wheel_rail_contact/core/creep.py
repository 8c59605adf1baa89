# SPDX-License-Identifier: BSD-3-Clause
"""Creep forces of elliptic contacts, and the coefficients of the linear theory."""
import numbers

import numpy as np

from .array_arguments import numbers_of
from .extension import core


def ellipse_creep_force(*, semi_axes, normal_force, creepage, friction=core.DEFAULT_FRICTION, method="exact",
                        young=core.DEFAULT_YOUNG, poisson=core.DEFAULT_POISSON, cells=None):
    """Force of the rail on the wheel by friction, in an elliptic contact with the pressure of Hertz that rolls forward.

    Axes of the patch: x forward, y left in the tangent plane, z out of the rail.

    semi_axes: (a, b) along and across the track [m]
    normal_force: above 0 [N]
    creepage: (x, y, spin) velocity of the wheel relative to the rail over the running speed: along x and y [-], rotation about
        z, right-handed [1/m]
    friction: coefficient, 0 to 2
    method: "linear" (with saturation; not for spin), "fastsim", "exact" (complete theory of steady rolling), or "none"
    young, poisson: Young's modulus [Pa] and Poisson's ratio, 0 to 0.5, of both bodies; default: those of config/default.yaml
    cells: (nx, ny) along and across the track, each 1 to 1024; default: 48 x 48. "linear" has no cells

    Returns (Fx, Fy, Mz) on the wheel [N, N, N m], Mz about z, right-handed. Force and creepage along x have opposite signs, and
    along y, unless spin opposes. Other threads run meanwhile.

    Raises TypeError for an argument that is not a number, ValueError for a wrong shape or a number out of range.
    """
    if method not in core.CREEP_METHODS:
        raise ValueError(f"method = {method!r}: must be one of {', '.join(core.CREEP_METHODS)}")
    creepage = _numbers("creepage", creepage, 3)
    if not np.all(np.isfinite(creepage)):
        raise ValueError(f"creepage = {tuple(creepage)}: must be finite")
    cells = core.ELLIPSE_CELLS if cells is None else cells
    if not all(isinstance(count, numbers.Integral) for count in np.ravel(cells)):
        raise TypeError(f"cells = {cells!r}: must be integers")
    counts = np.clip(_numbers("cells", cells, 2), -1, 2 ** 30).astype(int)  # the core refuses both ends
    one = [_number(name, value) for name, value in (("normal_force", normal_force), ("friction", friction), ("young", young),
                                                    ("poisson", poisson))]
    return tuple(core.ellipse_creep_force(_numbers("semi_axes", semi_axes, 2), one[0], creepage, one[1], method, *one[2:],
                                          counts))


def kalker_coefficients(ratio, poisson=core.DEFAULT_POISSON):
    """Coefficients C11, C22, C23 and C33 [-] of the linear theory: with c² = a b and the shear modulus G, the wheel has the forces

        Fx = -c² G C11 x,  Fy = -c² G C22 y - c³ G C23 spin,  Mz = c³ G C23 y - c⁴ G C33 spin

    for creepages (x, y, spin) as in ellipse_creep_force().

    ratio: a/b of the semi-axes along and across the track, above 0; a number or an array (...). The table of Kalker (1990) is
        for 0.1 to 10; beyond, it is extrapolated
    poisson: Poisson's ratio of both bodies, 0 to 0.5

    Returns an array (4, ...). Raises TypeError for an argument that is not a number, ValueError for a number out of range.
    """
    ratios = numbers_of("ratio", ratio)
    return core.kalker_coefficients(ratios.ravel(), _number("poisson", poisson)).reshape((4, *ratios.shape))


def _number(name, value):
    array = numbers_of(name, value)
    if array.shape:
        raise ValueError(f"{name}: has the shape {array.shape}, but must be a number")
    return float(array)


def _numbers(name, value, count):
    array = numbers_of(name, value)
    if array.shape != (count,):
        raise ValueError(f"{name}: has the shape {array.shape}, but must be an array ({count},)")
    return array
