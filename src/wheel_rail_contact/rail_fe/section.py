# SPDX-License-Identifier: BSD-3-Clause
"""Section of a rail: a closed outline read from CSV, its properties, and the division of its boundary into mesh edges."""
from pathlib import Path

import numpy as np

from ..command import Failure

CORNER_ANGLE = np.radians(20)       # a vertex with a larger angle is a corner, at which a mesh edge ends
LARGEST_EDGE_TURN = np.radians(60)  # largest angle of a mesh edge; fillets therefore have smaller edges
FLAT = 1e-9                         # heights with a smaller difference are considered equal [m]
CSV_HEADER = "y_mm,z_mm"


class Section:
    """Closed outline, counter-clockwise, (n, 2) array of y, z [m]: lowest point at z = 0, rail axis at y = 0.

    Arc lengths [m] on the outline are counted from its first vertex.
    """

    def __init__(self, name, outline):
        """Raises Failure if the points (n, 2) [m] are not a simple polygon."""
        self.name = name
        self.outline = _checked_outline(np.asarray(outline, float), name)
        self._edge = np.roll(self.outline, -1, axis=0) - self.outline
        self._length = np.linalg.norm(self._edge, axis=1)
        self._arc = np.concatenate([[0.0], np.cumsum(self._length)])

    @property
    def height(self):
        """Height of the crown above the underside of the foot [m]."""
        return float(self.outline[:, 1].max())

    @property
    def perimeter(self):
        """Length of the outline [m]."""
        return float(self._arc[-1])

    def properties(self):
        """Area [m^2], centroid height [m], central second moments about the y and z axes [m^4] (Green's theorem)."""
        (y, z), (y2, z2) = self.outline.T, (self.outline + self._edge).T
        cross = y * z2 - y2 * z
        area = cross.sum() / 2
        y_c, z_c = ((y + y2) * cross).sum() / (6 * area), ((z + z2) * cross).sum() / (6 * area)
        about_y = ((z * z + z * z2 + z2 * z2) * cross).sum() / 12 - area * z_c**2
        about_z = ((y * y + y * y2 + y2 * y2) * cross).sum() / 12 - area * y_c**2
        return {"area": float(area), "centroid_height": float(z_c), "second_moment_y": float(about_y),
                "second_moment_z": float(about_z)}

    def foot_width(self):
        """Width [m] of the flat underside: the part of the outline at z = 0."""
        bottom = self.outline[self.outline[:, 1] < FLAT, 0]
        return float(np.ptp(bottom))

    def points(self, arc):
        """Outline points (n, 2) at the arc lengths [m]."""
        closed = np.vstack([self.outline, self.outline[:1]])
        arc = np.mod(arc, self.perimeter)
        return np.column_stack([np.interp(arc, self._arc, closed[:, k]) for k in (0, 1)])

    def project(self, points):
        """Arc length [m] of the nearest outline point of each of the points (n, 2)."""
        arcs = np.empty(len(points))
        for i, point in enumerate(np.asarray(points, float)):
            share = np.clip(((point - self.outline) * self._edge).sum(axis=1) / self._length**2, 0, 1)
            distance = np.linalg.norm(self.outline + share[:, None] * self._edge - point, axis=1)
            nearest = np.argmin(distance)
            arcs[i] = self._arc[nearest] + share[nearest] * self._length[nearest]
        return arcs

    def crown(self):
        """Arc length [m] of the highest point (the middle of a level top)."""
        top = self.outline[self.outline[:, 1] > self.height - FLAT]
        return float(self.project([[top[:, 0].mean(), self.height]])[0])

    def crossing(self, axis, value, side):
        """Arc length [m] at which the coordinate `axis` (0: y, 1: z) is `value` [m]. If there are several such points, it is
        the one for which the other coordinate times `side` is largest. Raises Failure if there is none."""
        start, step = self.outline[:, axis], self._edge[:, axis]
        share = np.divide(value - start, step, out=np.full(len(step), -1.0), where=step != 0)
        hits = np.flatnonzero((share >= 0) & (share <= 1))
        if len(hits) == 0:
            raise Failure(f"section {self.name}: the outline does not reach {'yz'[axis]} = {value:g} m")
        other = self.outline[hits, 1 - axis] + share[hits] * self._edge[hits, 1 - axis]
        best = hits[np.argmax(side * other)]
        return float(self._arc[best] + share[best] * self._length[best])

    def gauge_face(self, height):
        """Arc length [m] of the gauge side (smallest y) at `height` [m] above the underside of the foot."""
        return self.crossing(1, height, -1)

    def cuts(self, size):
        """Increasing arc lengths [m] that divide the outline into edges of about `size` [m], smaller in fillets.

        They include the corners, the crown, and the ends and the middle of the flat underside.
        """
        turn = np.abs(_turns(self.outline))
        corners = self._arc[:-1][turn > CORNER_ANGLE]
        underside = self._arc[:-1][self.outline[:, 1] < FLAT]
        fixed = np.unique(np.round(np.concatenate([corners, underside, [self.crown(), self.crossing(0, 0.0, -1)]]), 12))
        turn = np.where(turn > CORNER_ANGLE, 0.0, turn)
        effort = np.concatenate([[0.0], np.cumsum(np.maximum(self._length / size, _edge_share(turn)))])
        arcs = []
        for first, last in zip(fixed, np.append(fixed[1:], fixed[0] + self.perimeter)):
            ends = np.interp([first, last], np.concatenate([self._arc, self._arc[1:] + self.perimeter]),
                             np.concatenate([effort, effort[1:] + effort[-1]]))
            count = max(1, int(round(ends[1] - ends[0])))
            cuts = np.linspace(*ends, count + 1)[:-1]
            arcs.append(np.interp(np.mod(cuts, effort[-1]), effort, self._arc))
        return np.sort(np.mod(np.concatenate(arcs), self.perimeter))


