# SPDX-License-Identifier: BSD-3-Clause
"""Chart of error against time: measures the methods, writes the table and the pictures."""
