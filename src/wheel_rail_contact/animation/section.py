# SPDX-License-Identifier: BSD-3-Clause
"""One side of a result as curves of a picture.

All curves are in side axes: y outward to the field side, z up, in mm, (n, 2) each; pressures in MPa.
"""
from dataclasses import dataclass

import numpy as np

MM, MPA = 1e3, 1e-6


@dataclass
class Patch:
    """A contact patch."""
    pressure: np.ndarray  # (nx, ny)
    x: np.ndarray         # (nx,) cell centres along the track, forward
    surface: np.ndarray   # (ny, 2) cell centres in the section, in the plane of the patch
    normal: np.ndarray    # unit vector out of the rail
    force: float          # along the normal [kN]


@dataclass
class Section:
    """Outlines and patches in the section through the contact at one instant."""
    wheel: np.ndarray
    rail: np.ndarray
    patches: list


def _rotated(points, angle):
    """Points rotated about the origin by an angle from y towards z [rad]."""
    c, s = np.cos(angle), np.sin(angle)
    return points @ np.array([[c, s], [-s, c]])


def _roll(orientation):
    return 2 * np.arctan2(orientation.x, orientation.w)


def _wheel(message, side, outline):
    sign = (1, -1)[side]
    pose = message.wheelset
    centre = np.array([sign * pose.position.y, pose.position.z])
    return MM * (centre + _rotated(outline, sign * _roll(pose.orientation)))


def _rail(message, side, outline, reference):
    deflection = (message.left_rail, message.right_rail)[side]
    displacement = np.array([deflection.lateral, deflection.vertical])
    return MM * (reference + displacement + _rotated(outline - reference, -deflection.roll))


def _patch(patch):
    sign = (1, -1)[patch.side]
    grid = patch.grid
    angle = sign * _roll(patch.pose.orientation)
    across = sign * (grid.y0 + grid.dy * np.arange(grid.ny))
    direction = np.array([np.cos(angle), np.sin(angle)])
    origin = np.array([sign * patch.pose.position.y, patch.pose.position.z])
    return Patch(pressure=MPA * np.asarray(grid.pressure, float).reshape(grid.ny, grid.nx).T,
                 x=MM * (patch.pose.position.x + grid.x0 + grid.dx * np.arange(grid.nx)),
                 surface=MM * (origin + across[:, None] * direction),
                 normal=np.array([-direction[1], direction[0]]), force=1e-3 * patch.normal_force)


def section(message, side, outlines):
    """Section of a result. The wheel is drawn without yaw; a yawed wheel therefore appears slightly away from its contact.

    @param side index into SIDES
    @param outlines of this side, as in report.results.Results
    """
    return Section(wheel=_wheel(message, side, outlines["wheel"]),
                   rail=_rail(message, side, outlines["rail"], outlines["reference"][0]),
                   patches=[_patch(p) for p in message.patches if p.side == side and p.grid.nx])
