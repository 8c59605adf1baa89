# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the contacts on a rail whose profile changes along the line, from above."""
import numpy as np

from ..command import pyplot
from ..message_constants import SIDES, USABLE
from . import marks
from .along_line import drawn_passes
from .drawing import draw_history, limit_zoom, numbered, save
from .results import part_of, per_result

GRID = 5e-4             # [m] distance of the points at which the surface is drawn, across the rail
COLUMNS = 900           # number of the drawn columns along the rail
DEEPEST = 0.025         # [m] the surface is drawn down to this depth below its highest point
LEVELS = (-20, -15, -10, -5, -2, 2)    # [mm] heights of the drawn lines
MARGIN = 0.02           # [m] of the picture beside the contacts, where the rail is wider
LARGEST_JUMP = 0.008    # [m] a contact farther from all contacts of the preceding results belongs to another head
LONGEST_GAP = 0.1       # [m] along the line, after which a contact is a new one
LARGEST_CHANGE = 0.02   # [m] of the width of a rail, from one outline to the next that is interpolated
LEAST_SHARE = 0.02      # [-] of the sum of all loads that a head must carry to be listed


def can_draw(results, side):
    """True if the profile of the rail changes and results have contacts on it."""
    return len({x for x, _ in results.sections[side]}) > 1 and bool((results.patches["side"] == side).any())


def surface(sections, places, across):
    """Heights of a rail (across, places) [m], NaN where there is none.

    Between two places of the outlines, points at the same share of their lengths are interpolated; if the rail has another
    number of parts there, or another width, the nearer outlines are drawn.

    @param sections (place on the line, outline) of each part, in increasing order of the places [m]
    @param across equidistant outward coordinates [m]
    """
    stations, outlines = _stations(sections)
    after = np.clip(np.searchsorted(stations, places), 1, len(stations) - 1)
    share = np.clip((places - stations[after - 1]) / (stations[after] - stations[after - 1]), 0, 1)
    heights = np.full((len(places), len(across)), np.nan)
    for column, (k, t) in enumerate(zip(after, share)):
        one, other = outlines[k - 1], outlines[k]
        parts = [(1 - t) * a + t * b for a, b in zip(one, other)] if _alike(one, other) else (one if t < 0.5 else other)
        for outline in parts:
            _raise(heights[column], outline, across)
    return heights.T


def _stations(sections):
    """Places of the outlines, and the outlines of all parts at each of them."""
    stations = np.unique([x for x, _ in sections])
    return stations, [[outline for x, outline in sections if x == station] for station in stations]


def _alike(one, other):
    def width(outline):
        return np.ptp(outline[:, 0])
    return len(one) == len(other) and all(len(a) == len(b) and abs(width(a) - width(b)) < LARGEST_CHANGE
                                          for a, b in zip(one, other))


def _raise(heights, outline, across):
    """Raises heights at places across to those of an outline, where it is higher or the only one."""
    steps = np.hypot(*np.diff(outline, axis=0).T)
    fine = np.linspace(0, 1, max(2, int(np.ceil(2 * steps.max() / (across[1] - across[0])))), endpoint=False)
    points = (outline[:-1, None] + fine[:, None] * np.diff(outline, axis=0)[:, None]).reshape(-1, 2)
    index = np.rint((points[:, 0] - across[0]) / (across[1] - across[0])).astype(int)
    inside = (index >= 0) & (index < len(across))
    np.fmax.at(heights, index[inside], points[inside, 1])


def heads(place, across):
    """Number of the head that each contact is on, counted from 0. A contact belongs to the head of the nearest contact before
    it. The rule does not require outlines, and holds for separate parts as well as for heads of one profile.

    @param place on the line, of each contact, increasing [m]
    @param across outward position of each contact [m]
    """
    known = []  # last place and position of each head
    numbers = np.empty(len(place), int)
    for i, (x, y) in enumerate(zip(place, across)):
        near = [(abs(y - other), k) for k, (last, other) in enumerate(known) if x - last <= LONGEST_GAP]
        distance, k = min(near, default=(np.inf, 0))
        if distance > LARGEST_JUMP:
            k = len(known)
            known.append(None)
        known[k] = (x, y)
        numbers[i] = k
    return numbers


def _contacts(results, side):
    """Result, place, track y, pressure, area, vertical force and head of each contact of a side, in order along the line."""
    patches = results.patches
    chosen = np.flatnonzero(patches["side"] == side)
    chosen = chosen[np.argsort(results.distance[patches["result"][chosen]], kind="stable")]
    result = patches["result"][chosen]
    place, y = results.distance[result], patches["y"][chosen]
    force = patches["normal_force"][chosen] * np.cos(patches["contact_angle"][chosen])
    return result, place, y, patches["max_pressure"][chosen], patches["area"][chosen], force, heads(place, y)


