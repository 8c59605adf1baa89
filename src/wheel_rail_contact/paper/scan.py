# SPDX-License-Identifier: BSD-3-Clause
"""Settings of the wheel that could give the figures of the paper. All solutions use one grid and a cold start."""
import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from ..core.one_wheel import OneWheel, roll_to_balance
from .case import (DISPLACEMENT, INCLINATION, LOAD, NO_FIGURES, PRINTED_WITH, PRINTED_WITHOUT, contact, crown_displaced,
                   deviation, steps)

CELLS = (32, 64)
NEAR_START = 0.03                                      # largest deviation without bending of a start [-]
NEAR_PRINTED = 0.04                                    # the same, of the part "inclination" [-]
REFINED_POSITIONS = steps(-0.1e-3, 0.1e-3, 20)         # around a position of the coarse scan [m]
REFINED_INCLINATIONS = steps(-0.75e-3, 0.75e-3, 6)     # around a pair of the coarse scan [rad]
REFINED_PAIR_POSITIONS = steps(-0.12e-3, 0.12e-3, 8)   # the same [m]
REFINED_TURN = 1e-3                                    # the same [rad]
SINKING = 1e-3                                         # downward displacement in the part "rails" [m]
TOGETHER = 32                                          # rows that a thread solves at a time


@dataclass(frozen=True)
class Ranges:
    """Ranges and steps of the scans. rails: profiles that "UIC60" in the paper may mean. Angles [rad], lengths [m], loads [N]."""
    rails: tuple = ("UIC60_manchester", "60E1")
    inclinations: tuple = (0.0, 1 / 40, 1 / 20)
    loads: tuple = (LOAD, 0.5 * LOAD)
    positions: tuple = steps(-6e-3, 6.4e-3, 124)
    positions_around_start: tuple = steps(-0.06e-3, 0.06e-3, 6)
    pure_shifts: tuple = steps(-5e-3, 4e-3, 180)
    shifts: tuple = (-1e-3, -0.5e-3, -DISPLACEMENT, 0.0, DISPLACEMENT, 0.5e-3, 1e-3)
    turns: tuple = steps(-20e-3, 20e-3, 40)
    free_positions: tuple = steps(-6e-3, 5.2e-3, 28)
    free_turns: tuple = steps(-26e-3, 26e-3, 52)
    rolls: tuple = steps(-1e-3, 1e-3, 20)
    free_inclinations: tuple = steps(14e-3, 50e-3, 36)


def setting(part, rail, inclination, load, y):
    """Row of scan.csv without its results.

    part           see the methods of Scan
    rail           name of the profile
    inclination    of the undeflected rail, towards the track centre [rad]
    load           vertical load of each wheel [N]
    y              lateral position of the wheelset, towards the flange positive [m]
    wheelset_roll  this wheel up positive [rad]
    crown_lateral, crown_vertical, rail_turn    displacement of the crown of this rail [m, m, rad]
    other_crown_lateral, other_crown_vertical   of the other rail, in the part "rails" only [m]
    without_max_pressure, without_area  figures of the undeflected rail at the same position; 0 in a part without pairs
    """
    row = {"part": part, "rail": rail, "inclination": inclination, "load": load, "y": y}
    for name in ("wheelset_roll", "crown_lateral", "crown_vertical", "rail_turn", "other_crown_lateral",
                 "other_crown_vertical", "without_max_pressure", "without_area"):
        row[name] = 0.0
    return row


def _from(start, part, **changes):
    """A row of a part that searches for pairs: the figures of `start` are those without bending."""
    return {**start, "part": part, "without_max_pressure": start["max_pressure"], "without_area": start["area"], **changes}


def _complete(row, figures):
    row["max_pressure"], row["area"] = figures
    row["deviation_without"] = deviation(figures, PRINTED_WITHOUT)
    row["deviation_with"] = deviation(figures, PRINTED_WITH)
    row["deviation_pair"] = max(deviation((row["without_max_pressure"], row["without_area"]), PRINTED_WITHOUT),
                                row["deviation_with"])


def _turned(row, turns):
    """Rows with the rail displaced as printed, and turned."""
    return [_from(row, row["part"], crown_lateral=DISPLACEMENT, rail_turn=turn) for turn in turns]


