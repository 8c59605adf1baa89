# SPDX-License-Identifier: BSD-3-Clause
"""The study: its calculations, in the order of the report, and their tables."""
import csv
from dataclasses import dataclass, field

from ..command import writing
from . import methods, placement
from .case import POSITION, steps
from .forces import Rail
from .scan import Scan
from .stress import RailStress, under_forces

# Rails of the package: first that of the paper, then on pads from stiff to soft.
RAILS = ("paper", "pads_100_500", "pads_40_100", "pads_20_60", "pads_10_25")
DIVIDED_RAIL = "pads_40_100"  # for the parts of the deflection
STRESS_RAILS = ("paper", "pads_40_100", "pads_10_25")
CHART_FORCES = steps(0.0, 80e3, 20)       # [N]
SEARCH_FORCES = steps(0.0, 60e3, 12)      # [N]
SEARCH_POSITIONS = steps(2e-3, 8e-3, 24)  # [m]
STRESS_FORCES = steps(0.0, 60e3, 2)       # [N]


@dataclass
class Study:
    """Results. Lists of rows are those of the CSV file with their name: dict by column, SI units."""
    placements: list = field(default_factory=list)
    stresses: list = field(default_factory=list)  # RailStress
    figures: list = field(default_factory=list)
    methods: list = field(default_factory=list)
    forces: list = field(default_factory=list)
    scan: list = field(default_factory=list)
    search: list = field(default_factory=list)


def run(folder, progress):
    """Runs the study and writes its tables.

    folder    of the tables (pathlib.Path)
    progress  is called with the name of each step when it begins

    Raises Failure if a solution is missing.
    """
    study = Study()
    rails = [Rail(name) for name in RAILS]
    for part in (_cases, _forces, _stress, _scan, _search):
        for name, rows in part(study, rails, progress).items():
            _write(folder / f"{name}.csv", rows)
    return study


def _cases(study, _, progress):
    for case in placement.CASES:
        progress(f"case {case.name}")
        solved = placement.solve(case)
        rows = methods.compare(solved.deflection)
        study.placements.append(solved)
        study.figures.append(solved.row(level=(rows[0]["max_pressure"], rows[0]["area"])))
        study.methods += [{"case": case.name, **row} for row in rows]
    placements = study.placements
    return {"figures": study.figures, "methods": study.methods,
            "profiles": [{"case": one.case.name, "body": body, "y": y, "z": z} for one in placements
                         for body, outline in (("rail", one.rail), ("wheel", one.wheel)) for y, z in outline],
            "contacts": [{"case": one.case.name, "y": one.touch[0], "z": one.touch[1]} for one in placements],
            "patches": [{"case": one.case.name, "patch": k, **cell} for one in placements
                        for k, patch in enumerate(one.patches) for cell in _cells(patch)]}


def _forces(study, rails, progress):
    for rail in rails:
        progress(f"lateral forces on {rail.name}")
        study.forces += rail.whole_deflection([POSITION], CHART_FORCES)
        if rail.name == DIVIDED_RAIL:
            for share in ("without_moment", "shift_only"):
                study.forces += rail.part_of_deflection(share, POSITION, CHART_FORCES)
    return {"forces": study.forces}


def _stress(study, rails, progress):
    progress("stress")
    study.stresses += [RailStress(one.case.name, one.patches) for one in study.placements if one.case.crown is not None]
    for rail in rails:
        if rail.name in STRESS_RAILS:
            study.stresses += under_forces(rail, STRESS_FORCES)
    return {"stress": [one.row() for one in study.stresses],
            "stress_patches": [{"rail": one.rail, "lateral_force": one.lateral_force, **cell} for one in study.stresses
                               for cell in _cells(one.patch)]}


def _scan(study, _, progress):
    scan = Scan()
    progress("scan: settings for the results without bending")
    study.scan += scan.start()
    for start in scan.nearest_starts(study.scan):
        progress(f"scan: pairs for {start['rail']}")
        study.scan += [start, *scan.shift(start), *scan.pair(start), *scan.roll(start), *scan.rails(start)]
    for rail in scan.ranges.rails:
        progress(f"scan: other inclinations of {rail}")
        study.scan += [*scan.alone(rail), *scan.inclination(rail)]
    return {"scan": study.scan}


def _search(study, rails, progress):
    for rail in rails:
        progress(f"scan: positions and lateral forces on {rail.name}")
        study.search += rail.whole_deflection(SEARCH_POSITIONS, SEARCH_FORCES)
    return {"search": study.search}


def _cells(patch):
    """Places and pressures of the cells of a patch."""
    for y, pressures in zip(patch.y, patch.pressure.T):
        for x, pressure in zip(patch.x, pressures):
            yield {"x": x, "y": y, "pressure": pressure}


def _write(path, rows):
    """Writes rows with the same columns; numbers with 8 significant digits, or 1 and 0 for True and False."""
    with writing(path), open(path, "w", newline="", encoding="ascii") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(rows[0])
        writer.writerows([value if isinstance(value, str) else f"{value:.8g}" for value in row.values()] for row in rows)
