# SPDX-License-Identifier: BSD-3-Clause
"""Mesh of half a rail (x >= 0, the other half is symmetric) with quadratic elements."""
from dataclasses import dataclass

import numpy as np

# Faces of the elements in the node order of CalculiX: corners, then the midpoints between them.
FACES = {
    "C3D10": np.array([[0, 2, 1, 6, 5, 4], [0, 1, 3, 4, 8, 7], [1, 2, 3, 5, 9, 8], [2, 0, 3, 6, 7, 9]]),
    "C3D20": np.array([[0, 3, 2, 1, 11, 10, 9, 8], [4, 5, 6, 7, 12, 13, 14, 15], [0, 1, 5, 4, 8, 17, 12, 16],
                       [1, 2, 6, 5, 9, 18, 13, 17], [2, 3, 7, 6, 10, 19, 14, 18], [3, 0, 4, 7, 11, 16, 15, 19]]),
}
PLANE_TOLERANCE = 1e-7  # [m]


@dataclass
class Mesh:
    """Nodes (n, 3) [m] and elements (m, 10 or 20), node indices from 0 in the order of CalculiX."""
    element_type: str
    nodes: np.ndarray
    elements: np.ndarray

    def faces(self):
        """All element faces, (k, 6 or 8) node indices; a face inside the rail appears twice."""
        table = FACES[self.element_type]
        return self.elements[:, table].reshape(-1, table.shape[1])

    def outer_faces(self):
        """Faces that belong to only one element."""
        faces = self.faces()
        corners = 3 if self.element_type == "C3D10" else 4
        _, first, count = np.unique(np.sort(faces[:, :corners], axis=1), axis=0, return_index=True, return_counts=True)
        return faces[first[count == 1]]

    def plane_faces(self, axis, value):
        """Faces in the plane coordinate[axis] = value [m], each one once."""
        faces = self.faces()
        inside = (np.abs(self.nodes[faces][:, :, axis] - value) < PLANE_TOLERANCE).all(axis=1)
        faces = faces[inside]
        _, first = np.unique(np.sort(faces, axis=1), axis=0, return_index=True)
        return faces[first]

    def plane_nodes(self, axis, value):
        """Indices of the nodes in the plane coordinate[axis] = value [m]."""
        return np.flatnonzero(np.abs(self.nodes[:, axis] - value) < PLANE_TOLERANCE)
