# SPDX-License-Identifier: BSD-3-Clause
"""Command line of plot_simulation."""
from pathlib import Path

from ..arguments import DefaultsFormatter, Parser
from ..command import Failure, finish, output_folder, pyplot
from ..csv_table import CsvTable
from . import picture


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("plot_simulation", _run, _parser().parse_args(arguments))


def _run(options):
    if not options.length > 0:
        raise Failure(f"--length {options.length:g}: must be above 0")
    runs = [(_start(table), table) for table in map(_read, options.tables)]
    plot = pyplot()
    output_folder(options.out)
    picture.draw_motion(plot, runs[0][1], options.out / "simulation_motion.png", options.length)
    picture.draw_phase(plot, runs, options.out / "simulation_phase.png")
    print(f"wrote simulation_motion.png and simulation_phase.png to {options.out}")


def _read(path):
    try:
        table = CsvTable(path)
        if len(table) > 1:
            table["left_saturated"]  # a column that only simulate_wheelset writes
            return table
    except (KeyError, ValueError, StopIteration):
        pass
    raise Failure(f"{path}: is no table of simulate_wheelset with at least two steps")


def _start(run):
    return f"y = {picture.MM * run['y'][0]:g} mm, yaw = {1e3 * run['yaw'][0]:g} mrad"


def _parser():
    parser = Parser(
        prog="plot_simulation", formatter_class=DefaultsFormatter,
        description="Draws runs of simulate_wheelset: motion and creep forces of the first table, and the phase plot of all.")
    parser.add_argument("tables", nargs="+", metavar="TABLE.csv", help="tables written by simulate_wheelset --out")
    parser.add_argument("--out", type=Path, default=Path("simulation"), metavar="DIR", help="folder for the pictures")
    parser.add_argument("--length", type=float, default=20.0, metavar="M",
                        help="length of the end of the run whose creep forces are drawn [m]")
    return parser
