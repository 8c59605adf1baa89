# SPDX-License-Identifier: BSD-3-Clause
"""Where the command finds what it needs, and how it reads what the calculation wrote."""
import csv
import os
from pathlib import Path

RUNNER = "paper_study_runner"
NAMES = {"body", "case", "method", "part", "rail", "share", "table"}  # columns of words: a rail's 60E1 is no number


class StudyError(Exception):
    """What went wrong, in one sentence for the user."""


def share():
    """The package's folder with config/, in the source tree or installed."""
    here = Path(__file__).resolve().parent
    for root in [here.parents[2], *(parent / "share" / "wheel_rail_contact" for parent in here.parents)]:
        if (root / "config" / "paper.yaml").is_file():
            return root
    raise StudyError("config/paper.yaml of the package was not found")


def runner():
    """The program that calculates, in the first workspace that has it."""
    for prefix in filter(None, os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep)):
        program = Path(prefix, "lib", "wheel_rail_contact", RUNNER)
        if os.access(program, os.X_OK):
            return program
    raise StudyError(f"{RUNNER} was not found; source the workspace's setup.bash first")


def tables():
    """The shipped compliance tables, the paper's rail first, then from stiff to soft pads."""
    folder = share() / "config" / "rails"
    return [folder / f"{name}.yaml" for name in ("paper", "pads_100_500", "pads_40_100", "pads_20_60", "pads_10_25")]


def read(path):
    """Rows of a CSV file as dictionaries, numbers as float."""
    with open(path, newline="", encoding="ascii") as stream:
        return [{name: text if name in NAMES else float(text) for name, text in row.items()}
                for row in csv.DictReader(stream)]
