# SPDX-License-Identifier: BSD-3-Clause
"""Titles of the columns of a table: name and unit, in the spellings of other programs."""
import re
from dataclasses import dataclass

from ..command import Failure
from .units import unit_of

LONGEST = 1000  # characters of a title with a unit; the time of the search grows with the square
IN_BRACKETS = re.compile(r"(.*?)\s*\[([^\[\]]*)\]")
# Other spellings count only if the text is a unit: y(mm), y / mm, y in mm, y_mm.
OTHERS = tuple(re.compile(pattern) for pattern in
               (r"(.*?)\s*\(([^()]*)\)", r"(.*\S)\s*/\s*([^/]+)", r"(.*\S)\s+in\s+(\S.*)", r"(.*\S)_([^_]+)"))


@dataclass(frozen=True)
class Title:
    """Title of a column. The unit is as it is written in the file; None: not given."""
    index: int
    text: str
    name: str
    unit: str

    @property
    def shown(self):
        """Title for a message."""
        named = self.text or f"column {self.index + 1}"
        return named if not self.unit or self.unit in named else f"{named} [{self.unit}]"


def split_title(text):
    """Name and unit of a title; the unit is None if the title has none."""
    if len(text) > LONGEST:
        return text, None
    match = IN_BRACKETS.fullmatch(text)
    if match:
        return match.group(1), match.group(2).strip() or None
    for pattern in OTHERS:
        match = pattern.fullmatch(text)
        if match and unit_of(match.group(2)):
            return match.group(1), match.group(2).strip()
    return text, None


def _bare_unit(cell):
    """Text of a cell in a row of units, without brackets."""
    match = re.fullmatch(r"[\[(]\s*(.*?)\s*[\])]", cell[:LONGEST])
    return match.group(1) if match else cell


def _is_units_row(head):
    """True if the last row of the head contains units: at least half of its cells, of which one is a unit of this package."""
    cells = [_bare_unit(cell) for cell in head[-1].cells if cell]
    alike = sum(1 for cell in cells if unit_of(cell) or "/" in cell)
    return len(head) > 1 and any(map(unit_of, cells)) and 2 * alike >= len(cells)


def titles_of(table):
    """Titles of the columns of a table of cells, and the rows above them.

    @throw Failure if there are no titles
    """
    head = table.head
    if not head:
        raise Failure(f"{table.path}: has no titles; its first line must contain names and units, for example 'y [mm]'")
    units = []
    if _is_units_row(head):
        units = [_bare_unit(cell) for cell in head.pop().cells]
    *above, titles = head
    return [_title(index, text, units[index] if index < len(units) else "") for index, text in enumerate(titles.cells)], above


def _title(index, text, below):
    """Title with its own unit, or that of the row of units. A unit in the title that differs from it is part of the name."""
    name, unit = split_title(text)
    if below in ("", "-"):
        return Title(index, text, name.strip(), unit)
    if unit and (unit_of(unit) or unit) == (unit_of(below) or below):
        return Title(index, text, name.strip(), unit)
    return Title(index, text, text, below)
