# SPDX-License-Identifier: BSD-3-Clause
"""Difference of the compliance of real bodies and of half-spaces, as a smooth function of the places of force and cell.

Under a force, the displacements of elements are inaccurate only in the cells around it. There they follow from the
difference farther away: the singular part of the displacement is that of a half-space.
"""
import numpy as np

DEGREE = 4     # of the polynomials in x and in the arc across the track
NEAR = 3.5     # distance in cells below which the elements are not used [-]


class Correction:
    """Displacements [m/N] of cells by unit forces on pairs of cells, beyond those of half-spaces.

    cells      list of Cells with compliances by finite elements
    difference (n, n) [m/N] for all cells, contact after contact, rows fastest
    """

    def __init__(self, cells, difference):
        self._frames = [_Frame(one) for one in cells]
        ends = np.cumsum([0] + [one.rows * one.columns for one in cells])
        self._coefficients, residuals = {}, []
        for k, own in enumerate(self._frames):
            for m in range(k, len(self._frames)):
                other = self._frames[m]
                block = difference[ends[k]:ends[k + 1], ends[m]:ends[m + 1]]
                terms = _terms(own, cells[k], other, cells[m], k == m)
                used = _far(cells[k]) if k == m else np.ones(block.shape, bool)
                found = np.linalg.lstsq(terms[used], block[used], rcond=None)[0]
                self._coefficients[k, m] = found
                residuals.append(block[used] - terms[used] @ found)
        self.residual = float(np.concatenate(residuals).std())
        self.largest = float(np.abs(difference).max())

    def on(self, cells):
        """The correction (n, n) [m/N] for other cells on the same contacts."""
        count = len(cells)
        blocks = [[None] * count for _ in cells]
        for (k, m), coefficients in self._coefficients.items():
            terms = _terms(self._frames[k], cells[k], self._frames[m], cells[m], k == m)
            blocks[k][m] = terms @ coefficients
            blocks[m][k] = blocks[k][m].T
        return np.block(blocks)

    def singular(self):
        """Coefficients of both singular terms for each contact [m/N]: of the direction, and of the logarithm."""
        return [self._coefficients[k, k][-2:] for k in range(len(self._frames))]


class _Frame:
    """Half-length and half-width of the cells of a contact [m]."""

    def __init__(self, cells):
        self.length = cells.rows * cells.dx
        self.width = 0.5 * cells.columns * cells.dy
    def powers(self, cells):
        """Products of powers, even in x: (k, n)."""
        x, arc = _places(cells)
        return np.array([(x / self.length)**a * (arc / self.width)**b
                         for a in range(0, DEGREE + 1, 2) for b in range(DEGREE + 1 - a)])


def _places(cells):
    """x and arc of each cell [m], rows fastest; from the plane of symmetry and from the middle."""
    return np.tile(cells.x, cells.columns), np.repeat(cells.arc, cells.rows)


def _terms(own, own_cells, other, other_cells, same):
    """Values of all terms (n, m, k): products of powers; within a contact also what a curvature adds at its first order,
    which depends on the direction of the distance and on its logarithm."""
    first, second = own.powers(own_cells), other.powers(other_cells)
    if not same:
        return np.einsum("kn,lm->nmkl", first, second).reshape(first.shape[1], second.shape[1], -1)
    pairs = [(k, m) for k in range(len(first)) for m in range(k + 1)]
    terms = [first[k][:, None] * second[m] + first[m][:, None] * second[k] for k, m in pairs]
    x, arc = _places(own_cells)
    across = (arc[:, None] - arc)**2
    direction, logarithm = 0.0, 0.0
    for along in ((x[:, None] - x)**2, (x[:, None] + x)**2):
        square = along + across
        own_cell = 0.08 * own_cells.dx * own_cells.dy  # square of a mean distance within a cell
        direction = direction + (along - across) / np.maximum(square, own_cell)
        logarithm = logarithm + 0.5 * np.log(np.maximum(square, own_cell) / own.length**2)
    return np.stack(terms + [direction, logarithm], axis=-1)


def _far(cells):
    """Pairs of cells (n, n) that are so far from one another, and from the other's image, that elements are accurate."""
    row = np.tile(np.arange(cells.rows), cells.columns)
    column = np.repeat(np.arange(cells.columns), cells.rows)
    across = np.abs(column[:, None] - column)
    near = np.minimum(np.abs(row[:, None] - row), row[:, None] + row + 1)
    return (across > NEAR) | (near > NEAR)
