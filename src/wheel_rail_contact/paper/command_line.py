# SPDX-License-Identifier: BSD-3-Clause
"""Command line of paper_study."""
import argparse
import subprocess
from pathlib import Path

from ..command import Failure, finish, pyplot, runner, shipped
from . import pictures, report

RUNNER = "paper_study_runner"
# The shipped compliance tables, the paper's rail first, then from stiff to soft pads.
TABLES = ("paper", "pads_100_500", "pads_40_100", "pads_20_60", "pads_10_25")


def main(arguments=None):
    """Run the command; returns its exit status."""
    return finish("paper_study", _run, _parser().parse_args(arguments).out)


def _run(folder):
    program, config = runner(RUNNER), shipped("config/paper.yaml")
    rails = [shipped(f"config/rails/{name}.yaml") for name in TABLES]
    plot = pyplot()
    folder.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([program, folder, config, *rails], check=False)
    if done.returncode != 0:
        raise Failure(f"the calculation ended with status {done.returncode}")
    print(report.text(folder))
    for picture in pictures.draw(plot, folder):
        print(f"wrote {picture}")


def _parser():
    parser = argparse.ArgumentParser(
        prog="paper_study", description="Golubenko et al. 2011 (influence of a rail's lateral bending on wheel-rail "
        "contact) calculated: the paper's figures beside ours, its Figure 3 redrawn, a scan of the settings that could "
        "have led to its figures, and pressure and area under lateral forces for each shipped rail. "
        "config/paper.yaml holds the case.")
    parser.add_argument("--out", type=Path, default=Path("paper_study"), metavar="DIR",
                        help="folder for CSV files (SI units) and pictures (default: %(default)s)")
    return parser
