# SPDX-License-Identifier: BSD-3-Clause
"""Power spectral densities of track irregularities, and random irregularities with such a density.

The densities are those of ORE B176 RP1 (1989). W is the wavenumber [rad/m]. They are one-sided: the variance of a quantity is
the integral of its density over the positive wavenumbers.
"""
import math
from dataclasses import dataclass

import numpy as np

W_C, W_R, W_S = 0.8246, 0.0206, 0.4380  # [rad/m]
HALF_BASE = 0.75  # b, half the distance of the running circles [m]
POINTS = 32  # at which a density is evaluated in each interval of wavenumbers


@dataclass
class Level:
    """Factors of the densities [rad m]."""
    alignment: float
    level: float
    gauge: float


# ORE B176 has no gauge. Its factors are from Zhai (2020), Vehicle-Track Coupled Dynamics, with the form of the cross level.
LEVELS = {"low": Level(2.119e-7, 4.032e-7, 5.32e-8), "high": Level(6.125e-7, 1.080e-6, 1.032e-7)}
QUANTITIES = ("alignment", "level", "cross_level", "gauge")


def densities(level):
    """Density of each of QUANTITIES [m² / (rad/m)], as a function of the wavenumber [rad/m].

    @param level key of LEVELS
    """
    factors = LEVELS[level]

    def position(w):
        return W_C**2 / ((w**2 + W_R**2) * (w**2 + W_C**2))

    def difference(w):
        return position(w) * w**2 / (w**2 + W_S**2)

    # The density of the cross level as an angle is A_V / b² difference(W). Times (2 b)²: of its height over 2 b.
    return {"alignment": lambda w: factors.alignment * position(w), "level": lambda w: factors.level * position(w),
            "cross_level": lambda w: factors.level / HALF_BASE**2 * (2 * HALF_BASE)**2 * difference(w),
            "gauge": lambda w: factors.gauge * difference(w)}


def variances(density, edges):
    """Integral of a density over each interval between successive edges [rad/m]."""
    low, width = edges[:-1, None], np.diff(edges)[:, None]
    return (density(low + width * (np.arange(POINTS) + 0.5) / POINTS) * width / POINTS).sum(axis=1)


def irregularity(density, count, spacing, wavelengths, random):
    """Values of a random quantity at count places, spacing [m] apart. It is periodic: value `count` would be the first one.

    It is a sum of cosines whose wavelengths divide the whole length (Shinozuka and Deodatis 1991). Their phases are random.
    Their amplitudes are those of the density; the standard deviation is therefore the same for all phases.

    @param density one-sided [m² / (rad/m)], a function of the wavenumber [rad/m]
    @param wavelengths shortest and longest one [m]
    @param random a random.Random
    """
    step = 2 * math.pi / (count * spacing)
    shortest, longest = wavelengths
    edges = np.clip(step * (np.arange(count // 2 + 2) - 0.5), 2 * math.pi / longest, 2 * math.pi / shortest)
    amplitudes = np.sqrt(2 * variances(density, edges))
    phases = 2 * math.pi * np.array([random.random() for _ in amplitudes])
    return np.fft.irfft(count / 2 * amplitudes * np.exp(1j * phases), count)
