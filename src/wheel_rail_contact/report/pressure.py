# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the pressures of one result, with one scale of lengths and one of colours for all its patches."""
import numpy as np

from ..command import pyplot
from ..message_constants import SIDES
from .drawing import save

WIDTH = 8.0          # [inch] largest width of a patch
TEXT = 7.2           # [inch] width of the text above a patch
HEIGHT = 9.0         # [inch] largest height of all patches together
LARGEST = 0.3        # [inch/mm] largest scale of lengths
LEFT, RIGHT = 0.75, 1.25      # [inch] margins beside the patches: labels, colour scale
TOP, BOTTOM, ABOVE = 0.3, 0.55, 0.5  # [inch] title, labels, text above each patch
MARGIN = 0.08        # space around the loaded cells, as a share of their extent
LEAST_ACROSS = 3.0   # [mm] smallest extent of a picture across the rail
TICK = 0.22          # [inch] smallest distance of the ticks across the rail


class _Map:
    """Cells of a patch, in mm and MPa.

    x, y are the edges of the cells, (nx + 1,) and (ny + 1,); pressure is (ny, nx), NaN where there is none.
    """

    def __init__(self, patch):
        grid, self.patch = patch.grid, patch
        pressure = 1e-6 * np.asarray(grid.pressure, float).reshape(grid.ny, grid.nx)
        self.pressure = np.where(pressure > 0, pressure, np.nan)
        self.x = 1e3 * (grid.x0 + grid.dx * (np.arange(grid.nx + 1) - 0.5))
        self.y = 1e3 * (grid.y0 + grid.dy * (np.arange(grid.ny + 1) - 0.5))

    def along(self):
        """Range of x of the loaded cells and the ellipse [mm]."""
        return _range(self.x, np.isfinite(self.pressure).any(axis=0), 1e3 * self.patch.semi_axis_along)

    def across(self):
        """Drawn range of y [mm]."""
        low, high = _range(self.y, np.isfinite(self.pressure).any(axis=1), 1e3 * self.patch.semi_axis_across)
        margin = max(MARGIN * (high - low), (LEAST_ACROSS - (high - low)) / 2)
        return low - margin, high + margin


def _range(edges, loaded, semi_axis):
    """Range of the loaded cells and of the ellipse about 0."""
    index = np.flatnonzero(loaded)
    low, high = (edges[index[0]], edges[index[-1] + 1]) if len(index) else (edges[0], edges[-1])
    return min(low, -semi_axis), max(high, semi_axis)


def _ellipse(axis, patch):
    """The ellipse with the area of the patch and the semi-axes of the result."""
    angle = np.linspace(0, 2 * np.pi, 100)
    axis.plot(1e3 * patch.semi_axis_along * np.cos(angle), 1e3 * patch.semi_axis_across * np.sin(angle), color="0.35",
              linewidth=0.9, linestyle="--")


def _text(patch):
    grid = patch.grid
    return (f"{SIDES[patch.side]} wheel: {1e-6 * patch.max_pressure:.0f} MPa, N = {1e-3 * patch.normal_force:.1f} kN "
            f"(Q = {1e-3 * patch.vertical_force:.1f} kN, Y = {1e-3 * patch.lateral_force:.1f} kN outward), "
            f"contact angle {np.degrees(patch.contact_angle):.1f}°, {1e6 * patch.area:.1f} mm²\n"
            f"semi-axes {1e3 * patch.semi_axis_along:.2f} mm along, {1e3 * patch.semi_axis_across:.2f} mm across; "
            f"rolling radius {1e3 * patch.rolling_radius:.2f} mm; cells of {1e3 * grid.dx:.2f} mm × {1e3 * grid.dy:.3f} mm, "
            f"{patch.method}")


def _draw(axis, shown, scale, limits):
    colours = axis.pcolormesh(shown.x, shown.y, shown.pressure, cmap="viridis", norm=scale)
    _ellipse(axis, shown.patch)
    low, high = shown.across()
    axis.set(xlim=limits, ylim=(low, high), ylabel="y [mm]", axisbelow=True)
    height = axis.get_position().height * axis.figure.get_figheight()
    axis.yaxis.set_major_locator(pyplot().MaxNLocator(nbins=max(1, int(height / TICK)), steps=[1, 2, 5, 10]))
    axis.set_title(_text(shown.patch), fontsize=8, loc="left")
    axis.grid(alpha=0.3)
    return colours


def _layout(maps):
    """Scale [inch/mm], range of x [mm] and heights of the patches [inch]."""
    along = np.array([shown.along() for shown in maps])
    low, high = along[:, 0].min(), along[:, 1].max()
    margin = MARGIN * (high - low)
    across = np.array([np.ptp(shown.across()) for shown in maps])
    scale = min(LARGEST, WIDTH / (high - low + 2 * margin), HEIGHT / across.sum())
    return scale, (low - margin, high + margin), scale * across


def figure(message, title, path):
    """Pressure of every patch of one result, seen along its normal, with the direction of travel to the right. Returns the
    path. The message has at least one patch with a grid."""
    plot = pyplot()
    maps = [_Map(patch) for patch in message.patches if patch.grid.nx]
    scale, limits, heights = _layout(maps)
    patch_width = scale * np.ptp(limits)
    width = LEFT + max(TEXT, patch_width) + RIGHT
    height = TOP + BOTTOM + heights.sum() + ABOVE * len(maps)
    picture = plot.figure(figsize=(width, height))
    pressure = plot.Normalize(0, max(np.nanmax(shown.pressure) for shown in maps))
    top = height - TOP
    for shown, own in zip(maps, heights):
        top -= ABOVE + own
        axis = picture.add_axes([LEFT / width, top / height, patch_width / width, own / height])
        colours = _draw(axis, shown, pressure, limits)
        axis.tick_params(labelbottom=shown is maps[-1])
    axis.set_xlabel("x [mm], forward")
    bar = picture.add_axes([(LEFT + patch_width + 0.25) / width, top / height, 0.2 / width,
                            (height - TOP - ABOVE - top) / height])
    picture.colorbar(colours, cax=bar, label="pressure [MPa]")
    picture.text(LEFT / width, 1 - 0.25 / height, title, fontsize="large")
    return save(picture, path)
