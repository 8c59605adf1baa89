# SPDX-License-Identifier: BSD-3-Clause
"""Checks of a simulation's wheel-rail contact against bounds."""
