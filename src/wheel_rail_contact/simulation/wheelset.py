# SPDX-License-Identifier: BSD-3-Clause
"""Equations of motion of one wheelset on its primary suspension, running at a constant speed V.

  m y''     = Y - 2 k_y y - 2 c_y y'
  m z''     = Z - axle_load
  I_x roll'' = M_x - 2 k_z b_s^2 roll + I_y W yaw'
  I_z yaw'' = M_z - 2 b_s^2 (k_x yaw + c_x yaw') - I_y W roll'

Y, Z and M are whole forces and moments of the rails: normal forces and friction. The terms of the rotation W about the axle are
gyroscopic; W follows from the contact. So do height and roll if these have no inertia of their own (wheelset/free: [z, roll]).
The contact then has the load

  force_z   = -axle_load - m z_line''
  torque_x  = -2 k_z b_s^2 roll - I_x roll_line'' + I_y W yaw'

with the height and roll of the rails by the line. doc/co_simulation.md describes the step.
"""
from typing import NamedTuple

import numpy as np

from ..command import Failure
from .parameters import step_nanoseconds

Y, Z, ROLL, YAW = range(4)
POSITIONS = ["y", "z", "roll", "yaw"]
VELOCITIES = ["lateral_velocity", "vertical_velocity", "roll_rate", "yaw_rate"]
FORCES = ["force_y", "force_z", "torque_x", "torque_z"]
MOST_ITERATIONS = 20
NEWTON_ITERATIONS = 4  # then changes that point back are halved: with other cells the force jumps
SLOW = 0.3             # share that is left of a change, from which differences are renewed
DIFFERENCE = 1e-5      # for differences, of the same velocities as TOLERANCE
TOLERANCE = 1e-6       # of the velocities of y and z, and of roll and yaw at 1 m, over the running speed
HALF_DISTANCE = 0.75   # of the rails [m], for the roll by the line


class Request(NamedTuple):
    """What the dynamics send: time, and pose, velocities and load of the wheelset in the track frame."""
    time: int = 0           # since the start [ns]; all states of one step have one time
    x: float = 0.0          # place along the track [m]
    y: float = 0.0          # lateral displacement of the axle centre, to the left positive [m]
    z: float = 0.0          # height of the axle centre [m]; not used if it is solved, as roll and their rates
    roll: float = 0.0       # positive if the left wheel is raised [rad]
    yaw: float = 0.0        # to the left positive [rad]
    speed: float = 0.0      # running speed V [m/s]
    lateral_velocity: float = 0.0   # [m/s]
    vertical_velocity: float = 0.0  # [m/s]
    roll_rate: float = 0.0  # [rad/s]
    yaw_rate: float = 0.0   # [rad/s]
    force_z: float = 0.0    # of vehicle and weight on the axle centre, up positive [N]
    torque_x: float = 0.0   # moment on the axle centre about x [N m]


