# SPDX-License-Identifier: BSD-3-Clause
"""Linear stability of the wheelset: growth and frequency of small motions about the centre, and the critical speed."""
import math
from typing import NamedTuple

import numpy as np

from ..command import Failure
from .wheelset import Request, Wheelset

# Shifts for the derivatives of the contact: large enough that the rounding of the grids, within contact/tolerance, is small.
SHIFT = 0.2e-3        # of y [m], of yaw [rad], and of their rates over the running speed
TORQUE_SHIFT = 1e3    # [N m]
SPEED_TOLERANCE = 0.01  # of the critical speed [m/s]
SPEEDS = 9              # in a report


class Motion(NamedTuple):
    """The motion of the wheelset that grows fastest, or decays slowest."""
    speed: float      # [m/s]
    growth: float     # of its amplitude [1/s]
    frequency: float  # [Hz]; 0: no oscillation


def report(p, contact, first, last):
    """Yields lines with the motion at speeds between two [m/s], and with the critical speed. Raises Failure."""
    if not 0 < first < last < math.inf:
        raise Failure(f"--stability {first:g} {last:g}: must be above 0, and increase")
    stability = Stability(p, contact)
    yield "speed [m/s]  growth [1/s]  frequency [Hz]"
    motions = [stability.motion(speed) for speed in np.linspace(first, last, SPEEDS)]
    yield from (f"{motion.speed:11.2f}  {motion.growth:12.3f}  {motion.frequency:14.3f}" for motion in motions)
    critical = stability.critical_speed(motions)
    yield f"critical speed: {critical:.1f} m/s" if critical else f"no critical speed from {first:g} to {last:g} m/s"


class Stability:
    """Small motions of a wheelset over the running speed; p, contact: see run_closed_loop()."""

    def __init__(self, p, contact):
        self._wheelset, self._contact, self._load = Wheelset(p), contact, p["wheelset"]["axle_load"]

    def motion(self, speed):
        """Motion at a speed [m/s]. Raises Failure if a contact is not usable."""
        values = np.linalg.eigvals(self._wheelset.state_matrix(*self._derivatives(speed)))
        fastest = values[np.argmax(values.real)]
        return Motion(speed, fastest.real, abs(fastest.imag) / (2 * math.pi))

    def critical_speed(self, motions):
        """Lowest speed at which motions begin to grow [m/s], within those of an increasing list of Motion; None without one."""
        for before, after in zip(motions, motions[1:]):
            if before.growth <= 0 < after.growth:
                low, high = before.speed, after.speed
                while high - low > SPEED_TOLERANCE:
                    middle = (low + high) / 2
                    low, high = (middle, high) if self.motion(middle).growth <= 0 else (low, middle)
                return (low + high) / 2
        return None

    def _derivatives(self, speed):
        """Derivatives for Wheelset.state_matrix(), and the rotation about the axle [rad/s]: central differences."""
        shifts = {"y": SHIFT, "yaw": SHIFT, "torque_x": TORQUE_SHIFT, "lateral_velocity": speed * SHIFT,
                  "yaw_rate": speed * SHIFT}
        columns = [(self._outputs(speed, **{name: shift})[0] - self._outputs(speed, **{name: -shift})[0]) / (2 * shift)
                   for name, shift in shifts.items()]
        return np.transpose(columns), self._outputs(speed)[1]

    def _outputs(self, speed, **state):
        reply = self._contact.evaluate(Request(speed=speed, force_z=-self._load, **state))
        if not reply.usable:
            raise Failure(f"no usable contact at the centre of the track: {reply.status}: {reply.status_text}")
        wrench = reply.rail_wrench
        return np.array([wrench.force.y, wrench.torque.z, reply.wheelset.roll]), reply.rotation
