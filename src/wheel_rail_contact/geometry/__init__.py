# SPDX-License-Identifier: BSD-3-Clause
"""Contact geometry of a wheelset on a track: runs the calculation, prints the conicity and draws the picture."""