def read_section(path):
    """Section from a CSV file: comment lines (#), the header y_mm,z_mm, one point [mm] per line.

    The section has the name of the file.
    Raises Failure for an unreadable file, or if the outline is not a simple polygon.
    """
    path = Path(path)
    try:
        lines = [line.strip() for line in path.read_text(encoding="utf-8").splitlines()]
    except (OSError, UnicodeDecodeError) as error:
        raise Failure(f"section file {path}: cannot be read ({error})") from error
    lines = [line for line in lines if line and not line.startswith("#")]
    if not lines or lines[0].replace(" ", "") != CSV_HEADER:
        raise Failure(f"section file {path}: the first line after the comments must be {CSV_HEADER}")
    try:
        outline = np.array([[float(number) for number in line.split(",")] for line in lines[1:]])
    except ValueError as error:
        raise Failure(f"section file {path}: {error}") from error
    return Section(path.stem, outline / 1000)


def _edge_share(turn):
    """Angle of each outline edge as a share of LARGEST_EDGE_TURN: half the turns at both its ends."""
    return 0.5 * (turn + np.roll(turn, -1)) / LARGEST_EDGE_TURN


def _turns(outline):
    """Angle [rad] by which the outline turns at each vertex, left positive."""
    after = np.roll(outline, -1, axis=0) - outline
    before = np.roll(after, 1, axis=0)
    return np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(axis=1))


def _checked_outline(outline, name):
    """The outline counter-clockwise, without repeated points, lowest point at z = 0. Raises Failure if it is not valid."""
    if outline.ndim != 2 or outline.shape[1] != 2 or not np.isfinite(outline).all():
        raise Failure(f"section {name}: must have two columns of finite numbers")
    outline = outline[np.linalg.norm(outline - np.roll(outline, -1, axis=0), axis=1) > 1e-9]
    if len(outline) < 3:
        raise Failure(f"section {name}: a closed outline must have at least three different points")
    if _turns(outline).sum() < 0:
        outline = outline[::-1]
    if _crosses_itself(outline):
        raise Failure(f"section {name}: the outline crosses itself")
    return outline - [0, outline[:, 1].min()]


def _crosses_itself(outline):
    """True if two edges that are not adjacent touch."""
    start, end = outline, np.roll(outline, -1, axis=0)

    def side(first, second, point):
        return np.sign((second[:, None, 0] - first[:, None, 0]) * (point[None, :, 1] - first[:, None, 1])
                       - (second[:, None, 1] - first[:, None, 1]) * (point[None, :, 0] - first[:, None, 0]))

    apart = side(start, end, start) * side(start, end, end)
    crossing = (apart <= 0) & (apart.T <= 0)
    n = len(outline)
    for shift in (-1, 0, 1):
        crossing[np.arange(n), (np.arange(n) + shift) % n] = False
    # Collinear edges have sign 0 on both sides. They touch only if their bounding boxes overlap.
    low, high = np.minimum(start, end), np.maximum(start, end)
    boxes = np.all((low[:, None] <= high[None]) & (low[None] <= high[:, None]), axis=2)
    return bool((crossing & boxes).any())
