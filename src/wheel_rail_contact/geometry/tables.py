# SPDX-License-Identifier: BSD-3-Clause
"""Reads the tables of the calculation."""
import csv

import numpy as np

GEOMETRY, CONICITY = "contact_geometry.csv", "equivalent_conicity.csv"
MM = 1e3  # millimetres per metre


class Table:
    """Columns of a CSV file by their names without unit, SI units. Empty cells are NaN."""

    def __init__(self, path):
        with open(path, newline="", encoding="ascii") as stream:
            rows = list(csv.DictReader(stream))
        self.reasons = [row.pop("reason") for row in rows]
        self._columns = {name.split(" [")[0]: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}

    def __getitem__(self, name):
        return self._columns[name]
