# SPDX-License-Identifier: BSD-3-Clause
"""Command line of make_crossing: sections of an artificial crossing, and states of a wheelset that runs straight over it.

The left rail consists of two parts. The wing rail is straight up to x = 0 and then moves outward. The nose begins beside it on
the gauge side; it becomes wider and rises. Its gauge face continues that of the wing rail. All heads have a round crown, round
corners and vertical sides. The right rail is 60E1, upright.

The folder contains the sections, a slices file of each part, the parameters crossing.yaml for contact_replay, and the table
states.csv for contact_states. The shape is our own: it is not that of a standard crossing.
"""
import argparse
import csv
import math
import pathlib

import numpy as np

from ..arguments import Parser
from ..command import Failure, finish, writing

HALF_WIDTH = 0.036      # [m] half the width of the wing rail, and of the nose where it is complete
CROWN, CORNER = 0.12, 0.013         # [m] radii of the wing rail
NOSE_CROWN, NOSE_CORNER = 0.1, 0.010    # [m] radii of the nose
DEPTH = 0.030           # [m] depth of the sides
SPACING = 5e-4          # [m] largest distance of the points of a section
BEGIN, END = -1.0, 1.2  # [m] places of the first and the last section
SLOPE = 0.1             # [-] lateral slope of the wing rail
STEP = 0.1              # [m] distance of the sections
NOSE_BEGIN, NOSE_END = 0.2, 0.7     # [m] places at which the nose begins and is complete
NOSE_HALF_WIDTH = 0.013             # [m] half the width of the nose where it begins
NOSE_DEPTH = 0.006                  # [m] depth of the top of the nose where it begins, below the top of the wing rail
SPEED = 20.0            # [m/s]

PARAMETERS = """\
# Crossing of make_crossing on the left, 60E1 on the right; upright rails.
track: {{rail_inclination: 0}}
wheel: {{profile: S1002}}
rail:
  profile: 60E1
  left:
    profile: {{slices: "{folder}/wing.slcs", placement: coordinates, parts: [{{slices: "{folder}/nose.slcs"}}]}}
"""


def head(middle, top, half_width, crown, corner):
    """Points (n, 2) of a head from the gauge side to the field side: y outward, z up [m]."""
    centre = half_width - corner
    centre_z = -crown + math.sqrt((crown - corner) ** 2 - centre ** 2)  # the corner touches the crown from within
    edge = math.asin(centre / (crown - corner))                         # angle of the touch about the centre of the crown
    angles = np.linspace(0, edge, max(2, math.ceil(crown * edge / SPACING) + 1))
    of_crown = np.column_stack([crown * np.sin(angles), crown * (np.cos(angles) - 1)])
    angles = np.linspace(edge, math.pi / 2, math.ceil(corner * (math.pi / 2 - edge) / SPACING) + 1)[1:]
    of_corner = np.column_stack([centre + corner * np.sin(angles), centre_z + corner * np.cos(angles)])
    heights = np.linspace(centre_z, -DEPTH, math.ceil((DEPTH + centre_z) / SPACING) + 1)[1:]
    half = np.vstack([of_crown, of_corner, np.column_stack([np.full(len(heights), half_width), heights])])
    return np.vstack([half[:0:-1] * (-1, 1), half]) + (middle, top)


def wing(x):
    """Section of the wing rail."""
    return head(SLOPE * max(x, 0.0), 0.0, HALF_WIDTH, CROWN, CORNER)


def nose(x):
    """Section of the nose."""
    share = min((x - NOSE_BEGIN) / (NOSE_END - NOSE_BEGIN), 1.0)
    half_width = NOSE_HALF_WIDTH + share * (HALF_WIDTH - NOSE_HALF_WIDTH)
    return head(half_width - HALF_WIDTH, (share - 1) * NOSE_DEPTH, half_width, NOSE_CROWN, NOSE_CORNER)


def places(begin):
    """Places of sections from `begin` to the end [m]."""
    return [round(x, 6) for x in np.arange(begin, END + STEP / 2, STEP)]


def _write_part(folder, name, begin, section):
    lines = [f"% {name}: artificial crossing of make_crossing", "0 1000  % U_OFFSET, S_SCALE [mm/m]",
             f"{len(places(begin))}  % NSLC", "0 0 0  % NFEAT, NKINK, NACCEL", "1  % U_INTPOL"]
    for number, x in enumerate(places(begin)):
        file = f"{name}_{number}.csv"
        np.savetxt(folder / file, 1e3 * section(x), fmt="%.6f", delimiter=",", header="y_mm,z_mm", comments="")
        lines.append(f"{x:.3f} '{file}'")
    (folder / f"{name}.slcs").write_text("\n".join(lines) + "\n", encoding="utf-8")


def _write_states(path, options):
    with open(path, "x", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["time [s]", "x [m]", "y [mm]", "Q_left [kN]", "Q_right [kN]"])
        for x in np.arange(BEGIN / 2, END - 0.1 + options.step / 2, options.step):
            table.writerow([f"{1 + (x - BEGIN) / SPEED:.6f}", f"{x:.6f}", f"{options.y:.6f}", options.load, options.load])


def _parser():
    parser = Parser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="FOLDER", help="folder to write; must not exist")
    parser.add_argument("--y", type=float, default=0.0, metavar="MM", help="lateral position of the wheelset [mm] (default: 0)")
    parser.add_argument("--load", type=float, default=80.0, metavar="KN", help="load of each wheel [kN] (default: 80)")
    parser.add_argument("--step", type=float, default=0.002, metavar="M", help="distance of the states [m] (default: 0.002)")
    return parser


def _run(options):
    for name in ("load", "step"):
        if not (math.isfinite(getattr(options, name)) and getattr(options, name) > 0):
            raise Failure(f"--{name} {getattr(options, name)}: must be above 0")
    if not math.isfinite(options.y):
        raise Failure(f"--y {options.y}: must be a finite number")
    folder = pathlib.Path(options.folder)
    with writing(folder):
        folder.mkdir()
        _write_part(folder, "wing", BEGIN, wing)
        _write_part(folder, "nose", NOSE_BEGIN, nose)
        (folder / "crossing.yaml").write_text(PARAMETERS.format(folder=folder.resolve()), encoding="utf-8")
        _write_states(folder / "states.csv", options)
    print(f"{len(places(BEGIN))} sections of the wing rail, {len(places(NOSE_BEGIN))} of the nose: {folder}")


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("make_crossing", _run, _parser().parse_args(arguments))
