# SPDX-License-Identifier: BSD-3-Clause
"""Command line of static_start."""
import argparse
import math
import sys

from .command import Failure, calculating, contact_model, finish, native

NOT_USABLE = 4  # exit status


def main(arguments=None):
    """Runs the command and returns its exit status: 4 if the load has no usable result."""
    return finish("static_start", _run, _parser().parse_args(arguments))


def _run(options):
    numbers = {"load": options.load, "torque": options.torque, "y": options.y, "yaw": options.yaw,
               "distance": options.distance, "left-force": options.left_force, "right-force": options.right_force}
    for name, value in numbers.items():
        if not math.isfinite(value):
            raise Failure(f"--{name} {value:g}: must be a finite number")
    model = contact_model([*options.config, {"wheelset": {"free": ["z", "roll"]}}])
    for note in [*model.notes, *_missing_inputs(model, options.distance)]:
        print(f"static_start: {note}", file=sys.stderr)
    with calculating():
        result = model.evaluate(_state(options))
    _print(result)
    return 0 if result.usable else NOT_USABLE


def _state(options):
    """State as a table of one row. Forces on the rails are ignored where the parameters do not use them."""
    forces = iter((options.left_force, options.right_force))
    values = {"force_z": -options.load, "torque_x": options.torque, "y": options.y, "yaw": options.yaw,  # force_z: upward
              "distance": options.distance}
    return [[next(forces) if name == "rail_lateral_force" else values.get(name, 0.0) for name in native().STATE_COLUMNS]]


def _missing_inputs(model, distance):
    """Inputs of a node with these parameters that the command does not have, one text each."""
    if model.has_neighbours:
        yield "rail_bending/neighbours: the forces of the neighbours are unknown, and taken as zero"
    if model.requires_displacement:
        yield "track/displacement = topic: the displacements of the rails are unknown, and taken as zero"
    if model.requires_distance:
        yield f"track/distance = topic: the place on the line is that of --distance, {distance:g} m"


def _print(result):
    print(f"status {result.status}")
    if result.status_text:
        print(f"reason {result.status_text}")
    if result.usable:
        print(f"z {result.wheelset.position.z:.9f} m\nroll {result.wheelset.roll:.9e} rad")
        for side, rail in (("left", result.left_rail), ("right", result.right_rail)):
            print(f"{side}_vertical_force {rail.vertical_force:.1f} N\n{side}_lateral_force {rail.lateral_force:.1f} N")


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
