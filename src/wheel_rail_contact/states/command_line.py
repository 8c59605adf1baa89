# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_states."""
import argparse
import math
import os
import sys
import textwrap

from ..arguments import Parser
from ..command import Failure, finish, writing
from ..progress import Progress, shown
from .columns import COLUMNS, QUANTITIES, WHEEL_LOADS
from .running_circles import LONGEST, SHORTEST, RunningCircles
from .state import read_bag, write_wheelsets
from .table import AXES, Reading, read_table, write_table
from .units import units_of

PERIOD = 10  # between lines of progress without a terminal [s]
DESCRIPTION = """Converts a table of wheelset states, as exported by a vehicle simulation, to a bag, or a bag to a table."""


def _epilog():
    """What --help prints below the options."""
    try:
        units = "; ".join(", ".join(names) for names in map(units_of, dict.fromkeys(QUANTITIES.values())))
    except Failure as failure:  # without the module
        units = str(failure)
    return f"""The table is a text file (comma, semicolon, tab or blanks; decimal point or comma). Names and units come first:
  time [s], y [mm], yaw [mrad], Q_left [kN], Q_right [kN]
Units may also be written as y (mm), y / mm, y_mm, or in the second line. Case does not matter in names and units.
{textwrap.fill(f"Required columns: time and y. Optional columns: {', '.join(name for name in COLUMNS if name != 'y')}.", 110)}
{' and '.join(WHEEL_LOADS)} may replace force_z and torque_x. Other columns are ignored, and listed.
--column y='Wset.Y [mm]' names another title in the file. If the file has no units, this option also gives the unit.
{textwrap.fill(f"Units: {units}.", 110)}
Lines that begin with #, %, ! or // are ignored. force_z and torque_x are the force and moment of the vehicle on the axle
centre, Q_left and Q_right the wheel loads (down), Y_left and Y_right the lateral forces on the rails (outward). rail_lateral
(outward), rail_vertical and rail_roll (outward) are displacements of the rails. distance is the place along the line.
speed and the velocities after it are those of the axle centre; rotation is about the axle, along y.
Axes: rep103: x forward, y left, z up; railway: x forward, y right, z down (roll, yaw and forces accordingly).
Rows with missing values (empty, NaN) are dropped, and of rows with equal times all but the last; their number is printed."""


def _parser():
    parser = Parser(description=DESCRIPTION, epilog=_epilog(), formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("source", nargs="+", metavar="IN",
        help="table (any ending, for example .csv or .txt), one for each --wheelset, or bag (.bag)")
    add("target", metavar="OUT", help="bag (.bag), or table (.csv); must not exist")
    add("--axes", choices=AXES, help="axes of the table (default: those in its line '# axes: ...', otherwise rep103)")
    add("--wheelset", action="append", default=[], metavar="NAME",
        help="namespace of the topics (default: /), repeatable: that of each table in turn, all in one bag")
    add("--column", action="append", default=[], metavar="NAME='TITLE [UNIT]'",
        help="title of a column in the file, repeatable; with an empty title, the column NAME is ignored")
    add("--config", action="append", default=[], metavar="F.yaml",
        help="parameters as for contact_replay, repeatable; they give the distance of the running circles "
             "(default: config/default.yaml)")
    add("--running-circles", type=float, metavar="M", help="distance of the running circles, for Q_left and Q_right [m]")
    add("--start", type=float, metavar="S",
        help="added to the times of the table [s] (default: whole seconds if the first time is not above 0, otherwise 0)")
    add("--speed", type=float, metavar="V", help="for a table without time: time = distance / V [m/s]")
    add("--decimal-comma", action="store_true",
        help="the numbers have a decimal comma; required only if it could also separate thousands")
    return parser


def _named(parser, options):
    """Titles given with --column: quantity -> title."""
    named = {}
    for text in options.column:
        quantity, equals, title = text.partition("=")
        if not equals or quantity not in QUANTITIES:
            parser.error(f"--column {text}: must be NAME='TITLE [UNIT]' with one of the names {', '.join(QUANTITIES)}")
        if quantity in named:
            parser.error(f"--column {quantity} is given twice")
        named[quantity] = title.strip()
    return named


def _reading(parser, options):
    """Reading of the options, after a check of their values."""
    circles, speed = options.running_circles, options.speed
    if circles is not None and not SHORTEST <= circles <= LONGEST:
        parser.error(f"--running-circles {circles}: must be a number from {SHORTEST} to {LONGEST}, in metres")
    if circles is not None and options.config:
        parser.error("--running-circles and --config exclude one another")
    if speed is not None and (not math.isfinite(speed) or speed == 0):
        parser.error(f"--speed {speed}: must be a finite number other than 0")
    if options.start is not None and not math.isfinite(options.start):
        parser.error(f"--start {options.start}: must be a finite number")
    return Reading(options.axes, _named(parser, options), options.decimal_comma, options.start, speed,
                   RunningCircles(circles, tuple(options.config)))


def main(arguments=None):
    """Runs the command and returns its exit status."""
    parser = _parser()
    options = parser.parse_args(arguments)
    ends = tuple(os.path.splitext(name)[1].lower() for name in (*options.source, options.target))
    if ends.count(".bag") != 1 or (ends[-1] != ".bag" and ends != (".bag", ".csv")):
        parser.error("one of IN and OUT must be a bag (.bag), the other a table (OUT: .csv)")
    names = ["/" + name.strip("/") if name.strip("/") else "" for name in options.wheelset or [""]]
    if len(names) != len(options.source):
        parser.error(f"{len(options.source)} times IN, but {len(names)} wheelsets: give a --wheelset for each table")
    if len(set(names)) != len(names):
        parser.error(f"--wheelset {max(names, key=names.count).strip('/')} is given twice")
    if len(names) > 1 and options.start is None:
        parser.error("several tables require --start, which is added to the times of all; 0 if these are above 0")
    return finish("contact_states", _convert, options, _reading(parser, options), names, ends[-1] == ".bag")


def _convert(options, reading, wheelsets, from_table):
    if os.path.exists(options.target):
        raise Failure(f"{options.target}: already exists and is not overwritten")
    dropped = count = 0
    progress = Progress(period=PERIOD)
    tables = {}
    for source, wheelset in zip(options.source, wheelsets):
        if from_table:
            states, remarks, left_out = read_table(source, reading, progress)
            dropped += left_out
            tables[wheelset] = shown(states, len(states), progress, "state")
        else:
            remarks = []
            states = read_bag(source, wheelset, remarks, progress)
        count += len(states)
        for remark in remarks:
            print(f"{source}: {remark}", file=sys.stderr)
    if from_table:
        _write(options.target, write_wheelsets, tables)
    else:
        _write(options.target, write_table, states, options.axes or AXES[0])
    progress.end()
    rest = f"; {dropped} of {count + dropped} rows were dropped" if dropped else ""
    print(f"{count} state{'' if count == 1 else 's'}{rest}")


def _write(target, write, *arguments):
    """Writes a file. After a failure or Ctrl-C, no part of it is left."""
    try:
        with writing(target):
            write(target, *arguments)
    except (Failure, KeyboardInterrupt):
        if os.path.exists(target):
            os.remove(target)
        raise
