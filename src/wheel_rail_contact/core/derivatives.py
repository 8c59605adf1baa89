# SPDX-License-Identifier: BSD-3-Clause
"""Derivatives of a result as matrices with the names of their rows and columns: of Python, and of messages."""
import numpy as np

FORCES = ("force_x", "force_y", "force_z", "torque_x", "torque_y", "torque_z")
POSITIONS = ("y", "z", "roll", "yaw")
VELOCITIES = ("speed", "lateral_velocity", "vertical_velocity", "roll_rate", "yaw_rate", "rotation")
SOLUTION = ("z", "roll", "left_vertical_force", "left_lateral_force", "right_vertical_force", "right_lateral_force")
INPUTS = ("y", "yaw", "force_z", "torque_x")
INPUT_VELOCITIES = ("speed", "lateral_velocity", "yaw_rate", "rotation")


class NamedMatrix(np.ndarray):
    """Matrix with names of its `rows` and `columns`. They are also indices, alone or in lists: m["force_y", ["y", "yaw"]]."""

    rows, columns = (), ()

    def __getitem__(self, index):
        if not _has_names(index):
            return np.asarray(self)[index]
        row, column = index if isinstance(index, tuple) and len(index) == 2 else (index, slice(None))
        return np.asarray(self)[_places(row, self.rows)][..., _places(column, self.columns)]


class Derivatives:
    """Derivatives of a result, as in the message ContactDerivatives. Without contact/derivatives, both matrices are (6, 0).

    forces: (6, n) NamedMatrix with height and roll given. Rows: FORCES, of both rails on the wheelset; columns: POSITIONS of
        the axle, then with creep/method VELOCITIES
    solution: (6, n) NamedMatrix, if height and roll are solved. Rows: SOLUTION; columns: INPUTS, then INPUT_VELOCITIES

    An entry is NaN where the derivative does not exist; status_text then has the reason.
    """

    def __init__(self, forces, solution):
        """Entries of both matrices, row by row."""
        self.forces = _named(forces, FORCES, POSITIONS + VELOCITIES)
        self.solution = _named(solution, SOLUTION, INPUTS + INPUT_VELOCITIES)

    def __repr__(self):
        return f"<Derivatives: forces {self.forces.shape}, solution {self.solution.shape}>"


def named_derivatives(message):
    """Derivatives of a message ContactDerivatives. Raises ValueError for a wrong number of entries."""
    return Derivatives(message.forces, message.solution)


def _named(entries, rows, columns):
    """Read-only NamedMatrix of entries, with as many of the columns as there are."""
    matrix = np.array(entries, dtype=float).reshape(len(rows), -1).view(NamedMatrix)
    count = matrix.shape[1]
    if count > len(columns):
        raise ValueError(f"derivatives: have {matrix.size} entries, but at most {len(rows)} times {len(columns)}")
    matrix.rows, matrix.columns = (rows, columns[:count]) if count else ((), ())
    matrix.flags.writeable = False
    return matrix


def _has_names(index):
    return isinstance(index, str) or isinstance(index, (tuple, list)) and any(map(_has_names, index))


def _places(index, names):
    """An index of an array for names of an axis."""
    if isinstance(index, str):
        if index not in names:
            raise KeyError(f"{index!r} is none of {', '.join(names) or 'the names, because there are no derivatives'}")
        return names.index(index)
    return [_places(name, names) for name in index] if _has_names(index) else index
