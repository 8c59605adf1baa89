# SPDX-License-Identifier: BSD-3-Clause
"""Equivalent conicity: that of cones whose kinematic wave has the same wavelength (EN 15302:2008+A1:2010).

The wave obeys y'' = -dr(y) / (e r0), with dr the rolling radius difference, e the distance of the running circles and r0 the
rolling radius (annex B of the standard). Its first integral gives the wavelength L as an integral over y between the turning
points, at which the integral S of dr is equal. Cones have L = 2 pi sqrt(e r0 / (2 tan gamma)) (Klingel 1883) and therefore

  tan(gamma_e) = (pi / I)^2,   I = integral of dy / sqrt(S(end) - S(y)),

in which e and r0 cancel. Between the points of the curve, dr is taken as linear; S and I are then exact.
"""
import math

import numpy as np

NO_CENTRE = "the rolling radius difference has no zero at which it grows with y"
OUT_OF_RANGE = "the wave leaves the computed range of y"
NO_WAVE = "no periodic wave has this amplitude"
SEVERAL_WAVES = "several waves have this amplitude"

CENTRE_TOLERANCE = 1e-14  # [m]
# Largest |dr| per amplitude that counts as none [-]. The conicity is then at most pi² / 16 times as large, below 0.0004: that
# of a constant |dr| which changes its sign in the centre.
LEAST_DIFFERENCE = 5e-4
ROUND_OFF = 1e-9  # of a difference of S, relative to the largest one of the wave
# A point as near to an end of the wave is left out: there S differs from that of the end by rounding only [m].
ROUND_OFF_WIDTH = 1e-12
SMALL_PART = 1e-6  # of a half angle; its tangent and hyperbolic tangent are then equal to it within rounding


def kinematic_wavelength(conicity, base, radius):
    """Wavelength of the kinematic wave of cones (Klingel 1883) [m]; infinite for the conicity 0.

    conicity: tan(gamma) [-]. base: distance of the running circles [m]. radius: rolling radius of the centred wheelset [m].
    """
    return math.inf if conicity == 0 else 2 * math.pi * math.sqrt(base * radius / (2 * conicity))


class RadiusDifference:
    """Rolling radius difference as straight lines between points, with its waves."""

    def __init__(self, curve):
        """curve: (n, 2) lateral displacement y, not decreasing, and radius difference, left minus right [m]; equal y are a
        jump."""
        self._y, self._value = np.reshape(np.asarray(curve, dtype=float), (-1, 2)).T
        width = np.diff(self._y)
        if not np.all(width >= 0):
            raise ValueError("y of the curve decreases")
        # S at the points [m²]
        self._sum = np.concatenate([[0.0], np.cumsum(width * (0.5 * (self._value[:-1] + self._value[1:])))])

    def conicity(self, amplitude):
        """Equivalent conicity for one amplitude of the wave.

        amplitude: half the distance of the turning points [m], > 0
        Returns (tan(gamma_e) [-], middle between the turning points [m], reason): NaN with a reason if there is no result,
        otherwise the reason is "". The conicity is 0 where |dr| <= 0.0005 `amplitude` over the whole width of a wave.
        """
        if not (math.isfinite(amplitude) and amplitude > 0):
            raise ValueError(f"amplitude = {amplitude:g} must be a positive number")
        flat = self._widest_flat(LEAST_DIFFERENCE * amplitude)
        is_flat = flat[1] - flat[0] >= 2 * amplitude
        if not is_flat and not np.any((self._value[:-1] < 0) & (self._value[1:] >= 0)):
            return math.nan, math.nan, NO_CENTRE
        if len(self._y) < 2 or self._y[-1] - self._y[0] < 2 * amplitude:
            return math.nan, math.nan, OUT_OF_RANGE
        centres = self._centres(amplitude)
        imbalances = self._imbalance(centres, amplitude)
        waves = list(self._restored_waves(centres, imbalances, amplitude, flat))
        if is_flat:
            waves.append((0.0, 0.5 * (flat[0] + flat[1]), ""))
        if len(waves) == 1:
            return waves[0]
        # A wave lies partly beyond the range if the imbalance has no change of its sign towards an end.
        is_beyond = imbalances[0] > 0 or imbalances[-1] < 0
        return math.nan, math.nan, SEVERAL_WAVES if waves else OUT_OF_RANGE if is_beyond else NO_WAVE

    def _centres(self, amplitude):
        """Centres of waves of which an end is at a point of the curve, increasing. The imbalance is a parabola between them."""
        first, last = self._y[0] + amplitude, self._y[-1] - amplitude
        found = np.concatenate([self._y - amplitude, self._y + amplitude])
        return np.sort(np.concatenate([[first, last], found[(found > first) & (found < last)]]))

    def _imbalance(self, centre, amplitude):
        """Difference of S at both ends of a wave with this centre [m²]; zero for a wave, negative left of it."""
        return self._integral(centre + amplitude) - self._integral(centre - amplitude)

    def _restored_waves(self, centres, imbalances, amplitude, flat):
        """Waves that the radius difference restores. Those in the flat range are not among them."""
        for i in np.flatnonzero((imbalances[:-1] < 0) & (imbalances[1:] >= 0)):
            centre = _root(lambda place: float(self._imbalance(place, amplitude)), *map(float, centres[i:i + 2]),
                           *map(float, imbalances[i:i + 2]))
            integral = self._over_wave(centre - amplitude, centre + amplitude)
            is_in_flat = flat[0] <= centre - amplitude and centre + amplitude <= flat[1]
            if math.isfinite(integral) and not is_in_flat:
                yield math.pi * math.pi / (integral * integral), centre, ""

    def _segment(self, y):
        """Index of the point after y; that of the last point at the end of the range."""
        return np.searchsorted(self._y[1:-1], y, side="right") + 1

    def _at(self, y):
        """Radius difference at y, which the range contains [m]."""
        i = self._segment(y)
        width, step = self._y[i] - self._y[i - 1], self._value[i] - self._value[i - 1]
        share = np.divide(y - self._y[i - 1], width, out=np.ones_like(width), where=width > 0)
        return np.where(width > 0, self._value[i - 1] + share * step, self._value[i])

    def _integral(self, y):
        """S from the begin of the range to y [m²]."""
        i = self._segment(y)
        return self._sum[i - 1] + (y - self._y[i - 1]) * (0.5 * (self._value[i - 1] + self._at(y)))

    def _widest_flat(self, threshold):
        """Widest range of y over which the radius difference is at most `threshold` [m]."""
        widest = present = (0.0, 0.0)
        for i in np.flatnonzero(np.diff(self._y) > 0):
            begin, end = _flat_part(*map(float, (self._y[i], self._value[i], self._y[i + 1], self._value[i + 1])), threshold)
            if end >= begin:
                present = (present[0] if i > 0 and begin == present[1] else begin, end)
                widest = max(widest, present, key=lambda part: part[1] - part[0])
        return widest

    def _over_wave(self, begin, end):
        """Integral of dy / sqrt(S(end) - S(y)) over a wave [-]; infinite if S(y) reaches S(end) before the end.

        S(begin) and S(end) must be equal.
        """
        inner = np.flatnonzero((self._y > begin + ROUND_OFF_WIDTH) & (self._y < end - ROUND_OFF_WIDTH))
        y = np.concatenate([[begin], self._y[inner], [end]])
        value = np.concatenate([[self._at(begin)], self._value[inner], [self._at(end)]])
        at_end = 0.5 * (self._integral(begin) + self._integral(end))
        energy = np.concatenate([[0.0], at_end - self._sum[inner], [0.0]])  # E = S(end) - S(y)
        width = np.diff(y)
        # Least E between two points: that at the points, or in a zero of dr between them.
        before, after = value[:-1], value[1:]
        dips = (before > 0) & (after < 0)
        fall = np.where(dips, before - after, 1.0)
        least = np.minimum(energy[1:], energy[:-1] - np.where(dips, 0.5 * before * before * width / fall, 0.0))
        if not np.all(least >= -ROUND_OFF * energy.max()):
            return math.inf
        v, wide = np.sqrt(np.maximum(energy, 0.0)), width > 0
        return sum(map(_over_line, width[wide], (after - before)[wide], (v[:-1] + v[1:])[wide]))


