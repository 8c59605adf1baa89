# SPDX-License-Identifier: BSD-3-Clause
"""Outline of the rail 60E1 from the lines and arcs of EN 13674-1 (drawing 60E1), in millimetres.

Command that wrote the file of the package:
python3 -m wheel_rail_contact.rail_fe.outline_60e1 > config/rails/sections/60E1.csv
"""
import sys
from dataclasses import dataclass

import numpy as np

HEIGHT = 172.0
FOOT_HALF_WIDTH = 75.0
FOOT_EDGE_HEIGHT = 11.5       # height at which the 1:14 line meets the edge of the foot
FOOT_LINE_ON_AXIS = 31.5      # height at which the 1:2.75 line of the foot meets the rail axis
HEAD_LINE_ON_AXIS = 121.0     # height at which the underside of the head meets the rail axis
WEB_HALF_WIDTH = 8.25
WEB_FLAT_HALF_HEIGHT = 16.0   # half height of the flat part of the web, midway between the two heights on the axis
WEB_FILLET_HALF_WIDTH = 11.45046  # half width at the transition from R120 to R35
CROWN_HALF_WIDTH = 10.228     # half width at the transition from R300 to R80
SHOULDER_HALF_WIDTH = 26.0265  # half width at the transition from R80 to R13
SLOPE_STEEP = 1 / 2.75
SLOPE_FLAT = 1 / 14
SLOPE_HEAD_SIDE = 1 / 20
CHORD_DEVIATION = 2e-3        # largest distance between an arc and its chords in the written outline


@dataclass
class Line:
    """Line through `point` along the unit vector `direction`."""
    point: np.ndarray
    direction: np.ndarray

    @staticmethod
    def through(y, z, dy, dz):
        direction = np.array([dy, dz], float)
        return Line(np.array([y, z], float), direction / np.linalg.norm(direction))

    def left(self):
        """Unit normal to the left of the direction."""
        return np.array([-self.direction[1], self.direction[0]])

    def intersection(self, other):
        """Intersection point with another line."""
        steps = np.linalg.solve(np.column_stack([self.direction, -other.direction]), other.point - self.point)
        return self.point + steps[0] * self.direction

    def foot(self, point):
        """Nearest point of the line."""
        return self.point + np.dot(point - self.point, self.direction) * self.direction


@dataclass
class Arc:
    """The shorter arc from `start` to `end` about `center`."""
    center: np.ndarray
    start: np.ndarray
    end: np.ndarray

    def points(self):
        """Chord points from start to end."""
        ray, last = self.start - self.center, self.end - self.center
        radius = np.linalg.norm(ray)
        angle = np.arctan2(ray[0] * last[1] - ray[1] * last[0], np.dot(ray, last))
        count = int(np.ceil(abs(angle) / np.sqrt(8 * CHORD_DEVIATION / radius))) + 1
        turn = np.linspace(0, angle, count)
        return self.center + np.outer(np.cos(turn), ray) + np.outer(np.sin(turn), [-ray[1], ray[0]])


def fillet(first, second, radius, side):
    """Arc tangent to two lines; its centre lies to the left (side = 1) or right (-1) of both."""
    shifted = [Line(line.point + side * radius * line.left(), line.direction) for line in (first, second)]
    center = shifted[0].intersection(shifted[1])
    return Arc(center, first.foot(center), second.foot(center))


def foot_arcs():
    """Arcs of the foot on the right-hand side, upwards from the underside to the 1:2.75 line; and this line."""
    underside = Line.through(0, 0, 1, 0)
    edge = Line.through(FOOT_HALF_WIDTH, 0, 0, 1)
    flat = Line.through(FOOT_HALF_WIDTH, FOOT_EDGE_HEIGHT, -1, SLOPE_FLAT)
    steep = Line.through(0, FOOT_LINE_ON_AXIS, -1, SLOPE_STEEP)
    return [fillet(underside, edge, 2, 1), fillet(edge, flat, 4, 1), fillet(flat, steep, 40, -1)], steep


