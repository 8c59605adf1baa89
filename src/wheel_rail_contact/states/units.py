# SPDX-License-Identifier: BSD-3-Clause
"""Units of the columns of a table, as the module knows them."""
from ..command import native


def units_of(kind):
    """Units of a kind, with their values in SI units; the SI unit is the first one."""
    return native().table_units[kind]


def unit_of(text):
    """Usual name of the unit with this spelling; empty if there is none."""
    return native().unit_named(text or "")


def same_unit(one, other):
    """True if two texts are the same unit, which the module need not know."""
    return (unit_of(one) or one) == (unit_of(other) or other)
