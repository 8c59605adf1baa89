# SPDX-License-Identifier: BSD-3-Clause
"""Equations of motion of one wheelset on its primary suspension, running at a constant speed V.

Lateral displacement y and yaw have inertia. Height, roll and the rotation W about the axle follow from the contact.

  m y''     = Y - 2 k_y y - 2 c_y y'
  I_z yaw'' = M_z - 2 b_s^2 (k_x yaw + c_x yaw') - I_y W roll'
  force_z   = -axle_load - m z_line''
  torque_x  = -2 k_z b_s^2 roll - I_x roll_line'' + I_y W yaw'

Y and M_z are whole forces of the rails: normal forces and friction. The last terms are gyroscopic moments and the inertia on a
line; z_line and roll_line are those of the rails by the line. doc/co_simulation.md describes the step.
"""
from typing import NamedTuple

import numpy as np

from ..command import Failure
from .parameters import step_nanoseconds

MOST_ITERATIONS = 20
NEWTON_ITERATIONS = 4  # then derivatives are kept, and changes that point back halved: with other cells the force jumps
TOLERANCE = 1e-6      # of the velocities of y, and of yaw at 1 m, over the running speed
DIFFERENCE = 1e-5     # for the derivatives, of the same velocities
SLOW = 0.3            # share that is left of a change, from which the derivatives are renewed
HALF_DISTANCE = 0.75  # of the rails [m], for the roll by the line


class Request(NamedTuple):
    """What the dynamics send: time, and pose, velocities and load of the wheelset in the track frame."""
    time: int = 0           # since the start [ns]; all states of one step have one time
    x: float = 0.0          # place along the track [m]
    y: float = 0.0          # lateral displacement of the axle centre, to the left positive [m]
    yaw: float = 0.0        # to the left positive [rad]
    speed: float = 0.0      # running speed V [m/s]
    lateral_velocity: float = 0.0  # [m/s]
    yaw_rate: float = 0.0   # [rad/s]
    force_z: float = 0.0    # of vehicle and weight on the axle centre, up positive [N]
    torque_x: float = 0.0   # moment on the axle centre about x [N m]


class Wheelset:
    """Motion of the wheelset: y [m] and yaw [rad] in `position`, their rates in `velocity`; p: see read_parameters()."""

    def __init__(self, p):
        w, s, arm = p["wheelset"], p["suspension"], p["suspension"]["half_spacing"] ** 2
        self.run, self.w, self.steps = p["run"], w, 0
        self.position, self.velocity = np.array([self.run["y"], self.run["yaw"]]), np.zeros(2)
        self._time_step = step_nanoseconds(self.run)
        self._step = 1e-9 * self._time_step
        self._inertia = np.array([w["mass"], w["yaw_inertia"]])
        self._stiffness = 2 * np.array([s["lateral_stiffness"], arm * s["longitudinal_stiffness"]])
        self._damping = 2 * np.array([s["lateral_damping"], arm * s["longitudinal_damping"]])
        self._roll_stiffness = 2 * arm * s["vertical_stiffness"]
        self._roll = self._roll_rate = self._spin_momentum = 0.0
        self._line = [np.zeros(2)] * 3  # height [m] and roll [rad] of the rails by the line, last three steps
        self._change = np.zeros(2)      # of the velocities in the last step
        self._correction = np.eye(2)    # change of the velocities by a residual

    def request(self, velocity=None):
        """State at the start of the next step, or in a step that ends with `velocity`: the yaw is then that at its end."""
        time, new, last, before = self.steps * self._time_step, *self._line
        inertia = self.w["line_inertia"] * self._inertia * (new - 2 * last + before) / self._step ** 2
        yaw = self.position[1] if velocity is None else self.position[1] + self._step * velocity[1]
        y_rate, yaw_rate = self.velocity if velocity is None else velocity
        return Request(time, self.run["start"] + self.run["speed"] * 1e-9 * time, self.position[0], yaw, self.run["speed"], y_rate,
                       yaw_rate, -self.w["axle_load"] - inertia[0],
                       -self._roll_stiffness * self._roll - inertia[1] + self._spin_momentum * yaw_rate)

    def advance(self, contact):
        """Advances the motion by one step with a HeldContact, and returns the contact in the step. Raises Failure.

        Newton's iteration for the new velocities, with the derivatives of an earlier step while these suffice.
        """
        velocity, last, share = self.velocity + self._change, np.zeros(2), 1.0
        reply = contact.evaluate(self.request(velocity))
        self._add_line(reply.left_rail.given_vertical, reply.right_rail.given_vertical)
        for i in range(MOST_ITERATIONS):
            residual = self._residual(velocity, reply)
            change = share * self._correction @ residual
            size = np.hypot(*change)
            if size <= TOLERANCE * self.run["speed"]:
                self._finish(velocity + change, reply)
                return reply
            if i >= NEWTON_ITERATIONS:
                if change @ last < 0:  # the force jumps: the step ends there
                    share, change = share / 2, change / 2
            elif size > SLOW * np.hypot(*last) if i else self.steps == 0:
                self._correction = self._differentiate(velocity, residual, contact)
                change = self._correction @ residual
            velocity, last = velocity + change, change
            reply = contact.evaluate_again(self.request(velocity))
        raise Failure(f"the velocities of the wheelset do not converge in a step of {self._step:g} s")

    def _residual(self, velocity, reply):
        """Velocities after the step, with the forces of the rails for `velocity`, less `velocity`."""
        wrench = reply.rail_wrench
        forces = np.array([wrench.force.y, wrench.torque.z - self._spin_momentum * self._roll_rate])
        forces -= self._stiffness * self.position + self._damping * velocity
        return self.velocity + self._step * forces / self._inertia - velocity

    def _differentiate(self, velocity, residual, contact):
        """Change of the velocities by a residual, from the derivatives of the residual."""
        columns = []
        for shift in DIFFERENCE * self.run["speed"] * np.eye(2):
            reply = contact.evaluate_again(self.request(velocity + shift))
            columns.append((self._residual(velocity + shift, reply) - residual) / shift.sum())
        return -np.linalg.inv(np.array(columns).T)

    def _add_line(self, left, right):
        place = np.array([(left + right) / 2, (left - right) / (2 * HALF_DISTANCE)])
        last = self._line[0] if self.steps else place
        self._line = [place, last, self._line[1] if self.steps > 1 else 2 * last - place]  # straight before the start

    def _finish(self, velocity, reply):
        self._change, self.velocity = velocity - self.velocity, velocity
        self.position = self.position + self._step * velocity
        self._roll_rate = (reply.wheelset.roll - self._roll) / self._step if self.steps else 0.0
        self._roll, self.steps = reply.wheelset.roll, self.steps + 1
        self._spin_momentum = self.w["gyroscopic"] * self.w["spin_inertia"] * reply.rotation
