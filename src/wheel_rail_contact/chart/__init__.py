# SPDX-License-Identifier: BSD-3-Clause
"""Chart of error against time: runs contact_chart_runner, reads its table, writes the table and the pictures."""
