# SPDX-License-Identifier: BSD-3-Clause
"""Bounds for the results of a contact node, read from parameters, and their violations. Does not depend on a ROS node."""
import math
import operator
from dataclasses import dataclass, field

from ..message_constants import SIDES, STATUSES, USABLE
from . import axle_verdict
from .axle import AxleLimits, Sample, history, read_axle_limits
from .parameters import BadParameter, bound, broken, group, merged, number, positive, whole_number, yes_or_no

QUANTITIES = {  # of each patch -> unit
    "max_pressure": "Pa",
    "area": "m^2",
    "contact_angle": "rad",
    "normal_force": "N",
    "approach": "m",
    "error_estimate": "-",
    "vertical_force": "N",
    "lateral_force": "N",
    "semi_axis_along": "m",
    "semi_axis_across": "m",
    "rolling_radius": "m",
    "normal_stiffness": "N/m",
    "adhesion_share": "-",
    "friction_power": "W",
}
OF_CREEP = {"adhesion_share": "creep.adhesion_share", "friction_power": "creep.power"}  # -> place in the message of a patch


@dataclass
class Limits:
    """Requirements for the results. The names of the fields are those of the parameters."""
    results: int = 1              # minimum number of results
    refusals: int = 0             # maximum number of results that are not usable
    lift_offs: int = 0            # maximum number of results in which a wheel carries no load
    least_load: float = 1e3       # smallest mean wheel load with wheels of 0.46 m; it scales with their squared radius [N]
    implausible_forces: int = 0   # maximum number of usable results with an implausible contact force (implausible_force)
    flange_contact: bool = True   # False: a contact angle of flange_angle or more, of either sign, is a violation
    flange_angle: float = 0.7     # contact angle from which a patch counts as flange contact [rad]
    patience: float = 60.0        # maximum wall time until the first result [s]
    idle: float = 3.0             # wall time without a result after which the run is considered finished [s]
    bounds: dict = field(default_factory=dict)  # name in QUANTITIES -> (min, max)
    axle: AxleLimits = None  # limits of wheels and axle


PARSERS = {"results": whole_number, "refusals": whole_number, "lift_offs": whole_number, "least_load": number,
           "implausible_forces": whole_number, "flange_contact": yes_or_no, "flange_angle": number, "patience": positive,
           "idle": positive}


def read_limits(parameters):
    """Limits from the private parameters of the node. Raises BadParameter for an invalid value or an unknown name."""
    limits = Limits()
    for name, value in parameters.items():
        if name == "bounds":
            limits.bounds = {quantity: bound(f"bounds/{quantity}", ends)
                             for quantity, ends in group("bounds", value, QUANTITIES).items()}
        elif name == "axle":
            limits.axle = read_axle_limits(value)
        elif name in PARSERS:
            setattr(limits, name, PARSERS[name](name, value))
        else:
            raise BadParameter(f"{name} = {value!r}: unknown parameter; valid names are "
                               + ", ".join([*PARSERS, "bounds", "axle", "nodes"]))
    return limits


def read_nodes(parameters):
    """Topic and Limits of each node to check, by its name; without the group nodes one without a name."""
    common = {name: value for name, value in parameters.items() if name != "nodes"}
    if "nodes" not in parameters:
        return {"": ("contact", read_limits(common))}
    nodes = parameters["nodes"]
    if not isinstance(nodes, dict) or not nodes or not all(isinstance(own, dict) and isinstance(own.get("topic"), str) and
                                                           str(name).isidentifier() for name, own in nodes.items()):
        raise BadParameter(f"nodes = {nodes!r}: must be a group of names, each with the topic of its results")
    return {name: (own["topic"], read_limits(merged(common, {key: value for key, value in own.items() if key != "topic"})))
            for name, own in nodes.items()}


def check_names(limits):
    """Names of the checks. Each one is a test of the rostest."""
    flange = [] if limits.flange_contact else ["flange_contact"]
    of_axle = [f"axle_{name}" for name in limits.axle.bounds] if limits.axle else []
    return ["results", "refusals", "lift_offs", "loads", "implausible_forces", *flange, *limits.bounds, *of_axle]


