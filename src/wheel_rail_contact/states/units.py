# SPDX-License-Identifier: BSD-3-Clause
"""Units of the columns of a table, and their spellings."""
import math
import unicodedata

# Kind -> unit -> value in SI units; the SI unit is the first one. Inch, foot and pound are those of 1959: 1 in = 25.4 mm,
# 1 lb = 0.45359237 kg; the pound-force has the standard gravity of 9.80665 m/s^2, and a kip is 1000 lbf.
POUND_FORCE = 0.45359237 * 9.80665
UNITS = {
    "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0},
    "length": {"m": 1.0, "mm": 1e-3, "um": 1e-6, "cm": 1e-2, "km": 1e3, "in": 0.0254, "ft": 0.3048},
    "angle": {"rad": 1.0, "mrad": 1e-3, "deg": math.pi / 180},
    "force": {"N": 1.0, "kN": 1e3, "lbf": POUND_FORCE, "kip": 1e3 * POUND_FORCE},
    "torque": {"N m": 1.0, "kN m": 1e3, "lbf ft": 0.3048 * POUND_FORCE},
    "velocity": {"m/s": 1.0, "mm/s": 1e-3, "km/h": 1 / 3.6},
    "rate": {"rad/s": 1.0, "mrad/s": 1e-3, "deg/s": math.pi / 180},
}
OTHER_SPELLINGS = {
    "sec": "s", "inch": "in", "inches": "in", "feet": "ft", "°": "deg", "degree": "deg", "degrees": "deg", "kips": "kip",
    "nm": "N m", "knm": "kN m", "ft lbf": "lbf ft",
}
KINDS = {unit: kind for kind, units in UNITS.items() for unit in units}
SPELLINGS = {**{unit.lower(): unit for unit in KINDS}, **OTHER_SPELLINGS}


def unit_of(text):
    """Unit with this spelling, or None. Case, blanks, and the signs of multiplication . * · and - do not matter."""
    plain = unicodedata.normalize("NFKC", text.replace("\u00ba", "°")).replace("μ", "u").lower()
    for sign in ".*·⋅-":
        plain = plain.replace(sign, " ")
    return SPELLINGS.get(" ".join(plain.split()))


def names_of(kind):
    """Units of a kind, for a message."""
    return ", ".join(UNITS[kind])
