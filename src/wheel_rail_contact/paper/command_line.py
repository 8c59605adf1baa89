# SPDX-License-Identifier: BSD-3-Clause
"""Command line of paper_study."""
import argparse
import subprocess
import sys
from pathlib import Path

from . import pictures, report
from .files import StudyError, runner, share, tables


def main(arguments=None):
    """Run the command; returns its exit status."""
    options = _parser().parse_args(arguments)
    try:
        _run(options.out)
    except (StudyError, OSError) as error:
        print(f"paper_study: {error}", file=sys.stderr)
        return 1
    return 0


def _run(folder):
    program, config, rails = runner(), share() / "config" / "paper.yaml", tables()
    pictures.check()
    folder.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([program, folder, config, "cases", "forces", "scan", "--", *rails], check=False)
    if done.returncode != 0:
        raise StudyError(f"the calculation ended with status {done.returncode}")
    print(report.text(folder))
    for picture in pictures.draw(folder):
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
