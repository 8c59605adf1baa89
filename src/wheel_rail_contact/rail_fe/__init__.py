# SPDX-License-Identifier: BSD-3-Clause
"""Offline finite elements of a rail: section outline -> compliance of the head under a wheel. SI units, radians.

Axes: x along the rail with the load at x = 0, y outward (field side), z up from the foot's underside. Roll is positive
when the crown moves outward.
"""
