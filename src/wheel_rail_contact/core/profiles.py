# SPDX-License-Identifier: BSD-3-Clause
"""Profiles of wheels and rails, and compliance tables, from their files."""
import json
import os

from .extension import core


def read_profile(name, kind, **options):
    """Reads a standard profile or a profile file.

    name: of a standard profile (doc/standard_profiles.md), or of a file: a name with a dot or a slash
    kind: "wheel", "rail" or "rail_section"
    options: those of the group `profile` in a parameter file (config/default.yaml): unit, y, z, origin, shift, rotate, mirror,
        smoothing; and the dimensions of the vehicle that a node has: tape_circle [m], scale (of a model, at most 1)

    Returns a Profile: name, report, length, at(u), slope(u), curvature(u), parts.
    Raises ValueError with the name, the value and the broken rule.
    """
    return core.read_profile(os.fspath(name), kind, json.dumps(options))


def read_compliance_table(file):
    """Reads a compliance table (config/rails/*.yaml, or written by rail_compliance).

    Returns a ComplianceTable: name, linear_range, displacement(lateral_force, vertical_force, moment, inclination).
    Raises ValueError with the file, the key, the value and the broken rule.
    """
    return core.read_compliance_table(os.fspath(file))
