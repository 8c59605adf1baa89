# SPDX-License-Identifier: BSD-3-Clause
"""Animated pictures of bags of answers."""
