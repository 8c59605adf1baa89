# SPDX-License-Identifier: BSD-3-Clause
"""The left wheel on its rail, alone: for studies in which its position, its roll and its load are given."""
from .extension import core

CLOSE = 1e-3             # of the gap to its final height, over the overlap of the bodies: a solution is accepted [-]
MOST_ROLL_STEPS = 20
HEIGHT_DIFFERENCE = 1e-9  # allowed difference of the axle heights of both wheels [m]


class OneWheel(core.OneWheel):
    """The left wheel of a wheelset without yaw. Track frame; the field side is to the left.

    An object belongs to one thread at a time. Other threads run during solve().

    patches         of the solution: list of dict with max_pressure [Pa], area [m²], pressure (rows, columns) of the cells with
                    x > 0 [Pa], their dx and dy [m], and cell_area with that of the image at -x [m²]
    iterations      sweeps of the method, or products with the influence matrix
    modulus         contact modulus [Pa]
    height          of the axle centre [m]
    vertical_force  of the rail on the wheel, up positive [N]
    height_per_roll change of the height by roll under the same load [m/rad]
    contacts        separate contacts of the solution: list of dict with first_u, last_u (parameters of the rail profile at the
                    outer loaded columns), wheel_u (of the wheel profile at the first), half_length [m], half_space_ratio [-],
                    turned (displacements are projected onto turned normals)
    rail_length, wheel_length  largest parameters of the profiles [m]
    """

    def __init__(self, contact, cells, method="conjugate_gradient", stop=1e-4):
        """contact: WheelsetContact with the parameters
        cells: numbers of cells along and across the track
        method: conjugate_gradient, seidel or seidel_printed
        stop: residual (seidel_printed: change of the pressure) at which the method stops [-]
        """
        super().__init__(contact._model, *cells, method, stop)  # pylint: disable=protected-access

    def solve(self, y, roll, load, close=CLOSE):
        """Solves the contact from a cold start. Returns False if there is no solution.

        y: lateral position of the wheelset, towards the flange of this wheel positive [m]
        roll: of the wheelset, this wheel up positive [rad]
        load: vertical load of this wheel [N]
        """
        return super().solve(y, roll, load, close)

    @property
    def figures(self):
        """Highest pressure [Pa] and area [m²] of the solution."""
        patches = self.patches
        return max(patch["max_pressure"] for patch in patches), sum(patch["area"] for patch in patches)


def roll_to_balance(first, second, y, load):
    """Finds the roll at which both wheels of a wheelset carry `load` [N] at one height of the axle, on rails that are held.

    first, second: OneWheel
    y: lateral position, towards the flange of `first` positive [m]

    Returns the roll, `first` up positive [rad]; then both have their solutions. None if there is no solution.
    """
    roll = 0.0
    for _ in range(MOST_ROLL_STEPS):
        if not (first.solve(y, roll, load) and second.solve(-y, -roll, load)):
            return None
        difference = first.height - second.height
        if abs(difference) < HEIGHT_DIFFERENCE:
            return roll
        roll -= difference / (first.height_per_roll + second.height_per_roll)  # Newton step
    return None
