# SPDX-License-Identifier: BSD-3-Clause
"""Used by catkin_python_setup(). Do not run it directly."""
from setuptools import setup

from catkin_pkg.python_setup import generate_distutils_setup

SUBPACKAGES = ("animation", "campaign", "chart", "checking", "core", "geometry", "line", "paper", "profile_check", "rail_fe", "report",
               "simulation", "states")

setup(**generate_distutils_setup(
    packages=["wheel_rail_contact"] + [f"wheel_rail_contact.{name}" for name in SUBPACKAGES], package_dir={"": "src"}))
