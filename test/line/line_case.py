# SPDX-License-Identifier: BSD-3-Clause
"""Tests of commands, and the table of a line."""
import numpy as np
from commands import FolderCase


class LineCase(FolderCase):
    """Tests of the commands for lines."""


def columns_of(path):
    """Columns of a table with lengths: name -> values [m]. Lines that begin with # are ignored."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    titles = [title.strip().rstrip("]").split(" [") for title in lines[0].split(",")]
    values = np.array([line.split(",") for line in lines[1:]], float).T
    return {name: {"m": 1.0, "mm": 1e-3}.get(unit, 1.0) * column for (name, unit), column in zip(titles, values)}
