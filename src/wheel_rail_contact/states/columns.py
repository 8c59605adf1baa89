# SPDX-License-Identifier: BSD-3-Clause
"""Quantities of a table of states, and the columns of a file that contain them."""
import re
from dataclasses import dataclass

from ..command import Failure
from .titles import Title, split_title
from .units import same_unit, unit_of, units_of

# Name in the table -> (field of a State, kind of unit, sign in railway axes: x forward, y right, z down).
COLUMNS = {
    "x": ("x", "length", 1), "y": ("y", "length", -1), "z": ("z", "length", -1),
    "roll": ("roll", "angle", 1), "pitch": ("pitch", "angle", -1), "yaw": ("yaw", "angle", -1),
    "force_z": ("force_z", "force", -1), "torque_x": ("torque_x", "torque", 1),
    # On the rail, outward positive in both systems of axes.
    "Y_left": ("left_lateral_force", "force", 1), "Y_right": ("right_lateral_force", "force", 1),
    # Of the rail: lateral and roll outward positive in both systems of axes.
    "rail_lateral_left": ("left_rail_lateral", "length", 1), "rail_lateral_right": ("right_rail_lateral", "length", 1),
    "rail_vertical_left": ("left_rail_vertical", "length", -1), "rail_vertical_right": ("right_rail_vertical", "length", -1),
    "rail_roll_left": ("left_rail_roll", "angle", 1), "rail_roll_right": ("right_rail_roll", "angle", 1),
    "distance": ("distance", "length", 1),
    "speed": ("speed", "velocity", 1), "lateral_velocity": ("lateral_velocity", "velocity", -1),
    "vertical_velocity": ("vertical_velocity", "velocity", -1), "roll_rate": ("roll_rate", "rate", 1),
    "rotation": ("rotation", "rate", -1), "yaw_rate": ("yaw_rate", "rate", -1),
    **{f"rail_{name}_{side}": (f"{side}_rail_{name}", kind, sign) for name, kind, sign in (
        ("lateral_velocity", "velocity", 1), ("vertical_velocity", "velocity", -1), ("roll_rate", "rate", 1))
       for side in ("left", "right")},
}
VELOCITIES = ("lateral_velocity", "vertical_velocity", "roll_rate", "rotation", "yaw_rate")  # require the speed
WHEEL_LOADS = {"Q_left": "force", "Q_right": "force"}  # down positive in both systems of axes
QUANTITIES = {"time": "time", **{name: kind for name, (_, kind, _) in COLUMNS.items()}, **WHEEL_LOADS}
# phi and psi are roll and yaw as in ISO 8855 and in the glossary.
SYNONYMS = {"t": "time", "s": "distance", "phi": "roll", "φ": "roll", "psi": "yaw", "ψ": "yaw"}
SIDES = {"left": "l", "right": "r"}


def _key(name):
    """Name without case, and with _ in place of blanks, points and hyphens."""
    return re.sub(r"[\s._-]+", "_", name.casefold()).strip("_")


def _spellings():
    """Quantity of each known spelling, as _key() writes it: Q_left, also as Q_l, Qleft and Ql."""
    known = dict(SYNONYMS)
    for name in QUANTITIES:
        known[_key(name)] = name
        stem, _, side = name.rpartition("_")
        if side in SIDES:
            short = f"{stem}_{SIDES[side]}".casefold()
            known[short] = name
            if len(stem) == 1:
                known[short.replace("_", "")] = known[_key(name).replace("_", "")] = name
    return known


SPELLINGS = _spellings()


@dataclass(frozen=True)
class Column:
    """Column of a file with its quantity, and the factor from its unit to SI units."""
    quantity: str
    title: Title
    unit: str
    factor: float

    @property
    def index(self):
        return self.title.index


def _column(quantity, title):
    """@throw Failure if the title has no unit of this quantity"""
    kind = QUANTITIES[quantity]
    unit = unit_of(title.unit)
    units = units_of(kind)
    if unit not in units:
        raise Failure(f"column '{title.shown}': {title.unit} is not a unit of {quantity}; valid units are {', '.join(units)}. "
                      f"--column {quantity}= ignores the column")
    return Column(quantity, title, unit, units[unit])


def _is_other_quantity(quantity, title):
    """True if a name of one letter, in another spelling, has the unit of another quantity: Y [kN] is a force, not y."""
    letter = _key(title.name).split("_")[0]
    unit = unit_of(title.unit)
    return bool(title.unit) and len(letter) == 1 and title.name != quantity \
        and unit not in units_of(QUANTITIES[quantity])


