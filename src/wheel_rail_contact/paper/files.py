# SPDX-License-Identifier: BSD-3-Clause
"""Reads the CSV files of the calculation."""
import csv

# Columns with text. They must be listed, because float() would accept the rail name 60E1.
NAMES = {"body", "case", "method", "part", "rail", "share", "table"}


def read(path):
    """Rows of a CSV file as dictionaries; numbers are float."""
    with open(path, newline="", encoding="ascii") as stream:
        return [{name: text if name in NAMES else float(text) for name, text in row.items()}
                for row in csv.DictReader(stream)]
