# SPDX-License-Identifier: BSD-3-Clause
"""States of a wheelset as tables of other programs and as bags."""
