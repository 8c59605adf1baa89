# SPDX-License-Identifier: BSD-3-Clause
"""Half-space solutions of one place, as half_space_study_runner writes them."""
import subprocess
from dataclasses import dataclass

import numpy as np

from ..command import Failure
from ..csv_table import CsvTable


@dataclass
class Cells:
    """Cells of one contact on the surface of the rail, x > 0: rows along the track, columns across it.

    dx, dy       length and width of a cell [m]
    rail, wheel  parameters of both profiles at the middle of each column [m]
    place        y and z of the rail there (columns, 2) [m]
    angle        of the tangent of the rail about x (columns) [rad]
    opposite     y and z of the wheel on the normal there (columns, 2) [m]
    """
    rows: int
    columns: int
    dx: float
    dy: float
    rail: np.ndarray
    wheel: np.ndarray
    place: np.ndarray
    angle: np.ndarray
    opposite: np.ndarray

    @property
    def arc(self):
        """Arc of the rail from the middle of the cells to that of each column [m]."""
        return (np.arange(self.columns) - 0.5 * (self.columns - 1)) * self.dy

    @property
    def x(self):
        """x of the middle of each row [m]."""
        return (np.arange(self.rows) + 0.5) * self.dx


@dataclass
class LoadCase:
    """Gaps at one load. Lists have an entry for each contact; arrays are (rows, columns), or (columns).

    gaps      along the normals of the rail, at the height of the half-space solution [m]
    planar    over the tangent plane [m]
    up        opening of the gap per displacement of the wheel up [-]
    outward   the same, outward [-]
    planar_up opening of the planar gap per displacement of the wheel up, a number for each contact [-]
    ratios    half_space_ratio of each contact [-]
    turned    whether the package projects the displacements of each contact onto turned normals
    stated    model error of each contact that the package states [-]
    """
    load: float
    gaps: list
    planar: list
    up: list
    outward: list
    planar_up: list
    ratios: list
    turned: list
    stated: list


@dataclass
class PlaceTables:
    """Everything of one place."""
    modulus: float
    young: float
    poisson: float
    axle_z: float
    outlines: dict
    cells: list
    cases: list


def compute(program, folder, config, y, loads, counts):
    """Runs the program and reads its tables; raises Failure if it fails.

    @param y       lateral position of the wheelset [m]
    @param loads   vertical loads of the wheel [N]
    @param counts  rows and columns of the cells of each contact
    """
    run = subprocess.run([program, folder, config, repr(y), *map(str, counts), *map(repr, loads)], text=True,
                         stderr=subprocess.PIPE, check=False)
    if run.returncode != 0:
        raise Failure(run.stderr.strip() or f"{program} failed with exit status {run.returncode}")
    return read(folder)


def read(folder):
    """Tables in a folder (pathlib.Path)."""
    values = CsvTable(folder / "values.csv").rows()[0]
    outline = CsvTable(folder / "outlines.csv", texts=("body",))
    body = np.array(outline["body"])
    outlines = {name: np.column_stack([outline[key][body == name] for key in ("u", "y", "z")])
                for name in ("rail", "wheel")}
    cells = _cells(CsvTable(folder / "cells.csv"), CsvTable(folder / "columns.csv"))
    return PlaceTables(outlines=outlines, cells=cells, cases=_cases(folder, cells), **values)


def _cells(table, columns):
    cells = []
    for row in table.rows():
        here = columns["grid"] == row["grid"]
        cells.append(Cells(int(row["rows"]), int(row["columns"]), row["dx"], row["dy"], columns["rail_u"][here],
                           columns["wheel_u"][here], np.column_stack([columns["y"], columns["z"]])[here],
                           columns["angle"][here], np.column_stack([columns["wheel_y"], columns["wheel_z"]])[here]))
    return cells


def _cases(folder, cells):
    gaps, openings = CsvTable(folder / "gaps.csv"), CsvTable(folder / "openings.csv")
    contacts = CsvTable(folder / "contacts.csv")
    cases = []
    for load in np.unique(gaps["load"]):
        case = LoadCase(load, [], [], [], [], [], [], [], [])
        for k, cell in enumerate(cells):
            here = (gaps["load"] == load) & (gaps["grid"] == k)
            shape = (cell.columns, cell.rows)
            case.gaps.append(gaps["gap"][here].reshape(shape).T)
            case.planar.append(gaps["planar_gap"][here].reshape(shape).T)
            here = (openings["load"] == load) & (openings["grid"] == k)
            case.up.append(openings["per_up"][here])
            case.outward.append(openings["per_outward"][here])
            case.planar_up.append(openings["planar_per_up"][here][0])
            here = (contacts["load"] == load) & (contacts["grid"] == k)
            case.ratios.append(contacts["half_space_ratio"][here][0])
            case.turned.append(bool(contacts["turned"][here][0]))
            case.stated.append(contacts["model_error"][here][0])
        cases.append(case)
    return cases
