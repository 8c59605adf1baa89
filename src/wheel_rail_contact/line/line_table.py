# SPDX-License-Identifier: BSD-3-Clause
"""Table of a line, as contact_node reads it: columns of EN 13848-1 in REP-103 axes (y left, z up)."""
import csv

import numpy as np

from ..command import Failure

RAILS = ("gauge", "alignment_left", "alignment_right", "level_left", "level_right", "cross_level")
TRACK = ("gauge", "alignment", "level", "cross_level")
COLUMNS = {"rails": RAILS, "track": TRACK}
MM = 1e3  # per metre


def with_rails(track, gauge):
    """Adds alignment and level of both rails to those of the track centre.

    @param track name -> values [m]; names: TRACK
    @param gauge nominal gauge [m]
    @return name -> values [m]; names: TRACK and RAILS
    """
    outward, up = 0.5 * (track["gauge"] - gauge), 0.5 * track["cross_level"]  # of the left rail
    return {**track,
            "alignment_left": track["alignment"] + outward, "alignment_right": track["alignment"] - outward,
            "level_left": track["level"] + up, "level_right": track["level"] - up}


def write_line(path, title, x, values, columns):
    """Writes a new file.

    @param title comment in the first line
    @param x along the line [m]
    @param values name -> values [m]
    """
    with open(path, "x", encoding="utf-8", newline="") as file:
        file.write(f"# {title}\n")
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["x [m]", *(f"{name} [mm]" for name in columns)])
        for place, *row in zip(x, *(MM * values[name] for name in columns)):
            table.writerow([f"{place:.10g}", *(f"{value:.4f}" for value in row)])


def read_centre(path):
    """x of the stations of such a table, and alignment of the track centre and cross level there [m]."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if line.strip() and not line.startswith("#")))
    columns = dict(zip(rows[0], zip(*rows[1:]))) if len(rows) > 2 else {}
    design = [name for name in columns if name.lower().startswith(("curvature", "cant", "superelevation", "gradient"))]
    if design:
        raise Failure(f"{path}: has a column '{design[0]}', but this command has no loads of curves (doc/curves.md)")
    sides = ("alignment [mm]",) if "alignment [mm]" in columns else ("alignment_left [mm]", "alignment_right [mm]")
    try:
        return (np.array(columns["x [m]"], float),
                sum(np.array(columns[side], float) for side in sides) / len(sides) / MM,
                np.array(columns["cross_level [mm]"], float) / MM)
    except (KeyError, ValueError) as error:
        raise Failure(f"{path}: not a table of make_irregular_line ({error})") from None
