# SPDX-License-Identifier: BSD-3-Clause
"""What an animation shows of one bag of answers."""
from dataclasses import dataclass

import numpy as np

from ..command import Failure
from ..message_constants import SIDES, STATUSES, USABLE
from ..report.answers import RAIL_FIELDS, full, of_answers, read
from .section import MM, MPA, section


@dataclass
class Run:
    """Histories have a value for each instant shown; lengths in mm, forces in kN, pressures in MPa."""
    label: str
    stamp: np.ndarray       # [s]
    status: np.ndarray
    outward: np.ndarray     # way of the wheelset towards the side
    lateral: np.ndarray     # way of the rail's head, outward
    force: np.ndarray       # that bends the rail, outward
    pressure: np.ndarray    # highest
    sections: list
    texts: list
    rest: np.ndarray        # section of the rail at rest
    reference: np.ndarray   # the point of its head whose way the answers tell


def instants(count, frames):
    """Indices of answers, evenly spread, the first and the last among them."""
    return np.unique(np.linspace(0, count - 1, min(frames, count)).round().astype(int))


def _text(message, side, lateral, force, pressure):
    if message.status not in USABLE:
        return f"{STATUSES[message.status]}\n{message.status_text}"
    area = 1e6 * sum(patch.area for patch in message.patches if patch.side == side)
    angle = max((np.degrees(patch.contact_angle) for patch in message.patches if patch.side == side), default=0)
    return (f"p max {pressure:5.0f} MPa   area {area:4.0f} mm²   angle {angle:3.0f}°\n"
            f"outward force {force:5.1f} kN   rail moves {lateral:5.2f} mm")


def read_run(path, label, side, frames, wheelset):
    """Raises Failure for a bag that does not tell the profiles or holds no pressure."""
    answers, topic = read(path, wheelset)
    if "reference" not in answers.outlines:
        raise Failure(f"{path}: does not tell the profiles; make the answers with contact_replay")
    if np.size(answers.patches["answer"]) == 0:
        raise Failure(f"{path}: no answer has a contact")
    chosen = instants(len(answers.stamp), frames)
    messages = full(path, topic, set(chosen.tolist()))
    of_side = np.flatnonzero(answers.patches["side"] == side)
    pressure = MPA * of_answers(answers.patches["max_pressure"], answers, of_side, "max")[chosen]
    if not np.nanmax(pressure, initial=0) > 0:
        raise Failure(f"{path}: no answer that would be shown has a contact on the {SIDES[side]} side")
    lateral = MM * answers.rail[chosen, side, RAIL_FIELDS.index("lateral")]
    force = 1e-3 * answers.rail[chosen, side, RAIL_FIELDS.index("lateral_force")]
    return Run(label=label, stamp=answers.stamp[chosen], status=answers.status[chosen],
               outward=MM * (1, -1)[side] * answers.y[chosen], lateral=lateral, force=force, pressure=pressure,
               sections=[section(messages[i], side, answers.outlines) for i in chosen],
               texts=[_text(messages[i], side, *row) for i, *row in zip(chosen, lateral, force, pressure)],
               rest=MM * answers.outlines["rail"], reference=MM * answers.outlines["reference"][0])
