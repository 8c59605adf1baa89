# SPDX-License-Identifier: BSD-3-Clause
"""State of a wheelset at one instant, and its messages in a bag."""
import collections
import heapq
import math
from dataclasses import dataclass, fields
from typing import Optional

import genpy
import rosbag
from geometry_msgs.msg import PointStamped, PoseStamped, TwistStamped, WrenchStamped
from wheel_rail_contact.msg import RailDisplacements

from ..bags import opened
from ..command import Failure
from ..message_constants import SIDES
from ..progress import no_progress, shown

FRAME = "track"
KINDS = ("pose", "load", "left_rail_force", "right_rail_force", "rail_displacement", "distance", "twist")  # of input topics
RAIL_VELOCITY = ("lateral_velocity", "vertical_velocity", "roll_rate")  # components of the velocity of a rail
DISPLACEMENT = ("lateral", "vertical", "roll", *RAIL_VELOCITY)  # components of a displacement of a rail
TWIST = {("linear", "x"): "speed", ("linear", "y"): "lateral_velocity", ("linear", "z"): "vertical_velocity",
         ("angular", "x"): "roll_rate", ("angular", "y"): "rotation", ("angular", "z"): "yaw_rate"}


def _with_slots(kind):
    """The same class with these attributes only, which need a quarter of the memory. Python 3.10 has it in dataclass()."""
    names = tuple(field.name for field in fields(kind))
    content = {name: value for name, value in vars(kind).items() if name not in (*names, "__dict__", "__weakref__")}
    return type(kind.__name__, (), {**content, "__slots__": names})


@_with_slots
@dataclass
class State:
    """SI units, track axes (x forward, y left, z up). None: not given."""
    time_ns: int
    x: float = 0.0         # axle centre
    y: float = 0.0
    z: float = 0.0
    roll: float = 0.0
    yaw: float = 0.0
    force_z: Optional[float] = None   # of the vehicle on the axle centre, up positive: a load is negative
    torque_x: Optional[float] = None
    left_lateral_force: Optional[float] = None   # Y on the rail, outward positive on both sides
    right_lateral_force: Optional[float] = None
    # Displacements of the rail heads from the ideal track, without the deflection under the wheel: lateral outward positive on
    # both sides, vertical up positive, roll positive when the crown moves outward
    left_rail_lateral: Optional[float] = None
    left_rail_vertical: Optional[float] = None
    left_rail_roll: Optional[float] = None
    right_rail_lateral: Optional[float] = None
    right_rail_vertical: Optional[float] = None
    right_rail_roll: Optional[float] = None
    distance: Optional[float] = None   # place along the line
    speed: Optional[float] = None      # velocities of the axle centre; without a speed none is written
    lateral_velocity: Optional[float] = None
    vertical_velocity: Optional[float] = None
    roll_rate: Optional[float] = None
    rotation: Optional[float] = None   # about the axle, positive when it rolls forward
    yaw_rate: Optional[float] = None
    # Velocities of the rail heads by their vibration, with the signs of the displacements
    left_rail_lateral_velocity: Optional[float] = None
    left_rail_vertical_velocity: Optional[float] = None
    left_rail_roll_rate: Optional[float] = None
    right_rail_lateral_velocity: Optional[float] = None
    right_rail_vertical_velocity: Optional[float] = None
    right_rail_roll_rate: Optional[float] = None
    pitch: Optional[float] = None   # angle about the axle, positive as the wheelset rolls forward


