# SPDX-License-Identifier: BSD-3-Clause
"""Finite-element analysis of a rail: section outline -> compliance of the rail head under a wheel. SI units, radians.

Axes: x along the rail with the load at x = 0, y outward (field side), z up from the underside of the foot. Roll is positive
when the crown moves outward.
"""