def _shaded(height):
    """Brightness of a surface [0, 1]: bright at the top, with light from the gauge side."""
    top = np.nanmax(height)
    depth = np.clip((height - top) / DEEPEST + 1, 0, 1)
    slope = np.gradient(np.nan_to_num(height, nan=top - DEEPEST), GRID, axis=0)
    return np.where(np.isnan(height) | (height < top - DEEPEST), np.nan, 0.30 + 0.55 * depth + 0.15 * np.tanh(slope))


def _draw_band(axis, results, side, contacts):
    """Surface and contacts; returns the colours of the pressures."""
    _, place, y, pressure, area, _, _ = contacts
    sign = (1, -1)[side]
    low, high = place.min(), place.max()
    near = [outline for x, outline in results.sections[side] if low <= x <= high] or [o for _, o in results.sections[side]]
    widest = np.concatenate([outline[:, 0] for outline in near])
    across = np.arange(max(widest.min(), (sign * y).min() - 3 * MARGIN), min(widest.max(), (sign * y).max() + 3 * MARGIN), GRID)
    along = np.linspace(low, high, COLUMNS)
    height = surface(results.sections[side], along, across)
    axis.imshow(_shaded(height), cmap="gray", vmin=0, vmax=1, origin="lower", aspect="auto",
                extent=(low, high, 1e3 * sign * across[0], 1e3 * sign * across[-1]))
    lines = axis.contour(along, 1e3 * sign * across, 1e3 * height, levels=LEVELS, colors="k", linewidths=0.4, alpha=0.5,
                         linestyles="solid")
    axis.clabel(lines, fmt="%.0f", fontsize="x-small")
    order = np.argsort(pressure, kind="stable")
    colours = axis.scatter(place[order], 1e3 * y[order], c=1e-6 * pressure[order], s=np.maximum(1e6 * area[order] / 12, 3),
                           cmap="plasma", vmin=0, zorder=3, linewidths=0)
    axis.set(ylabel="y [mm], left: +", facecolor="0.2")
    return colours


def _draw_loads(axis, x, results, contacts):
    """Load of each head; those that carry little are drawn in grey."""
    result, _, y, _, _, force, head = contacts
    for k in range(head.max() + 1):
        on_head = head == k
        load = np.bincount(result[on_head], force[on_head], minlength=len(x))
        from_centre = 1e3 * abs(y[on_head])
        listed = force[on_head].sum() > LEAST_SHARE * force.sum()
        label = f"head at {from_centre[0]:.0f} mm to {from_centre[-1]:.0f} mm"
        shown = np.convolve(load > 0, np.ones(3), "same") > 0  # also the results next to those with a load
        draw_history(axis, x, np.where(shown, 1e-3 * load, np.nan), results, linewidth=1.2 if listed else 0.7,
                     zorder=3 if listed else 2, label=label if listed else None, color=None if listed else "0.6")
    axis.set(ylabel="load of\neach head [kN]", ylim=(0, None))
    axis.legend(loc="lower right", bbox_to_anchor=(1, 1), borderaxespad=0.1, ncol=4, frameon=False, fontsize="x-small")


def _draw_pressures(axis, x, results, side):
    """Highest pressure of the side in each result."""
    highest = per_result(results.patches["max_pressure"], results, np.flatnonzero(results.patches["side"] == side), "max")
    draw_history(axis, x, 1e-6 * highest, results, color="0.2", linewidth=1.1)
    axis.set(xlabel="place on the line [m]", ylabel="highest pressure\n[MPa]")
    limit_zoom(axis)


def figures(results, side, out):
    """A picture of each pass of the wheelset that has contacts on the rail. Returns the paths."""
    passes = [(title, part_of(results, one)) for title, one in drawn_passes(results)]
    return [figure(part, side, numbered(out, f"running_band_{side}", k), title)
            for k, (title, part) in enumerate(passes, 1) if can_draw(part, side)]


def figure(results, side, path, title=""):
    """Contacts on the surface of the rail, load of each head, and highest pressure over the place. Returns the path."""
    contacts = _contacts(results, side)
    x = np.where(np.isin(results.status, USABLE), results.distance, np.nan)
    picture, axes = pyplot().subplots(3, 1, sharex=True, figsize=(11, 8), constrained_layout=True,
                                      gridspec_kw={"height_ratios": (2.4, 1, 1)})
    colours = _draw_band(axes[0], results, side, contacts)
    picture.colorbar(colours, ax=axes[0], label="highest pressure [MPa]", pad=0.01)
    picture.suptitle(title or None)
    axes[0].set_title(f"{SIDES[side]} rail, from above; lines: height [mm]", fontsize="medium")
    _draw_loads(axes[1], x, results, contacts)
    _draw_pressures(axes[2], x, results, side)
    marks.draw(axes[1:], marks.between(x, results), results)
    marks.legend(axes[2], results)
    axes[2].set_xlim(np.nanmin(x), np.nanmax(x))
    for axis in axes[1:]:
        axis.grid(alpha=0.3)
    return save(picture, path)
