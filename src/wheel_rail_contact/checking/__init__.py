# SPDX-License-Identifier: BSD-3-Clause
"""Compares the wheel-rail contact of a simulation with bounds."""
