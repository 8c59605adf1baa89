# SPDX-License-Identifier: BSD-3-Clause
"""Units of the columns of a table, as the module knows them."""
from ..command import native


def units():
    """Kind -> unit -> value in SI units; the SI unit is the first one."""
    kinds = {}
    for unit in native().table_units:
        kinds.setdefault(unit.kind, {})[unit.name] = unit.value
    return kinds


def unit_of(text):
    """Unit with this spelling: its name, value and kind; None if there is none."""
    return native().unit_named(text) if text else None


def same_unit(one, other):
    """True if two texts are the same unit, which the module need not know."""
    names = [unit.name if unit else text for text, unit in ((one, unit_of(one)), (other, unit_of(other)))]
    return names[0] == names[1]


def names_of(kind):
    """Units of a kind, for a message."""
    return ", ".join(units()[kind])
