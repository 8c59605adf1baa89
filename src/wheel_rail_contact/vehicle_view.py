# SPDX-License-Identifier: BSD-3-Clause
"""Shows the wheelsets of a node in one view of rviz."""
import copy
import subprocess
import tempfile

import rospy
import yaml

from .arguments import Parser
from .command import Failure, finish, shipped

SPACING = 2.5   # between wheelsets whose places are unknown [m]
WIDTH = 1280    # of the view [pixels]
COLUMNS = 4     # of panels
LETTERS = 6     # of the panels, which are then as wide as a column [pixels]
ROW = 115       # height of a panel [pixels]


def _parser():
    parser = Parser(description="Shows the wheelsets of a running node (parameter wheelsets) in one view of rviz, at their places "
                                "(wheelset_places). Other options are those of rviz.")
    add = parser.add_argument
    add("--source", default="contact_node", metavar="NODE", help="name of the node (default: %(default)s)")
    add("--frame", default="track", help="track frame; equal to the parameter track/frame (default: %(default)s)")
    add("--spacing", type=float, metavar="M",
        help="draw the wheelsets at equal distances [m] (default: their places; if they are unknown, 2.5)")
    add("--own-x", action="store_true", help="draw them at x of their poses")
    return parser


def view_of(wheelsets, places, node, own_x=False):
    """Configuration of rviz with a display for each wheelset: launch/track.rviz with the others beside its own.

    @param places  along the track, of each wheelset [m]
    @param node    full name of the node that holds them
    """
    with open(shipped("launch/track.rviz"), encoding="utf-8") as file:
        view = yaml.safe_load(file)
    manager = view["Visualization Manager"]
    pattern, middle = manager["Displays"][0], (min(places) + max(places)) / 2
    namespace, _, name = node.rpartition("/")
    manager["Displays"] = []
    for number, (wheelset, place) in enumerate(zip(wheelsets, places)):
        display = copy.deepcopy(pattern)
        display.update({"Name": wheelset, "Topic": f"{namespace}/{wheelset}/{name}/contact",
                        "Follow Wheelset": {"Value": not own_x, "Place": place - middle}})
        display["Pressure"] = {"Value": True, "Scale": 2000, "Size": 40, "Lift": 0.3, "Height": 0.3}
        display["Labels"]["Letters"] = 0.08
        display["Wheelset"] = {"Value": True, "Sweep": 180, "Alpha": 0.9}
        display["Rails"]["Length"] = 2
        display["Trail"] = {"Value": False}
        display["Panel"] = {"Value": True, "Letters": LETTERS, "Title": wheelset,
                            "Left": number % COLUMNS * (WIDTH // COLUMNS), "Top": number // COLUMNS * ROW}
        manager["Displays"].append(display)
    length = max(places) - min(places)
    manager["Views"]["Current"].update({"Distance": 2 + 0.8 * length, "Yaw": 3.9 if length else 3.14159})
    return view


def _show(options, rest):
    node = rospy.resolve_name(options.source)
    try:
        wheelsets = rospy.get_param(node + "/wheelsets", [])
    except OSError:
        raise Failure("no ROS master runs") from None
    if not wheelsets:
        raise Failure(f"{node}: has no list of wheelsets; view.launch shows a node with one")
    places = [] if options.spacing else [float(place) for place in rospy.get_param(node + "/wheelset_places", [])]
    places = places or [-(options.spacing or SPACING) * number for number in range(len(wheelsets))]
    with tempfile.NamedTemporaryFile("w", suffix=".rviz", encoding="utf-8") as file:
        yaml.safe_dump(view_of(wheelsets, places, node, options.own_x), file)
        file.flush()
        return subprocess.run(["rviz", "--display-config", file.name, "--fixed-frame", options.frame, *rest],
                              check=False).returncode


def main(arguments=None):
    """Runs the command and returns its exit status."""
    options, rest = _parser().parse_known_args(arguments)
    return finish("vehicle_view", _show, options, rest)
