# SPDX-License-Identifier: BSD-3-Clause
"""Tables of the calculation."""
from ..csv_table import CsvTable

GEOMETRY, CONICITY = "contact_geometry.csv", "equivalent_conicity.csv"
MM = 1e3  # millimetres per metre


def read(path):
    """CsvTable of one of the files, in SI units. The column `reason` has the reason why a row has no result, or ""."""
    return CsvTable(path, texts=("reason",))
