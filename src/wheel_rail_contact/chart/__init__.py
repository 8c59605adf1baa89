# SPDX-License-Identifier: BSD-3-Clause
"""The chart of error against time: runs contact_chart_runner, reads its rows, writes table and pictures."""
