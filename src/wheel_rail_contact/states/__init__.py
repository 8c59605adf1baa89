# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of wheelset states between tables of other programs and bags."""
