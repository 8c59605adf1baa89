# SPDX-License-Identifier: BSD-3-Clause
"""The closed loop: send pose, velocities and load, receive the contact, advance the motion by one step."""
import time

import numpy as np

from .contact import HeldContact
from .parameters import step_count
from .wheelset import Wheelset

SATURATED_SHARE = 0.99  # of the friction limit, from which a contact counts as saturated


def run_closed_loop(p, contact, add_row=None):
    """Runs the loop and returns its Summary.

    p: see read_parameters(). contact: a way to the contact calculation. add_row: see motion_table(). Raises Failure if the
    contact cannot be reached, has no usable result in too many successive steps, or the motion does not converge.
    """
    summary, wheelset = Summary(p["run"]["speed"]), Wheelset(p, contact.height_given)
    held = HeldContact(contact, p["run"]["held_steps"])
    if contact.height_given:
        wheelset.start(contact)
    for _ in range(step_count(p["run"])):
        begin = time.perf_counter()
        reply = wheelset.advance(held)
        summary.add(wheelset.sent, reply, time.perf_counter() - begin)
        if add_row:
            add_row(wheelset.sent, reply, held.in_a_row > 0)
    summary.held = held.held
    return summary


def is_saturated(patch):
    """Whether the friction of a contact is at its limit."""
    return patch.creep.adhesion_share >= SATURATED_SHARE


def friction_power(reply):
    """Power of the friction in all contacts [W]."""
    return sum(patch.creep.power for patch in reply.patches)


class Summary:
    """What happened in a run at a speed [m/s]."""

    def __init__(self, speed):
        self._speed, self._rows, self._seconds = speed, [], []
        self.saturated = 0  # steps in which the friction of a contact was at its limit
        self.held = 0       # steps with the contact of an earlier one, because there was no usable result

    def add(self, request, reply, seconds):
        """Adds a step: the request at its end, its contact, and its wall time."""
        self._rows.append((request.x, request.y, -reply.rail_wrench.force.x, friction_power(reply)))
        self._seconds.append(seconds)
        self.saturated += any(map(is_saturated, reply.patches))

    def waves(self):
        """Waves of the last third of the run."""
        return Waves(*np.array(self._rows[-(len(self._rows) // 3):]).T)

    def text(self):
        median, most, longest = 1e3 * np.percentile(self._seconds, (50, 95, 100))
        return (f"{len(self._rows)} steps, {self.held} with a held contact, {self.saturated} at the friction limit\n"
                f"last third: {self.waves().text(self._speed)}\n{1 / np.mean(self._seconds):.0f} steps/s; "
                f"step: median {median:.3f} ms, 95 % {most:.3f} ms, longest {longest:.3f} ms")


class Waves:
    """Means over the whole waves, between the first and the last upward zero crossing of y; 0 without one (`count`).

    They are the wavelength [m], the drag, backward positive [N], and the friction_power [W]; largest_y [m] is of all steps.
    """

    def __init__(self, distance, y, drag, power):
        """Arrays of the steps: place along the track [m], lateral displacement [m], drag [N], power of the friction [W]."""
        self.largest_y = np.max(np.abs(y))
        i = np.flatnonzero((y[:-1] < 0) & (y[1:] >= 0))
        places = distance[i] - (distance[i + 1] - distance[i]) * y[i] / (y[i + 1] - y[i])
        self.count = max(len(places) - 1, 0)
        whole = slice(i[0] + 1, i[-1] + 1) if self.count else slice(0)
        self.wavelength, self.drag, self.friction_power = (
            np.mean(values) if self.count else 0.0 for values in (np.diff(places), drag[whole], power[whole]))

    def text(self, speed):
        """All of this in words; speed: running speed [m/s]."""
        waves = "no whole wave"
        if self.count:
            waves = (f"wavelength {self.wavelength:.3f} m, drag {self.drag:.3f} N = {1e-3 * speed * self.drag:.3f} kW, "
                     f"friction {1e-3 * self.friction_power:.3f} kW")
        return f"largest |y| {1e3 * self.largest_y:.3f} mm, {waves}"
