# SPDX-License-Identifier: BSD-3-Clause
"""Sections of the surfaces of wheel and rail about a patch."""
import numpy as np

STEPS = 400          # number of steps of a contour
STEEPEST = 0.5       # [-] least dy/ds of a contour: it ends where it is steeper (60°) against the tangent plane
SMOOTHING = 0.25     # half length over which a tangent is averaged, as a share of half the width of the patch
MOST_TURN = 0.5      # [rad] largest turn of the normals over a length equal to the depth of the body


class Contour:
    """Section of a surface in the patch frame: a curve by its arc length.

    s: (n,) arc length from the centre of pressure, to the left positive, increasing [m]
    points: (n, 2) y (left) and z (out of the rail) [m]
    normals: (n, 2) unit vectors, out of the rail
    """

    def __init__(self, s, points, normals):
        self.s, self.points, self.normals = s, points, normals

    def at(self, s, depth):
        """Points (..., 2) at arc lengths s and heights -depth above the surface, along the normal [m]."""
        normal = _interpolated(s, self.s, self.normals)
        return _interpolated(s, self.s, self.points) - depth[..., None] * normal

    def for_depth(self, depth, sign):
        """The contour with normals that do not meet in the body up to a depth [m].

        Where the surface is convex with a radius below twice the depth, the normals turn less than the surface.

        sign: 1 for the rail (below the surface), -1 for the wheel (above it)
        """
        angle = np.unwrap(np.arctan2(self.normals[:, 1], self.normals[:, 0]))
        convex = np.minimum(-sign * np.gradient(angle, self.s), MOST_TURN / depth)
        turned = -sign * np.append(0, np.cumsum((convex[1:] + convex[:-1]) / 2 * np.diff(self.s)))
        turned += np.interp(0, self.s, angle) - np.interp(0, self.s, turned)
        return Contour(self.s, self.points, np.column_stack([np.cos(turned), np.sin(turned)]))


def _normals(s, points, reach):
    """Normals of a curve, from its directions over `reach` to both sides [m]."""
    before, after = (_interpolated(np.clip(s + step, s[0], s[-1]), s, points) for step in (-reach, reach))
    tangents = (after - before) / np.hypot(*(after - before).T)[:, None]
    return np.column_stack([-tangents[:, 1], tangents[:, 0]])


def _interpolated(s, knots, values):
    return np.stack([np.interp(s, knots, column) for column in values.T], axis=-1)


def plane(reach):
    """Contour of the tangent plane, to both sides of the centre of pressure by `reach` [m]."""
    s = np.linspace(-reach, reach, 3)
    return Contour(s, np.column_stack([s, np.zeros(3)]), np.tile((0.0, 1.0), (3, 1)))


def about(outline, place, side, half_width, reach):
    """Contour of an outline about a patch. Its mean direction across the patch is that of the tangent plane.

    outline: (n, 2) y (outward) and z (up) [m], from the gauge side to the field side
    place: (2,) place of the centre of pressure, near the outline [m]
    side: "left" or "right"
    half_width: half the width of the patch across the track [m]
    reach: largest arc length to both sides [m]. The contour is shorter where the outline ends, or turns by more than 60°
    """
    sign = {"left": 1, "right": -1}[side]
    curve = (outline * (sign, 1))[::sign]
    arc = np.append(0, np.cumsum(np.hypot(*np.diff(curve, axis=0).T)))
    centre = _nearest(curve, arc, np.asarray(place) * (sign, 1))
    s = np.linspace(max(-reach, arc[0] - centre), min(reach, arc[-1] - centre), STEPS)
    ends = np.clip(centre + half_width * np.array([-1, 1]), arc[0], arc[-1])
    direction = np.subtract(*_interpolated(ends, arc, curve)[::-1])
    c, d = direction / np.hypot(*direction)
    points = (_interpolated(centre + s, arc, curve) - _interpolated(centre, arc, curve)) @ np.array([[c, -d], [d, c]])
    spacing = np.diff(arc)[np.searchsorted(arc[1:-1], centre)]
    return _flat_part(Contour(s, points, _normals(s, points, max(SMOOTHING * half_width, spacing))))


def _nearest(curve, arc, place):
    """Arc length of the point of a polyline that is nearest to a place."""
    steps = np.diff(curve, axis=0)
    share = np.clip(((place - curve[:-1]) * steps).sum(axis=1) / np.maximum((steps**2).sum(axis=1), 1e-30), 0, 1)
    distance = np.hypot(*(curve[:-1] + share[:, None] * steps - place).T)
    nearest = distance.argmin()
    return arc[nearest] + share[nearest] * (arc[nearest + 1] - arc[nearest])


def _flat_part(contour):
    """The part about s = 0 that is not steeper than STEEPEST."""
    steep = contour.normals[:, 1] < STEEPEST
    before, after = steep & (contour.s < 0), steep & (contour.s > 0)
    first = np.flatnonzero(before)[-1] + 1 if before.any() else 0
    last = np.flatnonzero(after)[0] if after.any() else len(steep)
    return Contour(*(values[first:last] for values in (contour.s, contour.points, contour.normals)))


def pressed_on(wheel, rail, approach):
    """Contour of a wheel that is pressed on a rail by the approach [m]: nowhere below the surface of the rail."""
    low, high = max(wheel.s[0], rail.s[0]), min(wheel.s[-1], rail.s[-1])
    s = wheel.s[(wheel.s >= low) & (wheel.s <= high)]
    points, ground = wheel.at(s, np.full(len(s), approach)), rail.points
    points[:, 1] = np.maximum(points[:, 1], np.interp(points[:, 0], ground[:, 0], ground[:, 1]))
    return Contour(s, points, _interpolated(s, wheel.s, wheel.normals))
