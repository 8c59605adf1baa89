# SPDX-License-Identifier: BSD-3-Clause
"""Sections and studies shared by the tests."""
import shutil
import unittest
from pathlib import Path

import numpy as np

from wheel_rail_contact.rail_fe.analysis import solve
from wheel_rail_contact.rail_fe.section import Section, read_section

CONFIG = Path(__file__).resolve().parents[2] / "config" / "rails"
HAVE_PROGRAMS = shutil.which("gmsh") is not None and shutil.which("ccx") is not None
needs_programs = unittest.skipUnless(HAVE_PROGRAMS, "gmsh or ccx is not installed")


def rail_60e1():
    """Section 60E1 of the package."""
    return read_section(CONFIG / "sections" / "60E1.csv")


def bar(width, height):
    """Rectangular section [m]."""
    half = 0.5 * width
    return Section("bar", np.array([[-half, 0.0], [half, 0.0], [half, height], [-half, height]]))


def solved(study, compliance=True):
    """Solution of a valid study on its own mesh, without progress output."""
    study.validate()
    return solve(study, study.mesh_size, lambda text: None, compliance=compliance)
