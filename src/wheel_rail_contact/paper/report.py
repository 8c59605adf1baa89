# SPDX-License-Identifier: BSD-3-Clause
"""Results of the study as text."""
CASES = {"without": "without bending", "shifted": "0.2435 mm outward", "turned": "the same, 13 mrad inward",
         "own_rail": "paper's rail, 30 kN, coupled"}
RAILS = {"without": "without bending", "shifted": "0.2435 mm outward", "turned": "the same, 13 mrad inward",
         "paper": "paper's rail", "pads_40_100": "pads 40/100 kN/mm", "pads_10_25": "pads 10/25 kN/mm"}


def text(study):
    """All tables of a Study."""
    return "\n".join([*_cases(study.figures), "", *_methods(study.methods), "", *_stress(study.stresses), "",
                      *_scan(study.scan), "", *_search(study.search)])


def _values(row, prefix=""):
    pressure, area = row[prefix + "max_pressure"], row[prefix + "area"]
    return f"{1e-6 * pressure:5.0f} / {1e6 * area:5.1f}" if pressure else f"{'-':>13}"


def _cases(rows):
    yield "Highest pressure [MPa] / area [mm2] of the wheel on the flange side, y = 0.572 mm, 100 kN on each wheel"
    yield f"{'case':30}{'paper':>15}{'ours':>15}{'ours, roll 0':>15}{'CONTACT, roll 0':>17}"
    for row in rows:
        values = [_values(row, prefix) for prefix in ("printed_", "", "level_", "reference_")]
        yield f"{CASES[row['case']]:30}{values[0]:>15}{values[1]:>15}{values[2]:>15}{values[3]:>17}"


def _methods(rows):
    yield "The same by method, at roll 0. The area is that within its edge; counted: that of all cells with pressure"
    yield f"{'case':30}{'method':20}{'cells':>8}{'cell, mm':>13}{'stop':>8}{'MPa / mm2':>15}{'counted':>9}"
    for row in rows:
        cells = f"{row['cells_along']:.0f}x{row['cells_across']:.0f}"
        size = f"{1e3 * row['cell_along']:.2f} x {1e3 * row['cell_across']:.2f}" if row["area"] else "-"
        counted = f"{1e6 * row['counted_area']:.1f}" if row["area"] else "-"
        yield (f"{CASES[row['case']]:30}{row['method']:20}{cells:>8}{size:>13}{row['stop']:>8g}{_values(row):>15}"
               f"{counted:>9}")


def _stress(stresses):
    yield ("Highest stresses in the rail [MPa], depth of the highest von Mises stress, and of the region above 480 MPa, the "
           "assumed yield stress")
    yield (f"{'rail':26}{'Y, kN':>6}{'MPa / mm2':>15}{'von Mises':>10}{'depth, mm':>10}{'480 MPa, mm':>12}{'shear':>7}{'|xz|':>6}"
           f"{'strains, 1e-3':>15}{'load factor':>12}{'shakedown limit':>16}")
    for row in (one.row() for one in stresses):
        strains = f"{1e3 * row['strain_1']:.2f} / {1e3 * row['strain_3']:.2f}"
        yield (f"{RAILS[row['rail']]:26}{1e-3 * row['lateral_force']:6.0f}{_values(row):>15}{1e-6 * row['von_mises']:10.0f}"
               f"{1e3 * row['von_mises_depth']:10.2f}{1e3 * row['yield_depth']:12.1f}{1e-6 * row['shear']:7.0f}{1e-6 * row['alternating']:6.0f}"
               f"{strains:>15}{row['load_factor']:12.2f}{row['shakedown_limit']:16.2f}")


def _scan(rows):
    yield f"Nearest of {len(rows)} settings. Deviation: the larger one of pressure and area from the values of the paper"
    yield (f"{'scan':34}{'rail':17}{'inclination':>12}{'y, mm':>8}{'shift, mm':>10}{'turn, mrad':>11}{'without':>15}"
           f"{'with':>15}{'deviation, %':>14}")
    for title, part, key, chosen in _SEARCHES:
        for rail in dict.fromkeys(row["rail"] for row in rows):
            found = [row for row in rows if row["part"] == part and row["rail"] == rail and chosen(row)]
            if found:
                yield _nearest(title, min(found, key=lambda row: row[key]), key)


def _nearest(title, row, key):
    first, second = (_values(row), "") if key == "deviation_without" else (_values(row, "without_"), _values(row))
    return (f"{title:34}{row['rail']:17}{row['inclination']:12.5f}{1e3 * row['y']:8.2f}{1e3 * row['crown_lateral']:10.4f}"
            f"{1e3 * row['rail_turn']:11.2f}{first:>15}{second:>15}{100 * row[key]:14.1f}")


def _search(rows):
    yield "Values with bending on rails under a lateral force, y = 2 to 8 mm: nearest setting for each table"
    yield f"{'rail':17}{'y, mm':>8}{'Y, kN':>8}{'shift, mm':>10}{'turn, mrad':>11}{'MPa / mm2':>15}{'deviation, %':>14}"
    for table in dict.fromkeys(row["table"] for row in rows):
        row = min((row for row in rows if row["table"] == table), key=lambda row: row["deviation_with"])
        yield (f"{table:17}{1e3 * row['y']:8.2f}{1e-3 * row['lateral_force']:8.0f}{1e3 * row['rail_lateral']:10.3f}"
               f"{1e3 * row['rail_roll']:11.2f}{_values(row):>15}{100 * row['deviation_with']:14.1f}")


def _any(_):
    return True


def _within_printed(row):
    return abs(row["crown_lateral"]) <= 0.25e-3


_SEARCHES = (
    ("without bending, 100 kN", "start", "deviation_without", lambda row: row["load"] > 75e3),
    ("without bending, 50 kN", "start", "deviation_without", lambda row: row["load"] < 75e3),
    ("shift only, up to 0.25 mm", "shift", "deviation_pair", _within_printed),
    ("shift only, up to 5 mm", "shift", "deviation_pair", _any),
    ("wheelset rolled up to 1 mrad", "roll", "deviation_pair", _any),
    ("other rail displaced", "rails", "deviation_pair", _any),
    ("shift, and turn inward", "pair", "deviation_pair", lambda row: row["rail_turn"] < 0),
    ("shift, and turn outward", "pair", "deviation_pair", lambda row: row["rail_turn"] > 0),
    ("any inclination, no turn", "inclination", "deviation_pair", lambda row: abs(row["rail_turn"]) < 1e-9),
    ("any inclination, 0 to 2 mrad out", "inclination", "deviation_pair", lambda row: 0 <= row["rail_turn"] < 2.1e-3),
    ("any inclination, turn inward", "inclination", "deviation_pair", lambda row: row["rail_turn"] < 0),
    ("any inclination, turn outward", "inclination", "deviation_pair", lambda row: row["rail_turn"] > 0),
    ("with bending only", "alone", "deviation_with", _any),
)
