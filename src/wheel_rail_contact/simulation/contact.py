# SPDX-License-Identifier: BSD-3-Clause
"""The contact calculation in this process. As all ways to it, evaluate() takes a Request; results have the names of the module."""
import wheel_rail_contact

from ..command import Failure, shipped
from .wheelset import VELOCITIES, Request

CONFIG = "config/simulate_contact.yaml"
SOLVED = "[z, roll]"  # of wheelset/free: the contact calculation finds height and roll
# Parameters that the load and the motion of the example are written for: name, default, permitted values, reason.
RULES = (("wheelset/balance", "wheel_loads", ("moments",), "the load of this program is for it"),
         ("creep/method", "none", ("linear", "fastsim", "exact"), "this program has no friction of its own"),
         ("creep/rotation", "free", ("free",), "this program does not integrate the rotation"),
         ("wheelset/free", SOLVED, (SOLVED, "[]"), "this program integrates both or none"),
         ("track/displacement", "none", ("none",), "this program does not move the rails"),
         ("rail_bending/neighbours", "[]", ("[]",), "this program has one wheelset"))


def require_suitable(value_of, prefix=""):
    """Raises Failure unless value_of(name, default) of all RULES is permitted; prefix: of the names in the message."""
    for name, default, permitted, reason in RULES:
        value = value_of(name, default)
        if value not in permitted:
            expected = ", ".join(permitted[:-1]) + " or " * (len(permitted) > 1) + permitted[-1]
            raise Failure(f"{prefix}{name} = {value} must be {expected}: {reason}")


class InProcessContact:
    """The numerical core in this process."""

    def __init__(self, sources):
        """sources: parameters of WheelsetContact. Raises Failure for those that are refused."""
        try:
            self.contact = wheel_rail_contact.WheelsetContact(sources)
        except (ImportError, ValueError) as error:
            raise Failure(error) from error
        self._sources = sources
        self.height_given = self.contact.config["wheelset/free"] != SOLVED

    def evaluate(self, request):
        return _evaluate(self.contact, request)

    def static_start(self, request):
        """Result of a wheelset at rest under the load of the request."""
        return _evaluate(wheel_rail_contact.WheelsetContact([*self._sources, {"wheelset": {"free": ["z", "roll"]}}]), request)


def _evaluate(contact, request):
    values = request._asdict()
    twist = {name: values.pop(name) for name in ("speed", *VELOCITIES)}
    del values["time"]
    return contact.evaluate(**values, twist=twist)


def open_contact(path=None):
    """InProcessContact with the parameters of a YAML file, over config/default.yaml and config/simulate_contact.yaml.

    Raises Failure for parameters that are refused, or that expect another load or another state than the example sends.
    """
    way = InProcessContact([shipped(CONFIG), *([path] if path else [])])
    contact = way.contact
    require_suitable(contact.config.get)
    if contact.has_design:
        raise Failure(f"track/line = {contact.config['track/line']}: this program has no forces of curvature, cant or gradient")
    try:
        way.evaluate(Request(speed=1.0))  # raises an error if others are required
    except TypeError as error:
        raise Failure(f"{path}: this program has only x, pose, twist and load: {error}") from error
    contact.reset()
    return way


class HeldContact:
    """Contact of each step, or the last usable one while there is none: without forces the wheelset would fall unnoticed."""

    def __init__(self, contact, most):
        """most: largest number of successive steps with the last usable contact"""
        self._contact, self._most, self._last = contact, most, None
        self.held = 0      # number of steps with a held contact
        self.in_a_row = 0  # of these the last successive ones

    def evaluate(self, request):
        """Contact for the first request of a step. Raises Failure if it and `most` before it, or the first one, are not usable."""
        reply = self._contact.evaluate(request)
        if reply.usable:
            self._last, self.in_a_row = reply, 0
            return reply
        self.in_a_row += 1
        if self._last is None or self.in_a_row > self._most:
            reason = f": {reply.status_text}" if reply.status_text else ""
            raise Failure(f"no usable contact in {self.in_a_row} successive steps, at {1e-9 * request.time:.6f} s, "
                          f"y = {1e3 * request.y:.6f} mm: {reply.status}{reason}")
        self.held += 1
        return self._last

    def evaluate_again(self, request):
        """Contact for a further request of this step; the last usable one if it has none."""
        reply = None if self.in_a_row else self._contact.evaluate(request)
        if reply and reply.usable:
            self._last = reply
        return self._last
