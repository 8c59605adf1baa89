# SPDX-License-Identifier: BSD-3-Clause
"""Animated pictures of the results in bags."""
