# SPDX-License-Identifier: BSD-3-Clause
"""contact_campaign: divides bags into slices, evaluates them with many workers, and joins the results."""
