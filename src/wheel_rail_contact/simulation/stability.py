# SPDX-License-Identifier: BSD-3-Clause
"""Linear stability of the wheelset: growth and frequency of small motions about the centre, and the critical speed."""
import math
from typing import NamedTuple

import numpy as np

from ..command import Failure
from .wheelset import Request

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
    yield (f"critical speed: below {first:g} m/s, where motions already grow" if motions[0].growth > 0 else
           f"critical speed: {critical:.1f} m/s" if critical else f"no critical speed from {first:g} to {last:g} m/s")


class Stability:
    """Small motions of a wheelset over the running speed; p, contact: see run_closed_loop()."""

    def __init__(self, p, contact):
        self._p, self._contact = p, contact

    def motion(self, speed):
        """Motion at a speed [m/s]. Raises Failure if a contact is not usable."""
        values = np.linalg.eigvals(state_matrix(self._p, *self._derivatives(speed)))
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
        """Derivatives for state_matrix(), and the rotation about the axle [rad/s]: central differences."""
        shifts = {"y": SHIFT, "yaw": SHIFT, "torque_x": TORQUE_SHIFT, "lateral_velocity": speed * SHIFT,
                  "yaw_rate": speed * SHIFT}
        columns = [(self._outputs(speed, **{name: shift})[0] - self._outputs(speed, **{name: -shift})[0]) / (2 * shift)
                   for name, shift in shifts.items()]
        return np.transpose(columns), self._outputs(speed)[1]

    def _outputs(self, speed, **state):
        reply = self._contact.evaluate(Request(speed=speed, force_z=-self._p["wheelset"]["axle_load"], **state))
        if not reply.usable:
            raise Failure(f"no usable contact at the centre of the track: {reply.status}: {reply.status_text}")
        wrench = reply.rail_wrench
        return np.array([wrench.force.y, wrench.torque.z, reply.wheelset.roll]), reply.rotation


def state_matrix(p, contact, rotation):
    """Matrix A of the small motions x' = A x about the centre, x = (y, yaw, y', yaw'); wheelset.py has the equations.

    p: see read_parameters(). contact: (3, 5) derivatives of force y, torque z and roll in the contact by y, yaw, torque_x, y'
    and yaw'. rotation: W [rad/s]
    """
    w, s, arm = p["wheelset"], p["suspension"], p["suspension"]["half_spacing"] ** 2
    momentum, roll_stiffness = w["gyroscopic"] * w["spin_inertia"] * rotation, 2 * arm * s["vertical_stiffness"]
    by_torque, by_state = contact[:, 2], contact[:, [0, 1, 3, 4]]
    torque = momentum * np.eye(4)[3]  # on the axle, besides that of the springs by the roll
    roll = (by_state[2] + by_torque[2] * torque) / (1 + by_torque[2] * roll_stiffness)
    forces = by_state[:2] + np.outer(by_torque[:2], torque - roll_stiffness * roll)
    forces[:, :2] -= 2 * np.diag([s["lateral_stiffness"], arm * s["longitudinal_stiffness"]])
    forces[:, 2:] -= 2 * np.diag([s["lateral_damping"], arm * s["longitudinal_damping"]])
    forces[1, 2:] -= momentum * roll[:2]
    inertia = np.diag([w["mass"], w["yaw_inertia"]])
    inertia[1] += momentum * roll[2:]
    return np.vstack([np.eye(4)[2:], np.linalg.solve(inertia, forces)])
