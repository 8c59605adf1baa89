# SPDX-License-Identifier: BSD-3-Clause
"""Example of a track with irregularities: tables of a line, and states of a wheelset that runs over it."""
