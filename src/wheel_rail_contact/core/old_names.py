# SPDX-License-Identifier: BSD-3-Clause
"""Earlier names of the numbers of a result. They warn, and will be removed in the next version."""
import operator
import types
import warnings

# (class, earlier name): name as in the messages, and the earlier value where it is not that attribute
NAMES = {
    ("WheelsetResult", "reason"): ("status_text",),
    ("WheelsetResult", "x"): ("wheelset.position.x",),
    ("WheelsetResult", "y"): ("wheelset.position.y",),
    ("WheelsetResult", "z"): ("wheelset.position.z",),
    ("WheelsetResult", "yaw"): ("wheelset.yaw",),
    ("WheelsetResult", "roll"): ("wheelset.roll",),
    ("ManyResults", "reason"): ("status_text",),
    ("Wrench", "moment"): ("torque",),
    ("RailDeflection", "deflection"): ("lateral, vertical, roll", lambda rail: rail),
    ("RailDeflection", "given"): ("given_lateral, given_vertical, given_roll", lambda rail: types.SimpleNamespace(
        lateral=rail.given_lateral, vertical=rail.given_vertical, roll=rail.given_roll)),
    ("Pose", "x"): ("position.x, which is not counted from the axle centre", lambda pose: pose.position.x - pose._axle_x),
    ("Pose", "y"): ("position.y",),
    ("Pose", "z"): ("position.z",),
    ("Pose", "angle"): ("roll",),
}


def add_to(module):
    """Adds the earlier names to the classes of the module."""
    for (class_name, old), names in NAMES.items():
        setattr(getattr(module, class_name), old, _property(f"{class_name}.{old}", *names))


def _property(old, new, value=None):
    value = value or operator.attrgetter(new)

    def get(owner):
        warnings.warn(f"{old} is now {new}", DeprecationWarning, stacklevel=2)
        return value(owner)

    return property(get)
