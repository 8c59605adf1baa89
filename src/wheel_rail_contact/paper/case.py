# SPDX-License-Identifier: BSD-3-Clause
"""The case of the paper: Golubenko, Kostyukevich, Tsyganovskiy and Nozhenko 2011 (TEKA XI, 78-84), S1002 on UIC60.

Figures are a pair of the highest pressure [Pa] and the whole area [m²] of the contact of a wheel; (0, 0): no solution.
"""
import math

from ..command import shipped
from ..core.contact import WheelsetContact

PRINTED_WITHOUT = (1175e6, 185e-6)  # results of the paper without bending
PRINTED_WITH = (1330e6, 127e-6)     # with bending
LOAD = 100e3                 # vertical load of each wheel [N], see doc/paper.md
LATERAL_FORCE = 30e3         # outward force on the rail [N]
DISPLACEMENT = 0.2435e-3     # outward displacement of the top of the rail by this force [m]
POSITION = 0.572e-3          # of the wheelset, towards the flange [m]: reproduces the results without bending. Not printed
TURN = -13e-3                # outward roll of the rail that reproduces the results with bending [rad]. Not printed
INCLINATION = 0.025          # of the rails, in config/paper.yaml [rad]
REFERENCE_DEPTH = 0.014      # of the reference point of a rail head below its crown [m]
NO_FIGURES = (0.0, 0.0)


def contact(*changes):
    """WheelsetContact of config/paper.yaml, with changes (dict of groups and values)."""
    return WheelsetContact([str(shipped("config/paper.yaml")), *changes])


def deviation(found, printed):
    """The larger relative deviation of pressure and area [-]."""
    return max(abs(value / reference - 1) for value, reference in zip(found, printed))


def crown_displaced(lateral, vertical, roll, inclination=INCLINATION):
    """Displacement (lateral, vertical [m], roll [rad]) of the reference point of a rail head, from that of its crown: the
    finite elements of the paper give the displacement of the top of the rail.

    The crown lies above the reference point along the axis of the rail, (-sin a, cos a) with the inclination a.
    """
    turned = inclination - roll
    return (lateral - REFERENCE_DEPTH * (math.sin(inclination) - math.sin(turned)),
            vertical - REFERENCE_DEPTH * (math.cos(turned) - math.cos(inclination)), roll)


def left_patches(result):
    """Patches of the left wheel."""
    return [patch for patch in result.patches if patch.side == "left"]


def left_figures(result):
    """Figures of the left wheel."""
    patches = left_patches(result)
    return (max(patch.max_pressure for patch in patches), sum(patch.area for patch in patches)) if patches else NO_FIGURES


def steps(first, last, count):
    """Equidistant values, both ends included."""
    return tuple(first + (last - first) * i / count for i in range(count + 1))
