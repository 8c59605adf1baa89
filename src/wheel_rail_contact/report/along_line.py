# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the results along the line, for a wheelset that travels."""
import numpy as np

from ..command import pyplot
from ..message_constants import SIDES, USABLE
from . import marks
from .drawing import COLOURS, draw_history, is_zero, limit_zoom, save
from .positions import contact_points
from .results import RAIL_FIELDS, per_result

LEAST_DISTANCE = 1.0  # [m] a wheelset that moves less is not drawn along the line


def _places(results):
    """x of each result [m]; NaN if it is not usable: the pose of a rejected input may be missing."""
    return np.where(np.isin(results.status, USABLE), results.x, np.nan)


def travels(results):
    """True if the usable results have contacts and are at different places along the track."""
    x = _places(results)[results.patches["result"]]
    return len(x) > 0 and np.ptp(x) > LEAST_DISTANCE


def contacts_on_rail(results, side):
    """Lateral positions of the patches of a side on its rail, outward [m]: from the reference point of the rail head, or from
    the track centre if the bag does not contain this point."""
    reference = results.outlines[side].get("reference", np.zeros((1, 2)))
    return contact_points(results, side)[0][:, 0] - reference[0, 0]


def _draw_contacts(axes, x, results):
    """Positions of the contacts on each rail, in equal scales. Returns the colours of the pressures."""
    patches = results.patches
    pressure = 1e-6 * patches["max_pressure"]
    scale = pyplot().Normalize(0, pressure.max())
    outward = [1e3 * contacts_on_rail(results, side) for side in (0, 1)]
    margin = 0.05 * max(np.ptp(np.concatenate(outward)), 1.0)
    limits = min(map(np.min, filter(len, outward))) - margin, max(map(np.max, filter(len, outward))) + margin
    origin = "the reference point" if "reference" in results.outlines[0] else "the track centre"
    for side, axis in enumerate(axes):
        chosen = patches["side"] == side
        colours = axis.scatter(x[patches["result"][chosen]], outward[side], c=pressure[chosen], s=5, norm=scale,
                               cmap="viridis")
        axis.set(ylim=limits, ylabel=f"contact on the\n{SIDES[side]} rail [mm],\noutward from\n{origin}")
    return colours


def _histories(results):
    """Values, name and colour of the lines in each of the lower pictures, with the label of its axis. Displacements that are
    zero throughout are left out."""
    patches, sign = results.patches, (1, -1)

    def both(values):
        return [(values[side], SIDES[side], COLOURS[side]) for side in (0, 1)]

    def given(name, side):
        return 1e3 * results.rail[:, side, RAIL_FIELDS.index(name)]

    highest = [1e-6 * per_result(patches["max_pressure"], results, np.flatnonzero(patches["side"] == side), "max")
               for side in (0, 1)]
    lateral = [sign[side] * given("given_lateral", side) for side in (0, 1)]
    vertical = [given("given_vertical", side) for side in (0, 1)]
    own = (1e3 * results.y, "y of the wheelset", "k")
    return [("highest pressure\n[MPa]", both(highest)),
            ("y [mm]", [own]) if is_zero(lateral) else ("given displacement\nto the left [mm]", [*both(lateral), own]),
            *([] if is_zero(vertical) else [("given displacement\nup [mm]", both(vertical))])]


def _draw_lines(axis, x, label, lines, results):
    for values, name, colour in lines:
        draw_history(axis, x, values, results, color=colour, label=name, linewidth=1.1)
    axis.set_ylabel(label)
    axis.legend(loc="lower right", bbox_to_anchor=(1, 1), borderaxespad=0.1, ncol=3, frameon=False, fontsize="small")
    limit_zoom(axis)


def figure(results, path):
    """Contacts, pressures and given displacements of both rails over x. Returns the path."""
    x, rows = _places(results), _histories(results)
    picture, axes = pyplot().subplots(2 + len(rows), 1, sharex=True, figsize=(10, 1.8 * (2 + len(rows))),
                                      constrained_layout=True)
    colours = _draw_contacts(axes[:2], x, results)
    picture.colorbar(colours, ax=axes[:2], label="highest pressure [MPa]", pad=0.01)
    for axis, (label, lines) in zip(axes[2:], rows):
        _draw_lines(axis, x, label, lines, results)
    for axis in axes:
        axis.grid(alpha=0.3)
    marks.draw(axes, marks.between(x, results), results)
    marks.legend(axes[0], results)
    axes[-1].set(xlabel="x [m]", xlim=(np.nanmin(x), np.nanmax(x)))
    return save(picture, path)
