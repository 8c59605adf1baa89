# SPDX-License-Identifier: BSD-3-Clause
"""Check of profile files: check_profile."""
