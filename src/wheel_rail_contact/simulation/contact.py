# SPDX-License-Identifier: BSD-3-Clause
"""The contact calculation in this process, and what all ways to it have in common.

A way has one function: evaluate(request) takes a Request and returns a result with the names of the Python module.
"""
import wheel_rail_contact

from ..command import Failure, shipped

CONFIG = "config/simulate_contact.yaml"
# Parameters of the contact that the load and the motion of the example are written for.
RULES = (("wheelset/balance", ("moments",), "the load of this program is for it"),
         ("creep/method", ("linear", "fastsim", "exact"), "this program has no friction of its own"),
         ("creep/rotation", ("free",), "this program does not integrate the rotation"),
         ("wheelset/free", ("[z, roll]",), "this program does not integrate height and roll"),
         ("track/displacement", ("none",), "this program does not move the rails"),
         ("rail_bending/neighbours", ("[]",), "this program has one wheelset"))


def require_suitable(value_of, prefix=""):
    """Raises Failure if the contact expects another load or another state than the example sends.

    value_of: gives the text of a parameter by its name. prefix: of the names in the message.
    """
    for name, permitted, reason in RULES:
        if value_of(name) not in permitted:
            expected = " or ".join(filter(None, (", ".join(permitted[:-1]), permitted[-1])))
            raise Failure(f"{prefix}{name} = {value_of(name)} must be {expected}: {reason}")


class InProcessContact:
    """The numerical core in this process."""

    def __init__(self, contact):
        """contact: a WheelsetContact; see open_contact()"""
        self.contact = contact

    def evaluate(self, request):
        return self.contact.evaluate(
            x=request.x, y=request.y, yaw=request.yaw, force_z=request.force_z, torque_x=request.torque_x,
            twist={"speed": request.speed, "lateral_velocity": request.lateral_velocity, "yaw_rate": request.yaw_rate})


def open_contact(path=None):
    """InProcessContact with the parameters of a YAML file, over config/default.yaml and config/simulate_contact.yaml.

    Raises Failure for parameters that are refused, or that expect another load or another state than the example sends.
    """
    try:
        contact = wheel_rail_contact.WheelsetContact([shipped(CONFIG), *([path] if path else [])])
    except (ImportError, ValueError) as error:
        raise Failure(error) from error
    require_suitable(lambda name: contact.config[name])
    try:
        contact.evaluate(force_z=0.0, twist={"speed": 1.0})  # raises an error if others are required
    except TypeError as error:
        raise Failure(f"{path}: this program has only x, y, yaw, twist and load: {error}") from error
    contact.reset()
    return InProcessContact(contact)


class HeldContact:
    """Contact of each step, or the last usable one while there is none.

    Without forces the wheelset would fall and drift as after a lift-off, and nothing would show it.
    """

    def __init__(self, contact, most):
        """most: largest number of successive steps with the last usable contact"""
        self._contact, self._most, self._last = contact, most, None
        self.held = 0      # number of steps with a held contact
        self.in_a_row = 0  # of these the last successive ones

    def evaluate(self, request):
        """Contact for the first request of a step.

        Raises Failure if more than `most` successive steps, or the first one, have no usable result.
        """
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
