# SPDX-License-Identifier: BSD-3-Clause
"""Influence of the pressure on cells by half-spaces, for the same cells as the finite elements."""
import numpy as np

PARTS = 4  # of a cell in each direction, at whose middles its mean displacement is taken


def influence(cells, modulus, turned):
    """Mean closing displacement of both surfaces on each cell per pressure on each pair of cells, (n, n) [m/Pa].

    Love 1929 (Johnson 1985, eq. 3.25), with distances along the arc of the rail; between contacts the displacement of point
    forces (eq. 3.22b) with distances in the plane x = 0. A cell acts together with its image at -x. Rows run fastest.

    @param cells    list of Cells
    @param modulus  contact modulus [Pa]
    @param turned   whether displacements are projected onto the normals of the columns
    """
    blocks = [[_within(one, modulus) if one is other else _between(one, other, modulus) for other in cells]
              for one in cells]
    matrix = np.block(blocks)
    if turned:
        angle = np.concatenate([np.repeat(one.angle, one.rows) for one in cells])
        matrix *= np.cos(angle[:, None] - angle)
    return matrix


def _within(cells, modulus):
    rows, columns = cells.rows, cells.columns
    shifts = ((np.arange(PARTS) + 0.5) / PARTS - 0.5)
    y = np.arange(columns)
    table = np.zeros((2 * rows, columns))  # by the distance in cells: 1 - rows - ... is symmetric
    for shift_x in shifts:
        for shift_y in shifts:
            table += love((np.arange(2 * rows)[:, None] + shift_x) * cells.dx, (y + shift_y) * cells.dy, cells.dx, cells.dy)
    table /= PARTS**2 * np.pi * modulus
    row, column = np.arange(rows), np.arange(columns)
    apart = np.abs(column[:, None] - column)
    near, image = np.abs(row[:, None] - row), row[:, None] + row + 1
    both = table[near[:, :, None, None], apart] + table[image[:, :, None, None], apart]
    return both.transpose(2, 0, 3, 1).reshape(rows * columns, rows * columns)


def love(x, y, dx, dy):
    """Integral of 1/distance over a cell of dx times dy [m], seen from a point at x, y from its middle (Love 1929)."""
    def corner(a, b):
        return a * np.arcsinh(b / np.abs(a)) + b * np.arcsinh(a / np.abs(b))
    right, left, top, bottom = x + dx / 2, x - dx / 2, y + dy / 2, y - dy / 2
    return corner(right, top) - corner(left, top) - corner(right, bottom) + corner(left, bottom)


def _between(one, other, modulus):
    def points(cells):
        return np.tile(cells.x, cells.columns), np.repeat(cells.place, cells.rows, axis=0)
    (x, section), (other_x, other_section) = points(one), points(other)
    across = np.sum((section[:, None] - other_section)**2, axis=2)
    inverse = sum(1 / np.sqrt((x[:, None] + sign * other_x)**2 + across) for sign in (-1, 1))
    return other.dx * other.dy * inverse / (np.pi * modulus)