def judge(limits, results):
    """Violations by the results, as texts by the name of the check, and remarks on what was not compared."""
    of_axle = history(limits.axle, map(sample, results)) if limits.axle else None
    found = {check: axle_verdict.violation(check[len("axle_"):], limits.axle, of_axle) if check.startswith("axle_")
             else _violation(check, limits, results) for check in check_names(limits)}
    return ({check: text for check, text in found.items() if text},
            axle_verdict.remarks(limits.axle, of_axle) if limits.axle else [])


def sample(result):
    """What a message contributes to the quantities of wheels and axle."""
    wheels = result.left_wheel, result.right_wheel
    return Sample(result.header.stamp.to_sec(), result.wheelset.position.x, result.distance,
                  [wheel.lateral_force for wheel in wheels], [wheel.vertical_force for wheel in wheels],
                  [wheel.friction_lateral_force for wheel in wheels], result.status in USABLE and not result.held)


def _violation(check, limits, results):
    """Violation of a check of results and patches, as text; empty if there is none."""
    if check == "results":
        return _too_few(limits, results)
    if check == "refusals":
        return _too_many("refused", limits.refusals, [r for r in results if r.status not in USABLE])
    if check == "lift_offs":
        return _too_many("with a wheel that carries no load", limits.lift_offs,
                         [r for r in results if STATUSES[r.status] == "LIFT_OFF"])
    if check == "loads":
        return _too_light(limits.least_load, [r for r in results if r.status in USABLE and not r.held])
    if check == "implausible_forces":
        return _too_many("with an implausible contact force", limits.implausible_forces,
                         [r for r in results if r.status in USABLE and r.implausible_force])
    if check == "flange_contact":
        return _outside("contact_angle", lambda angle: abs(angle) < limits.flange_angle, -limits.flange_angle,
                        limits.flange_angle, results, "flange contact: ")
    low, high = limits.bounds[check]
    return _outside(check, lambda value: low <= value <= high, low, high, results, "")


def _too_few(limits, results):
    return "" if len(results) >= limits.results else f"{len(results)} results, at least {limits.results} are required"


def _too_light(least, results):
    """A mean wheel load in another unit than N, or with the wrong sign."""
    height = sum(r.wheelset.position.z for r in results) / max(len(results), 1)
    least *= min(1.0, height / 0.46)**2
    mean = sum(r.left_wheel.vertical_force + r.right_wheel.vertical_force for r in results) / max(2 * len(results), 1)
    return "" if not results or mean >= least else (f"the mean wheel load is {mean:.4g} N, at least {least:g} N are required; "
                                                    "loads must be in N, and force.z negative")


def _when(result):
    """The stamp with milliseconds; it may be a time of day, with ten digits before the point."""
    return f"at {result.header.stamp.to_sec():.3f} s"


def _too_many(kind, allowed, results):
    if len(results) <= allowed:
        return ""
    first = results[0]
    return (f"{len(results)} results {kind}, {allowed} allowed; the first {_when(first)}: "
            f"{STATUSES[first.status]}: {first.status_text}")


def _outside(quantity, is_inside, low, high, results, prefix):
    value_of = operator.attrgetter(OF_CREEP.get(quantity, quantity))
    patches = [(value_of(p), r, p) for r in results if not r.held for p in r.patches]
    if quantity == "normal_stiffness":  # not a number where no such stiffness exists, see ContactPatch
        patches = [entry for entry in patches if not math.isnan(entry[0])]
    outside = [entry for entry in patches if not is_inside(entry[0])]
    if not outside:
        return ""
    value, result, patch = max(outside, key=lambda entry: max(low - entry[0], entry[0] - high))
    return (f"{prefix}{broken(quantity, value, low, high, QUANTITIES[quantity])} {_when(result)}, "
            f"{SIDES[patch.side]} wheel, y = {1e3 * result.wheelset.position.y:.4g} mm "
            f"({len(outside)} of {len(patches)} patches are outside; this is the worst)")
