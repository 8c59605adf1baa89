# SPDX-License-Identifier: BSD-3-Clause
"""Rigid motion of the rail head in one section: least-squares fit to the displacements, weighted by area."""
import numpy as np

from .surface import FacePoints

DIVISIONS = 6  # integration points per direction of a face


class Head:
    """The head in the plane x = `station` [m]: the part of the section above the height `bottom` [m]."""

    def __init__(self, mesh, station, bottom, reference_height):
        faces = mesh.plane_faces(0, station)
        touched = mesh.nodes[faces][:, :, 2].max(axis=1) > bottom
        self._points = FacePoints(mesh.nodes, faces[touched], DIVISIONS)
        position = self._points.position
        self._weight = np.sqrt(np.where(position[..., 2] >= bottom, self._points.area, 0.0)).ravel()
        y, z = position[..., 1].ravel(), position[..., 2].ravel() - reference_height
        # rows: u_y = lateral + roll z, then u_z = vertical - roll y
        zero, one = np.zeros_like(y), np.ones_like(y)
        matrix = np.vstack([np.column_stack([one, zero, z]), np.column_stack([zero, one, -y])])
        self._inverse = np.linalg.pinv(matrix * np.tile(self._weight, 2)[:, None])

    @property
    def nodes(self):
        """Nodes whose displacements the fit requires."""
        return np.unique(self._points.faces)

    def motion(self, displacements):
        """Lateral [m], vertical [m] and roll [rad] motion of the reference point.

        @param displacements of all nodes (n, 3) [m]
        """
        values = self._points.values(displacements)
        right = np.concatenate([values[..., 1].ravel() * self._weight, values[..., 2].ravel() * self._weight])
        return self._inverse @ right
