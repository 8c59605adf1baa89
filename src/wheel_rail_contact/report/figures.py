# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the report."""
import numpy as np

from ..command import pyplot
from ..message_constants import SIDES, USABLE
from .results import RAIL_FIELDS, per_result

COLOURS = ("tab:blue", "tab:orange")
MAX_OUTLINES = 8   # largest number of places at which a rail that changes is drawn
MAX_POINTS = 4000  # largest number of points drawn of a history; longer ones are thinned
SMALLEST = 1e-12  # estimated errors below it are drawn as this value [-]


def save(figure, path):
    figure.savefig(path, dpi=110)
    pyplot().close(figure)
    return path


def thinned(x, y):
    """A history with at most MAX_POINTS points: the lowest and the highest one of each piece."""
    if len(x) <= MAX_POINTS:
        return x, y
    pieces = np.array_split(np.arange(len(x)), MAX_POINTS // 2)
    chosen = set()
    for piece in pieces:
        known = piece[np.isfinite(y[piece])]
        chosen.update({known[np.argmin(y[known])], known[np.argmax(y[known])]} if len(known) else {piece[0]})
    chosen = sorted(chosen)
    return x[chosen], y[chosen]


def _rows(results):
    """Rows of the histories: label of the axis, and values, name and colour of each line."""
    patches = results.patches
    side = [np.flatnonzero(patches["side"] == s) for s in (0, 1)]

    def by_side(values, scale=1.0):
        return [(scale * values[s], SIDES[s], COLOURS[s]) for s in (0, 1)]

    def rail(name, scale):
        column = RAIL_FIELDS.index(name)
        return by_side([results.rail[:, s, column] for s in (0, 1)], scale)

    def highest(name, scale, reduce="max"):
        return by_side([per_result(patches[name], results, side[s], reduce) for s in (0, 1)], scale)

    return [("y [mm]", [(1e3 * results.y, None, "k")]), ("yaw [mrad]", [(1e3 * results.yaw, None, "k")]),
            ("Q [kN]", rail("vertical_force", 1e-3)), ("Y [kN], outward", rail("lateral_force", 1e-3)),
            ("rail lateral [mm],\noutward", rail("lateral", 1e3)), ("rail roll [mrad],\noutward", rail("roll", 1e3)),
            ("highest pressure\n[MPa]", highest("max_pressure", 1e-6)),
            ("contact area\n[mm²]", highest("area", 1e6, "sum")),
            ("largest contact\nangle [°]", highest("contact_angle", 180 / np.pi))]


def limit_zoom(axis):
    """Gives the axis a minimum range: the rounding errors of a constant would otherwise fill its height."""
    low, high = axis.get_ylim()
    least = max(0.02 * max(abs(low), abs(high)), 1e-3)
    if high - low < least:
        axis.set_ylim((low + high) / 2 - least, (low + high) / 2 + least)
    axis.ticklabel_format(axis="y", useOffset=False)


def histories(results, other, path):
    """Histories over time. The other run, if given, is drawn dashed."""
    rows = _rows(results)
    others = _rows(other) if other else [(None, [])] * len(rows)
    figure, axes = pyplot().subplots(len(rows), 1, sharex=True, figsize=(10, 1.55 * len(rows)), constrained_layout=True)
    for axis, (label, lines), (_, other_lines) in zip(axes, rows, others):
        for values, name, colour in lines:
            axis.plot(*thinned(results.stamp, values), color=colour, label=name, linewidth=1.1)
        for values, name, colour in other_lines:
            axis.plot(*thinned(other.stamp, values), "--", color=colour, linewidth=0.9,
                      label=f"{name}, other run" if name else "other run")
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
        limit_zoom(axis)
    refused = ~np.isin(results.status, USABLE)
    axes[0].plot(results.stamp[refused], 1e3 * results.y[refused], ".", color="tab:red", label="refusal")
    if refused.any():
        axes[0].legend(loc="upper right", fontsize="small")
    axes[2].legend(loc="upper right", fontsize="small", ncol=2)
    axes[-1].set_xlabel("time [s]")
    axes[-1].set_xlim(results.stamp[0], results.stamp[-1])
    return save(figure, path)


def contact_points(results, side):
    """Positions of the patches of a side on the undeflected rail and on the wheel.

    @return two arrays (n, 2) of y, z [m] y outward
    """
    patches = results.patches
    chosen = patches["side"] == side
    index, sign = patches["result"][chosen], (1, -1)[side]
    y, z = patches["y"][chosen], patches["z"][chosen]
    lateral, vertical, tilt = (np.nan_to_num(results.rail[index, side, column]) for column in (0, 1, 2))
    on_rail = np.column_stack([sign * y - lateral, z - vertical])
    if "reference" in results.outlines[side]:  # centre of rotation of the rail roll
        reference = results.outlines[side]["reference"][0]
        dy, dz = (on_rail - reference).T
        on_rail = reference + np.column_stack([np.cos(tilt) * dy - np.sin(tilt) * dz,
                                               np.cos(tilt) * dz + np.sin(tilt) * dy])
    # To the axes of the wheelset. Yaw is neglected: it moves the contact along the track, not across it.
    dy, dz, roll = y - results.y[index], z - results.z[index], results.roll[index]
    on_wheel = np.column_stack([sign * (np.cos(roll) * dy + np.sin(roll) * dz), np.cos(roll) * dz - np.sin(roll) * dy])
    return on_rail, on_wheel


def _drawn_outlines(results, side, kind):
    """Outlines of a wheel or rail; of a rail that changes, some along the way of the wheelset."""
    if kind == "rail" and results.sections[side]:
        places = np.array([x for x, _ in results.sections[side]])
        way = np.linspace(results.distance.min(), results.distance.max(), MAX_OUTLINES)
        drawn = {places[np.argmin(np.abs(places - x))] for x in way}
        return [outline for x, outline in results.sections[side] if x in drawn]
    return [results.outlines[side][kind]] if kind in results.outlines[side] else []


def bands(results, path):
    """Contact positions on both profiles, coloured by the highest pressure."""
    figure, axes = pyplot().subplots(2, 2, figsize=(11, 6.2), constrained_layout=True)
    pressure = 1e-6 * results.patches["max_pressure"]
    scale = pyplot().Normalize(0, pressure.max())
    for side in (0, 1):
        chosen = results.patches["side"] == side
        for row, (kind, points) in enumerate(zip(("wheel", "rail"), contact_points(results, side)[::-1])):
            axis, sign = axes[row][side], (1, -1)[side]
            outlines = _drawn_outlines(results, side, kind)
            for outline in outlines:
                axis.plot(sign * 1e3 * outline[:, 0], 1e3 * outline[:, 1], color="0.4", linewidth=1.5 if len(outlines) == 1 else 0.7)
            colours = axis.scatter(sign * 1e3 * points[:, 0], 1e3 * points[:, 1], c=pressure[chosen], s=14, norm=scale,
                                   cmap="viridis", zorder=3)
            axis.set(title=f"{SIDES[side]} {kind}", aspect="equal", xlabel="y [mm]", ylabel="z [mm]")
            axis.grid(alpha=0.3)
    # The left side is at positive y. With this direction of the axis it is drawn on the left, as seen in travel direction.
    for axis in axes.flat:
        axis.invert_xaxis()
    figure.colorbar(colours, ax=axes, label="highest pressure [MPa]", shrink=0.8)
    return save(figure, path)


def pressure_maps(message, title, path):
    """Pressure of every patch of one result."""
    patches = [p for p in message.patches if p.grid.nx]
    columns = min(4, len(patches))
    rows = -(-len(patches) // columns)
    figure, axes = pyplot().subplots(rows, columns, figsize=(3.6 * columns, 3.6 * rows), squeeze=False,
                                 constrained_layout=True)
    for axis in axes.flat[len(patches):]:
        axis.remove()
    for axis, patch in zip(axes.flat, patches):
        grid = patch.grid
        pressure = np.asarray(grid.pressure, float).reshape(grid.ny, grid.nx)
        x = 1e3 * (grid.x0 + grid.dx * (np.arange(grid.nx + 1) - 0.5))
        y = 1e3 * (grid.y0 + grid.dy * (np.arange(grid.ny + 1) - 0.5))
        colours = axis.pcolormesh(y, x, 1e-6 * np.where(pressure > 0, pressure, np.nan).T, cmap="viridis", vmin=0)
        axis.set(aspect="equal", xlabel="y [mm]", ylabel="x [mm]")
        axis.invert_xaxis()
        axis.set_title(f"{SIDES[patch.side]}, {1e-3 * patch.normal_force:.1f} kN, {1e6 * patch.area:.0f} mm²,\n"
                       f"{np.degrees(patch.contact_angle):.1f}°, {patch.method}", fontsize="small")
        figure.colorbar(colours, ax=axis, label="MPa", shrink=0.8)
    figure.suptitle(title)
    return save(figure, path)


def quality(results, path):
    """Histogram of the estimated errors of the patches, by method."""
    figure, axis = pyplot().subplots(figsize=(7, 3), constrained_layout=True)
    errors = np.maximum(results.patches["error_estimate"], SMALLEST)
    edges = np.geomspace(errors.min() / 1.1, errors.max() * 1.1, 40)
    for method in sorted(set(results.patches["method"])):
        axis.hist(errors[results.patches["method"] == method], bins=edges, alpha=0.6, label=method)
    axis.set(xscale="log", xlabel="estimated relative error of a patch", ylabel="patches")
    axis.legend(fontsize="small")
    return save(figure, path)
