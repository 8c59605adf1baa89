# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of commands that read results: replays of the shipped sweep, and runs of a command."""

import os
import pathlib
import subprocess
import tempfile

from commands import CommandCase

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
SWEEP = PACKAGE / "bags" / "manchester_sweep.bag"


class SweepCase(CommandCase):
    """Tests of one command, with a temporary folder for all of them."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.rigid = cls.replay("rigid.bag", PACKAGE / "config" / "manchester.yaml")

    @classmethod
    def replay(cls, name, config, bag=SWEEP, *options):
        """@return path of the results of the sweep, or of another bag, with a parameter file"""
        out = cls.folder / name
        subprocess.run([os.environ["CONTACT_REPLAY"], bag, out, "--config", config, *options], check=True, capture_output=True)
        return out
