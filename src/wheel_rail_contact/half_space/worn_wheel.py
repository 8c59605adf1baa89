# SPDX-License-Identifier: BSD-3-Clause
"""Profile of a wheel that is worn to the shape of the gauge corner of 60E1: its contact turns by more than a radian."""
import numpy as np

from ..rail_fe import outline_60e1

RELATIVE_RADIUS = 1.5     # of the gap between both profiles, away from the middle of the gauge corner [m]
POINT_STEP = 0.02         # so close that an interpolation has no ripples wider than a cell [mm]
FLANK_LENGTH = 8.0        # below the arc of the gauge corner [mm]
FLANGE_RADIUS = 8.0       # at the lower end of the flank [mm]
FLANGE_WIDTH = 18.0       # beyond it [mm]
TREAD_END = 30.0          # beyond the axis of the rail [mm]
HALF_GAUGE = 717.5        # [mm]
GAUGE_DEPTH = 14.0        # [mm]
HALF_BASE = 750.0         # from the track centre to the running circle [mm]


def table(inclination):
    """The profile as a table (CSV, mm). At y = 0 it touches 60E1 in the middle of the gauge corner.

    @param inclination  of the rail, top towards the track centre [rad]
    """
    return "y_mm,z_mm\n" + "".join(f"{y:.7f},{z:.7f}\n" for y, z in _points(inclination))


def _points(inclination):
    rail = _placed(_rail_head(), inclination)
    tangent = np.gradient(rail, axis=0)
    tangent /= np.hypot(*tangent.T)[:, None]
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    arc = np.append(0, np.cumsum(np.hypot(*np.diff(rail, axis=0).T)))
    middle = FLANK_LENGTH + 0.5 * _corner_length()
    root = rail + normal * ((arc - middle)**2 / (2000 * RELATIVE_RADIUS))[:, None]
    wheel = np.vstack([_flange(root), root])
    wheel[:, 0] -= HALF_BASE
    wheel[:, 1] -= np.interp(0, wheel[:, 0], wheel[:, 1])
    return wheel


def _corner_length():
    corner = outline_60e1.head_arcs()[1]
    first, last = corner.start - corner.center, corner.end - corner.center
    return np.hypot(*first) * np.arccos(first @ last / (first @ first))


def _rail_head():
    """Upright head from the flank on the gauge side to beyond its axis, (n, 2) [mm], equally spaced."""
    _, corner, side, crown = outline_60e1.head_arcs()
    flank = corner.start + FLANK_LENGTH * np.array([outline_60e1.SLOPE_HEAD_SIDE, -1]) / np.hypot(
        1, outline_60e1.SLOPE_HEAD_SIDE)
    half = [np.linspace(flank, corner.start, 200, endpoint=False)]
    for one in (corner, side, crown):
        half.append(_turned(one)[:-1])
    half = np.vstack(half) * [-1, 1]
    whole = np.vstack([half, [[0.0, outline_60e1.HEIGHT]], half[::-1] * [-1, 1]])
    whole = whole[:np.flatnonzero(whole[:, 0] < TREAD_END)[-1]]
    arc = np.append(0, np.cumsum(np.hypot(*np.diff(whole, axis=0).T)))
    at = np.arange(0, arc[-1], POINT_STEP)
    return np.column_stack([np.interp(at, arc, whole[:, i]) for i in (0, 1)])


def _turned(arc):
    """Points of an arc that are so close that chords are as good as the arc."""
    ray, last = arc.start - arc.center, arc.end - arc.center
    angle = np.arctan2(ray[0] * last[1] - ray[1] * last[0], ray @ last)
    turn = np.linspace(0, angle, 20000)
    return arc.center + np.outer(np.cos(turn), ray) + np.outer(np.sin(turn), [-ray[1], ray[0]])


def _placed(points, inclination):
    cosine, sine = np.cos(inclination), np.sin(inclination)
    placed = points @ np.array([[cosine, sine], [-sine, cosine]])
    placed[:, 1] -= placed[:, 1].max()
    placed[:, 0] += HALF_GAUGE - placed[placed[:, 1] > -GAUGE_DEPTH, 0].min()
    return placed


def _flange(root):
    """Points from the back of the flange to the flank: a line, and an arc tangent to both."""
    down = root[0] - root[1]
    down /= np.hypot(*down)
    angle = np.arctan2(down[1], down[0])
    inward = np.array([down[1], -down[0]])  # into the wheel, from the flank
    centre = root[0] + FLANGE_RADIUS * inward
    turns = np.arange(POINT_STEP, FLANGE_RADIUS * abs(angle + np.pi), POINT_STEP) / FLANGE_RADIUS
    arc = np.array([centre + FLANGE_RADIUS * (-np.cos(turn) * inward + np.sin(turn) * down) for turn in turns])
    end = arc[-1]
    y = np.arange(end[0] - FLANGE_WIDTH, end[0] - POINT_STEP, 1.0)
    return np.vstack([np.column_stack([y, np.full(len(y), end[1])]), arc[::-1]])
