# SPDX-License-Identifier: BSD-3-Clause
"""Command line of static_start."""
import math
import sys

from .arguments import DefaultsFormatter, Parser
from .command import Failure, calculating, contact_model, finish, native

NOT_USABLE = 4  # exit status
LATERAL_FORCE = "rail_lateral_force"  # argument of evaluate(), and columns of a state


def main(arguments=None):
    """Runs the command and returns its exit status: 4 if the load has no usable result."""
    return finish("static_start", _run, _parser().parse_args(arguments))


def _run(options):
    numbers = {name: value for name, value in vars(options).items() if isinstance(value, float)}  # those that are given
    for name, value in numbers.items():
        if not math.isfinite(value):
            raise Failure(f"{_option(name)} {value:g}: must be a finite number")
    model = contact_model([*options.config, {"wheelset": {"free": ["z", "roll"]}}])
    _refuse_unused(model, numbers)
    place = numbers.get("distance", 0.0)
    for note in [*model.notes, *_missing_inputs(model, place)]:
        print(f"static_start: {note}", file=sys.stderr)
    with calculating():
        result = model.evaluate(_state(options, place))
    _print(result)
    return 0 if result.usable else NOT_USABLE


def _option(name):
    return "--" + name.replace("_", "-")


def _refuse_unused(model, given):
    """Raises Failure for a given option that the parameters do not use, as Python's evaluate() does for its argument."""
    from .core.states import unused
    remedies = unused(model)
    for name, argument in (("distance", "distance"), ("left_force", LATERAL_FORCE), ("right_force", LATERAL_FORCE)):
        if name in given and argument in remedies:
            raise Failure(f"{_option(name)} {given[name]:g}: {remedies[argument]}")


def _state(options, place):
    """Numbers of a state, in the order of STATE_COLUMNS."""
    forces = iter((options.left_force or 0.0, options.right_force or 0.0))
    values = {"force_z": -options.load, "torque_x": options.torque, "y": options.y, "yaw": options.yaw,  # force_z: upward
              "distance": place}
    return [next(forces) if name == LATERAL_FORCE else values.get(name, 0.0) for name in native().STATE_COLUMNS]


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
        print(f"status_text {result.status_text}")
    if result.usable:
        print(f"z {result.wheelset.position.z:.9f} m\nroll {result.wheelset.roll + 0.0:.9e} rad")
        for side, rail in (("left", result.left_rail), ("right", result.right_rail)):
            for name in ("vertical_force", "lateral_force"):
                print(f"{side}_{name} {round(getattr(rail, name), 1) + 0.0:.1f} N")  # + 0.0: a zero has no sign


def _parser():
    parser = Parser(
        prog="static_start", formatter_class=DefaultsFormatter,
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
    parser.add_argument("--distance", type=float, metavar="M",
                        help="place on a line, or on rails whose profile changes [m] (default: 0)")
    for side in ("left", "right"):
        parser.add_argument(f"--{side}-force", type=float, metavar="N",
                            help=f"lateral force on the {side} rail, outward positive, for rail_bending/lateral_force: "
                            "topic [N] (default: 0)")
    return parser
