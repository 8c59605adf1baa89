# SPDX-License-Identifier: BSD-3-Clause
"""Finite-element analysis: mesh, loads, supports, solution, and the compliance of the rail head."""
import tempfile
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from . import calculix, gmsh_mesh
from .deck import write_deck
from .head_motion import Head
from .loads import REFERENCE_DEPTH, HeadSurface
from .mesh import Mesh
from .stations import stations
from .supports import Supports, supports

ECCENTRICITY = 0.020        # lever arm of the vertical force that causes the moment [m]
COARSER = 1.5               # mesh size of the second solution, divided by that of the first
CONVERGENCE_ORDER = 1.5     # of the compliances with the mesh size (found: 1.5 to 1.8 for mesh sizes of 36 to 7 mm)
COMPLIANCES = ("lateral_lateral", "lateral_roll", "roll_roll", "vertical_vertical")


@dataclass
class Model:
    """Content of the input deck."""
    mesh: Mesh
    supports: Supports
    cases: list
    reported: np.ndarray  # indices of the nodes whose displacements are printed
    young: float
    poisson: float


@dataclass
class Solution:
    """Result of one mesh, per unit force on the whole rail; compliances in SI (see COMPLIANCES)."""
    mesh: Mesh
    compliance: dict
    asymmetry: float       # |roll per Y - displacement per M| / mean of both: 0 by Maxwell-Betti
    neighbours: list       # one compliance dictionary per distance
    unknowns: int
    check: np.ndarray      # displacements (nodes, 3) [m] under the check load; valid only in the loaded section
    check_crown: float     # lateral displacement of the crown in the loaded section [m]
    check_roll: float      # roll of the head in the loaded section [rad]


def solve(study, mesh_size, progress, deck_directory=None, compliance=True):
    """Solves the study on one mesh.

    @param progress is called with the name of each step when it begins
    @param deck_directory keeps the deck, if given
    @param compliance false: only the check load is solved, in a third of the time or less; compliance and neighbours are empty

    Raises Failure if a program is missing or fails.
    """
    location = nullcontext(deck_directory) if deck_directory else tempfile.TemporaryDirectory(prefix="rail_compliance_")
    with location as directory:
        directory = Path(directory)
        progress(f"meshing with {mesh_size:g} m")
        mesh = _mesh(study, mesh_size, directory)
        progress(f"loads and supports: {len(mesh.elements)} elements, {3 * len(mesh.nodes)} unknowns")
        heads = [Head(mesh, x, study.section.height - study.head_depth, study.section.height - REFERENCE_DEPTH)
                 for x in (0.0, *study.neighbours)]
        reported = np.unique(np.concatenate([mesh.plane_nodes(0, 0.0)] + [head.nodes for head in heads]))
        rail_supports = supports(study.supports, mesh, study.section, study.pads)
        model = Model(mesh, rail_supports, _load_cases(study, mesh, compliance), reported, study.young, study.poisson)
        write_deck(directory / "rail.inp", model, fields=deck_directory is not None)
        steps = calculix.solve(directory, "rail", len(model.cases),
                               lambda k: progress(f"solving load case {k} of {len(model.cases)}"))
    return _evaluate(study, model, heads, [_displacements(step, mesh) for step in steps])


def estimated_error(fine, coarse):
    """Largest estimated relative discretisation error of the four compliances of `fine`, from a second, coarser mesh
    (Richardson 1911, with COARSER and CONVERGENCE_ORDER)."""
    return max(abs(coarse.compliance[name] / fine.compliance[name] - 1) for name in COMPLIANCES) / (
        COARSER**CONVERGENCE_ORDER - 1)


def _mesh(study, size, directory):
    required = list(study.neighbours) + (list(study.pads.edges()) if study.pads else [])
    cuts = stations(0.5 * study.length, size, required)
    return gmsh_mesh.rail_mesh(study.section, cuts, size, study.element_type, directory)


def _load_cases(study, mesh, compliance):
    """Load cases: those of the compliance (Y at the reference height, Q on the axis, Q off the axis), then the check load, if
    it is not the first of them."""
    section, surface = study.section, HeadSurface(mesh, study.section)
    cases = [surface.lateral(section.gauge_face(section.height - REFERENCE_DEPTH), "Y at the reference height"),
             surface.vertical(section.crown(), "Q on the axis"),
             surface.vertical(section.crossing(0, ECCENTRICITY, 1), "Q off the axis")] if compliance else []
    if study.force_height is not None or not cases:
        cases.append(surface.lateral(section.gauge_face(study.check_height), f"Y at {study.check_height:g} m"))
    return cases


def _displacements(step, mesh):
    field = np.zeros_like(mesh.nodes)
    for number, displacement in step.items():
        field[number - 1] = displacement
    return field


def _evaluate(study, model, heads, fields):
    (own, asymmetry), *others = ([_compliance(head, model.cases, fields) for head in heads] if len(fields) > 1
                                 else [({}, np.nan)])
    check = study.force * (fields[0] if study.force_height is None else fields[-1])
    crown = np.linalg.norm(model.mesh.nodes - [0, *study.section.points(study.section.crown())[0]], axis=1).argmin()
    return Solution(model.mesh, own, asymmetry, [other for other, _ in others],
                    3 * len(model.mesh.nodes) - model.supports.fixed_count(),
                    check, float(check[crown, 1]), float(heads[0].motion(check)[2]))


def _compliance(head, cases, fields):
    """Compliances of the rigid motion of one head, from the first three load cases, and their asymmetry.

    The difference of the two vertical forces is a moment. The moment of the lateral force is subtracted from its motion.
    """
    (lateral_case, on_axis, off_axis), motions = cases[:3], [head.motion(field) for field in fields[:3]]
    per_moment = (motions[2] - motions[1]) / (off_axis.moment - on_axis.moment)
    per_lateral = motions[0] - lateral_case.moment * per_moment
    lateral_roll = 0.5 * (per_lateral[2] + per_moment[0])
    return {"lateral_lateral": float(per_lateral[0]), "lateral_roll": float(lateral_roll), "roll_roll": float(per_moment[2]),
            "vertical_vertical": float(-motions[1][1])}, float(abs(per_lateral[2] - per_moment[0]) / lateral_roll)
