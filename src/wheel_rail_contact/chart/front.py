# SPDX-License-Identifier: BSD-3-Clause
"""Which of many (time, error) are best, and how auto stands among them."""
import math
from dataclasses import dataclass
from statistics import median

from .table import Row

SCATTER = 1.1  # times of equal work agree within this factor


def pareto(points):
    """Those of (time, error) that no other one beats in both, by rising time."""
    best, front = math.inf, []
    for time, error in sorted(points):
        if error < best:
            front.append((time, error))
            best = error
    return front


def geometric_median(values):
    """Median on the logarithmic scale; infinite if a middle value is."""
    ordered = sorted(values)
    middle = ordered[(len(ordered) - 1) // 2:len(ordered) // 2 + 1]
    return math.exp(sum(map(math.log, middle)) / len(middle))


def over_scenes(rows):
    """{(method, rung): (median time, median error, answered, scenes)}; a scene without answer counts as the largest
    error."""
    groups = {}
    for row in rows:
        groups.setdefault((row.method, row.rung), []).append(row)
    return {key: (geometric_median([row.time for row in group]),
                  geometric_median([row.error if row.answered else math.inf for row in group]),
                  sum(row.answered for row in group), len(group))
            for key, group in groups.items()}


def fixed_time(rows, row: Row, error):
    """Least time of a fixed method in the scene of `row` whose error is at most `error`; infinite if there is none."""
    return min((other.time for other in rows if other.scene == row.scene and other.method != "auto"
                and other.answered and other.error <= error), default=math.inf)


@dataclass(frozen=True)
class Standing:
    """How auto stands at one tolerance."""

    tolerance: float
    scenes: int
    met: int  # scenes in which its error is within the tolerance
    ratio: float  # of its time to that of the cheapest fixed method that meets the tolerance, median where there is one
    largest_ratio: float
    on_front: int  # scenes in which no fixed method as exact as auto is faster


def standing(rows):
    """One Standing for each tolerance."""
    table = []
    for tolerance in sorted({row.tolerance for row in rows if row.method == "auto"}, reverse=True):
        autos = [row for row in rows if row.method == "auto" and row.tolerance == tolerance]
        good = [row for row in autos if row.answered]
        ratios = [row.time / time for row in good if (time := fixed_time(rows, row, tolerance)) < math.inf]
        on_front = sum(row.time <= SCATTER * fixed_time(rows, row, row.error) for row in good)
        table.append(Standing(tolerance, len(autos), sum(row.error <= tolerance for row in good),
                              median(ratios) if ratios else math.nan, max(ratios, default=math.nan), on_front))
    return table
