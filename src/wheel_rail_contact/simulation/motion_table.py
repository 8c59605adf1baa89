# SPDX-License-Identifier: BSD-3-Clause
"""Table of a run (CSV): one row per step, SI units. The first line has the names and units of the columns."""
import contextlib
import csv
import math

from ..command import writing
from .closed_loop import friction_power, is_saturated

SIDES = ("left", "right")
MOTION = ("time [s]", "distance [m]", "y [m]", "yaw [rad]", "y_rate [m/s]", "yaw_rate [rad/s]", "rotation [rad/s]", "z [m]",
          "roll [rad]", "force_z [N]", "torque_x [N m]", "lateral_force [N]", "yaw_moment [N m]", "friction_power [W]")
WHEEL = ("normal_force [N]", "rolling_radius [m]", "creep_x [N]", "creep_y [N]", "adhesion_share [-]", "saturated [-]")


@contextlib.contextmanager
def motion_table(path):
    """Opens the table, and gives a function that adds a step. Raises Failure if the file cannot be written."""
    with writing(path), open(path, "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow([*MOTION, *(f"{side}_{name}" for side in SIDES for name in WHEEL), "held [-]"])
        yield lambda *step: writer.writerow([f"{value:.9g}" for value in _row(*step)])


def _row(request, reply, is_held):
    """Values of a step: the request at its end, and the contact."""
    wrench, pose = reply.rail_wrench, reply.wheelset
    wheels = [value for side in SIDES for value in _wheel([patch for patch in reply.patches if patch.side == side])]
    return (1e-9 * request.time, request.x, request.y, request.yaw, request.lateral_velocity, request.yaw_rate, reply.rotation,
            pose.position.z, pose.roll, request.force_z, request.torque_x, wrench.force.y, wrench.torque.z,
            friction_power(reply), *wheels, is_held)


def _wheel(patches):
    """Values of the columns WHEEL; the friction is that on the wheel, along x and y of the track."""
    force = sum(patch.normal_force for patch in patches)
    radius = sum(patch.normal_force * patch.rolling_radius for patch in patches) / force if force > 0 else math.nan
    return (force, radius, sum(patch.creep.force_x for patch in patches),
            sum(patch.creep.force_y * math.cos(patch.pose.roll) for patch in patches),
            max((patch.creep.adhesion_share for patch in patches), default=0.0), any(map(is_saturated, patches)))
