# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_chart."""
import argparse
import tempfile
from pathlib import Path

from ..command import Failure, finish, pyplot, runner
from ..progress import Progress
from . import table
from .front import standing
from .measuring import RUNNER, measure
from .picture import draw


def main(arguments=None):
    """Run the command; returns its exit status."""
    return finish("contact_chart", _run, _parser().parse_args(arguments))


def _run(options):
    _check_folder(options.out)
    plot = pyplot()
    program = runner(RUNNER)
    progress = Progress()
    try:
        facts, lines = measure(program, options.quick, progress)
    finally:
        progress.end()
    facts = {"machine": table.machine(), **facts}
    rows = table.parse(lines)
    table.write(options.out / "chart.csv", facts, lines)
    draw(plot, rows, facts, [options.out / "chart.png", options.out / "chart.svg"])
    _report(rows)
    print(f"wrote chart.csv, chart.png and chart.svg to {options.out}")


def _check_folder(folder):
    """Raises Failure, before any time is spent, for a place that cannot be written to."""
    if not folder.is_dir():
        raise Failure(f"--out {folder}: there is no such folder")
    try:
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise Failure(f"--out {folder}: cannot be written to ({error.strerror})") from error


def _report(rows):
    print("auto against the fixed methods: its time over that of the cheapest one that meets the tolerance")
    print(f"{'':17}{'tolerance':>10}{'met':>10}{'median':>10}{'largest':>10}  on or left of the front")
    for kind in ("wheelset", "normal"):
        for start in ("warm", "cold"):
            own = [row for row in rows if row.kind == kind and row.start == start]
            for name, stand in zip((f"{kind}, {start}", "", "", ""), standing(own)):
                print(f"{name:<17}{100 * stand.tolerance:>8g} %{f'{stand.met} of {stand.scenes}':>10}"
                      f"{stand.ratio:>10.2f}{stand.largest_ratio:>10.2f}  {stand.on_front} of {stand.scenes}")


def _parser():
    parser = argparse.ArgumentParser(
        prog="contact_chart", description="Runs every method on every grid over a dozen scenes and draws error against "
        "time. Writes chart.csv, chart.png and chart.svg. Takes two or three minutes.")
    parser.add_argument("--out", type=Path, default=Path("."), metavar="DIR", help="existing folder (default: here)")
    parser.add_argument("--quick", action="store_true",
                        help="fewer repetitions, no slow grids, a coarser truth: a look in a tenth of the time")
    return parser
