# SPDX-License-Identifier: BSD-3-Clause
"""The one exception a user sees as a sentence instead of a traceback."""


class ChartError(Exception):
    """A place that cannot be written to, or a program that is missing or failed; the message says which."""
