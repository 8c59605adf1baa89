# SPDX-License-Identifier: BSD-3-Clause
"""Report of what happened in a bag of answers."""