def web_arcs(steep):
    """Arcs R7, R35 and R120, from the 1:2.75 line of the foot to the flat part of the web."""
    flat_end = 0.5 * (FOOT_LINE_ON_AXIS + HEAD_LINE_ON_AXIS) - WEB_FLAT_HALF_HEIGHT
    center_120 = np.array([WEB_HALF_WIDTH + 120, flat_end])
    cosine = (center_120[0] - WEB_FILLET_HALF_WIDTH) / 120
    ray = np.array([-cosine, -np.sqrt(1 - cosine**2)])
    transition = center_120 + 120 * ray
    center_35 = transition - 35 * ray
    # R7 is tangent to the line, and to R35 from inside. Its centre is 7 from the line and 35 - 7 from the centre of R35.
    foot = steep.foot(center_35) - 7 * steep.left()
    rise = np.sqrt((35 - 7) ** 2 - np.sum((foot - center_35) ** 2))
    center_7 = foot + rise * steep.direction * np.sign(np.dot(transition - foot, steep.direction))
    touch = center_35 + 35 * (center_7 - center_35) / np.linalg.norm(center_7 - center_35)
    return [Arc(center_7, steep.foot(center_7), touch), Arc(center_35, touch, transition),
            Arc(center_120, transition, np.array([WEB_HALF_WIDTH, flat_end]))]


def mirrored(arcs, middle):
    """The arcs mirrored about the height `middle`, in upward order."""
    def flip(point):
        return np.array([point[0], 2 * middle - point[1]])
    return [Arc(flip(arc.center), flip(arc.end), flip(arc.start)) for arc in reversed(arcs)]


def head_arcs():
    """Arcs of the head, from its underside to the crown."""
    center_300 = np.array([0, HEIGHT - 300])
    crown_end = center_300 + [CROWN_HALF_WIDTH, np.sqrt(300**2 - CROWN_HALF_WIDTH**2)]
    center_80 = crown_end + 80 / 300 * (center_300 - crown_end)
    side = SHOULDER_HALF_WIDTH - center_80[0]
    shoulder = center_80 + [side, np.sqrt(80**2 - side**2)]
    center_13 = shoulder + 13 / 80 * (center_80 - shoulder)
    flank = Line.through(0, 0, -SLOPE_HEAD_SIDE, 1)
    touch = center_13 - 13 * flank.left()
    flank.point = touch
    underside = Line.through(0, HEAD_LINE_ON_AXIS, 1, SLOPE_STEEP)
    return [fillet(underside, flank, 3, 1), Arc(center_13, touch, shoulder), Arc(center_80, shoulder, crown_end),
            Arc(center_300, crown_end, np.array([0, HEIGHT]))]


def outline():
    """Closed outline of 60E1, counter-clockwise, (n, 2) array of y, z [mm]; the first point is not repeated."""
    foot, steep = foot_arcs()
    web = web_arcs(steep)
    arcs = foot + web + mirrored(web, 0.5 * (FOOT_LINE_ON_AXIS + HEAD_LINE_ON_AXIS)) + head_arcs()
    right = [np.zeros((1, 2))]
    for arc in arcs:
        points = arc.points()
        joined = np.linalg.norm(points[0] - right[-1][-1]) < 1e-9
        right.append(points[1:] if joined else points)
    right = np.vstack(right)
    return np.vstack([right, (right * [-1, 1])[-2:0:-1]])


def main():
    """Writes the outline as CSV to standard output."""
    sys.stdout.write("# SPDX-License-Identifier: BSD-3-Clause\n"
                     "# Rail 60E1 after EN 13674-1: y from the rail's axis, z up from the foot's underside.\n"
                     "# Closed outline, written by wheel_rail_contact.rail_fe.outline_60e1\n"
                     "y_mm,z_mm\n")
    np.savetxt(sys.stdout, outline() + 0.0, fmt="%.6f", delimiter=",")


if __name__ == "__main__":
    main()
