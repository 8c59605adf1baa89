# SPDX-License-Identifier: BSD-3-Clause
"""The paper's case: runs the calculation, prints its figures beside ours, draws the pictures."""
