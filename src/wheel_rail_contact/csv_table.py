# SPDX-License-Identifier: BSD-3-Clause
"""Reads the CSV files that the programs of the package write. Tables of other programs: CellTable of the module."""
import csv

import numpy as np


class CsvTable:
    """Columns of a CSV file by their names, without the units in brackets behind these. Empty numbers are NaN.

    path   of the file
    texts  names of columns with text; those that the file does not have are ignored. They must be listed, because float()
           would accept the rail name 60E1
    """

    def __init__(self, path, texts=()):
        with open(path, newline="", encoding="utf-8") as stream:
            reader = csv.reader(stream)
            names = [title.split(" [")[0] for title in next(reader)]
            cells = list(reader)
        self._length = len(cells)
        self._columns = {}
        for i, name in enumerate(names):
            column = [row[i] for row in cells]
            self._columns[name] = column if name in texts else np.array([float(cell or "nan") for cell in column])

    def __getitem__(self, name):
        """Column: an array of numbers, or a list of texts."""
        return self._columns[name]

    def __len__(self):
        """Number of rows."""
        return self._length

    def rows(self):
        """Rows as dictionaries of numbers and texts."""
        columns = [column if isinstance(column, list) else column.tolist() for column in self._columns.values()]
        return [dict(zip(self._columns, row)) for row in zip(*columns)]
