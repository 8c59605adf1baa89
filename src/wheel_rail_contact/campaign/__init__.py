# SPDX-License-Identifier: BSD-3-Clause
"""contact_campaign: bags answered by many workers, in slices, and joined."""
