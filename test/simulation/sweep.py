# SPDX-License-Identifier: BSD-3-Clause
"""Contacts over the lateral displacement, and what follows from them for the motion."""
import numpy as np

from wheel_rail_contact.simulation.parameters import read_parameters
from wheel_rail_contact.simulation.wheelset import Request

STEP = 5e-5       # [m]
R0 = 0.46         # rolling radius [m]
HALF_BASE = 0.75  # of the running circles, with the default wheelset [m]


class Sweep:
    """Contacts without yaw, for displacements from 0 to `last` [m].

    The profiles are mirror images, and so are the contacts at negative displacements.
    """

    def __init__(self, contact, last):
        load = read_parameters()["wheelset"]["axle_load"]
        self._y = np.arange(0, last, STEP)
        results = [contact.evaluate(Request(y=y, force_z=-load)) for y in self._y]
        assert all(result.usable for result in results)
        self._difference = [_radius(result, "left") - _radius(result, "right") for result in results]
        self._roll = [result.wheelset.roll for result in results]
        self._angle = np.array([max(patch.pose.roll for patch in result.patches) for result in results])

    def kinematic_wavelength(self, amplitude):
        """Wavelength of the kinematic motion of an amplitude A [m].

        A wheelset that rolls without creepage obeys y' + r0 roll' = yaw and yaw' = -dr / (2 b r0), with the rolling radius
        difference dr = r_left - r_right and derivatives along the track. Klingel (1883) neglects the roll, which lengthens
        the wave by 1 % on the tread. With the equivalent conicity c and the slope s of the roll over y the wavelength is
        L = 2 pi sqrt(b r0 (1 + r0 s) / c). Both are those of harmonic linearisation: c = 1 / (2 pi A) times the integral
        over one period of dr(A sin t) sin t dt, and s = 1 / (pi A) times that of roll(A sin t) sin t dt.
        """
        conicity = 0.5 * self._harmonic(self._difference, amplitude) / amplitude
        slope = self._harmonic(self._roll, amplitude) / amplitude
        return 2 * np.pi * np.sqrt(HALF_BASE * R0 * (1 + R0 * slope) / conicity)

    def steep_from(self, angle):
        """Smallest displacement with a contact steeper than `angle` [m]."""
        return self._y[np.argmax(self._angle > angle)] if np.any(self._angle > angle) else self._y[-1] + STEP

    def _harmonic(self, values, amplitude):
        """Amplitude of the first harmonic of an odd function of y, for y = amplitude sin t."""
        parts = 400  # of a quarter of the period; the other three are equal
        sine = np.sin(0.5 * np.pi * (np.arange(parts) + 0.5) / parts)
        return 2 * np.mean(np.interp(amplitude * sine, self._y, values) * sine)


def _radius(result, side):
    """Mean rolling radius of a wheel, weighted with the normal forces [m]; NaN in the air."""
    moments = [(patch.normal_force, patch.normal_force * patch.rolling_radius) for patch in result.patches if patch.side == side]
    force, moment = np.sum(moments, axis=0) if moments else (1, np.nan)
    return moment / force
