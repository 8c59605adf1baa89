# SPDX-License-Identifier: BSD-3-Clause
"""Unit loads on small patches of the head at the loaded section, as consistent nodal forces of the half model."""
from dataclasses import dataclass

import numpy as np

from ..command import Failure
from .mesh import PLANE_TOLERANCE
from .surface import FacePoints

PATCH = 0.010            # side of the loaded square, along the rail and along the outline [m]
REFERENCE_DEPTH = 0.014  # depth of the reference point below the crown, on the rail axis [m]
DIVISIONS = 40           # integration points per direction of a face; many, because the edge of the patch cuts through faces


@dataclass
class LoadCase:
    """Nodal forces (nodes, 3) [N] on the half model; lateral, vertical [N] and moment [N m] on the whole rail."""
    name: str
    forces: np.ndarray
    lateral: float   # Y, outward positive
    vertical: float  # Q, down positive
    moment: float    # of both about the reference point of the head, outward roll positive


class HeadSurface:
    """Outer surface of the rail near the loaded section, for patch loads."""

    def __init__(self, mesh, section):
        faces = mesh.outer_faces()
        x = mesh.nodes[faces][:, :, 0]
        faces = faces[(np.ptp(x, axis=1) > PLANE_TOLERANCE) & (x.min(axis=1) < 0.5 * PATCH)]
        arc = section.project(mesh.nodes[faces][:, :, 1:].reshape(-1, 2)).reshape(faces.shape)
        whole = np.ptp(arc, axis=1) < 0.5 * section.perimeter  # excludes faces across the first point of the outline
        self._points = FacePoints(mesh.nodes, faces[whole], DIVISIONS)
        self._arc = arc[whole] @ self._points.shape.T
        self._nodes = mesh.nodes
        self._section = section

    def lateral(self, arc, name):
        """1 N outward on the patch centred at the arc length `arc` [m] of the outline."""
        return self._case(arc, name, np.array([0.0, 1.0, 0.0]))

    def vertical(self, arc, name):
        """1 N down on the patch centred at the arc length `arc` [m] of the outline."""
        return self._case(arc, name, np.array([0.0, 0.0, -1.0]))

    def _case(self, arc, name, direction):
        inside = (np.abs(self._arc - arc) <= 0.5 * PATCH) & (self._points.position[..., 0] <= 0.5 * PATCH)
        if not inside.any():
            raise Failure(f"load {name}: the mesh has no surface at this position")
        share = self._points.nodal(inside.astype(float), len(self._nodes))
        forces = np.outer(0.5 * share / share.sum(), direction)
        y, z = self._nodes[:, 1], self._nodes[:, 2] - (self._section.height - REFERENCE_DEPTH)
        moment = 2 * np.sum(forces[:, 1] * z - forces[:, 2] * y)
        return LoadCase(name, forces, direction[1], -direction[2], float(moment))
