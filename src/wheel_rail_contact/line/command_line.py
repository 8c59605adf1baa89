# SPDX-License-Identifier: BSD-3-Clause
"""Command line of make_irregular_line."""
import math
import random

import numpy as np

from ..arguments import DefaultsFormatter, Parser
from ..command import Failure, finish, writing
from .line_table import COLUMNS, MM, with_rails, write_line
from .spectrum import LEVELS, QUANTITIES, densities, irregularity

DESCRIPTION = """Writes random track irregularities as a table for the parameter track/line, with the power spectral densities
of ORE B176. x is from 0 to the length. The irregularities at both ends are equal: the line can be repeated."""
LEAST_STATIONS = 4  # in the shortest wavelength


def _parser():
    parser = Parser(description=DESCRIPTION, formatter_class=DefaultsFormatter)
    parser.add_argument("table", metavar="LINE", help="file to write (.csv); must not exist")
    parser.add_argument("--length", type=float, default=200.0, metavar="M", help="length [m]")
    parser.add_argument("--spacing", type=float, default=0.25, metavar="M", help="distance of the stations [m]")
    parser.add_argument("--level", choices=LEVELS, default="low", help="level of ORE B176")
    parser.add_argument("--wavelengths", type=float, nargs=2, default=(3.0, 25.0), metavar=("MIN", "MAX"),
                        help="shortest and longest wavelength [m]; the default is the range D1 of EN 13848-1")
    parser.add_argument("--seed", type=int, default=1, help="of the random phases")
    parser.add_argument("--gauge", type=float, default=1.435, metavar="M", help="mean gauge [m]")
    parser.add_argument("--gauge-variation", type=float, metavar="MM",
                        help="standard deviation of the gauge [mm]; default: 0.25 (low) or 0.35 (high) in D1")
    parser.add_argument("--columns", choices=COLUMNS, default="rails",
                        help="rails: alignment and level of each rail; track: of the track centre. "
                             "Gauge and cross level are always written")
    return parser


def _check(options):
    for name in ("length", "spacing", "gauge"):
        if not (math.isfinite(getattr(options, name)) and getattr(options, name) > 0):
            raise Failure(f"--{name} {getattr(options, name)}: must be above 0")
    if options.gauge_variation is not None and not (math.isfinite(options.gauge_variation)
                                                    and options.gauge_variation >= 0):
        raise Failure(f"--gauge-variation {options.gauge_variation}: must not be negative")
    shortest, longest = options.wavelengths
    if not shortest < longest:
        raise Failure(f"--wavelengths {shortest} {longest}: the first one must be the shorter one")
    if not shortest >= LEAST_STATIONS * options.spacing:
        raise Failure(f"--wavelengths {shortest} {longest}: the shortest one must be at least {LEAST_STATIONS} times the "
                      f"spacing, {options.spacing} m")
    if not longest <= options.length:
        raise Failure(f"--wavelengths {shortest} {longest}: the longest one must not be above the length, {options.length} m")


def make_line(options):
    """x and values of the quantities of a line [m]."""
    count = round(options.length / options.spacing)
    generator = random.Random(options.seed)
    track = {name: irregularity(density, count, options.spacing, options.wavelengths, generator)
             for name, density in densities(options.level).items()}
    if options.gauge_variation is not None:
        track["gauge"] *= options.gauge_variation / MM / np.std(track["gauge"])
    track = {name: np.append(values, values[0]) for name, values in track.items()}
    return options.spacing * np.arange(count + 1), {**track, "gauge": options.gauge + track["gauge"]}


def _run(options):
    _check(options)
    x, track = make_line(options)
    shortest, longest = options.wavelengths
    title = (f"ORE B176, {options.level} level, wavelengths {shortest:g} m to {longest:g} m, seed {options.seed}. "
             "Axes: rep103 (y left, z up)")
    with writing(options.table):
        write_line(options.table, title, x, with_rails(track, options.gauge), COLUMNS[options.columns])
    deviations = ", ".join(f"{name.replace('_', ' ')} {MM * np.std(track[name][:-1]):.2f}" for name in QUANTITIES)
    print(f"{len(x)} stations. Standard deviations [mm]: {deviations}")


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("make_irregular_line", _run, _parser().parse_args(arguments))
