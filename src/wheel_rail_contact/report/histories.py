# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the histories over time."""
from collections import namedtuple

import numpy as np

from ..command import pyplot
from ..message_constants import SIDES, USABLE
from . import marks
from .drawing import COLOURS, draw_history, is_zero, limit_zoom, prominent, save
from .loops import loops
from .results import RAIL_FIELDS, WHEEL_FIELDS, has_friction, main_patch, of_patches, per_result

FAR = 1e6      # [s] stamps beyond it, as times of day are, are drawn as differences from a whole second
SHARE = 0.01   # [-] of the largest force: a lateral force that bends the rail is given if it differs by more from that of the
               # contact. The balance of wheel and rail is more accurate than that

ZOOM = 0.02    # [-] half of the smallest range of an axis, as a share of the largest value
ZOOM_RADIUS = 5e-4  # [-] the same for rolling radii: small differences count

Row = namedtuple("Row", "label lines dots zoom")
Row.__doc__ = """A picture of the histories: label of its axis, lines (values of the results, name, colour), dots (results,
values, colour) of the other patches, and half of the smallest range of the axis as a share of the largest value."""


def _by_side(values, scale):
    return [(scale * values[side], SIDES[side], COLOURS[side]) for side in (0, 1)]


def _rail(results, name, scale):
    return _by_side([results.rail[:, side, RAIL_FIELDS.index(name)] for side in (0, 1)], scale)


def _wheel(results, name, scale):
    return _by_side([results.wheel[:, side, WHEEL_FIELDS.index(name)] for side in (0, 1)], scale)


def _reduced(results, name, scale, reduce):
    """Maximum or sum over the patches of each wheel."""
    sides = [np.flatnonzero(results.patches["side"] == side) for side in (0, 1)]
    return _by_side([per_result(results.patches[name], results, side, reduce) for side in sides], scale)


def _each_patch(results, label, name, scale, zoom=ZOOM):
    """A line for the patch with the largest normal force of each wheel, and dots for its other patches."""
    main = [main_patch(results, side) for side in (0, 1)]
    dots = []
    for side in (0, 1):
        others = np.setdiff1d(np.flatnonzero(results.patches["side"] == side), main[side])
        index, values = results.patches["result"][others], scale * results.patches[name][others]
        chosen = prominent(results.stamp[index], values)
        dots.append((index[chosen], values[chosen], COLOURS[side]))
    return Row(label, _by_side([of_patches(results, name, patch) for patch in main], scale), dots, zoom)


def _given_forces(results):
    """Lateral forces that bend the rails; no lines if they are those of the contacts, as without rail_bending/lateral_force:
    topic."""
    given = results.rail[:, :, RAIL_FIELDS.index("lateral_force")]
    contact = results.wheel[:, :, WHEEL_FIELDS.index("lateral_force")]
    largest = np.nanmax(np.abs(np.nan_to_num([given, contact])))
    differ = np.nanmax(np.abs(np.nan_to_num(given - contact))) > SHARE * largest
    return _by_side(given.T, 1e-3) if differ else []


def _friction(results):
    """Pictures of the friction; without lines if there is none, so that they are not named as zero."""
    rows = [Row("Y by friction [kN],\noutward", _wheel(results, "friction_lateral_force", 1e-3), [], ZOOM),
            Row("largest adhesion\nshare [-]", _reduced(results, "creep.adhesion_share", 1, "max"), [], ZOOM),
            Row("friction power\n[kW]", _reduced(results, "creep.power", 1e-3, "sum"), [], ZOOM)]
    return rows if has_friction(results) else [row._replace(lines=[]) for row in rows]


def _rows(results):
    return [Row("y [mm]", [(1e3 * results.y, None, "k")], [], ZOOM),
            Row("yaw [mrad]", [(1e3 * results.yaw, None, "k")], [], ZOOM),
            Row("Q [kN]", _wheel(results, "vertical_force", 1e-3), [], ZOOM),
            Row("Y [kN], outward", _wheel(results, "lateral_force", 1e-3), [], ZOOM),
            *_friction(results),
            Row("given Y on the rail\n[kN], outward", _given_forces(results), [], ZOOM),
            Row("rail lateral [mm],\noutward", _rail(results, "lateral", 1e3), [], ZOOM),
            Row("rail roll [mrad],\noutward", _rail(results, "roll", 1e3), [], ZOOM),
            Row("highest pressure\n[MPa]", _reduced(results, "max_pressure", 1e-6, "max"), [], ZOOM),
            Row("contact area\n[mm²]", _reduced(results, "area", 1e6, "sum"), [], ZOOM),
            _each_patch(results, "semi-axis a\nalong [mm]", "semi_axis_along", 1e3),
            _each_patch(results, "semi-axis b\nacross [mm]", "semi_axis_across", 1e3),
            _each_patch(results, "contact angle [°]", "contact_angle", 180 / np.pi),
            _each_patch(results, "rolling radius\n[mm]", "rolling_radius", 1e3, ZOOM_RADIUS)]