def _named_title(titles, quantity, text):
    """Title of the file that the option --column QUANTITY=TEXT names, with its unit.

    @throw Failure if there is none, or more than one, or if its unit differs from that in the text
    """
    name, unit = split_title(text)
    exact = [title for title in titles if title.text == text]
    found = exact or [title for title in titles if title.name == name.strip()] \
        or [title for title in titles if _key(title.name) == _key(name)]
    option = f"--column {quantity}='{text}'"
    if len(found) > 1 and unit:
        found = [title for title in found if title.unit and same_unit(title.unit, unit)] or found
    if len(found) != 1:
        listed = ", ".join(title.shown for title in found or titles)
        raise Failure(f"{option}: {len(found) or 'no'} columns have this title: {listed}")
    title = found[0]
    if exact or not unit:
        return title
    if title.unit and not same_unit(title.unit, unit):
        raise Failure(f"{option}: the unit in the file is {title.unit}")
    return Title(title.index, title.text, title.name, unit)


def _by_name(titles, taken):
    """Titles of each quantity by their names, without the quantities in `taken`."""
    found = {}
    for title in titles:
        quantity = SPELLINGS.get(_key(title.name))
        if quantity and quantity not in taken and not _is_other_quantity(quantity, title):
            found.setdefault(quantity, []).append(title)
    return found


def columns_of(titles, named):
    """Columns of the quantities that a file contains: quantity -> Column, and the titles of all other columns.

    @param titles list of Title
    @param named  quantity -> title in the file, as given by --column; "" if the file does not contain the quantity
    @throw Failure if a unit is missing or invalid, or if a quantity is given twice
    """
    chosen = {quantity: _named_title(titles, quantity, text) for quantity, text in named.items() if text}
    rest = [title for title in titles if title.index not in {title.index for title in chosen.values()}]
    for quantity, found in _by_name(rest, named).items():
        if len(found) > 1:
            shown = " and ".join(f"'{title.shown}'" for title in found)
            raise Failure(f"column '{quantity}' is given twice, by {shown}; --column {quantity}='TITLE [UNIT]' selects one")
        chosen[quantity] = found[0]
    bare = {quantity: title for quantity, title in chosen.items() if not title.unit}
    if bare:
        raise Failure(f"columns without a unit: {', '.join(title.shown for title in bare.values())}. Give the units in the "
                      f"titles, for example 'y [mm]', or with {_example(bare)}")
    used = {title.index for title in chosen.values()}
    ignored = [title for title in titles if title.index not in used]
    return {quantity: _column(quantity, title) for quantity, title in chosen.items()}, ignored


def _example(bare):
    """Options that give the units of columns."""
    si_unit = {"time": "s", "length": "mm", "angle": "mrad", "force": "kN", "torque": "kN m", "velocity": "m/s",
               "rate": "rad/s"}
    return " ".join(f"--column {quantity}='{title.name} [{si_unit[QUANTITIES[quantity]]}]'" for quantity, title in bare.items())


def check_columns(columns, titles, has_speed):
    """@throw Failure if a required column is missing, or if columns exclude one another"""
    listed = ", ".join(title.shown for title in titles)
    if has_speed and "time" in columns:
        raise Failure(f"--speed is for tables without time, but there is the column '{columns['time'].title.shown}'")
    if has_speed and "distance" not in columns:
        raise Failure(f"--speed requires a column 'distance'; the columns are {listed}")
    if "time" not in columns and not has_speed:
        by_distance = "; --speed V computes the time from the distance [m/s]" if "distance" in columns else ""
        raise Failure(f"column 'time' is missing; the columns are {listed}. --column time='TITLE [s]' names it{by_distance}")
    if "y" not in columns:
        raise Failure(f"column 'y' is missing; the columns are {listed}. --column y='TITLE [mm]' names it")
    if ("Q_left" in columns) != ("Q_right" in columns):
        raise Failure(f"Q_left and Q_right must be given together; the columns are {listed}")
    if "Q_left" in columns and ("force_z" in columns or "torque_x" in columns):
        raise Failure("the load must be given either by force_z and torque_x, or by Q_left and Q_right; "
                      "--column Q_left= --column Q_right= ignores the latter")
    if "torque_x" in columns and "force_z" not in columns:
        raise Failure("torque_x requires force_z")
    if "speed" not in columns and any(name in columns for name in VELOCITIES):
        raise Failure(f"{next(name for name in VELOCITIES if name in columns)} requires speed")