class Wheelset:
    """Motion of a wheelset: y, z [m], roll, yaw [rad] in `position`, their rates in `velocity`; p: see read_parameters()."""

    def __init__(self, p, height_given=False):
        """height_given: height and roll have inertia (wheelset/free: []); start() is required then."""
        w, s, arm = p["wheelset"], p["suspension"], p["suspension"]["half_spacing"] ** 2
        self.run, self.w, self.steps = p["run"], w, 0
        self.position = self._last_position = np.array([self.run["y"], 0, 0, self.run["yaw"]])  # one array at the start
        self.velocity = self._last_velocity = np.zeros(4)
        self.sent = None  # last request
        self._free, self._solved = ([Y, Z, ROLL, YAW], []) if height_given else ([Y, YAW], [Z, ROLL])
        self._time_step = step_nanoseconds(self.run)
        self._step = 1e-9 * self._time_step
        self._inertia = np.array([w["mass"], w["mass"], w["yaw_inertia"], w["yaw_inertia"]])
        self._stiffness = 2 * np.array([s["lateral_stiffness"], 0, arm * s["vertical_stiffness"],
                                        arm * s["longitudinal_stiffness"]])
        self._damping = 2 * np.array([s["lateral_damping"], 0, 0, arm * s["longitudinal_damping"]])
        self._weight = np.array([0, -w["axle_load"], 0, 0])
        self._gyroscopic = np.zeros((4, 4))  # moments by the velocities
        self._line = [np.zeros(2)] * 3  # height [m] and roll [rad] of the rails by the line, last three steps
        self._matrix = np.eye(len(self._free))

    def start(self, contact):
        """Sets given height and roll to those at rest, with the velocity of the rails. Raises Failure.

        contact: with the method static_start()
        """
        for _ in range(2):  # the roll changes the load
            reply = contact.static_start(self.request())
            if not reply.usable:
                raise Failure(f"no height and roll at the start: {reply.status}: {reply.status_text}")
            self.position[[Z, ROLL]] = reply.wheelset.position.z, reply.wheelset.roll
        self.velocity[[Z, ROLL]] = self.run["speed"] * _plane(reply.left_rail.vertical_slope, reply.right_rail.vertical_slope)

    def request(self, velocity=None):
        """State now, or at the end of the next step if this ends with `velocity`."""
        time = (self.steps + (velocity is not None)) * self._time_step
        position = self.position if velocity is None else self._position(velocity)
        velocity = self.velocity if velocity is None else velocity
        new, last, before = self._line
        inertia = self.w["line_inertia"] * bool(self._solved) * (new - 2 * last + before) / self._step ** 2
        return Request(time, self.run["start"] + self.run["speed"] * 1e-9 * time, *position, self.run["speed"], *velocity,
                       -self.w["axle_load"] - self._inertia[Z] * inertia[0],
                       -self._stiffness[ROLL] * position[ROLL] - self._inertia[ROLL] * inertia[1]
                       + self._gyroscopic[ROLL] @ velocity)

    def advance(self, contact):
        """Advances the motion by one step with a HeldContact, and returns the contact at its end. Raises Failure.

        Newton's iteration for the new velocities. Without derivatives of the contact, differences serve until they no
        longer suffice.
        """
        velocity, last, share = 2 * self.velocity - self._last_velocity, np.zeros(4), 1.0
        self.sent = self.request(velocity)
        reply = contact.evaluate(self.sent)
        self._add_line(reply.left_rail.given_vertical, reply.right_rail.given_vertical)
        for i in range(MOST_ITERATIONS):
            self._follow(reply, velocity)
            residual = self._residual(velocity, reply)
            is_known = _is_known(reply.derivatives)
            if is_known:
                self._matrix = self._matrix_of(np.zeros((2, 4, 4)) if contact.in_a_row else _slopes(reply.derivatives))
            change = share * self._change(residual)
            size = np.linalg.norm(change)
            if size <= TOLERANCE * self.run["speed"]:
                self._finish(velocity + change, reply)
                return reply
            if i >= NEWTON_ITERATIONS:
                if change @ last < 0:  # the force jumps: the step ends there
                    share, change = share / 2, change / 2
            elif not is_known and (size > SLOW * np.linalg.norm(last) if i else not self.steps):
                self._matrix = self._differences(velocity, residual, contact)
                change = self._change(residual)
            velocity, last = velocity + change, change
            self.sent = self.request(velocity)
            reply = contact.evaluate_again(self.sent)
        raise Failure(f"the velocities of the wheelset do not converge in a step of {self._step:g} s")

    def _residual(self, velocity, reply):
        """Velocities after the step, with the forces for `velocity`, less `velocity`."""
        wrench = reply.rail_wrench
        forces = self._weight + [wrench.force.y, wrench.force.z, wrench.torque.x, wrench.torque.z]
        forces += self._gyroscopic @ velocity - self._stiffness * self._position(velocity) - self._damping * velocity
        return self._base(self.velocity, self._last_velocity) + self._length() * forces / self._inertia - velocity

    def _matrix_of(self, slopes):
        """Derivatives of the residual by the velocities, with negative sign. slopes: see _slopes()."""
        by_position, by_velocity = slopes
        by_velocity = by_velocity + self._gyroscopic - np.diag(self._damping)
        by_velocity = by_velocity + self._length() * (by_position - np.diag(self._stiffness))
        return (np.eye(4) - self._length() * by_velocity / self._inertia[:, np.newaxis])[np.ix_(self._free, self._free)]

    def _differences(self, velocity, residual, contact):
        """The same, from differences of further evaluations."""
        columns, shift = [], DIFFERENCE * self.run["speed"]
        for i in self._free:
            moved = velocity + shift * np.eye(4)[i]
            reply = contact.evaluate_again(self.request(moved))
            self._follow(reply, moved)
            columns.append((residual - self._residual(moved, reply))[self._free] / shift)
        return np.transpose(columns)

    def _change(self, residual):
        """Change of the velocities by a residual."""
        change = np.zeros(4)
        change[self._free] = np.linalg.solve(self._matrix, residual[self._free])
        return change

    def _length(self):
        """Change of a value in a step per rate at its end [s]: 2/3 of the step after the first one."""
        return self._step * (2 / 3 if self.steps else 1)

    def _base(self, now, last):
        """Value after the step with a rate of zero at its end."""
        return (4 * now - last) / 3 if self.steps else now

    def _position(self, velocity):
        """Position after a step that ends with `velocity`."""
        return self._base(self.position, self._last_position) + self._length() * velocity

    def _follow(self, reply, velocity):
        """Sets the rates of solved height and roll; both rest before the first step."""
        if self._solved:
            height = np.array([reply.wheelset.position.z, reply.wheelset.roll])
            if not self.steps:
                self.position[self._solved] = height
            velocity[self._solved] = (height - self._position(np.zeros(4))[self._solved]) / self._length()

    def _add_line(self, left, right):
        place = _plane(left, right)
        last = self._line[0] if self.steps else place
        self._line = [place, last, self._line[1] if self.steps > 1 else 2 * last - place]  # straight before the start

    def _finish(self, velocity, reply):
        position = self._position(velocity)
        self._last_position, self._last_velocity = self.position, self.velocity
        self.position, self.velocity, self.steps = position, velocity, self.steps + 1
        momentum = self.w["gyroscopic"] * self.w["spin_inertia"] * reply.rotation
        self._gyroscopic[[ROLL, YAW], [YAW, ROLL]] = momentum, -momentum


def _plane(left, right):
    """Height and roll of values of both rails."""
    return np.array([(left + right) / 2, (left - right) / (2 * HALF_DISTANCE)])


def _is_known(derivatives):
    return derivatives.forces.size and np.all(np.isfinite(derivatives.forces)) and np.all(np.isfinite(derivatives.solution))


def _slopes(derivatives):
    """Derivatives (2, 4, 4) of the forces of the rails by position and velocity. Solved height and roll follow y and yaw."""
    forces, solution = derivatives.forces, derivatives.solution
    by_position, by_velocity = forces[FORCES, POSITIONS], forces[FORCES, VELOCITIES]
    if solution.size:
        by_height, free = by_position[:, [Z, ROLL]], [Y, YAW]
        by_position[:, free] += by_height @ solution[["z", "roll"], ["y", "yaw"]]
        by_velocity[:, free] += by_height @ solution[["z", "roll"], ["lateral_velocity", "yaw_rate"]]
    return by_position, by_velocity
