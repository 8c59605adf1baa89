# SPDX-License-Identifier: BSD-3-Clause
"""The cases of the paper: the displacements of both rails, solved with the wheelset balanced."""
from dataclasses import dataclass

import numpy as np

from ..command import Failure
from ..core.one_wheel import OneWheel
from .case import (DISPLACEMENT, LOAD, NO_FIGURES, POSITION, PRINTED_WITH, PRINTED_WITHOUT, TURN, INCLINATION, contact,
                   crown_displaced, deviation, left_figures, left_patches)

DRAWING_STEP = 2e-4  # distance of the points along a profile [m]
CELLS = (32, 64)     # of the wheel that is drawn: any


@dataclass
class Case:
    """A displacement of both rails.

    crown      (lateral, vertical, roll) of the crowns [m, m, rad]; None: computed, for the rail of config/rails/paper.yaml
               under the printed lateral force and the wheel load
    printed    figures of the paper
    reference  of the program CONTACT (Vollebregt and Kalker, version of July 2025), at roll 0
    """
    name: str
    crown: tuple
    printed: tuple
    reference: tuple = NO_FIGURES


CASES = (Case("without", (0.0, 0.0, 0.0), PRINTED_WITHOUT, (1175.0e6, 187.2e-6)),
         Case("shifted", (DISPLACEMENT, 0.0, 0.0), PRINTED_WITH, (1097e6, 190e-6)),
         Case("turned", (DISPLACEMENT, 0.0, TURN), PRINTED_WITH, (1347e6, 129.6e-6)),  # agrees with the printed figures
         Case("own_rail", None, PRINTED_WITH))


@dataclass
class Placement:
    """A solved case: the left wheel, which runs towards its flange.

    deflection  (lateral, vertical, roll) of the left rail head, at its reference point [m, m, rad]
    roll        of the balanced wheelset [rad]
    balanced    figures of the left wheel
    patches     of the left wheel: list of PatchResult
    rail        outline, (n, 2) y and z [m]
    wheel       outline at first touch, the same
    touch       y and z of the first touch [m]
    """
    case: Case
    deflection: tuple
    roll: float
    balanced: tuple
    patches: list
    rail: np.ndarray
    wheel: np.ndarray
    touch: np.ndarray

    def row(self, level):
        """Row of figures.csv. level: figures at roll 0."""
        case = self.case
        row = {"case": case.name}
        for prefix, figures in (("", self.balanced), ("level_", level), ("reference_", case.reference),
                                ("printed_", case.printed)):
            row[prefix + "max_pressure"], row[prefix + "area"] = figures
        return {**row, "deviation": deviation(self.balanced, case.printed), "wheelset_roll": self.roll,
                **dict(zip(("rail_lateral", "rail_vertical", "rail_roll"), self.deflection))}


def solve(case, *changes):
    """Placement of a case. changes: of config/paper.yaml. Raises Failure if there is no solution."""
    if case.crown is not None:
        prescribed = dict(zip(("lateral", "vertical", "roll"), crown_displaced(*case.crown)))
        changes += ({"rail_bending": {"model": "prescribed", "prescribed": prescribed}},)
    wheelset = contact(*changes)
    many = wheelset.evaluate_many(y=POSITION, force_z=-2 * LOAD, results=True)
    result = many.results[0]
    if result.status != "OK":
        raise Failure(f"case {case.name}: {result.status_text}")
    deflection = tuple(each[0, 0] for each in (many.rail_lateral, many.rail_vertical, many.rail_roll))
    return Placement(case, deflection, result.wheelset.roll, left_figures(result), left_patches(result),
                     *_outlines(OneWheel(wheelset, CELLS), deflection, result.wheelset.roll))


def _outlines(wheel, deflection, roll):
    wheel.set_rail(INCLINATION, *deflection)
    touch = wheel.rail_at([wheel.touch(POSITION, roll)])[0, :2]
    rail, outline = (at(np.arange(0, length, DRAWING_STEP)) for at, length in (
        (wheel.rail_at, wheel.rail_length), (wheel.wheel_at, wheel.wheel_length)))
    return rail[:, :2], outline[~np.isnan(outline[:, 0])], touch
