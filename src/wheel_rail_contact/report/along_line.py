# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the results along the line, for a wheelset that travels: one for each pass."""
import numpy as np

from ..command import pyplot
from ..message_constants import SIDES, USABLE
from . import marks
from .drawing import COLOURS, draw_history, is_zero, limit_zoom, numbered, prominent, save
from .positions import contact_points
from .results import RAIL_FIELDS, part_of, per_result

LEAST_DISTANCE = 1.0  # [m] a wheelset that moves less is not drawn along the line; one that goes back by more begins a new pass
MOST_PASSES = 8        # largest number of passes that are drawn, the longest ones


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


def drawn_passes(results):
    """Title and slice of each pass that is drawn: the longest ones in their order, with contacts on more than the least
    distance. A wheelset that does not travel has one pass without a title."""
    if not travels(results):
        return [("", slice(0, len(results.stamp)))]
    x, touched = _places(results), results.patches["result"]
    every = passes(x)
    of_pass = [x[touched[(touched >= one.start) & (touched < one.stop)]] for one in every]
    length = np.array([np.ptp(places) if len(places) else 0 for places in of_pass])
    longest = np.sort(np.argsort(-length, kind="stable")[:MOST_PASSES])
    stamps = results.stamp
    return [(f"Pass {k + 1} of {len(every)}, from {stamps[every[k].start]:.3f} s to {stamps[every[k].stop - 1]:.3f} s"
             if len(every) > 1 else "", every[k]) for k in longest if length[k] > LEAST_DISTANCE or length[k] == length.max()]


def contacts_on_rail(results, side):
    """Lateral positions of the patches of a side on its rail, outward [m]: from the reference point of the rail head, or from
    the track centre if the bag does not contain this point."""
    reference = results.outlines[side].get("reference", np.zeros((1, 2)))
    return contact_points(results, side)[0][:, 0] - reference[0, 0]


def _draw_contacts(axes, touching, x, results, limits, scale):
    """Positions of the contacts on each rail that is touched; those with the highest pressures are in front. Returns the
    colours of the pressures."""
    patches = results.patches
    origin = "the reference point" if "reference" in results.outlines[0] else "the track centre"
    for side, axis in zip(touching, axes):
        chosen = patches["side"] == side
        place, outward = x[patches["result"][chosen]], 1e3 * contacts_on_rail(results, side)
        pressure = 1e-6 * patches["max_pressure"][chosen]
        drawn = prominent(place, outward, pressure)
        drawn = drawn[np.argsort(pressure[drawn], kind="stable")]
        colours = axis.scatter(place[drawn], outward[drawn], c=pressure[drawn], s=5, norm=scale, cmap="viridis")
        axis.set(ylim=limits, ylabel=f"contact on the\n{SIDES[side]} rail [mm],\noutward from\n{origin}")
    return colours


def _contact_limits(results):
    """Range of the contacts on both rails [mm], with a margin."""
    outward = np.concatenate([1e3 * contacts_on_rail(results, side) for side in (0, 1)])
    margin = 0.05 * max(np.ptp(outward), 1.0)
    return outward.min() - margin, outward.max() + margin


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


def _draw_pass(results, rows, touching, limits, scale):
    """Picture of one pass, and its axes from above: contacts, then lines."""
    x, count = _places(results), len(touching)
    picture, axes = pyplot().subplots(count + len(rows), 1, sharex=True, figsize=(10, 1.8 * (count + len(rows))),
                                      constrained_layout=True)
    colours = _draw_contacts(axes[:count], touching, x, results, limits, scale)
    picture.colorbar(colours, ax=axes[:count], label="highest pressure [MPa]", pad=0.01)
    for axis, (label, lines) in zip(axes[count:], rows):
        _draw_lines(axis, x, label, lines, results)
    for axis in axes:
        axis.grid(alpha=0.3)
    axes[-1].set(xlabel="x [m]")
    return picture, axes


def _give_equal_limits(axes):
    """Gives the axes of a quantity in several pictures the range that contains all of theirs."""
    limits = np.array([axis.get_ylim() for axis in axes])
    for axis in axes:
        axis.set_ylim(limits[:, 0].min(), limits[:, 1].max())
        limit_zoom(axis)


def figures(results, out):
    """Contacts, pressures and given displacements of both rails over x: a picture of each pass, all with equal scales, so that
    the same place is at the same position when they are one above another. Returns the paths."""
    every, rows = drawn_passes(results), _histories(results)
    touching = [side for side in (0, 1) if (results.patches["side"] == side).any()]
    limits, scale = _contact_limits(results), pyplot().Normalize(0, 1e-6 * results.patches["max_pressure"].max())
    parts = [part_of(results, one) for _, one in every]
    drawn = [_draw_pass(part, [(label, [(values[one], name, colour) for values, name, colour in lines])
                               for label, lines in rows], touching, limits, scale) for part, (_, one) in zip(parts, every)]
    for alike in list(zip(*(axes for _, axes in drawn)))[len(touching):]:
        _give_equal_limits(alike)
    places = np.concatenate([_places(part) for part in parts])
    paths = []
    for k, ((picture, axes), part, (title, _)) in enumerate(zip(drawn, parts, every), 1):
        picture.suptitle(title or None)
        marks.draw(axes, marks.between(_places(part), part), part)
        marks.legend(axes[0], part)
        axes[-1].set_xlim(np.nanmin(places), np.nanmax(places))
        paths.append(save(picture, numbered(out, "along_line", k)))
    return paths
