# SPDX-License-Identifier: BSD-3-Clause
"""Von Mises stress in the section of wheel and rail through the place of the highest one."""
from collections import namedtuple

import numpy as np

from . import contour
from .pressure import grid_of, side_of
from .stress import core, stress_at, von_mises

BODIES = ("wheel", "rail")
SIGNS = {"wheel": -1, "rail": 1}  # of the depth, along -z of the patch frame
DEPTH = 2.0      # drawn depth, as a multiple of the shorter semi-axis of the patch
BESIDE = 1.5     # drawn width beside the patch, as a multiple of the same
ACROSS, BELOW = 97, 33  # numbers of points across the track, at most, and along the depth

# Stress of a body in the section.
#
# surface: Contour
# points: (n, BELOW, 2) y (left) and z (out of the rail) in the patch frame [m]
# stress: (n, BELOW) von Mises stress at these points [Pa]
# beneath: PatchStress of the body; its peaks are those of the whole body, not of the section
# place: (2,) y and z of the highest von Mises stress [m]
# yield_stress: in tension [Pa]; 0: not known
# poisson: Poisson's ratio [-]
Body = namedtuple("Body", "name surface points stress beneath place yield_stress poisson")


class StressSection:
    """Section x = const of wheel and rail through the place of the highest von Mises stress beneath a patch.

    side: "left" or "right"
    x: place of the section along the track, in the patch frame [m]
    loaded: (k, 2, 2) ends (y, z) of the k lines on the surface of the rail that carry pressure in this section [m]
    width: (2,) drawn range of y [m]
    depth: drawn depth [m]
    bodies: Body of the wheel and of the rail
    """

    def __init__(self, patch, surfaces=None, poisson=None):
        """Computes the section.

        patch: PatchResult, or message ContactPatch
        surfaces: function reach -> {"wheel": Contour, "rail": Contour}; None: both surfaces are the tangent plane
        poisson: {"wheel": ..., "rail": ...} Poisson's ratios [-]; default: that of config/default.yaml

        Raises ValueError for a patch without stress (stress/depths) or pressure, or a message without its grid.
        """
        highest = max((_beneath(patch, name).von_mises for name in BODIES), key=lambda peak: peak.value)
        if not highest.value > 0:
            raise ValueError("patch: has no stress; set stress/depths above 0")
        self.side, self.x = side_of(patch), highest.x
        ends, lines = _loaded(patch, self.x)
        shorter = min(patch.semi_axis_along, patch.semi_axis_across)
        self.depth, beside = DEPTH * shorter, BESIDE * shorter
        self.width = ends + beside * np.array([-1, 1])
        contours = self._contours(patch, surfaces)
        self.loaded = contours["rail"].at(lines, np.zeros(lines.shape))
        poisson = poisson or dict.fromkeys(BODIES, core.DEFAULT_POISSON)
        s, depth = self._mesh(contours.values())
        # Bodies with the same Poisson's ratio have the same stress.
        fields = {ratio: von_mises(stress_at(patch, self.x, s[:, None], depth, ratio)) for ratio in set(poisson.values())}
        self.bodies = [_body(patch, name, contours[name], (s, depth, fields[poisson[name]]), poisson[name]) for name in BODIES]

    def _contours(self, patch, surfaces):
        reach = np.abs(self.width).max() + self.depth
        if surfaces is None:
            return dict.fromkeys(BODIES, contour.plane(reach))
        contours = surfaces(reach)
        return {"wheel": contour.pressed_on(contours["wheel"], contours["rail"], patch.approach), "rail": contours["rail"]}

    def _mesh(self, surfaces):
        """Arc lengths, and depths below the surface [m], which cover the drawn parts of both bodies."""
        drawn = [(surface.points[:, 0] >= self.width[0]) & (surface.points[:, 0] <= self.width[1]) for surface in surfaces]
        depth = self.depth + max(np.abs(surface.points[part, 1]).max() for surface, part in zip(surfaces, drawn))
        lean = depth * max(np.abs(surface.normals[part, 0]).max() for surface, part in zip(surfaces, drawn))
        first = max(self.width[0] - lean, min(surface.s[0] for surface in surfaces))
        last = min(self.width[1] + lean, max(surface.s[-1] for surface in surfaces))
        # The stress changes faster near the surface.
        return np.linspace(first, last, ACROSS), depth * np.linspace(0, 1, BELOW) ** 1.5


def _loaded(patch, x):
    """Ends of the whole patch (2,), and of its lines with pressure in the section at x (k, 2); y along the arc [m]."""
    pressure, first, size = grid_of(patch)
    edges = first[1] + size[1] * (np.arange(pressure.shape[1] + 1) - 0.5)
    columns = np.flatnonzero((pressure > 0).any(axis=0))
    if not len(columns):
        raise ValueError("patch: its grid has no pressure above 0")
    row = int(np.clip(np.rint((x - first[0]) / size[0]), 0, pressure.shape[0] - 1))
    steps = np.diff(np.concatenate([[0], (pressure[row] > 0).astype(int), [0]]))
    lines = np.column_stack([edges[np.flatnonzero(steps == 1)], edges[np.flatnonzero(steps == -1)]])
    return edges[[columns[0], columns[-1] + 1]], lines


def _body(patch, name, surface, field, poisson):
    """Body whose stress is given by the arc lengths, depths, and stress of a field."""
    s, depth, stress = field
    known = (s >= surface.s[0]) & (s <= surface.s[-1])
    sign, beneath = SIGNS[name], _beneath(patch, name)
    surface = surface.for_depth(depth[-1], sign)
    points = surface.at(np.repeat(s[known, None], len(depth), axis=1), sign * np.tile(depth, (known.sum(), 1)))
    place = surface.at(np.array(beneath.von_mises.y), np.array(sign * beneath.von_mises.depth))
    return Body(name, surface, points, stress[known], beneath, place, yield_stress(patch, name), poisson)


def _beneath(patch, name):
    return getattr(patch, f"{name}_stress")


def yield_stress(patch, name):
    """Yield stress of a body in tension [Pa], from its load factor; 0: not known.

    name: "wheel" or "rail"
    """
    factor = _beneath(patch, name).load_factor
    return np.sqrt(3) * patch.max_pressure / factor if factor > 0 else 0.0
