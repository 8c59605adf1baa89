# SPDX-License-Identifier: BSD-3-Clause
"""Python access to the numerical core. Its names are those of the package wheel_rail_contact."""
