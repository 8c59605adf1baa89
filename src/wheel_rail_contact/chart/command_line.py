# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_chart."""
import argparse
import tempfile
from pathlib import Path

from ..command import Failure, finish, pyplot, runner
from ..progress import Progress
from . import scenes_picture, summary_picture, table
from .front import compare_auto
from .measuring import RUNNER, measure


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
    draw(plot, rows, facts, options.out)
    _report(rows)
    print(f"wrote chart.csv, chart.png and chart_scenes.png, and both pictures as .svg, to {options.out}")


def draw(plot, rows, facts, folder):
    """Writes both pictures, each as PNG and SVG."""
    for picture, name in ((summary_picture, "chart"), (scenes_picture, "chart_scenes")):
        picture.draw(plot, rows, facts, [folder / f"{name}.png", folder / f"{name}.svg"])


def _check_folder(folder):
    """Raises Failure before the measurement starts if the folder is not writable."""
    if not folder.is_dir():
        raise Failure(f"--out {folder}: this folder does not exist")
    try:
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise Failure(f"--out {folder}: this folder is not writable ({error.strerror})") from error


def _report(rows):
    print("Time of auto divided by the time of the fastest fixed method that meets the tolerance")
    print(f"{'':17}{'tolerance':>10}{'met':>10}{'median':>10}{'largest':>10}  on or left of the front")
    for kind in ("wheelset", "normal"):
        for start in ("warm", "cold"):
            own = [row for row in rows if row.kind == kind and row.start == start]
            for name, found in zip((f"{kind}, {start}", "", "", ""), compare_auto(own)):
                print(f"{name:<17}{100 * found.tolerance:>8g} %{f'{found.met} of {found.scenes}':>10}"
                      f"{found.ratio:>10.2f}{found.largest_ratio:>10.2f}  {found.on_front} of {found.scenes}")


def _parser():
    parser = argparse.ArgumentParser(
        prog="contact_chart", description="Runs every method on every grid over twelve scenes and draws error against "
        "time: chart.png summarises the scenes, chart_scenes.png has a panel for each scene. Also writes both pictures as "
        ".svg and all values to chart.csv. Takes two to three minutes.")
    parser.add_argument("--out", type=Path, default=Path("."), metavar="DIR",
                        help="existing folder for the files (default: the current one)")
    parser.add_argument("--quick", action="store_true",
                        help="fewer repetitions, no slow grids, a coarser reference solution; a tenth of the time")
    return parser