class Scan:
    """Runs the parts of the scan. Each returns its rows."""

    def __init__(self, ranges=Ranges()):
        self.ranges = ranges
        self._contacts = {rail: contact({"rail": {"profile": rail}}) for rail in ranges.rails}
        self._free = []  # wheels by the name of the rail, which no thread uses

    def start(self):
        """Settings for the results without bending: rail profiles, inclinations, loads, positions."""
        ranges = self.ranges
        return self._solved([setting("start", rail, inclination, load, y) for rail in ranges.rails
                             for inclination in ranges.inclinations for load in ranges.loads for y in ranges.positions])

    def nearest_starts(self, rows, limit=NEAR_START):
        """From rows of the part "start" at the printed load: for each rail profile and inclination, the row closest to the
        printed results without bending, if its deviation is below `limit` [-]. Sorted by the deviation. Positions are refined
        to 0.01 mm."""
        nearest = []
        for rail in self.ranges.rails:
            for inclination in self.ranges.inclinations:
                best = min((row for row in rows if (row["rail"], row["inclination"], row["load"]) == (rail, inclination, LOAD)),
                           key=_start_deviation)
                if _start_deviation(best) <= 2 * limit:
                    refined = self._solved([{**best, "y": best["y"] + offset} for offset in REFINED_POSITIONS])
                    nearest.append(min([best, *refined], key=_start_deviation))
        return sorted((row for row in nearest if _start_deviation(row) < limit), key=_start_deviation)

    def shift(self, start):
        """From a start, the rail displaced laterally only."""
        return self._solved([_from(start, "shift", crown_lateral=lateral) for lateral in self.ranges.pure_shifts])

    def pair(self, start):
        """At positions around a start, the rail displaced and turned about its crown."""
        around = self._solved([{**start, "y": start["y"] + offset} for offset in self.ranges.positions_around_start])
        return self._solved([_from(row, "pair", crown_lateral=shift, rail_turn=turn) for row in around
                             for shift in self.ranges.shifts for turn in self.ranges.turns])

    def inclination(self, rail):
        """All inclinations and positions whose results without bending are close to the printed ones. The rail is displaced
        outward as printed, and turned. Refined around the best pairs with an inward and an outward turn."""
        ranges = self.ranges
        rows = self._pairs([(inclination, y, ranges.turns) for inclination in ranges.free_inclinations
                            for y in ranges.positions], rail)
        for direction in (-1, 1):
            turned = [row for row in rows if direction * row["rail_turn"] > 0]
            if turned:
                best = min(turned, key=lambda row: row["deviation_pair"])
                turns = steps(best["rail_turn"] - REFINED_TURN, best["rail_turn"] + REFINED_TURN, 8)
                rows += self._pairs([(best["inclination"] + change, best["y"] + offset, turns)
                                     for change in REFINED_INCLINATIONS for offset in REFINED_PAIR_POSITIONS], rail)
        return rows

    def _pairs(self, places, rail):
        """places: inclination, position, and turns of the rail there."""
        bases = self._solved([setting("inclination", rail, inclination, LOAD, y) for inclination, y, _ in places])
        return self._solved([row for base, (_, _, turns) in zip(bases, places) if _start_deviation(base) <= NEAR_PRINTED
                             for row in _turned(base, turns)])

    def alone(self, rail):
        """Settings for the results with bending only: all positions, all turns of the rail."""
        return self._solved([{**setting("alone", rail, INCLINATION, LOAD, y), "rail_turn": turn}
                             for y in self.ranges.free_positions for turn in self.ranges.free_turns])

    def roll(self, start):
        """From a start, the wheelset rolled, and the rail displaced by the printed amount outward, inward or not at all."""
        return self._solved([_from(start, "roll", crown_lateral=shift, wheelset_roll=roll)
                             for shift in (-DISPLACEMENT, 0.0, DISPLACEMENT) for roll in self.ranges.rolls])

    def rails(self, start):
        """From a start, the wheelset balanced on two rails with different displacements."""
        wheel, other = (self._wheel(start["rail"]) for _ in range(2))
        displacements = ((0.0, 0.0), (DISPLACEMENT, 0.0), (-DISPLACEMENT, 0.0), (0.0, -SINKING))
        rows = []
        for own in displacements:
            for others in displacements:
                row = _from(start, "rails", crown_lateral=own[0], crown_vertical=own[1], other_crown_lateral=others[0],
                            other_crown_vertical=others[1])
                for each, crown in ((wheel, own), (other, others)):
                    each.set_rail(row["inclination"], *crown_displaced(*crown, 0.0, row["inclination"]))
                roll = roll_to_balance(wheel, other, row["y"], row["load"])
                row["wheelset_roll"] = roll or 0.0
                _complete(row, NO_FIGURES if roll is None else wheel.figures)
                rows.append(row)
        return rows

    def _wheel(self, rail):
        return OneWheel(self._contacts[rail], CELLS)

    def _solved(self, rows):
        """Adds the results of rows, on all processor cores, and returns them."""
        with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
            list(pool.map(self._solve, [rows[i:i + TOGETHER] for i in range(0, len(rows), TOGETHER)]))
        return rows

    def _solve(self, rows):
        try:
            wheels = self._free.pop()
        except IndexError:
            wheels = {rail: self._wheel(rail) for rail in self.ranges.rails}
        for row in rows:
            wheel, inclination = wheels[row["rail"]], row["inclination"]
            crown = (row["crown_lateral"], row["crown_vertical"], row["rail_turn"])
            wheel.set_rail(inclination, *crown_displaced(*crown, inclination))
            _complete(row, wheel.figures if wheel.solve(row["y"], row["wheelset_roll"], row["load"]) else NO_FIGURES)
        self._free.append(wheels)


def _start_deviation(row):
    return row["deviation_without"]
