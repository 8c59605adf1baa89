# SPDX-License-Identifier: BSD-3-Clause
"""Rows of a table of states: their times, the rows that are dropped, and the states."""
import decimal
import re

from ..command import Failure, native
from ..progress import shown
from .columns import COLUMNS
from .state import State

SECOND = 10**9                # [ns]
LAST_STAMP = 2**32 * SECOND   # [ns] stamps of ROS have 32 bits for the seconds
LISTED = 5                    # lines in a remark
THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}", re.ASCII)  # 1,250 is 1.25 or 1250


def reversed_value(value):
    """Value along the opposite axis; 0 stays 0 and does not become -0."""
    return 0.0 - value


def _decimal_sign(table, indices, plain_number):
    """Decimal sign of the numbers in the columns with these indices: "." or ",". plain_number: that of the module.

    @throw Failure if both occur, or if the comma may also separate thousands
    """
    example = {}
    table.rewind()
    for row in table:
        for cell in (row.cells[index] for index in indices):
            sign = "," if "," in cell else "."
            if sign in cell and ("sure" not in example or sign not in example) and plain_number(cell):
                example.setdefault(sign, cell)
                if sign == "." or not THOUSANDS.fullmatch(cell):
                    example.setdefault("sure", cell)
    if "." in example and "," in example:
        raise Failure(f"{table.path}: '{example['.']}' has a decimal point and '{example[',']}' a comma; export it with one "
                      "decimal sign and without separators of thousands")
    if "," in example and "sure" not in example:
        raise Failure(f"{table.path}: '{example[',']}' has a decimal comma or a separator of thousands; --decimal-comma selects "
                      "the first, otherwise export it without separators of thousands")
    return "," if "," in example else "."


def _number_text(cell, sign, plain_number):
    """Number of a cell, as float() and decimal.Decimal() read it; "" if the cell is empty, NaN, NA or the like.

    @throw ValueError if the cell contains something else
    """
    if native().is_missing(cell):
        return ""
    text = plain_number(cell.replace("\u2212", "-"))
    if not text or (sign == "." and "," in cell) or (sign == "," and "." in cell):
        raise ValueError(f"'{cell}' is not a finite number with a decimal {'comma' if sign == ',' else 'point'}")
    return re.sub("[dD]", "e", text)


def _value(column, text):
    """Number of a cell in SI units."""
    return float(text) if column.factor == 1 else float(text) * column.factor


def _counted(count, lines, why):
    word = "row was" if count == 1 else "rows were"
    more = ", ..." if len(lines) < count else ""
    return f"{count} {word} dropped, {why} (line{'' if count == 1 else 's'} {', '.join(map(str, lines))}{more})"


def _lines(path):
    with open(path, "rb") as file:
        return sum(part.count(b"\n") for part in iter(lambda: file.read(2**20), b""))


class Dropped:
    """Rows that were dropped for one reason: their number, and the lines of the first ones."""

    def __init__(self, why):
        self.why, self.count, self.lines = why, 0, []

    def add(self, line):
        self.count += 1
        if self.count <= LISTED:
            self.lines.append(line)

    @property
    def remark(self):
        return _counted(self.count, self.lines, self.why)


class Rows:
    """Converts the rows of a table of cells to states.

    remarks  sentences for the user, after states()
    dropped  number of rows that were dropped, after states()
    """

    def __init__(self, table, columns, reading, is_railway, running_circles):
        """
        @param columns          quantity -> Column
        @param reading          Reading of the table
        @param is_railway       the values are in railway axes
        @param running_circles  their distance [m]
        """
        self.remarks, self.dropped = [], 0
        self._table, self._columns, self._reading = table, columns, reading
        self._is_railway, self._running_circles = is_railway, running_circles
        indices = [column.index for column in columns.values()]
        self._plain_number = native().plain_number
        self._sign = "," if reading.decimal_comma else _decimal_sign(table, indices, self._plain_number)

    def states(self, progress):
        """States with increasing times above 0.

        @param progress a Progress
        @throw Failure if a cell is not a number, if times decrease, or if more than half of the rows had to be dropped
        """
        incomplete = Dropped("because a value is missing")
        repeated = Dropped("because the next row has the same time")
        states, total, before = [], 0, None
        self._table.rewind()
        for row in shown(self._table, _lines(self._table.path), progress, "line"):
            total += 1
            line = row.line
            state = self._state(line, row.cells)
            if state is None:
                incomplete.add(line)
                continue
            if states and state.time_ns < states[-1].time_ns:
                raise self._failure(line, f"its time is before that of line {before}; times must not decrease")
            if states and state.time_ns == states[-1].time_ns:
                states.pop()
                repeated.add(before)
            states.append(state)
            before = line
        self._count(total, [kind for kind in (incomplete, repeated) if kind.count])
        self._shift(states)
        return states

    def _failure(self, line, reason):
        return Failure(f"{self._table.path}:{line}: {reason}")

    def _count(self, total, kinds):
        """@throw Failure if there is no row, or if more than half of the rows were dropped"""
        remarks = [kind.remark for kind in kinds]
        self.dropped = sum(kind.count for kind in kinds)
        if not total:
            raise Failure(f"{self._table.path}: has no row with numbers")
        if 2 * self.dropped > total:
            raise Failure(f"{self._table.path}: more than half of the {total} rows are unusable: {'; '.join(remarks)}")
        self.remarks += remarks

    def _shift(self, states):
        """Adds the start to the times, or whole seconds if the first one is not above 0."""
        start = self._reading.start
        if start is not None:
            shift = round(start * SECOND)
        else:
            shift = 0 if states[0].time_ns > 0 else SECOND * (-states[0].time_ns // SECOND + 1)
            if shift:
                self.remarks.append(f"{shift // SECOND} s were added to all times, because a stamp must be above 0 in ROS; "
                                    "--start S selects another addition")
        for state in states:
            state.time_ns += shift
        if states[0].time_ns <= 0:
            raise Failure(f"{self._table.path}: the first time, {states[0].time_ns / SECOND:g} s with --start, is not above 0")
        if states[-1].time_ns >= LAST_STAMP:
            raise Failure(f"{self._table.path}: the last time, {states[-1].time_ns / SECOND:.9g} s, is beyond the last stamp "
                          f"of ROS, {LAST_STAMP // SECOND} s")

    def _state(self, line, cells):
        """State of a row; None if a value is missing."""
        texts = {quantity: self._text(line, column, cells[column.index]) for quantity, column in self._columns.items()}
        if not all(texts.values()):
            return None
        values = {quantity: _value(self._columns[quantity], text) for quantity, text in texts.items()}
        state = State(self._nanoseconds(texts, values))
        for quantity, (field, _, railway_sign) in COLUMNS.items():
            if quantity in values:
                value = values[quantity]
                setattr(state, field, reversed_value(value) if self._is_railway and railway_sign < 0 else value)
        if "Q_left" in values:
            state.force_z = -(values["Q_left"] + values["Q_right"])
            state.torque_x = (values["Q_right"] - values["Q_left"]) * self._running_circles / 2
        return state

    def _text(self, line, column, cell):
        try:
            return _number_text(cell, self._sign, self._plain_number)
        except ValueError as error:
            raise self._failure(line, f"column '{column.title.shown}': {error}") from None

    def _nanoseconds(self, texts, values):
        """Time of a row [ns], exact to the rounding of its last digit."""
        if self._reading.speed is not None:
            return round(values["distance"] / self._reading.speed * SECOND)
        scale = round(self._columns["time"].factor * SECOND)
        return int((decimal.Decimal(texts["time"]) * scale).to_integral_value())
