# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the results along the line, for a wheelset that travels."""
import numpy as np

from ..command import pyplot
from ..message_constants import SIDES, USABLE
from . import marks
from .drawing import COLOURS, draw_history, is_zero, limit_zoom, save
from .positions import contact_points
from .results import RAIL_FIELDS, part_of, per_result

LEAST_DISTANCE = 1.0  # [m] a wheelset that moves less is not drawn along the line; one that goes back by more begins a new pass


def _places(results):
    """x of each result [m]; NaN if it is not usable: the pose of a rejected input may be missing."""
    return np.where(np.isin(results.status, USABLE), results.x, np.nan)


def travels(results):
    """True if the usable results have contacts and are at different places along the track."""
    x = _places(results)[results.patches["result"]]
    return len(x) > 0 and np.ptp(x) > LEAST_DISTANCE


def passes(x):
    """Slices of the results between which the wheelset moves in one direction: a line that is run over again has several.

    @param x of each result [m]; NaN: unknown
    """
    known = np.flatnonzero(np.isfinite(x)).tolist()
    slices, begin, start, farthest, way = [], 0, x[known[0]], known[0], 0
    for index in known:
        if way * (x[index] - x[farthest]) < -LEAST_DISTANCE:
            slices.append(slice(begin, farthest + 1))
            begin, start, farthest, way = farthest + 1, x[index], index, 0
        if way == 0 or way * (x[index] - x[farthest]) > 0:
            farthest = index
        if way == 0 and abs(x[index] - start) > LEAST_DISTANCE:
            way = np.sign(x[index] - start)
    return [*slices, slice(begin, len(x))]


def contacts_on_rail(results, side):
    """Lateral positions of the patches of a side on its rail, outward [m]: from the reference point of the rail head, or from
    the track centre if the bag does not contain this point."""
    reference = results.outlines[side].get("reference", np.zeros((1, 2)))
    return contact_points(results, side)[0][:, 0] - reference[0, 0]


def _draw_contacts(axes, touching, x, results):
    """Positions of the contacts on each rail that is touched, in equal scales. Returns the colours of the pressures."""
    patches = results.patches
    pressure = 1e-6 * patches["max_pressure"]
    scale = pyplot().Normalize(0, pressure.max())
    outward = [1e3 * contacts_on_rail(results, side) for side in (0, 1)]
    margin = 0.05 * max(np.ptp(np.concatenate(outward)), 1.0)
    limits = min(map(np.min, filter(len, outward))) - margin, max(map(np.max, filter(len, outward))) + margin
    origin = "the reference point" if "reference" in results.outlines[0] else "the track centre"
    for side, axis in zip(touching, axes):
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
    """Contacts, pressures and given displacements of both rails over x, in the longest pass. Returns the path."""
    all_passes = passes(_places(results))
    parts = [part_of(results, one) for one in all_passes]
    drawn = int(np.argmax([np.ptp(_places(part)[part.patches["result"]]) if len(part.patches["result"]) else -1
                           for part in parts]))
    results = parts[drawn]
    x, rows = _places(results), _histories(results)
    touching = [side for side in (0, 1) if (results.patches["side"] == side).any()]
    count = len(touching)
    picture, axes = pyplot().subplots(count + len(rows), 1, sharex=True, figsize=(10, 1.8 * (count + len(rows))),
                                      constrained_layout=True)
    colours = _draw_contacts(axes[:count], touching, x, results)
    picture.colorbar(colours, ax=axes[:count], label="highest pressure [MPa]", pad=0.01)
    if len(all_passes) > 1:
        picture.suptitle(f"Pass {drawn + 1} of {len(all_passes)}")
    for axis, (label, lines) in zip(axes[count:], rows):
        _draw_lines(axis, x, label, lines, results)
    for axis in axes:
        axis.grid(alpha=0.3)
    marks.draw(axes, marks.between(x, results), results)
    marks.legend(axes[0], results)
    axes[-1].set(xlabel="x [m]", xlim=(np.nanmin(x), np.nanmax(x)))
    return save(picture, path)
