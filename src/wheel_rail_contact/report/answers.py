# SPDX-License-Identifier: BSD-3-Clause
"""Answers of a bag as arrays. Pressure grids are kept only of the answers that are asked for."""
import re
from dataclasses import dataclass, field

import numpy as np
import rosbag
from wheel_rail_contact.msg import WheelsetContact

from ..command import Failure
from ..message_constants import USABLE


@dataclass
class Answers:
    """SI units, track axes. Histories have one value for each answer, patches one for each patch of a usable answer."""
    stamp: np.ndarray = None
    status: np.ndarray = None
    y: np.ndarray = None
    z: np.ndarray = None
    roll: np.ndarray = None
    yaw: np.ndarray = None
    rail: np.ndarray = None        # (answer, side, lateral vertical roll Y Q)
    patches: dict = None           # by name: arrays; `answer` is the index of the patch's answer
    reasons: dict = field(default_factory=dict)    # (status, text without figures) -> [number, first text]
    outlines: dict = field(default_factory=dict)   # "rail", "wheel", "reference" of the left side -> (n, 2) y, z, if told
    parameters: str = ""


PATCH_FIELDS = ("contact_angle", "normal_force", "approach", "area", "max_pressure", "error_estimate", "iterations")
OUTLINES = {"rail": "rail_outline", "wheel": "wheel_outline", "reference": "rail_reference"}  # by field of the header
RAIL_FIELDS = ("lateral", "vertical", "roll", "lateral_force", "vertical_force")


def _answer(raw):
    """A message from its bytes; grids as numpy arrays."""
    return WheelsetContact().deserialize_numpy(raw[1], np)


def find_topic(bag, wheelset):
    """The topic of the answers, as the bag writes it."""
    types, infos = bag.get_type_and_topic_info()
    if types.get(WheelsetContact._type, WheelsetContact._md5sum) != WheelsetContact._md5sum:
        raise Failure("its answers are those of another version of wheel_rail_contact; replay the states again")
    topics = [t for t, info in infos.items() if info.msg_type == WheelsetContact._type]
    if wheelset is not None:
        topics = [t for t in topics if t.lstrip("/").startswith((wheelset.strip("/") + "/").lstrip("/"))]
    if len(topics) != 1:
        raise Failure(f"{len(topics)} topics with answers: {' '.join(sorted(topics)) or 'none'}"
                          + (" (choose one with --wheelset)" if len(topics) > 1 else ""))
    return topics[0]


def read(path, wheelset=None):
    """All answers of a bag without their grids, and the topic they stand on."""
    try:
        with rosbag.Bag(str(path)) as bag:
            topic = find_topic(bag, wheelset)
            answers = _collect(_answer(raw) for _, raw, _ in bag.read_messages(topics=[topic], raw=True))
            _, _, _, header = next(bag.read_messages(topics=[topic], raw=True, return_connection_header=True))
    except rosbag.ROSBagException as error:
        raise Failure(f"{path}: {error}") from None
    answers.outlines = {kind: np.array(_text(header[name]).split(), float).reshape(-1, 2)
                        for kind, name in OUTLINES.items() if name in header}
    answers.parameters = _text(header.get("contact_replay", ""))
    return answers, topic


def _text(value):
    """A field of a connection header: rosbag leaves those it does not know as bytes."""
    return value.decode() if isinstance(value, bytes) else value


def _collect(stream):
    histories, rails, patches, names = [], [], [], []
    answers = Answers()
    for index, message in enumerate(stream):
        p, q = message.wheelset.position, message.wheelset.orientation
        histories.append((message.header.stamp.to_sec(), message.status, p.y, p.z, 2 * np.arctan2(q.x, q.w),
                          2 * np.arctan2(q.z, q.w)))
        rails.append([[getattr(rail, name) for name in RAIL_FIELDS] for rail in (message.left_rail, message.right_rail)])
        if message.status not in USABLE or message.status_text:
            key = (message.status, re.sub(r"\d+(\.\d+)?", "", message.status_text).replace("-", ""))
            answers.reasons.setdefault(key, [0, message.status_text])[0] += 1
        for patch in message.patches:
            o = patch.pose
            patches.append((index, patch.side, o.position.y, o.position.z, *(getattr(patch, f) for f in PATCH_FIELDS)))
            names.append(patch.method)
    if not histories:
        raise Failure("the bag holds no answer")
    answers.stamp, status, answers.y, answers.z, answers.roll, answers.yaw = np.array(histories, float).T
    answers.status = status.astype(int)
    answers.rail = np.array(rails, float)
    answers.rail[~np.isin(answers.status, USABLE)] = np.nan
    table = np.array(patches, float).reshape(-1, 4 + len(PATCH_FIELDS)).T
    answers.patches = dict(zip(("answer", "side", "y", "z", *PATCH_FIELDS), table))
    for name in ("answer", "side"):
        answers.patches[name] = answers.patches[name].astype(int)
    answers.patches["method"] = np.array(names, dtype=object)
    return answers


def of_answers(values, answers, index, reduce):
    """A value for each answer from those of its patches: "max" or "sum"; not a number where there is no patch."""
    operation, start = {"max": (np.fmax, np.nan), "sum": (np.add, 0.0)}[reduce]
    result = np.full(len(answers.stamp), np.nan)
    chosen = answers.patches["answer"][index]
    result[chosen] = start
    operation.at(result, chosen, values[index])
    return result


def full(path, topic, wanted):
    """The messages of some answers, by their index, with grids."""
    with rosbag.Bag(str(path)) as bag:
        stored = enumerate(bag.read_messages(topics=[topic], raw=True))
        return {index: _answer(raw) for index, (_, raw, _) in stored if index in wanted}
