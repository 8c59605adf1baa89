# SPDX-License-Identifier: BSD-3-Clause
"""Low-pass of a force over time and its sliding mean over the way: causal, at any rate, also with uneven stamps."""
import math
from collections import deque

DAMPING = (math.cos(math.pi / 8), math.cos(3 * math.pi / 8))  # of both sections of the Butterworth filter of fourth order [-]
LONGEST_STEP = 1 / 4  # [periods of the cut-off frequency] with a longer step, the filter does not follow
SETTLING = 2          # [periods of the cut-off frequency] after which exp(-2 pi 2 cos(3 pi/8)) < 1 % of a wrong start remains
ROUNDING = 1e-9       # [-] of the length of a mean, by which a sum of steps may miss it


class LowPass:
    """Butterworth filter of fourth order: -3 dB at the cut-off frequency, then -24 dB per octave.

    Each section y'' + 2 d y' + y = u is integrated over each step by the trapezoidal rule in a time of its own, in which a step
    of h has the length 2 tan(pi f h). With equal steps this is the bilinear transform with the exact gain 1/sqrt(2) at the
    cut-off frequency f (A. V. Oppenheim, R. W. Schafer, Discrete-Time Signal Processing, section 7.1.2).
    """

    def __init__(self, frequency, value):
        """@param frequency of the cut-off [Hz]
        @param value first value: the filter starts at rest at it"""
        self.frequency, self.input = frequency, value
        self.sections = [[value, 0.0] for _ in DAMPING]

    def step(self, duration, value):
        """The filtered value after a step [s] to the next value."""
        t = math.tan(math.pi * self.frequency * duration)
        before, now = self.input, value
        self.input = value
        for section, damping in zip(self.sections, DAMPING):
            y, rate = section
            change = (2 * rate + t * (before + now - 2 * y)) / (1 + 2 * damping * t + t * t)
            before, now = y, y + t * change
            section[:] = now, change - rate
        return now


class SlidingMean:
    """Mean over the last length of way, of values between which a straight line is drawn."""

    def __init__(self, length):
        """@param length of the way [m]"""
        self.length = length
        self.points = deque()  # way, value, integral of the values up to there

    def step(self, way, value):
        """The mean after a step of way [m] to the next value; NaN before the whole length is travelled."""
        points = self.points
        if points:
            end, last, integral = points[-1]
            points.append((end + way, value, integral + way * (last + value) / 2))
        else:
            points.append((0.0, value, 0.0))
        begin = points[-1][0] - self.length
        if points[0][0] > begin + ROUNDING * self.length:
            return math.nan
        while points[1][0] <= begin:
            points.popleft()
        (start, first, integral), (end, second, _) = points[0], points[1]
        inside = begin - start
        at_begin = first + (second - first) * inside / (end - start)
        return (points[-1][2] - integral - inside * (first + at_begin) / 2) / self.length
