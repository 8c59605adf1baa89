# SPDX-License-Identifier: BSD-3-Clause
"""States of a wheelset as a table: one row per instant; the titles of the columns contain the units."""
import csv
import re
from dataclasses import dataclass, field
from typing import Dict, Optional

from ..command import Failure, calculating, load_doubt, native
from ..progress import no_progress
from .columns import COLUMNS, check_columns, columns_of
from .rows import Rows, reversed_value
from .running_circles import RunningCircles
from .titles import titles_of
from .units import units_of

AXES = ("rep103", "railway")
AXES_COMMENT = re.compile(r"\s*axes:\s*(.*?)\s*")


@dataclass
class Reading:
    """How a table is read."""
    axes: Optional[str] = None             # one of AXES; None: those of its line "# axes: ...", or rep103
    named: Dict[str, str] = field(default_factory=dict)  # quantity -> title of its column in the file
    decimal_comma: bool = False            # numbers have a decimal comma, even if it may separate thousands
    start: Optional[float] = None          # [s] added to the times; None: whole seconds, if the first time is not above 0
    speed: Optional[float] = None          # [m/s] for a table without time: time = distance / speed
    running_circles: RunningCircles = RunningCircles()


def _axes_of(table, wanted):
    """Axes of a table.

    @throw Failure if its comment names other axes than the wanted ones
    """
    noted = next((match.group(1) for match in map(AXES_COMMENT.fullmatch, table.comments) if match), None)
    if noted and (noted not in AXES or wanted not in (None, noted)):
        raise Failure(f"{table.path}: its line '# axes: {noted}' contradicts --axes {wanted or ' or '.join(AXES)}")
    return wanted or noted or AXES[0]


def _remarks(table, above, ignored, columns):
    """Yields a sentence for each part of the file that is not used, and if there is no load."""
    for row in above:
        yield f"line {row.line}, above the titles, is ignored: {' '.join(row.cells)}"
    unused = f"ignored columns: {', '.join(title.shown for title in ignored)}" if ignored else ""
    no_load = "" if "force_z" in columns or "Q_left" in columns else "no load was found (force_z, or Q_left and Q_right)"
    if unused or no_load:
        yield "; ".join(filter(None, (unused, no_load)))


def read_table(path, reading, progress=no_progress):
    """States of a table.

    @param reading a Reading
    @return States, remarks for the user, and the number of rows that were dropped
    @throw Failure
    """
    with calculating():
        return _states_of(native().CellTable(str(path)), reading, progress)


def _states_of(table, reading, progress):
    axes = _axes_of(table, reading.axes)
    titles, above = titles_of(table)
    first = next(iter(table), None)
    titles = [title for title in titles if title.text or (first and first.cells[title.index])]
    try:
        columns, ignored = columns_of(titles, reading.named)
        check_columns(columns, titles, reading.speed is not None)
    except Failure as error:
        raise Failure(f"{table.path}: {error}") from None
    remarks = list(_remarks(table, above, ignored, columns))
    distance = 0.0
    if "Q_left" in columns:
        distance, source = reading.running_circles.distance()
        remarks.append(f"distance of the running circles: {distance:.9g} m ({source})")
    rows = Rows(table, columns, reading, axes == "railway", distance)
    states = rows.states(progress)
    if "Q_left" in columns:
        mean = -0.5 * sum(state.force_z for state in states) / len(states)
        remarks += filter(None, [load_doubt(mean, reading.running_circles.configs)])
    return states, remarks + rows.remarks, rows.dropped


def write_table(path, states, axes):
    """Writes states in SI units. A column is omitted if no state has a value for it."""
    si_unit = {kind: next(iter(units_of(kind))) for _, kind, _ in COLUMNS.values()}
    columns = {name: column for name, column in COLUMNS.items()
               if any(getattr(state, column[0]) is not None for state in states)}
    with open(path, "x", encoding="utf-8", newline="") as file:
        file.write(f"# axes: {axes}\n")
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["time [s]", *(f"{name} [{si_unit[kind]}]" for name, (_, kind, _) in columns.items())])
        for state in states:
            cells = [f"{state.time_ns // 10**9}.{state.time_ns % 10**9:09d}"]
            for name, _, railway_sign in columns.values():
                value = getattr(state, name)
                if value is not None and axes == "railway" and railway_sign < 0:
                    value = reversed_value(value)
                cells.append("" if value is None else repr(value))
            table.writerow(cells)
