# SPDX-License-Identifier: BSD-3-Clause
"""Ranges of paper_study with fewer steps."""
from wheel_rail_contact.paper.case import DISPLACEMENT, steps
from wheel_rail_contact.paper.scan import Ranges

RAIL = "UIC60_manchester"
COARSE = Ranges(rails=(RAIL,), positions=steps(-6e-3, 6e-3, 30), positions_around_start=(0.0,),
                pure_shifts=steps(-5e-3, 4e-3, 36), shifts=(-DISPLACEMENT, 0.0, DISPLACEMENT), turns=steps(-16e-3, 16e-3, 32),
                rolls=steps(-1e-3, 1e-3, 4))
# With an inclination of 1:21, near the flange.
NEAR_FLANGE = Ranges(rails=(RAIL,), positions=steps(4.8e-3, 5.8e-3, 10), turns=steps(2e-3, 10e-3, 8),
                     free_inclinations=steps(46e-3, 49e-3, 3))
