# SPDX-License-Identifier: BSD-3-Clause
"""Verdict on the quantities of wheels and axle: violated limits, and what was not compared."""
import math

import numpy as np

from ..message_constants import SIDES
from .axle import OF_Y, OVER_WAY, QUANTITIES
from .parameters import broken

NO_FRICTION = "Y contains no friction, because the results have no creep forces (creep/method)"


def violation(name, limits, history):
    """Violation of the limit of a quantity, as text; empty if there is none. A limit without any value is violated."""
    low, high = limits.bounds[name]
    symbol, unit = QUANTITIES[name]
    values = history.values[name]
    found = [(max(low - values[row, column], values[row, column] - high), row, column)
             for column in range(values.shape[1]) for row in _extremes(values[:, column], limits.percentile)]
    if not found:
        return f"{symbol} has no value: {'; '.join(remarks(limits, history)) or 'there are no results'}"
    excess, row, column = max(found)
    if excess <= 0:
        return ""
    outside, known = ((values < low) | (values > high)).sum(), np.isfinite(values).sum()
    which = "this is the worst" if limits.percentile == 100 else f"this is the percentile of {limits.percentile:g} %"
    wheel = f", {SIDES[column]} wheel" if values.shape[1] == 2 else ""
    return (f"{broken(symbol, values[row, column], low, high, unit)} at {history.stamps[row]:.3f} s{wheel}, "
            f"{_place(limits)} = {history.places[row]:.3f} m ({outside} of {known} values are outside; {which}; "
            f"{treatment(name, limits)}){'; ' + NO_FRICTION if name in OF_Y and not history.friction else ''}")


def _extremes(values, percentile):
    """Results with the values of the lower and the upper percentile, by the nearest rank."""
    known = np.flatnonzero(np.isfinite(values))
    rank = math.ceil(percentile / 100 * len(known)) - 1
    order = known[np.argsort(values[known], kind="stable")]
    return (order[len(order) - 1 - rank], order[rank]) if len(order) else ()


def _place(limits):
    return f"{limits.speed:g} m/s times the time" if limits.place == "time" else limits.place


def treatment(name, limits):
    """How a quantity is filtered, as text."""
    parts = [f"low-pass {limits.low_pass:g} Hz"] if limits.low_pass else []
    if name in OVER_WAY and limits.mean_length:
        parts.append(f"mean over the last {limits.mean_length:g} m of {_place(limits)}")
    return ", ".join(parts) or "not filtered"


def remarks(limits, history):
    """What was not compared, and what Y lacks, as texts."""
    lacks = [NO_FRICTION] if not history.friction and set(OF_Y) & set(limits.bounds) else []
    return [f"{number} {reason}" for reason, number in history.counts.items()] + lacks