def stamp_of(time_ns):
    return genpy.Time(time_ns // 10**9, time_ns % 10**9)


def _header(message, state):
    message.header.stamp = stamp_of(state.time_ns)
    message.header.frame_id = FRAME
    return message


def _pose(state):
    message = _header(PoseStamped(), state)
    message.pose.position.x, message.pose.position.y, message.pose.position.z = state.x, state.y, state.z
    # rotation Rz(yaw) Rx(roll) Ry(pitch)
    cr, sr, cy, sy, cp, sp = (f(a / 2) for a in (state.roll, state.yaw, state.pitch or 0.0) for f in (math.cos, math.sin))
    q = message.pose.orientation
    x, y, z, w = cy * sr, sy * sr, sy * cr, cy * cr
    q.x, q.y, q.z, q.w = x * cp - z * sp, y * cp + w * sp, z * cp + x * sp, w * cp - y * sp
    return message


def _wrench(state, force_y=0.0, force_z=0.0, torque_x=0.0):
    message = _header(WrenchStamped(), state)
    message.wrench.force.y, message.wrench.force.z, message.wrench.torque.x = force_y, force_z, torque_x
    return message


def _displacements(state):
    """Displacements of both rails as a message, in which components that are not given are 0. None if none is given."""
    given = {(side, name): getattr(state, f"{side}_rail_{name}") for side in SIDES for name in DISPLACEMENT}
    if all(value is None for value in given.values()):
        return None
    message = _header(RailDisplacements(), state)
    for (side, name), value in given.items():
        setattr(getattr(message, side), name, value or 0.0)
    return message


def _distance(state):
    message = _header(PointStamped(), state)
    message.point.x = state.distance
    return message


def _twist(state):
    message = _header(TwistStamped(), state)
    for (group, axis), name in TWIST.items():
        setattr(getattr(message.twist, group), axis, getattr(state, name) or 0.0)
    return message


def write_bag(path, states, wheelset=""):
    """Writes states to a bag for contact_node and contact_replay. The same states give the same bytes."""
    write_wheelsets(path, {wheelset: states})


def write_wheelsets(path, states):
    """The same for several wheelsets, in the order of their times: namespace -> states."""
    bag = rosbag.Bag(str(path), "w", compression=rosbag.Compression.BZ2)
    for state, wheelset in heapq.merge(*map(_named, states.values(), states), key=lambda row: row[0].time_ns):
        _write_state(bag, state, f"{wheelset}/wheelset/")
    bag.close()  # not after an error: on a full disk, close() raises another error, which would hide the first one


def _named(states, wheelset):
    for state in states:
        yield state, wheelset


def _write_state(bag, state, topics):
    stamp = stamp_of(state.time_ns)
    bag.write(topics + "pose", _pose(state), stamp)
    if state.force_z is not None:
        bag.write(topics + "load", _wrench(state, 0.0, state.force_z, state.torque_x or 0.0), stamp)
    for side in SIDES:
        force = getattr(state, f"{side}_lateral_force")
        if force is not None:
            bag.write(f"{topics}{side}_rail_force", _wrench(state, force_y=force), stamp)
    displacements = _displacements(state)
    if displacements is not None:
        bag.write(topics + "rail_displacement", displacements, stamp)
    if state.distance is not None:
        bag.write(topics + "distance", _distance(state), stamp)
    if state.speed is not None:
        bag.write(topics + "twist", _twist(state), stamp)


def read_bag(path, wheelset="", remarks=None, progress=no_progress):
    """States of a bag in the order of their stamps. The other messages are assigned to the pose with the same stamp.

    @param remarks list to which a line is added for each kind of message that is left out
    """
    prefix = f"{wheelset}/wheelset/"
    states = {}
    others = []
    left_out = collections.Counter()
    try:
        for kind, message in _messages(path, prefix, progress):
            if kind not in KINDS:
                continue
            stamp = message.header.stamp.to_nsec()
            if stamp == 0:
                left_out[f"{kind}: stamp 0, which means that the stamp is unknown"] += 1
            elif kind == "pose":
                left_out["pose: stamp of another pose, which is replaced"] += stamp in states
                states[stamp] = _state_of(message)
            else:
                others.append((kind, message))
    except rosbag.ROSBagException as error:
        raise Failure(f"{path}: {error}") from None
    if not states:
        raise Failure(f"{path}: no messages on {prefix}pose" + (" with a stamp" if left_out else ""))
    for kind, message in others:
        stamp = message.header.stamp.to_nsec()
        left_out[f"{kind}: no pose with the same stamp"] += stamp not in states
        _add(states.get(stamp), kind, message)
    _forget_zeros(states.values())
    if remarks is not None:
        remarks += [f"{count} left out, {reason}" for reason, count in left_out.items() if count]
    return [states[time] for time in sorted(states)]


def _forget_zeros(states):
    """A message has the pitch and the velocities of the rails even if they are not known: zero."""
    for name in ("pitch", *(f"{side}_rail_{velocity}" for side in SIDES for velocity in RAIL_VELOCITY)):
        if not any(getattr(state, name) for state in states):
            for state in states:
                setattr(state, name, None)


def _messages(path, prefix, progress):
    """Yields each message whose topic begins with the prefix, preceded by the rest of its topic."""
    with opened(path) as bag:
        names = {topic: "/" + topic.lstrip("/") for topic in bag.get_type_and_topic_info().topics}
        wanted = [topic for topic, name in names.items() if name.startswith(prefix)]
        messages = bag.read_messages(topics=wanted) if wanted else ()
        for topic, message, _ in shown(messages, bag.get_message_count(wanted or None), progress, "message"):
            yield names[topic][len(prefix):], message


def _state_of(message):
    position, q = message.pose.position, message.pose.orientation
    axle = (2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x**2 + q.z**2), 2 * (q.y * q.z + q.w * q.x))
    yaw = math.atan2(0.0 - axle[0], axle[1])
    along = [math.cos(yaw) * x + math.sin(yaw) * y for x, y in (  # x and z axis of the pose, along the running direction
        (1 - 2 * (q.y**2 + q.z**2), 2 * (q.x * q.y + q.w * q.z)), (2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x)))]
    return State(message.header.stamp.to_nsec(), position.x, position.y, position.z, yaw=yaw,
                 roll=math.asin(max(-1.0, min(1.0, axle[2]))), pitch=round(math.atan2(along[1], along[0]), 12))


def _add(state, kind, message):
    if state is None:
        return
    if kind == "load":
        state.force_z, state.torque_x = message.wrench.force.z, message.wrench.torque.x
    elif kind == "left_rail_force":
        state.left_lateral_force = message.wrench.force.y
    elif kind == "right_rail_force":
        state.right_lateral_force = message.wrench.force.y
    elif kind == "rail_displacement":
        for side in SIDES:
            for name in DISPLACEMENT:
                setattr(state, f"{side}_rail_{name}", getattr(getattr(message, side), name, 0.0))  # older: no velocities
    elif kind == "distance":
        state.distance = message.point.x
    elif kind == "twist":
        for (group, axis), name in TWIST.items():
            setattr(state, name, getattr(getattr(message.twist, group), axis))
