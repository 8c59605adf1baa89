# SPDX-License-Identifier: BSD-3-Clause
"""The example of a closed loop, simulate_wheelset: motion, contact in process or of a node, table and pictures of a run."""
