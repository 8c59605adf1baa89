# SPDX-License-Identifier: BSD-3-Clause
"""Wheel and rail near a contact as elastic bodies: a section, swept along x (rail) or about the axle (wheel)."""
from dataclasses import dataclass

import numpy as np

WEB_HALF_WIDTH = 0.00825   # of 60E1 [m]
UNDERSIDE_DEPTH = 0.054    # below the crown, at which the underside of the head meets the web [m]
WEB_CUT_DEPTH = 0.075      # below the crown, at which the web is cut and held [m]
RIM_THICKNESS = 0.060      # from the running circle to the cut of the wheel's rim, where it is held [m]
OUTLINE_STEP = 1e-3        # distance of the points of a spline outside of the contacts [m]
PATCH_STEP = 0.25e-3       # distance of the points of a spline in a contact [m]


@dataclass
class Body:
    """Section of a body. The outline goes over the running surface from the gauge side to the field side.

    curves   consecutive arrays of points (n, 2) [m]; each ends where the next one begins
    patches  index in curves for each contact
    closing  points (n, 2) [m] that close the section, in this order
    held     indices of the two neighbouring points in `closing` between which the body is held
    axle_z   height of the axle about which the section turns [m]; None: it moves along x
    """
    name: str
    curves: list
    patches: list
    closing: np.ndarray
    held: tuple
    axle_z: float = None


def rail_body(outline, places, inclination):
    """Head and upper web of the rail.

    @param outline      points (n, 3): parameter, y, z [m]
    @param places       parameter ranges of the cells of each contact [m]
    @param inclination  of the rail, top towards the track centre [rad]
    """
    curves, patches = _split(outline, places)
    left, right = outline[0, 1:], outline[-1, 1:]
    across = np.array([np.cos(inclination), np.sin(inclination)])
    up = np.array([-across[1], across[0]])
    crown = (outline[:, 1:] @ up).max()
    middle = 0.5 * (left + right) @ across
    closing = np.array([(middle + side * WEB_HALF_WIDTH) * across + (crown - depth) * up for side, depth in (
        (1, UNDERSIDE_DEPTH), (1, WEB_CUT_DEPTH), (-1, WEB_CUT_DEPTH), (-1, UNDERSIDE_DEPTH))])
    return Body("rail", curves, patches, closing, (1, 2))


def wheel_body(outline, places, axle_z, radius):
    """Rim of the wheel with its flange.

    @param outline  points (n, 3): parameter, y, z [m]
    @param places   parameter ranges of the cells of each contact [m]
    @param axle_z   height of the axle [m]
    @param radius   of the running circle [m]
    """
    curves, patches = _split(outline, places)
    top = axle_z - radius + RIM_THICKNESS
    closing = np.array([[outline[-1, 1], top], [outline[0, 1], top]])
    return Body("wheel", curves, patches, closing, (0, 1), axle_z)


def _split(outline, places):
    """Curves of an outline, divided at the ends of the contacts; and the indices of those of the contacts."""
    ends = [outline[0, 0]]
    for place in places:
        ends += list(place)
    ends.append(outline[-1, 0])
    curves = []
    for k, (first, last) in enumerate(zip(ends[:-1], ends[1:])):
        step = PATCH_STEP if k % 2 else OUTLINE_STEP
        u = np.linspace(first, last, max(3, int(np.ceil((last - first) / step)) + 1))
        curves.append(np.column_stack([np.interp(u, outline[:, 0], outline[:, i]) for i in (1, 2)]))
    return curves, list(range(1, len(curves), 2))
