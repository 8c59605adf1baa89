# SPDX-License-Identifier: BSD-3-Clause
"""The report's pictures."""
import numpy as np

from ..command import pyplot
from ..message_constants import SIDES, USABLE
from .answers import RAIL_FIELDS, of_answers

COLOURS = ("tab:blue", "tab:orange")
MOST_POINTS = 4000  # of a history that are drawn; of more, the extremes of each piece
SMALLEST = 1e-12  # estimated error that is drawn


def _save(figure, path):
    figure.savefig(path, dpi=110)
    pyplot().close(figure)
    return path


def _thinned(x, y):
    """A history with as many points as a picture can show: lowest and highest of each piece."""
    if len(x) <= MOST_POINTS:
        return x, y
    pieces = np.array_split(np.arange(len(x)), MOST_POINTS // 2)
    chosen = set()
    for piece in pieces:
        known = piece[np.isfinite(y[piece])]
        chosen.update({known[np.argmin(y[known])], known[np.argmax(y[known])]} if len(known) else {piece[0]})
    chosen = sorted(chosen)
    return x[chosen], y[chosen]


def _rows(answers):
    """Of the histories: label, and for each line its values, name and colour."""
    patches = answers.patches
    side = [np.flatnonzero(patches["side"] == s) for s in (0, 1)]

    def by_side(values, scale=1.0):
        return [(scale * values[s], SIDES[s], COLOURS[s]) for s in (0, 1)]

    def rail(name, scale):
        column = RAIL_FIELDS.index(name)
        return by_side([answers.rail[:, s, column] for s in (0, 1)], scale)

    def highest(name, scale, reduce="max"):
        return by_side([of_answers(patches[name], answers, side[s], reduce) for s in (0, 1)], scale)

    return [("y [mm]", [(1e3 * answers.y, None, "k")]), ("yaw [mrad]", [(1e3 * answers.yaw, None, "k")]),
            ("Q [kN]", rail("vertical_force", 1e-3)), ("Y [kN], outward", rail("lateral_force", 1e-3)),
            ("rail lateral [mm],\noutward", rail("lateral", 1e3)), ("rail roll [mrad],\noutward", rail("roll", 1e3)),
            ("highest pressure\n[MPa]", highest("max_pressure", 1e-6)),
            ("contact area\n[mm²]", highest("area", 1e6, "sum")),
            ("steepest contact\n[°]", highest("contact_angle", 180 / np.pi))]


def _show_constant_as_constant(axis):
    """Rounding errors are not drawn over the whole height."""
    low, high = axis.get_ylim()
    least = max(0.02 * max(abs(low), abs(high)), 1e-3)
    if high - low < least:
        axis.set_ylim((low + high) / 2 - least, (low + high) / 2 + least)
    axis.ticklabel_format(axis="y", useOffset=False)


def histories(answers, other, path):
    """Everything over time; the other run, if given, dashed."""
    rows = _rows(answers)
    others = _rows(other) if other else [(None, [])] * len(rows)
    figure, axes = pyplot().subplots(len(rows), 1, sharex=True, figsize=(10, 1.55 * len(rows)), constrained_layout=True)
    for axis, (label, lines), (_, other_lines) in zip(axes, rows, others):
        for values, name, colour in lines:
            axis.plot(*_thinned(answers.stamp, values), color=colour, label=name, linewidth=1.1)
        for values, name, colour in other_lines:
            axis.plot(*_thinned(other.stamp, values), "--", color=colour, linewidth=0.9,
                      label=f"{name}, other run" if name else "other run")
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
        _show_constant_as_constant(axis)
    refused = ~np.isin(answers.status, USABLE)
    axes[0].plot(answers.stamp[refused], 1e3 * answers.y[refused], ".", color="tab:red", label="refused")
    if refused.any():
        axes[0].legend(loc="upper right", fontsize="small")
    axes[2].legend(loc="upper right", fontsize="small", ncol=2)
    axes[-1].set_xlabel("time [s]")
    axes[-1].set_xlim(answers.stamp[0], answers.stamp[-1])
    return _save(figure, path)


def contact_points(answers, side):
    """Where the patches of a side lie on the rail at rest and on the wheel; (n, 2) each, as seen on the left."""
    patches = answers.patches
    chosen = patches["side"] == side
    index, sign = patches["answer"][chosen], (1, -1)[side]
    y, z = patches["y"][chosen], patches["z"][chosen]
    lateral, vertical, tilt = (np.nan_to_num(answers.rail[index, side, column]) for column in (0, 1, 2))
    on_rail = np.column_stack([sign * y - lateral, z - vertical])
    if "reference" in answers.outlines:  # the point that a rail's roll turns it about
        reference = answers.outlines["reference"][0]
        dy, dz = (on_rail - reference).T
        on_rail = reference + np.column_stack([np.cos(tilt) * dy - np.sin(tilt) * dz,
                                               np.cos(tilt) * dz + np.sin(tilt) * dy])
    # To the wheelset's axes, yaw left out: it moves the contact along the track, not across.
    dy, dz, roll = y - answers.y[index], z - answers.z[index], answers.roll[index]
    on_wheel = np.column_stack([sign * (np.cos(roll) * dy + np.sin(roll) * dz), np.cos(roll) * dz - np.sin(roll) * dy])
    return on_rail, on_wheel


def bands(answers, path):
    """Where it runs: contact positions on both profiles, coloured by the highest pressure."""
    figure, axes = pyplot().subplots(2, 2, figsize=(11, 6.2), constrained_layout=True)
    pressure = 1e-6 * answers.patches["max_pressure"]
    scale = pyplot().Normalize(0, pressure.max())
    for side in (0, 1):
        chosen = answers.patches["side"] == side
        for row, (kind, points) in enumerate(zip(("wheel", "rail"), contact_points(answers, side)[::-1])):
            axis, sign = axes[row][side], (1, -1)[side]
            if kind in answers.outlines:
                axis.plot(sign * 1e3 * answers.outlines[kind][:, 0], 1e3 * answers.outlines[kind][:, 1], color="0.4")
            colours = axis.scatter(sign * 1e3 * points[:, 0], 1e3 * points[:, 1], c=pressure[chosen], s=14, norm=scale,
                                   cmap="viridis", zorder=3)
            axis.set(title=f"{SIDES[side]} {kind}", aspect="equal", xlabel="y [mm]", ylabel="z [mm]")
            axis.grid(alpha=0.3)
    # Left is at positive y: as seen in the direction of travel, the left side stands on the left.
    for axis in axes.flat:
        axis.invert_xaxis()
    figure.colorbar(colours, ax=axes, label="highest pressure [MPa]", shrink=0.8)
    return _save(figure, path)


def pressure_maps(message, title, path):
    """The pressure of every patch of one answer."""
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
    return _save(figure, path)


def quality(answers, path):
    """Estimated errors of the patches, by method."""
    figure, axis = pyplot().subplots(figsize=(7, 3), constrained_layout=True)
    errors = np.maximum(answers.patches["error_estimate"], SMALLEST)
    edges = np.geomspace(errors.min() / 1.1, errors.max() * 1.1, 40)
    for method in sorted(set(answers.patches["method"])):
        axis.hist(errors[answers.patches["method"] == method], bins=edges, alpha=0.6, label=method)
    axis.set(xscale="log", xlabel="estimated relative error of a patch", ylabel="patches")
    axis.legend(fontsize="small")
    return _save(figure, path)
