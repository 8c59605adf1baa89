# SPDX-License-Identifier: BSD-3-Clause
"""Titles of the columns of a table: name and unit. The module reads them, as those of all tables."""
from dataclasses import dataclass

from ..command import Failure, native


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
    name, unit = native().title_of(text)
    return name, unit or None


def titles_of(table):
    """Titles of the columns of a table of cells, and the rows above them.

    @throw Failure if there are no titles
    """
    head = table.head
    if not head:
        raise Failure(f"{table.path}: has no titles; its first line must contain names and units, for example 'y [mm]'")
    titles, row = table.titles
    texts = head[row].cells
    return [Title(index, text, name, unit or None) for index, (text, (name, unit)) in enumerate(zip(texts, titles))], head[:row]
