# SPDX-License-Identifier: BSD-3-Clause
"""Test case with a temporary folder, and functions that run a command and read the table of a line."""
import contextlib
import io
import pathlib
import tempfile
import unittest

import numpy as np


class LineCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_command(self, main, *arguments, status=0):
        """Runs the main function of a command. Returns what it prints."""
        printed = io.StringIO()
        with contextlib.redirect_stderr(printed), contextlib.redirect_stdout(printed):
            result = main([str(argument) for argument in arguments])
        self.assertEqual(result, status, printed.getvalue())
        return printed.getvalue()


def columns_of(path):
    """Columns of a table with lengths: name -> values [m]. Lines that begin with # are ignored."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    titles = [title.strip().rstrip("]").split(" [") for title in lines[0].split(",")]
    values = np.array([line.split(",") for line in lines[1:]], float).T
    return {name: {"m": 1.0, "mm": 1e-3}.get(unit, 1.0) * column for (name, unit), column in zip(titles, values)}
