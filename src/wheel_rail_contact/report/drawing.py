# SPDX-License-Identifier: BSD-3-Clause
"""Functions and constants shared by the pictures of the report."""
import numpy as np

from ..command import pyplot
from .loops import loops

COLOURS = ("tab:blue", "tab:orange")  # of the left and the right side
LEAST_POINTS = 4   # number of points drawn of each loop, at least
MAX_POINTS = 4000  # largest number of points drawn of a history; longer ones are thinned


def save(figure, path):
    """Writes a figure to a file and closes it. Returns the path."""
    figure.savefig(path, dpi=110)
    pyplot().close(figure)
    return path


def thinned(x, y, most=MAX_POINTS):
    """A history with at most `most` points: the lowest and the highest one of each piece."""
    if len(x) <= most:
        return x, y
    pieces = np.array_split(np.arange(len(x)), most // 2)
    chosen = set()
    for piece in pieces:
        known = piece[np.isfinite(y[piece])]
        chosen.update({known[np.argmin(y[known])], known[np.argmax(y[known])]} if len(known) else {piece[0]})
    chosen = sorted(chosen)
    return x[chosen], y[chosen]


def interrupted(x, y, parts):
    """A thinned history with a gap (NaN) between its parts: no line connects the end of a loop with the begin of the next.

    @param x, y arrays (n,)
    @param parts slices of the arrays
    @return x and y of the line
    """
    most = max(LEAST_POINTS, MAX_POINTS // len(parts))
    pieces = [np.array(thinned(x[part], y[part], most), float) for part in parts]
    gap = np.full((2, 1), np.nan)
    return np.concatenate([column for piece in pieces for column in (piece, gap)][:-1], axis=1)


def draw_history(axis, x, y, results, style="-", **properties):
    """Draws one value per result over x, with a gap between the loops of the recording."""
    axis.plot(*interrupted(x, y, loops(results.stamp)), style, **properties)


def limit_zoom(axis, share=0.02):
    """Gives the axis a minimum range: the rounding errors of a constant would otherwise fill its height.

    @param share half of the minimum range, as a share of the largest value [-]
    """
    low, high = axis.get_ylim()
    least = max(share * max(abs(low), abs(high)), 1e-3)
    if high - low < least:
        axis.set_ylim((low + high) / 2 - least, (low + high) / 2 + least)
    axis.ticklabel_format(axis="y", useOffset=False)


def is_zero(lines):
    """True if all values of all lines are zero or unknown (NaN).

    @param lines arrays
    """
    return not any(np.nan_to_num(values).any() for values in lines)
