# SPDX-License-Identifier: BSD-3-Clause
"""What the numbers in answers stand for, as WheelsetContact.msg and ContactPatch.msg have them."""
SIDES = ("left", "right")
STATUSES = ("OK", "LIFT_OFF", "OFF_PROFILE", "NOT_CONVERGED", "INVALID_INPUT", "NO_TRANSFORM")
USABLE = (STATUSES.index("OK"), STATUSES.index("LIFT_OFF"))
