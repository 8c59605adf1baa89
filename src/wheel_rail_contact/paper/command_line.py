# SPDX-License-Identifier: BSD-3-Clause
"""Command line of paper_study."""
import argparse
import subprocess
from pathlib import Path

from ..command import Failure, finish, pyplot, runner, shipped
from . import pictures, report

RUNNER = "paper_study_runner"
# Compliance tables of the package: first the rail of the paper, then pads from stiff to soft.
TABLES = ("paper", "pads_100_500", "pads_40_100", "pads_20_60", "pads_10_25")


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("paper_study", _run, _parser().parse_args(arguments).out)


def _run(folder):
    program, config = runner(RUNNER), shipped("config/paper.yaml")
    rails = [shipped(f"config/rails/{name}.yaml") for name in TABLES]
    plot = pyplot()
    folder.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([program, folder, config, *rails], check=False)
    if done.returncode != 0:
        raise Failure(f"the calculation failed with exit status {done.returncode}")
    print(report.text(folder))
    for sentence in pictures.draw(plot, folder):
        print(sentence)


def _parser():
    parser = argparse.ArgumentParser(
        prog="paper_study", description="Recalculates Golubenko et al. 2011 (influence of the lateral bending of a rail "
        "on the wheel-rail contact). The command prints the values of the paper and ours, and draws Figure 3 of the paper. "
        "It scans the settings that could give the values of the paper, and computes pressure and area under lateral forces "
        "for each rail of the package, and the stress in the rail. config/paper.yaml contains the case.")
    parser.add_argument("--out", type=Path, default=Path("paper_study"), metavar="DIR",
                        help="folder for CSV files (SI units) and pictures (default: %(default)s)")
    return parser
