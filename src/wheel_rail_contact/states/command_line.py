# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_states."""
import argparse
import os
import textwrap

from ..command import Failure, finish, writing
from .state import read_bag, write_bag
from .table import AXES, COLUMNS, UNITS, WHEEL_LOADS, read_table, write_table

DESCRIPTION = """Converts a table of wheelset states, as exported by a vehicle simulation, to a bag, or a bag to a table."""
EPILOG = f"""The table is CSV (comma, semicolon or tab). Its first line contains names and units, for example
  time [s], y [mm], yaw [mrad], Q_left [kN], Q_right [kN]
{textwrap.fill(f"Required columns: time and y. Optional columns: {', '.join(name for name in COLUMNS if name != 'y')}.", 110)}
{' and '.join(WHEEL_LOADS)} may replace force_z and torque_x.
Units: {'; '.join(', '.join(units) for units in UNITS.values())}.
Lines that begin with # are ignored. force_z and torque_x are the force and moment of the vehicle on the axle centre, Q_left
and Q_right the wheel loads (down), Y_left and Y_right the lateral forces on the rails (outward). rail_lateral (outward),
rail_vertical and rail_roll (outward) are displacements of the rails. distance is the place along the line.
Axes: rep103: x forward, y left, z up; railway: x forward, y right, z down (roll, yaw and forces accordingly)."""


def _parser():
    parser = argparse.ArgumentParser(description=DESCRIPTION, epilog=EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source", metavar="IN", help="table (.csv) or bag (.bag)")
    parser.add_argument("target", metavar="OUT", help="bag (.bag) or table (.csv); must not exist")
    parser.add_argument("--axes", choices=AXES, default="rep103", help="axes of the table (default: %(default)s)")
    parser.add_argument("--wheelset", default="", metavar="NAME", help="namespace of the topics (default: /)")
    parser.add_argument("--running-circles", type=float, default=1.5, metavar="M",
                        help="distance of the running circles, for Q_left and Q_right [m] (default: %(default)s)")
    parser.add_argument("--start", type=float, default=0.0, metavar="S",
                        help="added to the times of the table [s] (default: 0)")
    return parser


def main(arguments=None):
    """Runs the command and returns its exit status."""
    parser = _parser()
    options = parser.parse_args(arguments)
    kinds = tuple(os.path.splitext(name)[1] for name in (options.source, options.target))
    if sorted(kinds) != [".bag", ".csv"]:
        parser.error("one of IN and OUT must be a .csv, the other a .bag")
    if not options.running_circles > 0:
        parser.error(f"--running-circles {options.running_circles}: must be above 0")
    return finish("contact_states", _convert, options, kinds[0] == ".csv")


def _convert(options, from_table):
    wheelset = "/" + options.wheelset.strip("/") if options.wheelset.strip("/") else ""
    if os.path.exists(options.target):
        raise Failure(f"{options.target}: already exists and is not overwritten")
    if from_table:
        states = read_table(options.source, options.axes, options.running_circles, round(options.start * 1e9))
        _write(options.target, write_bag, states, wheelset)
    else:
        states = read_bag(options.source, wheelset)
        _write(options.target, write_table, states, options.axes)
    print(f"{len(states)} states")


def _write(target, write, *arguments):
    """Writes a file. After a failure, no part of it is left."""
    try:
        with writing(target):
            write(target, *arguments)
    except Failure:
        if os.path.exists(target):
            os.remove(target)
        raise
