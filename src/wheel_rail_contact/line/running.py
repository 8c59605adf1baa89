# SPDX-License-Identifier: BSD-3-Clause
"""Command line of make_line_states: states of a wheelset that runs over a line.

The wheelset follows the alignment of the track by its conical treads (Klingel 1883), y'' = -(c / (e r)) (y - alignment), with
the conicity c, half the distance of the running circles e and the rolling radius r; ' is the derivative along the track. The
wavelength of this motion is within that of the irregularities, and without damping its amplitude would grow along the line.
The bogie therefore damps the yaw, with the damping ratio d: y'' = -(c / (e r)) (y - alignment) - 2 d sqrt(c / (e r)) y'. The yaw
is the slope y'. The car body follows the lateral motion. Its centre is at the height h above the axle, and its lateral
acceleration increases the load of one wheel and decreases the load of the other.

A cross level turns the track, and with it the body: the axle centre of a centred wheelset then lies r sin(tilt) down the slope
from the alignment, and so do body and load, at the height h above it.

This is a simple path with loads for the example of doc/line.md, not a simulation of a vehicle.
"""
import argparse
import csv
import math

import numpy as np

from ..arguments import Parser
from ..command import Failure, finish, writing
from .line_table import read_centre

RADIUS = 0.460          # [m]
HALF_BASE = 0.750       # [m] half the distance of the running circles
CONICITY = 0.05         # [-]
DAMPING = 0.15          # [-] of the yaw, as a part of the critical damping
LOAD = 200e3            # [N] on the axle
LOAD_HEIGHT = 1.2       # [m] centre of the load, above the axle
GRAVITY = 9.81          # [m/s^2]
BASE = 1.507            # [m] over which the line turns by its cross level: distance of the reference points of 60E1

STIFFNESS = CONICITY / (HALF_BASE * RADIUS)  # [1/m^2] of the restoring curvature


def curvature(y, slope, alignment):
    """y'' [1/m]."""
    return -STIFFNESS * (y - alignment) - 2 * DAMPING * math.sqrt(STIFFNESS) * slope


def path(x, alignment_at):
    """y [m], y' [-] and y'' [1/m] at equidistant places x [m], from the centre of the track (Runge-Kutta, fourth order)."""
    step = x[1] - x[0]
    state = np.array([alignment_at(x[0]), 0.0])

    def rate(place, at):
        return np.array([at[1], curvature(at[0], at[1], alignment_at(place))])

    rows = []
    for place in x:
        first = rate(place, state)
        rows.append((*state, first[1]))
        second = rate(place + step / 2, state + step / 2 * first)
        third = rate(place + step / 2, state + step / 2 * second)
        fourth = rate(place + step, state + step * third)
        state = state + step / 6 * (first + 2 * second + 2 * third + fourth)
    return np.array(rows)


def _parser():
    parser = Parser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("line", metavar="LINE", help="table of make_irregular_line")
    parser.add_argument("table", metavar="STATES", help="file to write (.csv), for contact_states; must not exist")
    parser.add_argument("--speed", type=float, default=40.0, metavar="M/S", help="speed [m/s] (default: %(default)s)")
    parser.add_argument("--step", type=float, default=0.1, metavar="M",
                        help="distance of the states along the line [m] (default: %(default)s)")
    return parser


def _run(options):
    for name in ("speed", "step"):
        if not (math.isfinite(getattr(options, name)) and getattr(options, name) > 0):
            raise Failure(f"--{name} {getattr(options, name)}: must be above 0")
    stations, alignment, cross_level = read_centre(options.line)
    tilt = np.arcsin(np.clip(cross_level / BASE, -1, 1))  # positive: the left rail is higher
    centre = alignment - RADIUS * np.sin(tilt)
    count = int((stations[-1] - stations[0]) / options.step * (1 + 1e-12)) + 1
    if count < 2:
        raise Failure(f"--step {options.step}: is longer than the line")
    x = np.minimum(stations[0] + options.step * np.arange(count), stations[-1])
    rows = path(x, lambda place: np.interp(place, stations, centre))
    slopes = np.interp(x, stations, np.sin(tilt))
    with writing(options.table), open(options.table, "x", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["time [s]", "x [m]", "y [mm]", "yaw [mrad]", "force_z [kN]", "torque_x [kN m]"])
        for place, (y, slope, bend), sine in zip(x, rows, slopes):
            # Moments about the x axis of the axle: of the inertia force -m a, and of the weight beside the axle.
            torque = LOAD_HEIGHT * LOAD * (options.speed**2 * bend / GRAVITY + sine)
            time = 1 + (place - x[0]) / options.speed
            row = (time, place, 1e3 * y, 1e3 * math.atan(slope), -1e-3 * LOAD, 1e-3 * torque)
            table.writerow([f"{value:.9g}" for value in row])


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("make_line_states", _run, _parser().parse_args(arguments))
