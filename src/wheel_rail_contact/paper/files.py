# SPDX-License-Identifier: BSD-3-Clause
"""Reads the CSV files of the calculation."""
from ..csv_table import CsvTable

NAMES = ("body", "case", "method", "part", "rail", "share", "table")  # columns with text


def read(path):
    """Rows of a CSV file as dictionaries; numbers are float."""
    return CsvTable(path, texts=NAMES).rows()
