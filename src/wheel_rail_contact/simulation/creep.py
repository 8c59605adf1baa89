# SPDX-License-Identifier: BSD-3-Clause
"""Creep forces of one wheelset: Kalker's linear theory with a limit by friction, for the example simulate_wheelset_python.

Formulas, sources and signs are those of src/examples/simulate_wheelset/creep_force.h and wheelset_dynamics.h.
"""
import numpy as np

import wheel_rail_contact

SATURATION = 3  # demand, linear force over friction limit, from which the force is the limit (Vermeulen and Johnson 1964)


class Contacts:
    """Contacts of one result, as columns: one value per contact. There may be none."""

    def __init__(self, result, creep):
        patches = result.patches
        centre = result.wheelset.position
        column = np.array([[*(p.pose.position - centre), p.pose.roll, p.normal_force,
                            p.semi_axis_along, p.semi_axis_across, p.side == "left"] for p in patches]).reshape(-1, 8).T
        self.x, self.y, self.z, angle, self.normal_force, a, b, self.is_left = column
        self.sine, self.cosine, self.tangent = np.sin(angle), np.cos(angle), np.tan(angle)
        self.roll = result.wheelset.roll
        c11, c22, c23, c33 = wheel_rail_contact.kalker_coefficients(a / b, creep["poisson"])
        g, product = creep["shear_modulus"], a * b
        self.k_xx, self.k_yy, self.k_zz = g * product * c11, g * product * c22, g * product ** 2 * c33
        self.k_yz, self.limit = g * product ** 1.5 * c23, creep["friction"] * self.normal_force
        self.main = [np.argmax(np.where(self.is_left == side, self.normal_force, -1.0))
                     for side in (1, 0) if np.any(self.is_left == side)]  # of each wheel that has contacts, left first


def following_rates(c, y_rate, yaw_rate):
    """Rates of height [m/s] and roll [rad/s], each (m, 1), for m trial rates y' and yaw', each (m, 1).

    The main contact of each wheel has no velocity along its normal. With contacts on one wheel only, the roll is held.
    """
    rise, lever = c.tangent * (y_rate + yaw_rate * c.x), c.y + c.tangent * c.z
    rises = [rise[:, i:i + 1] for i in c.main]
    if len(c.main) == 2:
        roll_rate = (rises[0] - rises[1]) / (lever[c.main[0]] - lever[c.main[1]])
        return rises[0] - roll_rate * lever[c.main[0]], roll_rate
    none = np.zeros_like(y_rate)
    return (rises[0] if rises else none), none


def creep_forces(c, yaw, velocity, speed):
    """Creep forces for m trial velocities (y', yaw', spin), each (m, 1); yaw (m, 1) [rad].

    Returns the sums over all contacts (m,): lateral and vertical force [N], moments about x, z and the axle [N m].
    """
    y_rate, yaw_rate, spin = velocity
    z_rate, roll_rate = following_rates(c, y_rate, yaw_rate)
    e_x, e_y, e_z = -np.sin(yaw) * np.cos(c.roll), np.cos(yaw) * np.cos(c.roll), np.sin(c.roll)  # direction of the axle
    v_x = speed - yaw_rate * c.y + spin * (e_y * c.z - e_z * c.y)
    v_y = y_rate + yaw_rate * c.x - roll_rate * c.z + spin * (e_z * c.x - e_x * c.z)
    v_z = z_rate + roll_rate * c.y + spin * (e_x * c.y - e_y * c.x)
    along, across = v_x / speed, (v_y * c.cosine + v_z * c.sine) / speed
    turn = ((yaw_rate + spin * e_z) * c.cosine - spin * e_y * c.sine) / speed
    f_x, f_t = -c.k_xx * along, -c.k_yy * across - c.k_yz * turn
    moment = c.k_yz * across - c.k_zz * turn
    demand = np.maximum(np.hypot(f_x, f_t) / c.limit, 1e-12)
    scale = np.where(demand < SATURATION, 1 - demand / 3 + demand ** 2 / 27, 1 / demand)
    f_x, f_t, moment = scale * f_x, scale * f_t, scale * moment
    f_y, f_z = f_t * c.cosine, f_t * c.sine
    m_x = c.y * f_z - c.z * f_y
    m_y, m_z = c.z * f_x - c.x * f_z - moment * c.sine, c.x * f_y - c.y * f_x + moment * c.cosine
    m_axle = e_x * m_x + e_y * m_y + e_z * m_z
    return [part.sum(axis=1) for part in (f_y, f_z, m_x, m_z, m_axle)]
