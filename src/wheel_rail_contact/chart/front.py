# SPDX-License-Identifier: BSD-3-Clause
"""Pareto front of points (time, error), medians over scenes, and comparison of auto with the fixed methods."""
import math
from dataclasses import dataclass
from statistics import median

from .table import Row

SCATTER = 1.1  # measured times of equal work agree within this factor


def pareto(points):
    """The points (time, error) that no other point beats in both, by rising time."""
    best, front = math.inf, []
    for time, error in sorted(points):
        if error < best:
            front.append((time, error))
            best = error
    return front


def geometric_median(values):
    """Median on the logarithmic scale; infinite if a middle value is infinite."""
    ordered = sorted(values)
    middle = ordered[(len(ordered) - 1) // 2:len(ordered) // 2 + 1]
    return math.exp(sum(map(math.log, middle)) / len(middle))


def over_scenes(rows):
    """{(method, setting): (median time [s], median error [-])}; a missing result counts as an infinite error."""
    groups = {}
    for row in rows:
        groups.setdefault((row.method, row.setting), []).append(row)
    return {key: (geometric_median([row.time for row in group]),
                  geometric_median([row.error if row.has_result else math.inf for row in group]))
            for key, group in groups.items()}


def longest_times(rows):
    """{(method, setting): longest time of a state in any scene [s]}, at least the median time of the scene."""
    longest = {}
    for row in rows:
        key = row.method, row.setting
        longest[key] = max(row.time, row.time_longest or 0, longest.get(key, 0))
    return longest


def fixed_time(rows, row: Row, error):
    """Least time of a fixed method in the scene of `row` with at most this error; infinite if there is none."""
    return min((other.time for other in rows if other.scene == row.scene and other.method != "auto"
                and other.has_result and other.error <= error), default=math.inf)


@dataclass(frozen=True)
class Comparison:
    """auto at one tolerance, compared with the fixed methods."""

    tolerance: float
    scenes: int
    met: int  # scenes in which the error of auto is within the tolerance
    # Time of auto over that of the fastest fixed method that meets the tolerance, over the scenes with such a method:
    ratio: float  # median
    largest_ratio: float
    on_front: int  # scenes in which no fixed method with at most the error of auto is faster


def compare_auto(rows):
    """One Comparison for each tolerance."""
    table = []
    for tolerance in sorted({row.tolerance for row in rows if row.method == "auto"}, reverse=True):
        autos = [row for row in rows if row.method == "auto" and row.tolerance == tolerance]
        solved = [row for row in autos if row.has_result]
        ratios = [row.time / time for row in solved if (time := fixed_time(rows, row, tolerance)) < math.inf]
        on_front = sum(row.time <= SCATTER * fixed_time(rows, row, row.error) for row in solved)
        table.append(Comparison(tolerance, len(autos), sum(row.error <= tolerance for row in solved),
                                median(ratios) if ratios else math.nan, max(ratios, default=math.nan), on_front))
    return table


def compare_medians(rows):
    """For each tolerance of auto: its median time over that of the fastest fixed setting of at most its median error."""
    medians = over_scenes(rows)
    fixed = [point for (method, _), point in medians.items() if method != "auto"]
    autos = sorted(((setting, point) for (method, setting), point in medians.items() if method == "auto"), reverse=True)
    return [(tolerance, time / min((other for other, own in fixed if own <= error), default=math.nan))
            for tolerance, (time, error) in autos]
