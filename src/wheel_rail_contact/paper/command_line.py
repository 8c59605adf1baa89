# SPDX-License-Identifier: BSD-3-Clause
"""Command line of paper_study."""
import sys
from pathlib import Path

from ..arguments import Parser
from ..command import calculating, finish, output_folder, pyplot
from . import pictures, report, study


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("paper_study", _run, _parser().parse_args(arguments).out)


def _run(folder):
    plot = pyplot()
    output_folder(folder)
    with calculating():
        found = study.run(folder, lambda step: print(f"paper_study: {step}", file=sys.stderr, flush=True))
    print(report.text(found))
    for path in pictures.draw(plot, found, folder):
        print(f"wrote {path}")


def _parser():
    parser = Parser(
        prog="paper_study", description="Recalculates Golubenko et al. 2011 (influence of the lateral bending of a rail "
        "on the wheel-rail contact). The command prints the values of the paper and ours, and draws Figure 3 of the paper. "
        "It scans the settings that could give the values of the paper, and computes pressure and area under lateral forces "
        "for each rail of the package, and the stress in the rail. config/paper.yaml contains the case.")
    parser.add_argument("--out", type=Path, default=Path("paper_study"), metavar="DIR",
                        help="folder for CSV files (SI units) and pictures (default: %(default)s)")
    return parser
