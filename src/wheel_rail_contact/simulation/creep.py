# SPDX-License-Identifier: BSD-3-Clause
"""Creep forces of one wheelset: Kalker's linear theory with a limit by friction, for the example simulate_wheelset_python.

Formulas, sources and signs are those of src/examples/simulate_wheelset/creep_force.h and wheelset_dynamics.h.
"""
import numpy as np

# Kalker (1990), table E3: a/b, then C11, C22, C23 and C33, each for the Poisson's ratios 0, 1/4 and 1/2.
KALKER = np.array([
    [0.1, 2.51, 3.31, 4.85, 2.51, 2.52, 2.53, 0.334, 0.473, 0.731, 6.42, 8.28, 11.7],
    [0.2, 2.59, 3.37, 4.81, 2.59, 2.63, 2.66, 0.483, 0.603, 0.809, 3.46, 4.27, 5.66],
    [0.3, 2.68, 3.44, 4.80, 2.68, 2.75, 2.81, 0.607, 0.715, 0.889, 2.49, 2.96, 3.72],
    [0.4, 2.78, 3.53, 4.82, 2.78, 2.88, 2.98, 0.720, 0.823, 0.977, 2.02, 2.32, 2.77],
    [0.5, 2.88, 3.62, 4.83, 2.88, 3.01, 3.14, 0.827, 0.929, 1.07, 1.74, 1.93, 2.22],
    [0.6, 2.98, 3.72, 4.91, 2.98, 3.14, 3.31, 0.930, 1.03, 1.18, 1.56, 1.68, 1.86],
    [0.7, 3.09, 3.81, 4.97, 3.09, 3.28, 3.48, 1.03, 1.14, 1.29, 1.43, 1.50, 1.60],
    [0.8, 3.19, 3.91, 5.05, 3.19, 3.41, 3.65, 1.13, 1.25, 1.40, 1.34, 1.37, 1.42],
    [0.9, 3.29, 4.01, 5.12, 3.29, 3.54, 3.82, 1.23, 1.36, 1.51, 1.27, 1.27, 1.27],
    [1.0, 3.40, 4.12, 5.20, 3.40, 3.67, 3.98, 1.33, 1.47, 1.63, 1.21, 1.19, 1.16],
    [1 / 0.9, 3.51, 4.22, 5.30, 3.51, 3.81, 4.16, 1.44, 1.59, 1.77, 1.16, 1.11, 1.06],
    [1 / 0.8, 3.65, 4.36, 5.42, 3.65, 3.99, 4.39, 1.58, 1.75, 1.94, 1.10, 1.04, 0.954],
    [1 / 0.7, 3.82, 4.54, 5.58, 3.82, 4.21, 4.67, 1.76, 1.95, 2.18, 1.05, 0.965, 0.852],
    [1 / 0.6, 4.06, 4.78, 5.80, 4.06, 4.50, 5.04, 2.01, 2.23, 2.50, 1.01, 0.892, 0.751],
    [1 / 0.5, 4.37, 5.10, 6.11, 4.37, 4.90, 5.56, 2.35, 2.62, 2.96, 0.958, 0.819, 0.650],
    [1 / 0.4, 4.84, 5.57, 6.57, 4.84, 5.48, 6.31, 2.88, 3.24, 3.70, 0.912, 0.747, 0.549],
    [1 / 0.3, 5.57, 6.34, 7.34, 5.57, 6.40, 7.51, 3.79, 4.32, 5.01, 0.868, 0.674, 0.446],
    [1 / 0.2, 6.96, 7.78, 8.82, 6.96, 8.14, 9.79, 5.72, 6.63, 7.89, 0.828, 0.601, 0.341],
    [1 / 0.1, 10.7, 11.7, 12.9, 10.7, 12.8, 16.0, 12.2, 14.6, 18.0, 0.795, 0.526, 0.228]])


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
        c11, c22, c23, c33 = coefficients(a / b, creep["poisson"])
        g, product = creep["shear_modulus"], a * b
        self.k_xx, self.k_yy, self.k_zz = g * product * c11, g * product * c22, g * product ** 2 * c33
        self.k_yz, self.limit = g * product ** 1.5 * c23, creep["friction"] * self.normal_force
        self.main = [np.argmax(np.where(self.is_left == side, self.normal_force, -1.0))
                     for side in (1, 0) if np.any(self.is_left == side)]  # of each wheel that has contacts, left first


def coefficients(ratio, poisson):
    """C11, C22, C23, C33 (4, n) at ratios of the semi-axes a/b (n,)."""
    p = 4 * poisson
    weights = np.array([0.5 * (p - 1) * (p - 2), p * (2 - p), 0.5 * p * (p - 1)])
    values = np.log(KALKER[:, 1:].reshape(-1, 4, 3) @ weights)
    place, logarithm = np.log(KALKER[:, 0]), np.log(ratio)
    i = np.clip(np.searchsorted(place, logarithm, side="right"), 1, len(place) - 1)
    share = ((logarithm - place[i - 1]) / (place[i] - place[i - 1]))[:, None]
    return np.exp((1 - share) * values[i - 1] + share * values[i]).T


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
