# SPDX-License-Identifier: BSD-3-Clause
"""Tables of the study (CSV, SI units), and what is read of them."""
import csv
from dataclasses import dataclass

import numpy as np

from ..csv_table import CsvTable
from .half_space import influence

MODELS = ("planar", "curved", "turned")
SOLUTIONS = (*MODELS, "elements", "held")
LEAST_SHARE = 0.05  # of the largest force of a place, below which a second contact is not compared [-]


@dataclass
class Comparison:
    """One contact at one load.

    errors          model -> relative errors of the maximum pressure and of the area, against the elements
    package         name of the model that the package uses
    stated          model error that the package states [-]
    lateral_shift   displacement of the wheel at which the elements have the lateral force of the turned model [m]
    """
    place: str
    kept_out: bool
    load: float
    contact: int
    ratio: float
    package: str
    stated: float
    force: float
    max_pressure: float
    area: float
    errors: dict
    lateral_shift: float

    def error(self, model):
        """The larger absolute error of a model [-]."""
        return max(abs(value) for value in self.errors[model])


def comparisons(results):
    """Comparisons of all places."""
    rows = []
    for result in results:
        for case in result.cases:
            largest = max(one.force for one in case.models["elements"])
            rows += [_comparison(result.place, case, k) for k, one in enumerate(case.models["elements"])
                     if one.force > LEAST_SHARE * largest]
    return rows


def _comparison(place, case, contact):
    true = case.models["elements"][contact]
    errors = {}
    for name in (*MODELS, "held"):
        own = case.models[name][contact]
        errors[name] = (own.max_pressure / true.max_pressure - 1, own.area / true.area - 1)
    return Comparison(place.name, place.kept_out, case.load, contact, case.ratios[contact],
                      "turned" if case.turned[contact] else "curved", case.stated[contact], true.force, true.max_pressure,
                      true.area, errors, case.shift)


def write_comparisons(path, rows):
    """Writes the table of read_comparisons()."""
    names = (*MODELS, "held")
    with open(path, "w", newline="", encoding="ascii") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(["place", "kept_out", "load", "contact", "half_space_ratio", "package_model", "model_error",
                         "normal_force", "max_pressure", "area", "lateral_shift"]
                        + [f"{name}_error_{measure}" for name in names for measure in ("max_pressure", "area")])
        for row in rows:
            writer.writerow([row.place, int(row.kept_out), f"{row.load:g}", row.contact, f"{row.ratio:.5g}", row.package]
                            + [f"{value:.6g}" for value in (row.stated, row.force, row.max_pressure, row.area, row.lateral_shift)]
                            + [f"{value:.3e}" for name in names for value in row.errors[name]])


def read_comparisons(path):
    """Comparisons of a table."""
    rows = []
    for row in CsvTable(path, texts=("place", "package_model")).rows():
        errors = {name: (row[f"{name}_error_max_pressure"], row[f"{name}_error_area"]) for name in (*MODELS, "held")}
        rows.append(Comparison(row["place"], bool(row["kept_out"]), row["load"], int(row["contact"]),
                               row["half_space_ratio"], row["package_model"], row["model_error"], row["normal_force"],
                               row["max_pressure"], row["area"], errors, row["lateral_shift"]))
    return rows


def write_sections(path, results):
    """Pressures of all solutions in the row of cells beside the plane x = 0, over the arc of the rail."""
    with open(path, "w", newline="", encoding="ascii") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(["place", "load", "contact", "arc", *SOLUTIONS])
        for result in results:
            for case in result.cases:
                for k, cells in enumerate(result.gaps.cells):
                    columns = [case.models[name][k].pressure[0] for name in SOLUTIONS]
                    for arc, *values in zip(cells.arc, *columns):
                        writer.writerow([result.place.name, f"{case.load:g}", k, f"{arc:.6g}"]
                                        + [f"{value:.5g}" for value in values])


def write_influences(path, results):
    """Normal displacement of one contact by a force of 1 N on another (on itself: at half its width), at their middles, by
    half-spaces and by elements [m/N]. Both surfaces."""
    with open(path, "w", newline="", encoding="ascii") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(["place", "contact", "other", "distance", "half_space", "elements"])
        for result in results:
            for one, other, *values in _influences(result):
                writer.writerow([result.place.name, one, other] + [f"{value:.4g}" for value in values])


def _influences(result):
    cells = result.gaps.cells
    plane = influence(cells, result.gaps.modulus, turned=True)
    areas = np.concatenate([np.full(one.rows * one.columns, one.dx * one.dy) for one in cells])
    plane *= 0.5 / areas  # per force on both halves
    real = plane + 0.5 * sum(one.on(cells) for one in result.corrections)
    starts = np.cumsum([0] + [one.rows * one.columns for one in cells])
    middles = [start + one.rows * (one.columns // 2) for start, one in zip(starts, cells)]
    for k, here in enumerate(middles):
        for m, there in enumerate(middles):
            if k < m:
                distance = float(np.hypot(*(cells[k].place[cells[k].columns // 2] - cells[m].place[cells[m].columns // 2])))
                yield k, m, distance, plane[here, there], real[here, there]
