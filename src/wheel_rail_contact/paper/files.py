# SPDX-License-Identifier: BSD-3-Clause
"""How the command reads what the calculation wrote."""
import csv

NAMES = {"body", "case", "method", "part", "rail", "share", "table"}  # columns of words: a rail's 60E1 is no number


def read(path):
    """Rows of a CSV file as dictionaries, numbers as float."""
    with open(path, newline="", encoding="ascii") as stream:
        return [{name: text if name in NAMES else float(text) for name, text in row.items()}
                for row in csv.DictReader(stream)]
