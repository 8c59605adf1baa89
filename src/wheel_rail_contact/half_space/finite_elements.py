# SPDX-License-Identifier: BSD-3-Clause
"""Correction of half-spaces at one place, by finite elements of the rail and of the wheel."""
from dataclasses import dataclass

import numpy as np

from . import bodies
from .body_mesh import body_mesh
from .cell_loads import cell_loads
from .compliance import compliance
from .correction import Correction
from .half_space import influence
from .places import RADIUS


@dataclass
class Sizes:
    """Lengths of the elements.

    near         at the contact, over the side of a cell [-]
    growth       increase of the size with the distance from the contact [-]
    far          largest size [m]
    half_length  of the bodies along the track [m]
    """
    near: float = 1.0
    growth: float = 0.3
    far: float = 0.009
    half_length: float = 0.06


def corrections(gaps, inclination, sizes, directory, progress):
    """Correction of the rail and of the wheel: two Corrections.

    @param gaps       PlaceGaps with the cells of the finite elements
    @param directory  receives the files of gmsh and CalculiX (pathlib.Path)
    @param progress   is called with the name of each step when it begins
    """
    cells = gaps.cells
    rail = bodies.rail_body(gaps.outlines["rail"], [_range(one.rail) for one in cells], inclination)
    wheel = bodies.wheel_body(gaps.outlines["wheel"], [_range(one.wheel) for one in cells], gaps.axle_z, RADIUS)
    centre = np.mean([one.place.mean(axis=0) for one in cells], axis=0)
    plane = influence(cells, gaps.young / (1 - gaps.poisson**2), turned=True)
    plane /= np.concatenate([np.full(one.rows * one.columns, one.dx * one.dy) for one in cells])
    found = []
    for body, outward in ((rail, 1), (wheel, -1)):
        progress(f"meshing the {body.name}")
        mesh = body_mesh(body, cells, sizes, directory)
        loads = [load for one, curve in zip(cells, body.patches)
                 for load in cell_loads(mesh, body, one, body.curves[curve], outward)]
        progress(f"solving {len(loads)} forces on the {body.name}: {len(mesh.nodes)} nodes")
        real = compliance(mesh, body, loads, centre, (gaps.young, gaps.poisson), directory)
        found.append(Correction(cells, real - plane))
        progress(f"correction of the {body.name}: up to {found[-1].largest:.2e} m/N near forces, fitted within "
                 f"{found[-1].residual:.1e} m/N")
    return found


def _range(parameters):
    """Range of the parameter of a profile over the columns [m]."""
    return (1.5 * parameters[0] - 0.5 * parameters[1], 1.5 * parameters[-1] - 0.5 * parameters[-2])
