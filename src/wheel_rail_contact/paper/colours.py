# SPDX-License-Identifier: BSD-3-Clause
"""Okabe and Ito's colours (2008): told apart by colour-blind eyes."""
BLACK, ORANGE, GREEN, BLUE, RED, PURPLE = "#000000", "#E69F00", "#009E73", "#0072B2", "#D55E00", "#CC79A7"
