# SPDX-License-Identifier: BSD-3-Clause
"""Reads the tables of the calculation."""
from pathlib import Path

import numpy as np

from ..csv_table import CsvTable


class Tables:
    """Tables of one profile, in SI units.

    curve, points, standard: CsvTable. marks: point (y, z) by name, in m. values: text by name.
    """

    def __init__(self, folder):
        self.curve, self.points, self.standard = (CsvTable(Path(folder, f"{name}.csv"))
                                                  for name in ("curve", "points", "standard"))
        marks = CsvTable(Path(folder, "marks.csv"), texts=("name",))
        self.marks = dict(zip(marks["name"], zip(marks["y"], marks["z"])))
        values = CsvTable(Path(folder, "values.csv"), texts=("name", "value"))
        self.values = dict(zip(values["name"], values["value"]))

    def missing_ranges(self):
        """Ranges of the arc length over which points are missing [m], as a list of pairs."""
        missing = np.concatenate([[0], self.curve["missing"], [0]])
        ends = np.flatnonzero(np.diff(missing))
        length = self.curve["arc_length"]
        return [(length[begin], length[end - 1]) for begin, end in zip(ends[::2], ends[1::2])]
