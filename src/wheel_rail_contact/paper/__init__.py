# SPDX-License-Identifier: BSD-3-Clause
"""The case of the paper: runs the calculation, prints the values of the paper and ours, and draws the pictures."""