def _over_line(width, step, v_sum):
    """Integral of dy / sqrt(E) over a line, with E = v² at both of its ends.

    width: of the line [m]. step: of dr over it [m]. v_sum: sum of v at its ends [m].
    E is a parabola. With k the slope of dr, (dr / sqrt(2 k), v) runs on a circle or, with -k, a hyperbola. The integral is its
    angle over sqrt(k / 2); the tangent of half this angle is that of the chord.
    """
    chord = float(width / v_sum) if v_sum > 0 else math.inf
    slope = float(0.5 * step / width)
    root = math.sqrt(abs(slope))
    part = root * chord
    if not part >= SMALL_PART:
        return 2 * chord
    if slope > 0:
        return 2 / root * math.atan(part)
    return 2 / root * math.atanh(part) if part < 1 else math.inf


def _flat_part(y_a, value_a, y_b, value_b, threshold):
    """Begin and end of the part of a line on which its absolute value is at most `threshold`; end < begin if there is none."""
    if value_a == value_b:
        return (y_a, y_b) if abs(value_a) <= threshold else (y_b, y_a)
    slope = (value_b - value_a) / (y_b - y_a)
    ends = sorted((y_a + (-threshold - value_a) / slope, y_a + (threshold - value_a) / slope))
    return max(y_a, ends[0]), min(y_b, ends[1])


def _root(function, a, b, value_a, value_b):
    """Root of a function between a and b, at which its values have opposite signs [m].

    Illinois form of regula falsi (Dowell & Jarratt 1971). A bisection follows if three steps have not halved the bracket.
    """
    width_before = abs(b - a)
    for i in range(100):
        if not (abs(b - a) > CENTRE_TOLERANCE and value_b != 0):
            break
        is_slow = i % 3 == 2 and abs(b - a) > 0.5 * width_before
        width_before = abs(b - a) if i % 3 == 2 else width_before
        x = 0.5 * (a + b) if is_slow else (a * value_b - b * value_a) / (value_b - value_a)
        value = function(x)
        if (value > 0) != (value_b > 0):
            a, value_a = b, value_b
        else:
            value_a *= 0.5
        is_settled = abs(x - b) < CENTRE_TOLERANCE and not is_slow
        b, value_b = x, value
        if is_settled:
            break
    return b
