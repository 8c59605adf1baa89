# SPDX-License-Identifier: BSD-3-Clause
"""Colours of Okabe and Ito (2008), which colour-blind readers can distinguish."""
BLACK, ORANGE, GREEN, BLUE, RED, PURPLE = "#000000", "#E69F00", "#009E73", "#0072B2", "#D55E00", "#CC79A7"
