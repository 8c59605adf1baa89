# SPDX-License-Identifier: BSD-3-Clause
"""States of a wheelset as a table: one row per instant; the titles of the columns contain the units."""
import csv
import decimal
import math
import re

from ..command import Failure
from .state import State

UNITS = {
    "time": {"s": 1.0, "ms": 1e-3},
    "length": {"m": 1.0, "mm": 1e-3, "um": 1e-6},
    "angle": {"rad": 1.0, "mrad": 1e-3, "deg": math.pi / 180},
    "force": {"N": 1.0, "kN": 1e3},
    "torque": {"N m": 1.0, "Nm": 1.0, "kN m": 1e3, "kNm": 1e3},
}
# Name in the table -> (field of a State, kind of unit, sign in railway axes: x forward, y right, z down).
COLUMNS = {
    "x": ("x", "length", 1), "y": ("y", "length", -1), "z": ("z", "length", -1),
    "roll": ("roll", "angle", 1), "yaw": ("yaw", "angle", -1),
    "force_z": ("force_z", "force", -1), "torque_x": ("torque_x", "torque", 1),
    # On the rail, outward positive in both systems of axes.
    "Y_left": ("left_lateral_force", "force", 1), "Y_right": ("right_lateral_force", "force", 1),
    # Of the rail: lateral and roll outward positive in both systems of axes.
    "rail_lateral_left": ("left_rail_lateral", "length", 1), "rail_lateral_right": ("right_rail_lateral", "length", 1),
    "rail_vertical_left": ("left_rail_vertical", "length", -1), "rail_vertical_right": ("right_rail_vertical", "length", -1),
    "rail_roll_left": ("left_rail_roll", "angle", 1), "rail_roll_right": ("right_rail_roll", "angle", 1),
    "distance": ("distance", "length", 1),
}
WHEEL_LOADS = {"Q_left": "force", "Q_right": "force"}  # down positive in both systems of axes
REQUIRED = ("time", "y")
AXES = ("rep103", "railway")
TITLE = re.compile(r"\s*(\w+)\s*\[\s*([\w ]+?)\s*\]\s*")


def _delimiter(line):
    return max(",;\t", key=line.count)


class _Column:
    """A column of the table: its index, name and unit, and the factor from this unit to SI."""

    def __init__(self, index, title):
        match = TITLE.fullmatch(title)
        if not match:
            raise Failure(f"column '{title.strip()}': must be a name with its unit, for example 'y [mm]'")
        self.index, self.name, self.unit = index, match.group(1), match.group(2)
        kind = "time" if self.name == "time" else WHEEL_LOADS.get(self.name) or COLUMNS.get(self.name, (0, None))[1]
        if not kind:
            known = ", ".join(["time", *COLUMNS, *WHEEL_LOADS])
            raise Failure(f"column '{self.name}': unknown quantity; valid names are {known}")
        if self.unit not in UNITS[kind]:
            raise Failure(f"column '{self.name}': unknown unit '{self.unit}'; valid units are {', '.join(UNITS[kind])}")
        self.factor = UNITS[kind][self.unit]

    def value(self, row):
        text = row[self.index] if self.index < len(row) else ""
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise Failure(f"column '{self.name}': '{text}' is not a finite number")
        return value if self.factor == 1 else value * self.factor

    def nanoseconds(self, row):
        self.value(row)
        scale = decimal.Decimal(10) ** (9 if self.unit == "s" else 6)
        return int((decimal.Decimal(row[self.index].strip()) * scale).to_integral_value())


def _reversed(value):
    """Value along the opposite axis; 0 stays 0 and does not become -0."""
    return 0.0 - value


def _columns(titles):
    columns = {}
    for index, title in enumerate(titles):
        column = _Column(index, title)
        if column.name in columns:
            raise Failure(f"column '{column.name}' is given twice")
        columns[column.name] = column
    for name in REQUIRED:
        if name not in columns:
            raise Failure(f"column '{name}' is missing")
    if ("Q_left" in columns) != ("Q_right" in columns):
        raise Failure("Q_left and Q_right must be given together")
    if "Q_left" in columns and ("force_z" in columns or "torque_x" in columns):
        raise Failure("the load must be given either by force_z and torque_x, or by Q_left and Q_right")
    if "torque_x" in columns and "force_z" not in columns:
        raise Failure("torque_x requires force_z")
    return columns


def _state(columns, row, axes, running_circles, start_ns):
    state = State(columns["time"].nanoseconds(row) + start_ns)
    for name, (field, _, railway_sign) in COLUMNS.items():
        if name in columns:
            value = columns[name].value(row)
            setattr(state, field, _reversed(value) if axes == "railway" and railway_sign < 0 else value)
    if "Q_left" in columns:
        left, right = (columns[name].value(row) for name in ("Q_left", "Q_right"))
        state.force_z = -(left + right)
        state.torque_x = (right - left) * running_circles / 2
    return state


def read_table(path, axes, running_circles, start_ns=0):
    """States of a table.

    @param running_circles distance of the running circles [m], for Q_left and Q_right
    @param start_ns added to the times [ns]
    """
    with open(path, encoding="utf-8-sig", newline="") as file:
        lines = [(number, line) for number, line in enumerate(file, 1) if line.strip() and not line.startswith("#")]
    if not lines:
        raise Failure(f"{path}: empty")
    delimiter = _delimiter(lines[0][1])
    rows = csv.reader((line for _, line in lines), delimiter=delimiter)
    try:
        columns = _columns(next(rows))
    except Failure as error:
        raise Failure(f"{path}: {error}") from None
    states = []
    for (number, _), row in zip(lines[1:], rows):
        try:
            states.append(_state(columns, row, axes, running_circles, start_ns))
            if states[-1].time_ns <= 0:
                raise Failure("time must be above 0, which means unknown in ROS; --start 1 adds one second")
            if len(states) > 1 and states[-1].time_ns <= states[-2].time_ns:
                raise Failure("time must increase")
        except Failure as error:
            raise Failure(f"{path}:{number}: {error}") from None
    return states


def write_table(path, states, axes):
    """Writes states in SI units. A column is omitted if no state has a value for it."""
    si_unit = {kind: next(iter(units)) for kind, units in UNITS.items()}
    columns = {name: column for name, column in COLUMNS.items()
               if any(getattr(state, column[0]) is not None for state in states)}
    with open(path, "x", encoding="utf-8", newline="") as file:
        file.write(f"# axes: {axes}\n")
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["time [s]", *(f"{name} [{si_unit[kind]}]" for name, (_, kind, _) in columns.items())])
        for state in states:
            cells = [f"{state.time_ns // 10**9}.{state.time_ns % 10**9:09d}"]
            for field, _, railway_sign in columns.values():
                value = getattr(state, field)
                if value is not None and axes == "railway" and railway_sign < 0:
                    value = _reversed(value)
                cells.append("" if value is None else repr(value))
            table.writerow(cells)
