# SPDX-License-Identifier: BSD-3-Clause
"""Loads on the cells of a contact, on the surface of a meshed body."""
from dataclasses import dataclass

import numpy as np

from ..command import Failure

SAMPLES = 20            # places in a column among which the nearest to a face is searched
SURFACE_DISTANCE = 0.2  # of a face from the cells, over the smaller side of a cell, at which it is not on them [-]
FACES_OF_CELL = 2


@dataclass
class CellLoad:
    """A uniform pressure on one cell, with a force of 1 N: forces at nodes. The work of these forces is that of the mean
    displacement of the cell along `direction`.

    nodes      indices of the nodes
    weights    force of each node [N], sum 1
    direction  y and z of the force [-]
    """
    nodes: np.ndarray
    weights: np.ndarray
    direction: np.ndarray


def cell_loads(mesh, body, cells, curve, outward):
    """Loads of all cells of one contact, rows running fastest.

    @param curve    points (n, 2) of the section of the body under the cells, y and z [m]
    @param outward  1 if the normals of the cells point out of the body's surface and the force presses on it (wheel: -1)

    Raises Failure if the mesh is not regular on the cells.
    """
    faces = _surface_faces(mesh)
    row, column = _place(mesh.nodes[faces[:, :3]].mean(axis=1), body, cells, curve)
    loads = []
    for j in range(cells.columns):
        direction = -outward * np.array([-np.sin(cells.angle[j]), np.cos(cells.angle[j])])
        for i in range(cells.rows):
            own = faces[(row == i) & (column == j)]
            if len(own) != FACES_OF_CELL:
                raise Failure(f"the mesh of the {body.name} has {len(own)} faces in a cell: must be {FACES_OF_CELL}")
            loads.append(_load(mesh, own, direction))
    return loads


def _surface_faces(mesh):
    """Outer faces that are not in the plane of symmetry."""
    faces = mesh.outer_faces()
    return faces[mesh.nodes[faces][:, :, 0].max(axis=1) > 1e-7]


def _place(points, body, cells, curve):
    """Row and column of the cell at points (n, 3) [m]; -1 beside the cells."""
    section, x = points[:, 1:], points[:, 0]
    if body.axle_z is not None:
        down = body.axle_z - points[:, 2]
        section = np.column_stack([points[:, 1], body.axle_z - np.hypot(x, down)])
        x = np.arctan2(x, down) * swept_radius(body)
    places = _equally_spaced(curve, cells.columns * SAMPLES + 1)
    row = np.floor(x / cells.dx).astype(int)
    row[(row < 0) | (row >= cells.rows)] = -1
    column = np.full(len(points), -1)
    for k in np.flatnonzero(row >= 0):
        distances = np.hypot(*(places - section[k]).T)
        nearest = distances.argmin()
        if distances[nearest] < SURFACE_DISTANCE * min(cells.dx, cells.dy) and 0 < nearest < len(places) - 1:
            column[k] = nearest // SAMPLES
    return row, column


def swept_radius(body):
    """Radius at which the sweep about the axle has the length of the cells [m]."""
    return body.axle_z - np.mean([body.curves[k][:, 1].mean() for k in body.patches])


def _equally_spaced(curve, count):
    arc = np.append(0, np.cumsum(np.hypot(*np.diff(curve, axis=0).T)))
    at = np.linspace(0, arc[-1], count)
    return np.column_stack([np.interp(at, arc, curve[:, i]) for i in (0, 1)])


def _load(mesh, faces, direction):
    """Consistent forces of a uniform pressure on 6-node triangles: a third on each middle node, none on the corners."""
    corners = mesh.nodes[faces[:, :3]]
    areas = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    nodes, index = np.unique(faces[:, 3:], return_inverse=True)
    weights = np.zeros(len(nodes))
    np.add.at(weights, index.ravel(), np.repeat(areas / 3, 3))
    return CellLoad(nodes, weights / weights.sum(), direction)
