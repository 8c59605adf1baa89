# SPDX-License-Identifier: BSD-3-Clause
"""Supports of the rail: clamped foot, clamped or hinged ends, or elastic seats on the sleepers."""
from dataclasses import dataclass, field

import numpy as np

from ..command import Failure
from .surface import FacePoints

FOOT = ("foot_clamped", "foot_and_ends_clamped")
ENDS = ("ends_clamped", "foot_and_ends_clamped")
KINDS = ("foot_and_ends_clamped", "foot_clamped", "ends_clamped", "ends_hinged", "seats")


@dataclass
class Pads:
    """Elastic seats under the whole rail: `bays` of length `spacing`, each with a seat in its middle.

    With an even number of bays the load is between two seats, with an odd number it is over a seat.
    """
    lateral: float           # stiffness of a seat [N/m]
    vertical: float          # stiffness of a seat [N/m]
    roll: float = None       # stiffness of a seat about the rail axis [N m/rad]; None: see roll_stiffness()
    spacing: float = 0.6     # distance between the seats [m]
    bays: int = 20
    seat_length: float = 0.15  # length of a seat along the rail [m]

    def roll_stiffness(self, section):
        """Stiffness of a seat about the rail axis [N m/rad]. If it is not given, it results from the vertical stiffness,
        evenly distributed under the flat part of the foot."""
        return self.vertical * section.foot_width() ** 2 / 12 if self.roll is None else self.roll

    def centres(self):
        """x of the centres of the seats with x >= 0 [m]."""
        first = 0.5 * self.spacing * (1 - self.bays % 2)
        return first + self.spacing * np.arange((self.bays + 1) // 2)

    def edges(self):
        """x > 0 at which a seat begins or ends [m]."""
        centres = self.centres()
        edges = np.concatenate([centres - 0.5 * self.seat_length, centres + 0.5 * self.seat_length])
        return np.sort(edges[edges > 0])


@dataclass
class Supports:
    """Fixed degrees of freedom (1 = x, 2 = y, 3 = z) of node sets, and springs from nodes to the ground."""
    fixed: dict = field(default_factory=dict)    # set name -> (node indices, degrees of freedom)
    springs: list = field(default_factory=list)  # (node index, degree of freedom, stiffness [N/m])

    def fixed_count(self):
        """Number of fixed degrees of freedom."""
        return len({(node, freedom) for nodes, freedoms in self.fixed.values()
                    for node in nodes for freedom in freedoms})


def supports(kind, mesh, section, pads=None):
    """Supports of the half model. The plane x = 0 is always a plane of symmetry."""
    result = Supports({"SYMMETRY": (mesh.plane_nodes(0, 0.0), (1,))})
    end = mesh.nodes[:, 0].max()
    if kind in FOOT:
        result.fixed["FOOT"] = (mesh.plane_nodes(2, 0.0), (1, 2, 3))
    if kind in ENDS:
        result.fixed["END"] = (mesh.plane_nodes(0, end), (1, 2, 3))
    if kind == "ends_hinged":
        result.fixed["END"] = (mesh.plane_nodes(0, end), (2, 3))
    if kind == "seats":
        result.springs = _seat_springs(mesh, section, pads)
    return result


def _seat_springs(mesh, section, pads):
    """Springs of all seats. The lateral stiffness per area is uniform. The vertical springs also give the roll stiffness."""
    springs, roll = [], pads.roll_stiffness(section)
    faces = mesh.plane_faces(2, 0.0)
    x = mesh.nodes[faces][:, :, 0]
    for centre in pads.centres():
        inside = (x > centre - 0.5 * pads.seat_length - 1e-6) & (x < centre + 0.5 * pads.seat_length + 1e-6)
        area = _nodal_area(mesh.nodes, faces[inside.all(axis=1)])
        nodes = np.flatnonzero(area)
        whole = 0.5 if centre == 0 else 1.0  # the model contains only half of a seat under the load
        vertical = _vertical_springs(mesh.nodes[nodes, 1], area[nodes], pads.vertical, roll) * whole
        lateral = area[nodes] * (pads.lateral * whole / area.sum())
        springs += [(node, 2, k) for node, k in zip(nodes, lateral)]
        springs += [(node, 3, k) for node, k in zip(nodes, vertical)]
    return springs


def _nodal_area(nodes, faces):
    """Area [m^2] of each node. The area of a face is distributed in proportion to the squares of its shape functions, which
    gives no negative share (Hinton, Rock and Zienkiewicz 1976, diagonal scaling of a mass matrix)."""
    points = FacePoints(nodes, faces, 6)
    squares = np.einsum("fp,pn->fn", points.area, points.shape**2)
    area = np.zeros(len(nodes))
    np.add.at(area, faces, squares * (points.area.sum(axis=1) / squares.sum(axis=1))[:, None])
    return area


def _vertical_springs(y, area, vertical, roll):
    """Stiffness [N/m] of springs at y [m] with the areas [m^2]: a + b y^2 per area. Their sums are the vertical [N/m] and
    roll [N m/rad] stiffness of the seat. Raises Failure if a spring would be negative."""
    moments = [np.sum(area * y**power) for power in (0, 2, 4)]
    level, bend = np.linalg.solve([moments[:2], moments[1:]], [vertical, roll])
    stiffness = area * (level + bend * y**2)
    if stiffness.min() < 0:
        edge = np.abs(y).max()
        limits = [vertical * (moments[1] * edge**2 - moments[2]) / (moments[0] * edge**2 - moments[1]),
                  vertical * moments[2] / moments[1]]
        raise Failure(f"--pad-roll is {roll:g} N m/rad: with a vertical stiffness of {vertical:g} N/m under this "
                        f"foot it must be between {limits[0]:.4g} and {limits[1]:.4g}")
    return stiffness
