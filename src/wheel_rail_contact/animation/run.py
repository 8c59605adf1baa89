# SPDX-License-Identifier: BSD-3-Clause
"""Data that an animation shows of the results in one bag."""
from dataclasses import dataclass

import numpy as np

from ..command import Failure
from ..message_constants import SIDES, STATUSES, USABLE
from ..report.results import RAIL_FIELDS, per_result, rail_outline, read, read_full
from .section import MM, MPA, section


@dataclass
class Run:
    """Histories have one value per instant shown. Lengths in mm, forces in kN, pressures in MPa."""
    label: str
    stamp: np.ndarray       # [s]
    status: np.ndarray
    outward: np.ndarray     # displacement of the wheelset towards the side
    lateral: np.ndarray     # displacement of the rail head, outward positive
    force: np.ndarray       # lateral force on the rail, outward positive
    pressure: np.ndarray    # highest pressure of the side
    sections: list
    texts: list
    rest: np.ndarray        # outline of the undeflected rail, (n, 2)
    reference: np.ndarray   # reference point of the rail head, at which the deflection is given


def instants(count, frames):
    """Indices of at most `frames` evenly spaced results, including the first and the last one."""
    return np.unique(np.linspace(0, count - 1, min(frames, count)).round().astype(int))


def _text(message, side, lateral, force, pressure):
    if message.status not in USABLE:
        return f"{STATUSES[message.status]}\n{message.status_text}"
    patches = [patch for patch in message.patches if patch.side == side]
    if not patches:
        return f"LIFT_OFF: the {SIDES[side]} wheel carries no load"
    area = 1e6 * sum(patch.area for patch in patches)
    angle = max((np.degrees(patch.contact_angle) for patch in patches), key=abs)
    return (f"p max {pressure:5.0f} MPa   area {area:4.0f} mm²   angle {angle:3.0f}°\n"
            f"outward: force {force:5.1f} kN   rail head {lateral:5.2f} mm")


def read_run(path, label, side, frames, wheelset):
    """Reads the results of a bag. Raises Failure if it contains no outlines of the profiles, or no contact."""
    results, topic = read(path, wheelset)
    outlines = results.outlines[side]
    if "reference" not in outlines:
        raise Failure(f"{path}: does not contain the outlines of the profiles; write the results with contact_replay")
    if np.size(results.patches["result"]) == 0:
        raise Failure(f"{path}: no result has a contact")
    chosen = instants(len(results.stamp), frames)
    messages = read_full(path, topic, set(chosen.tolist()))
    of_side = np.flatnonzero(results.patches["side"] == side)
    pressure = MPA * per_result(results.patches["max_pressure"], results, of_side, "max")[chosen]
    if not np.nan_to_num(pressure).any():
        raise Failure(f"{path}: no result to be shown has a contact on the {SIDES[side]} side")
    lateral = MM * results.rail[chosen, side, RAIL_FIELDS.index("lateral")]
    force = 1e-3 * results.rail[chosen, side, RAIL_FIELDS.index("lateral_force")]
    return Run(label=label, stamp=results.stamp[chosen], status=results.status[chosen],
               outward=MM * (1, -1)[side] * results.y[chosen], lateral=lateral, force=force, pressure=pressure,
               sections=[section(messages[i], side, {**outlines, "rail": rail_outline(results, side, results.distance[i])})
                         for i in chosen],
               texts=[_text(messages[i], side, *row) for i, *row in zip(chosen, lateral, force, pressure)],
               rest=MM * outlines["rail"], reference=MM * outlines["reference"][0])
