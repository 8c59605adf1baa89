# SPDX-License-Identifier: BSD-3-Clause
"""Functions and constants shared by the pictures of the report."""
import numpy as np

from ..command import pyplot
from .loops import loops

COLOURS = ("tab:blue", "tab:orange")  # of the left and the right side
COLUMNS = 1000     # [pixels] of a picture over time or place; results of one column cannot be distinguished
MAX_POINTS = 4 * COLUMNS  # longest history that is drawn as a line; longer ones are solid blocks, and drawn as ranges
MEAN_WIDTH = 0.7   # [points] of the line of the mean values of a long history
SHADE = 0.35       # [-] opacity of the range of a long history


def save(figure, path):
    """Writes a figure to a file and closes it. Returns the path."""
    figure.savefig(path, dpi=110)
    pyplot().close(figure)
    return path


def numbered(folder, name, number):
    """Path of a picture of a pass: the first one has no number."""
    return folder / f"{name}{f'_{number}' if number > 1 else ''}.png"


def _columns(x):
    """Column of pixels of each place, which is known."""
    width = np.ptp(x)
    return np.minimum((COLUMNS * (x - x.min()) / (width or 1)).astype(int), COLUMNS - 1)


def _ends(columns, values):
    """Index of the lowest and of the highest value in each column that has any, (2, columns)."""
    order = np.lexsort((values, columns))
    last = np.append(np.diff(columns[order]) > 0, True)
    return np.array([order[np.append(True, last[:-1])], order[last]])


def prominent(x, *quantities):
    """Indices of the points to draw: all, or of many those with the lowest or highest value of a quantity in their column of
    pixels."""
    if len(x) <= MAX_POINTS:
        return np.arange(len(x))
    columns = _columns(x)
    return np.unique([_ends(columns, values) for values in quantities])


def ranges(x, y):
    """Place, mean, lowest and highest value of a history in each column of pixels, (4, columns); NaN in a column with results
    but without a known value, none in a pause. A result whose place is not known (NaN) lies between its neighbours."""
    placed = np.isfinite(x)
    if not placed.any():
        return np.empty((4, 0))
    x = np.interp(np.arange(len(x)), np.flatnonzero(placed), x[placed])
    columns, known = _columns(x), np.isfinite(y) & placed
    used = np.unique(columns)
    drawn = np.full((4, COLUMNS), np.nan)
    drawn[0, used] = x.min() + (used + 0.5) * np.ptp(x) / COLUMNS
    if known.any():
        columns, y = columns[known], y[known]
        low, high = _ends(columns, y)
        drawn[1:, columns[low]] = np.bincount(columns, y)[columns[low]] / np.bincount(columns)[columns[low]], y[low], y[high]
    return drawn[:, used]


def interrupted(parts):
    """Columns (k, n) of several parts in sequence, with a gap (NaN) between them: no line connects the end of one with the
    begin of the next."""
    pieces = [np.array(part, float) for part in parts]
    gap = np.full((len(pieces[0]), 1), np.nan)
    return np.concatenate([column for piece in pieces for column in (piece, gap)][:-1], axis=1)


def draw_history(axis, x, y, results, style="-", **properties):
    """Draws one value per result over x, with a gap between the loops of the recording. Where the results are many more than
    the pixels of the picture, the mean of those in each column is a line, and their lowest and highest one bound a range."""
    parts = loops(results.stamp)
    if len(x) <= MAX_POINTS:
        axis.plot(*interrupted([(x[part], y[part]) for part in parts]), style, **properties)
        return
    place, mean, low, high = interrupted([ranges(x[part], y[part]) for part in parts])
    line, = axis.plot(place, mean, style, **{**properties, "linewidth": MEAN_WIDTH})
    axis.fill_between(place, low, high, color=line.get_color(), alpha=SHADE, linewidth=0.5, zorder=line.get_zorder() - 0.1)


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
