# SPDX-License-Identifier: BSD-3-Clause
"""Parts of the example of a closed loop: parameters and contact in Python, and pictures of a run."""
