# SPDX-License-Identifier: BSD-3-Clause
"""Writes the compliance table for the contact node: YAML, with a description of its keys at the beginning."""
import json
import math

from . import calculix, gmsh_mesh
from .analysis import COMPLIANCES, estimated_error
from .loads import REFERENCE_DEPTH

HEAD = """\
# Compliance of one rail head under a wheel, read by the contact node (SI units, axes of the upright rail).
#
#   [lateral; roll] = [[lateral_lateral, lateral_roll], [lateral_roll, roll_roll]] [Y; M]
#   vertical = -vertical_vertical Q
#
# Forces: Y [N] lateral, outward (field side) positive; Q [N] vertical, down positive; M [N m] moment of both about the
# reference point, outward roll positive. The reference point is on the rail axis, reference_depth below the crown.
# Displacements (small): lateral [m] outward positive, vertical [m] up positive, roll [rad] outward positive.
#
# Keys (all are required, no others are allowed, numbers are finite unless stated otherwise):
#   name                 string
#   reference_depth      [m], must be 0.014
#   lateral_lateral      [m/N]        outward displacement of the reference point per Y
#   lateral_roll         [rad/N]      roll per Y = [m/(N m)] outward displacement per M (Maxwell-Betti)
#   roll_roll            [rad/(N m)]  roll per M; the 2x2 matrix is positive definite
#   vertical_vertical    [m/N]        downward displacement per Q, > 0
#   linear_range_lateral_to_vertical  largest |Y|/Q for which the table is valid, > 0; .inf: no limit
#   neighbours           list, may be empty, distances strictly increasing: influence of a force on the same rail at
#                        `distance` [m] along it, by the same four compliances (any sign)
#   provenance           map with the origin of the numbers; not used by the node
"""
UNITS = {"lateral_lateral": "m/N", "lateral_roll": "rad/N", "roll_roll": "rad/(N m)", "vertical_vertical": "m/N"}


def table_text(name, study, fine, coarse, command):
    """Text of the file, from the solutions on the mesh of the given size (`fine`) and on the coarser mesh."""
    lines = [f"name: {name}", _number("reference_depth", REFERENCE_DEPTH, "m")]
    lines += _compliances(fine.compliance)
    lines += [_number("linear_range_lateral_to_vertical", study.linear_range, "-")]
    lines += ["neighbours:" if study.neighbours else "neighbours: []"]
    for distance, compliance in zip(study.neighbours, fine.neighbours):
        entry = [_number("distance", distance, "m")] + _compliances(compliance)
        lines += [("  - " if i == 0 else "    ") + line for i, line in enumerate(entry)]
    lines += ["provenance:", f"  command: {json.dumps(command)}"]
    lines += ["  " + line for line in _provenance(study, fine, coarse)]
    return HEAD + "\n".join(lines) + "\n"


def _number(key, value, unit, digits=4):
    """Line `key: value  # [unit]`. The value has a point and a signed exponent, which YAML 1.1 requires for a float."""
    text = ".inf" if math.isinf(value) else f"{value:.{digits}e}"
    return f"{key}: {text}  # [{unit}]"


def _compliances(values):
    return [_number(name, values[name], UNITS[name]) for name in COMPLIANCES]


def _provenance(study, fine, coarse):
    properties = study.section.properties()
    lines = ["section:", f"  name: {study.section.name}", "  " + _number("area", properties["area"], "m^2"),
             "  " + _number("second_moment_y", properties["second_moment_y"], "m^4, vertical bending"),
             "  " + _number("second_moment_z", properties["second_moment_z"], "m^4, lateral bending"),
             _number("young", study.young, "Pa"), _number("poisson", study.poisson, "-"),
             f"supports: {study.supports}", _number("length", study.length, "m")]
    lines += _pads(study) if study.pads else []
    return lines + [
        f"element: {study.element_type}", _number("mesh_size", study.mesh_size, "m"),
        f"elements: {len(fine.mesh.elements)}  # half the rail, symmetric about the load",
        f"unknowns: {fine.unknowns}",
        _number("estimated_discretisation_error", estimated_error(fine, coarse), "relative, largest of the four", 1),
        _number("maxwell_asymmetry", fine.asymmetry, "relative, roll per Y against displacement per M", 1),
        f"gmsh: '{gmsh_mesh.version()}'", f"calculix: '{calculix.version()}'",
        "check:  # a lateral force on the gauge face, no vertical one", "  " + _number("force", study.force, "N"),
        "  " + _number("height", study.check_height, "m above the foot's underside"),
        "  " + _number("crown_lateral", fine.check_crown, "m"), "  " + _number("head_roll", fine.check_roll, "rad")]


def _pads(study):
    pads = study.pads
    return ["pads:  # of one seat", "  " + _number("lateral", pads.lateral, "N/m"),
            "  " + _number("vertical", pads.vertical, "N/m"),
            "  " + _number("roll", pads.roll_stiffness(study.section), "N m/rad"),
            "  " + _number("length", pads.seat_length, "m"), "  " + _number("spacing", pads.spacing, "m"),
            f"  bays: {pads.bays}  # {'load between two seats' if pads.bays % 2 == 0 else 'load over a seat'}"]
