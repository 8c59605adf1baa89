# SPDX-License-Identifier: BSD-3-Clause
"""Read by catkin_python_setup(); not to be run by hand."""
from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

ROOMS = ("animation", "campaign", "chart", "checking", "paper", "rail_fe", "report", "states")

setup(**generate_distutils_setup(
    packages=["wheel_rail_contact"] + [f"wheel_rail_contact.{room}" for room in ROOMS], package_dir={"": "src"}))
