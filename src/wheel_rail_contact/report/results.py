# SPDX-License-Identifier: BSD-3-Clause
"""Reads the results in a bag into arrays. Pressure grids are read only for selected results."""
import operator
import re
import struct
from dataclasses import dataclass, field, replace

import numpy as np
import rosbag
from wheel_rail_contact.msg import WheelsetContact

from ..bags import opened
from ..command import Failure
from ..message_constants import USABLE


@dataclass
class Results:
    """SI units, track axes. Histories have one value per result, patches one value per patch of a usable result. The pose of an
    input that was rejected before the evaluation is not known, unless it is held: its y and yaw are NaN."""
    stamp: np.ndarray = None
    status: np.ndarray = None
    x: np.ndarray = None
    y: np.ndarray = None
    z: np.ndarray = None
    roll: np.ndarray = None
    yaw: np.ndarray = None
    distance: np.ndarray = None    # place on the line
    held: np.ndarray = None        # True: refused, and the forces of the last usable result were repeated
    rail: np.ndarray = None        # (result, side, RAIL_FIELDS); NaN if not usable
    wheel: np.ndarray = None       # (result, side, WHEEL_FIELDS); NaN if not usable
    patches: dict = None           # name -> array; `result` is the index of the result to which the patch belongs
    reasons: dict = field(default_factory=dict)    # (status, text without numbers) -> [count, first text]
    outlines: list = field(default_factory=lambda: [{}, {}])   # left, right: "rail", "wheel", "reference" -> (n, 2) outward y,
                                                               # z; may be empty
    sections: list = field(default_factory=lambda: [[], []])   # left, right: (place on the line, (n, 2) outward y, z) of the
                                                               # outlines of a rail that changes, else empty
    parameters: str = ""


ALWAYS = (-np.inf, np.inf)
FAR_BELOW = -0.1  # [m] height below all pictures
PATCH_FIELDS = ("contact_angle", "normal_force", "approach", "area", "max_pressure", "error_estimate", "iterations",
                "semi_axis_along", "semi_axis_across", "rolling_radius", "wheel_s", "rail_s", "wheel_stress.von_mises.value",
                "rail_stress.von_mises.value", "creep.adhesion_share", "creep.power")
OF_PATCH = operator.attrgetter(*PATCH_FIELDS)
OUTLINES = {"rail": "rail_outline", "wheel": "wheel_outline", "reference": "rail_reference"}  # -> end of the header's field
RAIL_FIELDS = ("lateral", "vertical", "roll", "lateral_force", "vertical_force", "given_lateral", "given_vertical")
WHEEL_FIELDS = ("lateral_force", "vertical_force", "friction_lateral_force")


def _messages(bag, topic, span):
    """Bytes of the messages with stamps in a span [s], in the order of the bag."""
    for _, raw, _ in bag.read_messages(topics=[topic], raw=True):
        seconds, nanoseconds = struct.unpack_from("<II", raw[1], 4)  # the header comes first
        if span[0] <= seconds + 1e-9 * nanoseconds <= span[1]:
            yield raw[1]


def _message(data):
    """A message from its bytes, with grids as numpy arrays."""
    return WheelsetContact().deserialize_numpy(data, np)


def find_topic(bag, wheelset):
    """The topic of the results, as it is written in the bag."""
    types, infos = bag.get_type_and_topic_info()
    if types.get(WheelsetContact._type, WheelsetContact._md5sum) != WheelsetContact._md5sum:
        raise Failure("the results are from another version of wheel_rail_contact; replay the states again, or convert "
                      "the bag with `rosbag fix` (doc/replay.md)")
    topics = [t for t, info in infos.items() if info.msg_type == WheelsetContact._type]
    if wheelset is not None:
        topics = [t for t in topics if t.lstrip("/").startswith((wheelset.strip("/") + "/").lstrip("/"))]
    if len(topics) != 1:
        raise Failure(f"{len(topics)} topics with results: {' '.join(sorted(topics)) or 'none'}"
                      + (" (select one with --wheelset)" if len(topics) > 1 else ""))
    return topics[0]


def read(path, wheelset=None, span=ALWAYS):
    """The results of a bag with stamps in a span [s], without their grids, and their topic."""
    try:
        with opened(path) as bag:
            topic = find_topic(bag, wheelset)
            results = _collect(map(_message, _messages(bag, topic, span)))
            _, _, _, header = next(bag.read_messages(topics=[topic], raw=True, return_connection_header=True))
    except rosbag.ROSBagException as error:
        raise Failure(f"{path}: {error}") from None
    results.outlines = [{kind: np.array(_text(header[side + name]).split(), float).reshape(-1, 2)
                         for kind, name in OUTLINES.items() if side + name in header} for side in ("left_", "right_")]
    results.sections = [_sections(_text(header.get(side + "rail_sections", ""))) for side in ("left_", "right_")]
    results.parameters = _text(header.get("contact_replay", ""))
    return results, topic


def _text(value):
    """A field of a connection header as text: rosbag returns fields that are unknown to it as bytes."""
    return value.decode() if isinstance(value, bytes) else value


