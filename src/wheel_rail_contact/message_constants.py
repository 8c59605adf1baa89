# SPDX-License-Identifier: BSD-3-Clause
"""Names of the numbers in results, as defined in WheelsetContact.msg and ContactPatch.msg."""
SIDES = ("left", "right")
STATUSES = ("OK", "LIFT_OFF", "OFF_PROFILE", "NOT_CONVERGED", "INVALID_INPUT", "NO_TRANSFORM",
            "OUTSIDE_LINE", "TOO_DEEP")
USABLE = (STATUSES.index("OK"), STATUSES.index("LIFT_OFF"))
