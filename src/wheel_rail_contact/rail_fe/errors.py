# SPDX-License-Identifier: BSD-3-Clause
"""The one exception a user sees as a sentence instead of a traceback."""


class RailError(Exception):
    """Wrong input, a missing program or a failed solution; the message says what to do."""