def _sections(text):
    """Outlines of a rail that changes along the line: a line "x PLACE" comes before the points of each one."""
    blocks = [block.split() for block in text.split("x ")[1:]]
    return [(float(block[0]), np.array(block[1:], float).reshape(-1, 2)) for block in blocks]


def _collect(stream):
    histories, rails, wheels, patches, names, has_pose = [], [], [], [], [], []
    results = Results()
    for index, message in enumerate(stream):
        p, q = message.wheelset.position, message.wheelset.orientation
        histories.append((message.header.stamp.to_sec(), message.status, p.x, p.y, p.z, 2 * np.arctan2(q.x, q.w),
                          2 * np.arctan2(q.z, q.w), message.distance, message.held))
        has_pose.append(any((q.x, q.y, q.z, q.w)))
        rails.append([[getattr(rail, name) for name in RAIL_FIELDS] for rail in (message.left_rail, message.right_rail)])
        wheels.append([[getattr(wheel, name) for name in WHEEL_FIELDS] for wheel in (message.left_wheel, message.right_wheel)])
        if message.status not in USABLE or message.status_text:
            key = (message.status, re.sub(r"\d+(\.\d+)?", "", message.status_text).replace("-", ""))
            results.reasons.setdefault(key, [0, message.status_text])[0] += 1
        for patch in () if message.held else message.patches:
            o = patch.pose
            patches.append((index, patch.side, o.position.y, o.position.z, *OF_PATCH(patch)))
            names.append(patch.method)
    if not histories:
        raise Failure("the bag contains no results, or none from --from to --to")
    results.stamp, status, results.x, results.y, results.z, results.roll, results.yaw, results.distance, held = np.array(
        histories, float).T
    results.status, results.held = status.astype(int), held.astype(bool)
    results.rail, results.wheel = np.array(rails, float), np.array(wheels, float)
    for forces in (results.rail, results.wheel):
        forces[~np.isin(results.status, USABLE)] = np.nan
    unknown = ~np.array(has_pose)
    results.y[unknown] = results.yaw[unknown] = np.nan
    table = np.array(patches, float).reshape(-1, 4 + len(PATCH_FIELDS)).T
    results.patches = dict(zip(("result", "side", "y", "z", *PATCH_FIELDS), table))
    for name in ("result", "side"):
        results.patches[name] = results.patches[name].astype(int)
    results.patches["method"] = np.array(names, dtype=object)
    return results


def part_of(results, chosen):
    """The results of a slice, with their patches."""
    patches = results.patches
    inside = (patches["result"] >= chosen.start) & (patches["result"] < chosen.stop)
    histories = {name: values[chosen] for name, values in vars(results).items() if isinstance(values, np.ndarray)}
    of_part = {name: values[inside] for name, values in patches.items()}
    return replace(results, **histories, patches={**of_part, "result": of_part["result"] - chosen.start})


def rail_outline(results, side, distance):
    """Outline of the undeflected rail at a place of the line (n, 2), outward y and z [m]. Parts are joined far below."""
    places = np.array([x for x, _ in results.sections[side]])
    if not len(places):
        return results.outlines[side]["rail"]
    nearest = places[np.argmin(np.abs(places - distance))]
    parts = sorted((outline for x, outline in results.sections[side] if x == nearest), key=lambda part: part[:, 0].mean())
    return np.vstack([np.vstack([(part[0, 0], FAR_BELOW), part, (part[-1, 0], FAR_BELOW)]) for part in parts])


def has_friction(results):
    """True if there are creep forces."""
    return bool(results.patches["creep.power"].any())


def per_result(values, results, index, reduce):
    """One value per result, from the values of its patches.

    @param values one per patch
    @param index the patches to include
    @param reduce "max" or "sum"
    @return NaN for a result without such a patch
    """
    operation, start = {"max": (np.fmax, np.nan), "sum": (np.add, 0.0)}[reduce]
    reduced = np.full(len(results.stamp), np.nan)
    chosen = results.patches["result"][index]
    reduced[chosen] = start
    operation.at(reduced, chosen, values[index])
    return reduced


def main_patch(results, side):
    """Index of the patch with the largest normal force of a wheel, for each result (n,); -1 where the wheel has none."""
    patches = results.patches
    of_side = np.flatnonzero(patches["side"] == side)
    chosen = np.full(len(results.stamp), -1)
    order = of_side[np.argsort(patches["normal_force"][of_side], kind="stable")]
    chosen[patches["result"][order]] = order  # the last value of each result remains
    return chosen


def of_patches(results, name, index):
    """Values of patches; NaN where the index is -1."""
    return np.where(index >= 0, np.append(results.patches[name], np.nan)[index], np.nan)


def read_full(path, topic, wanted, span=ALWAYS):
    """Messages with grids of the results of read() with the indices `wanted`, as a dictionary by index."""
    with opened(path) as bag:
        return {index: _message(data) for index, data in enumerate(_messages(bag, topic, span)) if index in wanted}
