# SPDX-License-Identifier: BSD-3-Clause
"""Integrals over quadratic element faces: 8-node quadrilaterals and 6-node triangles, corners first."""
import numpy as np


def shape_functions(node_count, r, s):
    """Shape functions of a face at the coordinates (r, s): (points, nodes). Quadrilateral: -1..1; triangle: 0..1."""
    if node_count == 6:
        t = 1 - r - s
        return np.stack([t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * r * t, 4 * r * s, 4 * s * t], axis=-1)
    corners = [0.25 * (1 + r * a) * (1 + s * b) * (r * a + s * b - 1) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    middles = [0.5 * (1 - r * r) * (1 - s), 0.5 * (1 + r) * (1 - s * s), 0.5 * (1 - r * r) * (1 + s),
               0.5 * (1 - r) * (1 - s * s)]
    return np.stack(corners + middles, axis=-1)


def shape_slopes(node_count, r, s):
    """Derivatives of the shape functions with respect to r and s: two arrays (points, nodes)."""
    step = 1e-6  # central differences, exact up to rounding: the polynomials are at most cubic in r or s
    return [(shape_functions(node_count, r + dr, s + ds) - shape_functions(node_count, r - dr, s - ds)) / (2 * step)
            for dr, ds in ((step, 0), (0, step))]


def rule(node_count, divisions):
    """Integration points r, s and weights: the midpoints of `divisions`^2 equal parts of the face."""
    middle = (np.arange(divisions) + 0.5) / divisions
    u, v = (grid.ravel() for grid in np.meshgrid(middle, middle))
    if node_count == 8:
        return 2 * u - 1, 2 * v - 1, np.full(u.size, 4 / divisions**2)
    # square mapped to the triangle: (u, v) -> (u, v (1 - u)), area element (1 - u)
    return u, v * (1 - u), (1 - u) / divisions**2


class FacePoints:
    """Integration points of faces: shape functions (p, n), positions (f, p, 3) [m] and areas (f, p) [m^2]."""

    def __init__(self, nodes, faces, divisions):
        count = faces.shape[1]
        r, s, weight = rule(count, divisions)
        corners = nodes[faces]
        self.faces = faces
        self.shape = shape_functions(count, r, s)
        self.position = np.einsum("pn,fnk->fpk", self.shape, corners)
        along = [np.einsum("pn,fnk->fpk", slope, corners) for slope in shape_slopes(count, r, s)]
        self.area = np.linalg.norm(np.cross(*along), axis=2) * weight

    def nodal(self, density, node_count):
        """Consistent nodal values (node_count,) of a density per area (f, p)."""
        result = np.zeros(node_count)
        np.add.at(result, self.faces, np.einsum("fp,pn->fn", density * self.area, self.shape))
        return result

    def values(self, nodal):
        """Values (f, p, k) of a nodal field (nodes, k) at the points."""
        return np.einsum("pn,fnk->fpk", self.shape, nodal[self.faces])
