# SPDX-License-Identifier: BSD-3-Clause
"""Names of the numbers in results: constants of WheelsetContact.msg and ContactPatch.msg."""
from wheel_rail_contact.msg import ContactPatch, WheelsetContact


def _names(message):
    """Names of the constants of a message, by their values."""
    constants = {value: name for name, value in vars(message).items() if name.isupper() and isinstance(value, int)}
    return tuple(constants[value] for value in range(len(constants)))


SIDES = tuple(name.lower() for name in _names(ContactPatch))
STATUSES = _names(WheelsetContact)
USABLE = (WheelsetContact.OK, WheelsetContact.LIFT_OFF)
