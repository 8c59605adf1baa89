# SPDX-License-Identifier: BSD-3-Clause
"""Left wheel on rails that bend under a lateral force (outward, the same on both rails) and the wheel load."""
import numpy as np

from ..command import shipped
from ..core.one_wheel import OneWheel, roll_to_balance
from ..core.profiles import read_compliance_table
from .case import INCLINATION, LOAD, NO_FIGURES, PRINTED_WITH, REFERENCE_DEPTH, contact, deviation

CELLS = (32, 64)


class Rail:
    """A rail of the package with its compliance table.

    name   of config/rails/NAME.yaml
    table  ComplianceTable
    """

    def __init__(self, name):
        self.name, self._file = name, str(shipped(f"config/rails/{name}.yaml"))
        self.table = read_compliance_table(self._file)

    def is_in_range(self, force):
        """Whether a lateral force [N] is in the range of the table, with the printed wheel load."""
        return abs(force) <= self.table.linear_range * LOAD

    def evaluate(self, positions, forces, results=False):
        """ManyResults of the wheelset, coupled with the rails, at each position [m] under each lateral force [N]: the forces
        run faster."""
        wheelset = contact({"rail_bending": {"model": "compliance", "table": self._file, "lateral_force": "topic"},
                            "contact": {"method": "conjugate_gradient", "grid": dict(zip(("along", "across"), CELLS))}})
        y, force = (grid.ravel() for grid in np.meshgrid(positions, forces, indexing="ij"))
        return wheelset.evaluate_many(y=y, force_z=-2 * LOAD, rail_lateral_force=np.column_stack([force, force]),
                                      results=results)

    def whole_deflection(self, positions, forces):
        """Rows of forces.csv with the complete deflection of the table."""
        many = self.evaluate(positions, forces)
        left = [each[:, 0] for each in (many.rail_lateral, many.rail_vertical, many.rail_roll, many.max_pressure, many.area)]
        numbers = np.nan_to_num(np.column_stack(left))  # 0 without a solution
        places = [(y, force) for y in positions for force in forces]
        return [self._row("whole", *place, of_place[:3], of_place[3:]) for place, of_place in zip(places, numbers)]

    def part_of_deflection(self, share, y, forces):
        """Rows of forces.csv with a part of the deflection, which is known before the solution.

        share: without_moment (without the roll by the eccentric wheel load), or shift_only (lateral displacement by the lateral
            force only: no roll, no effect of the wheel load)
        """
        wheelset = contact()
        left, right = OneWheel(wheelset, CELLS), OneWheel(wheelset, CELLS)
        rows = []
        for force in forces:
            moved = self._displacement(share, force)
            for wheel in (left, right):
                wheel.set_rail(INCLINATION, *moved)
            solved = roll_to_balance(left, right, y, LOAD) is not None
            rows.append(self._row(share, y, force, moved, left.figures if solved else NO_FIGURES))
        return rows

    def _displacement(self, share, force):
        """In the track, from the table of the upright rail, for a lateral force at the height of the crown."""
        moment = force * REFERENCE_DEPTH
        if share == "shift_only":
            return self.table.displacement(force, 0.0, moment, INCLINATION).lateral, 0.0, 0.0
        moved = self.table.displacement(force, LOAD, moment, INCLINATION)
        return moved.lateral, moved.vertical, moved.roll

    def _row(self, share, y, force, moved, figures):
        return {"table": self.name, "share": share, "y": y, "lateral_force": force, "in_range": self.is_in_range(force),
                "rail_lateral": moved[0], "rail_vertical": moved[1], "rail_roll": moved[2], "max_pressure": figures[0],
                "area": figures[1], "deviation_with": deviation(figures, PRINTED_WITH)}
