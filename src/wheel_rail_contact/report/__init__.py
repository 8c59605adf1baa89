# SPDX-License-Identifier: BSD-3-Clause
"""Report of the results in a bag."""
