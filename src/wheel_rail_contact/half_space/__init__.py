# SPDX-License-Identifier: BSD-3-Clause
"""Model error of elastic half-spaces: contacts of a wheel and a rail by finite elements and by half-spaces. SI units, radians.

Side axes of the left rail: x along the track, y outward (field side), z up from the top of the rails. All models are the half
x >= 0; the other half is symmetric.
"""
