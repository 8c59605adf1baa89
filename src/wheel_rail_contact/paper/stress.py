# SPDX-License-Identifier: BSD-3-Clause
"""Highest stresses in the rail beneath the left wheel, at the position of the case."""
from types import SimpleNamespace

import numpy as np

from ..command import Failure
from ..core.extension import core
from ..core.stress import max_shear, principal_stresses, strain, stress_at, stress_layers, von_mises
from .case import POSITION, left_patches, steps

# Assumed yield stress of the rail in tension [Pa]. The paper does not state the steel. EN 13674-1 requires a tensile strength
# (880 MPa for R260), but no yield stress. 0.2 % proof stresses of R260 are about 480 to 500 MPa.
YIELD = 480e6
YOUNG, POISSON = 2.1e11, 0.28  # of the rail, in config/paper.yaml [Pa], [-]

# Depths of the search, in units of the shorter semi-axis [-]. The maxima of the paper's cases are at 0.26 to 0.4. Below the
# close depths, the stress falls steadily.
CLOSE_DEPTHS = steps(0.05, 0.8, 30)
FAR_DEPTHS = steps(0.9, 2.5, 16)


def maxima(patch, poisson=POISSON, yield_stress=YIELD):
    """Highest stresses in a half-space beneath a patch: all cells at close depths. Slower than the search of the core
    (PatchResult.rail_stress), and more accurate: 0.2 % in stress, 2 % in depth.

    Returns von_mises, shear (peaks: value [Pa], x, y, depth [m]), alternating (highest |xz|, which alternates under rolling
    along the track [Pa]), yield_depth (largest depth with a von Mises stress above the yield stress [m]; 0: there is none) and
    principal (stresses at the highest von Mises stress [Pa], the largest first).

    Raises Failure if a maximum or the region of yield is not within the searched depths.
    """
    depths = np.array(CLOSE_DEPTHS + FAR_DEPTHS) * min(patch.semi_axis_along, patch.semi_axis_across)
    layers = np.moveaxis(stress_layers(patch, depths, poisson), 1, -1)
    by_depth = _peaks(patch, depths, von_mises(layers))
    peak = _highest(by_depth)
    stress = stress_at(patch, peak.x, peak.y, peak.depth, poisson)
    return SimpleNamespace(von_mises=peak, shear=_highest(_peaks(patch, depths, max_shear(layers))),
                           alternating=_highest(_peaks(patch, depths, np.abs(layers[..., 4]))).value,
                           yield_depth=_depth_above(by_depth, yield_stress), principal=principal_stresses(stress))


def _peaks(patch, depths, values):
    """Highest value in each layer, on parabolas along and across the track.

    values: (depths, nx, ny)
    """
    peaks = []
    for depth, layer in zip(depths, values):
        column, row = np.unravel_index(layer.T.argmax(), layer.T.shape)
        peak = SimpleNamespace(value=layer[row, column], x=patch.x[row], y=patch.y[column], depth=depth)
        # The pressure of a usable patch does not reach the border of its grid, so the highest stress has all neighbours.
        if 0 < row < layer.shape[0] - 1 and 0 < column < layer.shape[1] - 1:
            along, across = _top(*layer[row - 1:row + 2, column]), _top(*layer[row, column - 1:column + 2])
            peak.x += along[0] * patch.dx
            peak.y += across[0] * patch.dy
            peak.value += along[1] + across[1]
        peaks.append(peak)
    return peaks


def _top(before, middle, after):
    """Top of the parabola through three equidistant values: its offset from the middle in steps, and its gain over it."""
    slope, bend = 0.5 * (after - before), before + after - 2 * middle
    return (-slope / bend, -0.5 * slope**2 / bend) if bend < 0 else (0.0, 0.0)


def _highest(peaks):
    """The highest peak, on a parabola through three of the close depths."""
    k = int(np.argmax([peak.value for peak in peaks]))
    if not 0 < k < len(CLOSE_DEPTHS) - 1:
        raise Failure(f"the highest stress is not within the close depths: found at {peaks[k].depth:.6f} m")
    offset, gain = _top(*(peak.value for peak in peaks[k - 1:k + 2]))
    peak = peaks[k]
    return SimpleNamespace(value=peak.value + gain, x=peak.x, y=peak.y,
                           depth=peak.depth + offset * (peaks[k + 1].depth - peak.depth))


def _depth_above(peaks, limit):
    """Largest depth at which the highest value is above a limit, linear between the layers [m]; 0 if it is nowhere."""
    if peaks[-1].value > limit:
        raise Failure("the von Mises stress is above the yield stress at the largest searched depth")
    for above, below in zip(peaks[-2::-1], peaks[:0:-1]):
        if above.value > limit:
            return below.depth - (limit - below.value) / (above.value - below.value) * (below.depth - above.depth)
    return 0.0


class RailStress:
    """Stress in the rail beneath the only patch of the left wheel.

    rail           name of a case, or of a rail
    lateral_force  outward, the same on both rails [N]; 0 for a case
    is_in_range    whether the force is in the range of the table of the rail
    patch          PatchResult
    highest        see maxima()
    """

    def __init__(self, rail, patches, lateral_force=0.0, is_in_range=True):
        """Raises Failure if there is not one patch: the stress would include the pressure of the others."""
        if len(patches) != 1:
            raise Failure(f"{rail} under {lateral_force:g} N: the left wheel has {len(patches)} patches, but the stress is "
                          "computed for one")
        self.rail, self.lateral_force, self.is_in_range, self.patch = rail, lateral_force, is_in_range, patches[0]
        self.highest = maxima(self.patch)

    @property
    def load_factor(self):
        """As PatchStress.load_factor, with YIELD [-]."""
        return core.load_factor(self.patch.max_pressure, YIELD)

    @property
    def shakedown_limit(self):
        """As PatchStress.shakedown_limit [-]."""
        return core.shakedown_limit(self.patch.max_pressure, self.highest.alternating, self.highest.von_mises.value)

    @property
    def strain(self):
        """Principal strains at the highest von Mises stress [-]: an isotropic material has the same axes of both."""
        return strain(np.append(self.highest.principal, np.zeros(3)), YOUNG, POISSON)[:3]

    def row(self):
        """Row of stress.csv."""
        patch, highest = self.patch, self.highest
        peak = highest.von_mises
        row = {"rail": self.rail, "lateral_force": self.lateral_force, "in_range": self.is_in_range,
               "max_pressure": patch.max_pressure, "area": patch.area, "semi_axis_along": patch.semi_axis_along,
               "semi_axis_across": patch.semi_axis_across, "von_mises": peak.value, "von_mises_x": peak.x,
               "von_mises_y": peak.y, "von_mises_depth": peak.depth, "shear": highest.shear.value,
               "shear_depth": highest.shear.depth, "alternating": highest.alternating, "yield_depth": highest.yield_depth}
        row.update({f"stress_{k}": value for k, value in enumerate(highest.principal, 1)})
        row.update({f"strain_{k}": value for k, value in enumerate(self.strain, 1)})
        return {**row, "load_factor": self.load_factor, "shakedown_limit": self.shakedown_limit, "poisson": POISSON}


def under_forces(rail, forces):
    """RailStress on a Rail, coupled, under each lateral force [N]. Raises Failure if there is no solution."""
    found = []
    for force, result in zip(forces, rail.evaluate([POSITION], forces, results=True).results):
        if not result.usable:
            raise Failure(f"{rail.name} under {force:g} N: {result.status_text}")
        found.append(RailStress(rail.name, left_patches(result), force, rail.is_in_range(force)))
    return found
