# SPDX-License-Identifier: BSD-3-Clause
"""Pressures of patches as arrays and pictures: of results of Python, and of messages."""
import numpy as np

from ..message_constants import SIDES

MM, MPA, KN = 1e3, 1e-6, 1e-3


def to_array(grid):
    """Pressure of a message PressureGrid as an array (nx, ny) [Pa]. Cell (i, j) is at (x0 + i dx, y0 + j dy).

    Raises ValueError if the grid is empty (contact_replay --no-grids) or has another number of values than nx ny.
    """
    if not grid.nx or len(grid.pressure) != grid.nx * grid.ny:
        raise ValueError(f"grid: has {len(grid.pressure)} values, but must have nx ny = {grid.nx * grid.ny}, above 0")
    return np.array(grid.pressure, dtype=float).reshape(grid.ny, grid.nx).T


def plot_pressure(patch, ax=None, max_pressure=None, colorbar=True):
    """Draws the pressure of a patch, seen from above, in true proportions.

    patch: PatchResult, or message ContactPatch
    ax: axes of matplotlib; default: those of a new figure
    max_pressure: pressure at the upper end of the colours [Pa]; default: the highest one of the cells
    colorbar: False omits the colour bar

    x (forward) points right, y (left, along the section of the rail) up; both from the centre of pressure, in mm.

    Returns the axes. Raises ValueError for a message without its grid, or max_pressure below or equal to 0.
    """
    if max_pressure is not None and not max_pressure > 0:
        raise ValueError(f"max_pressure = {max_pressure}: must be above 0")
    pressure, x, y = _cells(patch)
    if ax is None:
        from matplotlib import pyplot
        ax = pyplot.subplots()[1]
    highest = MPA * (pressure.max() if max_pressure is None else max_pressure)
    shown = np.ma.masked_less_equal(MPA * pressure, 0)
    mesh = ax.pcolormesh(MM * x, MM * y, shown.T, vmin=0, vmax=highest, cmap="viridis")
    ax.set_aspect("equal")
    ax.set(xlabel="x, forward [mm]", ylabel="y, left [mm]", title=_label(patch))
    if colorbar:
        clipped = "max" if MPA * pressure.max() > highest else "neither"
        ax.figure.colorbar(mesh, ax=ax, label="pressure [MPa]", extend=clipped)
    return ax


def grid_of(patch):
    """Pressure (nx, ny) [Pa] of a patch, centre (x0, y0) of its first cell, and length and width (dx, dy) of the cells [m].

    patch: PatchResult, or message ContactPatch

    Raises ValueError for a message without its grid.
    """
    if hasattr(patch, "grid"):
        grid = patch.grid
        return to_array(grid), (grid.x0, grid.y0), (grid.dx, grid.dy)
    return patch.pressure, (patch.x[0], patch.y[0]), (patch.dx, patch.dy)


def side_of(patch):
    """Side of a patch: "left" or "right"."""
    return patch.side if isinstance(patch.side, str) else SIDES[patch.side]


def _cells(patch):
    """Pressure (nx, ny) [Pa], and the boundaries of the cells along x and y [m]."""
    pressure, first, size = grid_of(patch)
    x, y = (start + width * (np.arange(count + 1) - 0.5) for start, width, count in zip(first, size, pressure.shape))
    return pressure, x, y


def _label(patch):
    return f"{side_of(patch)}: {MPA * patch.max_pressure:.0f} MPa, {KN * patch.normal_force:.1f} kN"
