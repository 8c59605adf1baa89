# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the quantities of wheels and axle, with the limits that contact_check applies to them."""
import numpy as np
import yaml

from ..checking.axle import QUANTITIES, Sample, history
from ..checking.axle_verdict import remarks, treatment, violation
from ..checking.bounds import read_nodes
from ..checking.parameters import UNBOUNDED, BadParameter
from ..command import Failure, pyplot
from ..message_constants import USABLE
from . import marks
from .drawing import COLOURS, draw_history, limit_zoom, save
from .histories import time_axis
from .results import WHEEL_FIELDS

LIMIT = "tab:red"
KILO = {"N": ("kN", 1e-3), "-": ("-", 1.0)}


def read_limits(path, topic):
    """AxleLimits from a parameter file of contact_check: of the node with this topic, if the file has the group nodes."""
    try:
        with open(path, encoding="utf-8") as file:
            nodes = read_nodes(yaml.safe_load(file))
    except (BadParameter, yaml.YAMLError, AttributeError) as error:
        raise Failure(f"{path}: is no parameter file of contact_check: {error}") from error
    for name, (of_node, limits) in nodes.items():
        if limits.axle and (not name or of_node.strip("/") == topic.strip("/")):
            return limits.axle
    raise Failure(f"{path}: has no group axle for {topic}")


def of_results(limits, results):
    """History of the quantities of all results."""
    usable = np.isin(results.status, USABLE) & ~results.held
    forces = (results.wheel[:, :, WHEEL_FIELDS.index(name)].tolist()
              for name in ("lateral_force", "vertical_force", "friction_lateral_force"))
    return history(limits, map(Sample, results.stamp.tolist(), results.x.tolist(), results.distance.tolist(), *forces,
                               usable.tolist()))


def items(results, limits, path):
    """For the page: the picture, the violations, and what was not compared."""
    found = of_results(limits, results)
    verdict = [text for text in (violation(name, limits, found) for name in limits.bounds) if text]
    return [_figure(results, limits, found, path), *(verdict or ["All limits are met."] * bool(limits.bounds)),
            *(f"Not compared, or lacking: {remark}." for remark in remarks(limits, found))]


def _figure(results, limits, found, path):
    """The quantities over time, each with its limits. Returns the path."""
    picture, axes = pyplot().subplots(len(found.values), 1, sharex=True, figsize=(10, 0.5 + 1.6 * len(found.values)),
                                      constrained_layout=True)
    origin, label = time_axis(results)
    time = results.stamp - origin
    for axis, (name, values) in zip(axes, found.values.items()):
        symbol, unit = QUANTITIES[name]
        unit, scale = KILO[unit]
        for column, colour in zip(values.T, COLOURS if values.shape[1] == 2 else "k"):
            draw_history(axis, time, scale * column, results, color=colour, linewidth=1.1)
        for end in limits.bounds.get(name, ()):
            if abs(end) < UNBOUNDED:
                axis.axhline(scale * end, color=LIMIT, linestyle="--", linewidth=1)
        axis.set_ylabel(f"{symbol} [{unit}]")
        axis.set_title(treatment(name, limits), fontsize="small", loc="left")
        axis.grid(alpha=0.3)
        limit_zoom(axis)
    line = pyplot().Line2D
    entries = [line([], [], color=colour, label=side) for colour, side in zip(COLOURS, ("left", "right"))]
    marks.draw(axes, time, results)
    marks.legend(axes[0], results, [*entries, line([], [], color=LIMIT, linestyle="--", label="limit")])
    axes[-1].set_xlabel(label)
    return save(picture, path)
