# SPDX-License-Identifier: BSD-3-Clause
"""Rolling radius difference of elastic wheels that carry a load, over the lateral displacement."""
import math

import numpy as np

from ..command import calculating

LONGEST_STEP = 0.1e-3  # of the curve, which is linear between them [m]
ROUND_OFF = 1e-6       # in the number of steps
# Both wheels carry the given load at every lateral displacement, in the ideal track, and without creep forces.
CONFIG = {"wheelset": {"free": ["z", "roll"], "balance": "wheel_loads"}, "creep": {"method": "none"},
          "track": {"line": "", "publish_track_frame": "", "displacement": "none", "distance": "pose"},
          "rail_bending": {"lateral_force": "contact", "neighbours": []}}


def loaded_points(configs, y, load, distance):
    """Rolling radii under load: a table as of tables.points_of(), and the curve for RadiusDifference.

    configs: as for WheelsetContact. y: lateral displacements, increasing by equal steps [m]. load: vertical force of each wheel
    [N]. distance: place on the line [m], or None. The rolling radius of a wheel is that of its contacts at their centres of
    pressure, weighted by their normal forces.
    """
    from ..core.contact import WheelsetContact
    parts = max(1, math.ceil((y[1] - y[0]) / LONGEST_STEP - ROUND_OFF)) if len(y) > 1 else 1
    fine = np.interp(np.arange(parts * (len(y) - 1) + 1) / parts, np.arange(len(y)), y)
    with calculating():
        many = WheelsetContact([*configs, CONFIG]).evaluate_many(y=fine, force_z=-2 * load, distance=distance)
    carried = many.status == "OK"
    left, right = np.where(carried, many.mean_rolling_radius.T, np.nan)
    reasons = ["" if ok else status.lower() for ok, status in zip(carried, many.status)]
    columns = {"y": fine, "rolling_radius_difference": left - right, "left_rolling_radius": left, "right_rolling_radius": right,
               "reason": reasons}
    return {name: column[::parts] for name, column in columns.items()}, _longest_curve(fine, left - right)


def _longest_curve(y, difference):
    """Points (n, 2) of y and rolling radius difference [m], over the longest range of y with results."""
    ends = np.flatnonzero(np.diff(np.concatenate([[False], np.isfinite(difference), [False]]).astype(int))).reshape(-1, 2)
    begin, end = max(ends, key=np.ptp, default=(0, 0))
    return np.column_stack([y, difference])[begin:end]
