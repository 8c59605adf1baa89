# SPDX-License-Identifier: BSD-3-Clause
"""Marks of the results in which a wheel carries no load, or which are not usable: shaded spans of the horizontal axis."""
import numpy as np

from ..command import pyplot
from ..message_constants import SIDES, STATUSES, USABLE
from .drawing import COLOURS
from .loops import loops

REFUSED, HELD = "tab:red", "tab:purple"
SHADE = 0.18  # opacity of a span [-]
ROUNDING = 1e-6  # of the median step: spans with a smaller distance are one


def lifted(results, side):
    """Results (n,) in which the wheel of a side carries no load."""
    touching = np.zeros(len(results.stamp), bool)
    touching[results.patches["result"][results.patches["side"] == side]] = True
    return (results.status == STATUSES.index("LIFT_OFF")) & ~touching


def marks(results):
    """Label, colour and results (n,) of each kind of mark that occurs."""
    kinds = [(f"{name} wheel lifted off", colour, lifted(results, side))
             for side, (name, colour) in enumerate(zip(SIDES, COLOURS))]
    kinds.append(("refused", REFUSED, ~np.isin(results.status, USABLE) & ~results.held))
    kinds.append(("refused and held", HELD, results.held))
    return [kind for kind in kinds if kind[2].any()]


def spans(x, chosen, parts):
    """Intervals of x that belong to the chosen results: each extends half way to the results beside it, but not farther than
    the median step.

    @param x place of each result on the axis, (n,), monotonic in each part
    @param chosen results to mark, (n,)
    @param parts slices of the arrays
    @return intervals (k, 2), in increasing order and disjoint; a result whose place is not known (NaN) has none
    """
    ends = np.concatenate([_ends(x[part]) for part in parts])
    known = np.isfinite(ends).all(axis=1)
    near = ROUNDING * np.median(np.ptp(ends[known], axis=1)) if known.any() else 0
    merged = []
    for low, high in sorted(ends[known & chosen].tolist()):
        if merged and low <= merged[-1][1] + near:
            merged[-1][1] = max(high, merged[-1][1])
        else:
            merged.append([low, high])
    return np.array(merged).reshape(-1, 2)


def _ends(x):
    """Ends of the interval of each result in one part, (n, 2)."""
    steps = np.abs(np.diff(x))
    reach = np.minimum(steps, np.median(steps)) / 2 if len(steps) else np.zeros(0)
    before, after = np.append(reach[:1], reach), np.append(reach, reach[-1:])
    if len(x) > 1 and x[-1] < x[0]:
        before, after = after, before
    return np.column_stack([x - (before if len(before) else 0), x + (after if len(after) else 0)])


def between(x, results):
    """Places (n,), in which an unknown one (NaN) is replaced by the one between its neighbours in time, in the same loop."""
    filled = x.copy()
    for loop in loops(results.stamp):
        known = np.isfinite(x[loop])
        if known.any():
            filled[loop] = np.interp(results.stamp[loop], results.stamp[loop][known], x[loop][known])
    return filled


def draw(axes, x, results):
    """Shades the marks on all axes, without a change of their limits.

    @param x place of each result on the horizontal axis, (n,)
    """
    for _, colour, chosen in marks(results):
        intervals = spans(x, chosen, loops(results.stamp))
        for axis in axes if len(intervals) else []:
            low, high = axis.get_ylim()
            axis.broken_barh([(start, end - start) for start, end in intervals], (low, high - low), facecolor=colour,
                             edgecolor=colour, linewidth=0.8, alpha=SHADE, zorder=0)
            axis.set_ylim(low, high)


def _handles(results):
    return [pyplot().Rectangle((0, 0), 1, 1, facecolor=colour, alpha=2 * SHADE, label=label)
            for label, colour, _ in marks(results)]


def legend(axis, results, entries=()):
    """Legend above an axis: the entries, and the marks that occur."""
    entries = [*entries, *_handles(results)]
    if entries:
        axis.legend(handles=entries, loc="lower right", bbox_to_anchor=(1, 1), borderaxespad=0.1, ncol=len(entries),
                    frameon=False, fontsize="small")
