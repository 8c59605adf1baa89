# SPDX-License-Identifier: BSD-3-Clause
"""Rolling radius difference of elastic wheels that carry a load, over the lateral displacement."""
import numpy as np

from ..command import calculating

# Both wheels carry the given load at every lateral displacement, in the ideal track, and without creep forces.
CONFIG = {"wheelset": {"free": ["z", "roll"], "balance": "wheel_loads"}, "creep": {"method": "none"},
          "track": {"line": "", "publish_track_frame": "", "displacement": "none", "distance": "pose"},
          "rail_bending": {"lateral_force": "contact", "neighbours": []}}


def loaded_points(configs, y, load, distance):
    """Rolling radii under load: a table as of tables.points_of().

    configs: as for WheelsetContact. y: lateral displacements [m]. load: vertical force of each wheel [N]. distance: place on
    the line [m], or None. The rolling radius of a wheel is that of its contacts at their centres of pressure, weighted by their
    normal forces.
    """
    from ..core.contact import WheelsetContact
    with calculating():
        many = WheelsetContact([*configs, CONFIG]).evaluate_many(y=y, force_z=-2 * load, distance=distance)
    carried = many.status == "OK"
    left, right = np.where(carried, many.mean_rolling_radius.T, np.nan)
    return {"y": y, "rolling_radius_difference": left - right, "left_rolling_radius": left, "right_rolling_radius": right,
            "reason": ["" if ok else status.lower() for ok, status in zip(carried, many.status)]}


def longest_curve(points):
    """Points (n, 2) of y and rolling radius difference [m] of a table, over the longest range of y with results."""
    has_result = np.isfinite(points["rolling_radius_difference"])
    ends = np.flatnonzero(np.diff(np.concatenate([[False], has_result, [False]]).astype(int))).reshape(-1, 2)
    begin, end = max(ends, key=np.ptp, default=(0, 0))
    return np.column_stack([points["y"], points["rolling_radius_difference"]])[begin:end]
