# SPDX-License-Identifier: BSD-3-Clause
"""Command line of static_start."""
import argparse
import math
import subprocess

from .command import Failure, finish, runner, shipped

RUNNER = "static_start_runner"


def main(arguments=None):
    """Runs the command and returns its exit status: 4 if the load has no usable result."""
    return finish("static_start", _run, _parser().parse_args(arguments))


def _run(options):
    numbers = {"load": options.load, "torque": options.torque, "y": options.y, "yaw": options.yaw,
               "distance": options.distance, "left-force": options.left_force, "right-force": options.right_force}
    for name, value in numbers.items():
        if not math.isfinite(value):
            raise Failure(f"--{name} {value:g}: must be a finite number")
    numbers["load"] = -options.load  # force_z is positive upward
    return subprocess.run([runner(RUNNER), *(repr(value) for value in numbers.values()), shipped("config/default.yaml"),
                           *options.config], check=False).returncode


def _parser():
    parser = argparse.ArgumentParser(
        prog="static_start", formatter_class=argparse.ArgumentDefaultsHelpFormatter,
        description="Computes height z and roll of a wheelset at rest under its load, whatever wheelset/free is, and prints "
        "them with the status and the forces on both rails. A simulation with wheelset/free: [] can start there. Exit status "
        "4: the status is not usable.")
    parser.add_argument("--config", action="append", default=[], metavar="F.yaml",
                        help="parameters of the node, applied over config/default.yaml and the files given before")
    parser.add_argument("--load", type=float, required=True, metavar="N",
                        help="vertical force on the axle, with the weight of the wheelset, down positive [N]")
    parser.add_argument("--torque", type=float, default=0.0, metavar="NM",
                        help="moment on the axle centre about the x axis [N m]; a positive one unloads the left wheel")
    parser.add_argument("--y", type=float, default=0.0, metavar="M",
                        help="lateral position of the axle centre, left positive [m]")
    parser.add_argument("--yaw", type=float, default=0.0, metavar="RAD",
                        help="yaw about the z axis, positive when the left wheel is behind [rad]")
    parser.add_argument("--distance", type=float, default=0.0, metavar="M", help="place on the line [m]")
    for side in ("left", "right"):
        parser.add_argument(f"--{side}-force", type=float, default=0.0, metavar="N",
                            help=f"lateral force on the {side} rail, outward positive, for rail_bending/lateral_force: "
                            "topic [N]")
    return parser