def _drawn(rows, others):
    """Rows of both runs that are drawn: the first one, and those with a value that is not zero; and the labels of the others
    that have lines."""
    pairs = list(zip(rows, others))
    empty = [is_zero([values for row in pair for values, *_ in row.lines]) for pair in pairs]
    empty[0] = False  # y, the picture of the refusals
    return ([pair for pair, zero in zip(pairs, empty) if not zero],
            [pair[0].label.replace("\n", " ") for pair, zero in zip(pairs, empty)
             if zero and (pair[0].lines or pair[1].lines)])


def time_axis(results):
    """Whole second from which times are drawn: 0, unless the digits of the stamps would not fit on the axis; and its label."""
    origin = np.floor(results.stamp.min()) if results.stamp.min() > FAR else 0.0
    return origin, f"time [s], from {origin:.0f} s" if origin else "time [s]"


def _draw_row(axis, row, results, origin, dashed=False):
    time = results.stamp - origin
    for values, _, colour in row.lines:
        draw_history(axis, time, values, results, "--" if dashed else "-", color=colour, linewidth=0.9 if dashed else 1.1)
    for index, values, colour in ([] if dashed else row.dots):
        axis.plot(time[index], values, ".", color=colour, markersize=2)


def _draw_refusals(axis, results, origin):
    """Dots at the y of the refusals. Returns the entries of the legend."""
    refused = ~np.isin(results.status, USABLE) & np.isfinite(results.y)
    if not refused.any():
        return []
    return axis.plot(results.stamp[refused] - origin, 1e3 * results.y[refused], ".", color=marks.REFUSED,
                     label="y of a refusal")


def _line_entries(rows, other):
    """Entries of the legend for the lines and dots of the rows."""
    line = pyplot().Line2D
    entries = [line([], [], color=colour, label=name) for name, colour in zip(SIDES, COLOURS)]
    if other:
        entries.append(line([], [], color="0.4", linestyle="--", label="other run"))
    if any(len(index) for row in rows for index, *_ in row.dots):
        entries.append(line([], [], color="0.4", linestyle="", marker=".", markersize=4, label="other patches of a wheel"))
    return entries


def _draw_title(picture, results):
    number = len(loops(results.stamp))
    if number > 1:
        picture.suptitle(f"{number} loops (time goes back {number - 1} times), drawn over each other", fontsize="medium")


def histories(results, other, path):
    """Histories over time. The other run, if given, is drawn dashed. Quantities that are zero throughout are not drawn.

    @return the path, and the labels of the quantities that are not drawn
    """
    pairs, left_out = _drawn(_rows(results), _rows(other or results))
    picture, axes = pyplot().subplots(len(pairs), 1, sharex=True, figsize=(10, 0.5 + 1.4 * len(pairs)), squeeze=False,
                                      constrained_layout=True)
    axes, (origin, label) = axes[:, 0], time_axis(results)
    for axis, (row, other_row) in zip(axes, pairs):
        _draw_row(axis, row, results, origin)
        if other:
            _draw_row(axis, other_row, other, origin, dashed=True)
        axis.set_ylabel(row.label)
        axis.grid(alpha=0.3)
        limit_zoom(axis, row.zoom)
    entries = [*_line_entries([row for row, _ in pairs], other), *_draw_refusals(axes[0], results, origin)]
    marks.draw(axes, results.stamp - origin, results)
    marks.legend(axes[0], results, entries)
    _draw_title(picture, results)
    axes[-1].set_xlabel(label)
    if np.ptp(results.stamp) > 0:
        axes[-1].set_xlim(results.stamp.min() - origin, results.stamp.max() - origin)
    picture.align_ylabels(axes)
    return save(picture, path), left_out
