# SPDX-License-Identifier: BSD-3-Clause
"""Meshes a body with gmsh: 10-node tetrahedra, regular on the cells of its contacts, and coarser away from them."""
import re
import subprocess

import numpy as np

from ..command import Failure
from ..rail_fe.gmsh_mesh import program, read, version
from .cell_loads import swept_radius

SCRIPT_HEAD = """\
// Half a body (metres). Written by half_space_study; mesh it with: gmsh -3 NAME.geo
Mesh.ElementOrder = 2;
Mesh.MshFileVersion = 2.2;
Mesh.Binary = 0;
Mesh.CharacteristicLengthExtendFromBoundary = 0;
Mesh.CharacteristicLengthFromPoints = 0;
Geometry.ExtrudeReturnLateralEntities = 1;
"""
# Names of options of fields: of gmsh 4.8, and before.
NAMES = {"surfaces": ("SurfacesList", "FacesList"), "points": ("NumPointsPerCurve", "NNodesByEdge"),
         "field": ("InField", "IField"), "least": ("SizeMin", "LcMin"), "most": ("SizeMax", "LcMax")}
RENAMED = (4, 8)
LAST_FIELD = 100  # number of the field that combines those of the contacts


def body_mesh(body, cells, sizes, directory):
    """Mesh (rail_fe.mesh.Mesh) of a body.

    @param cells      list of Cells, one for each contact
    @param sizes      Sizes of the mesh
    @param directory  receives the files of gmsh (pathlib.Path)

    Raises Failure if gmsh is missing or fails.
    """
    name = body.name
    (directory / f"{name}.geo").write_text(_script(body, cells, sizes), encoding="ascii")
    run = subprocess.run([program(), "-3", f"{name}.geo", "-o", f"{name}.msh", "-nopopup"], cwd=directory, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    errors = [line for line in run.stdout.splitlines() if line.startswith(("Error", "terminate"))]
    if run.returncode != 0 or errors or not (directory / f"{name}.msh").exists():
        raise Failure(f"gmsh could not mesh the {name}: " + (" ".join(errors) or f"exit status {run.returncode}"))
    return read(directory / f"{name}.msh", "C3D10")


def _script(body, cells, sizes):
    lines, first = [], 1
    outline = [curve[:-1] for curve in body.curves] + [body.curves[-1][-1:], body.closing]
    points = np.vstack(outline)
    lines += [f"Point({i + 1}) = {{0, {y:.12g}, {z:.12g}}};" for i, (y, z) in enumerate(points)]
    curve_count = len(body.curves)
    for k, curve in enumerate(body.curves):
        lines.append(f"Spline({k + 1}) = {{{first}:{first + len(curve) - 1}}};")
        first += len(curve) - 1
    corners = [*range(first, first + len(body.closing) + 1), 1]
    lines += [f"Line({curve_count + 1 + k}) = {{{a}, {b}}};" for k, (a, b) in enumerate(zip(corners[:-1], corners[1:]))]
    lines += [f"Curve Loop(1) = {{1:{curve_count + len(corners) - 1}}};", "Plane Surface(1) = {1};"]
    return SCRIPT_HEAD + "\n".join(lines + _sweep(body, cells, sizes) + _sizes(cells, sizes)) + "\n"


def _sweep(body, cells, sizes):
    """Two volumes: the first has the length of the cells, which is the same for all contacts."""
    length = cells[0].rows * cells[0].dx
    lines = [f"near[] = Extrude {{{_move(body, length)}}} {{ Surface{{1}}; }};",
             f"far[] = Extrude {{{_move(body, sizes.half_length - length)}}} {{ Surface{{near[0]}}; }};"]
    for contact, (curve, cell) in enumerate(zip(body.patches, cells)):
        lines += _regular(2 + curve, cell, contact)
    return lines + ["Physical Volume(1) = {near[1], far[1]};"]


def _move(body, distance):
    if body.axle_z is None:
        return f"{distance:.12g}, 0, 0"
    return f"{{0, 1, 0}}, {{0, 0, {body.axle_z:.12g}}}, {-distance / swept_radius(body):.12g}"


def _regular(index, cell, contact):
    """Regular triangles on the cells: the first and third curves of the swept surface lie across the track."""
    return [f"contact{contact} = near[{index}];",
            f"edge[] = Abs(Boundary {{ Surface{{contact{contact}}}; }});",
            f"Transfinite Curve {{edge[0], edge[2]}} = {cell.columns + 1};",
            f"Transfinite Curve {{edge[1], edge[3]}} = {cell.rows + 1};",
            f"Transfinite Surface {{contact{contact}}};"]


def _sizes(cells, sizes):
    """Size of the elements: that of the cells at a contact, growing with the distance from it."""
    old = tuple(map(int, re.findall(r"\d+", version())[:2])) < RENAMED
    name = {key: names[int(old)] for key, names in NAMES.items()}
    lines = []
    for contact, cell in enumerate(cells):
        near = sizes.near * np.sqrt(cell.dx * cell.dy)
        distance, size = f"Field[{2 * contact + 1}]", f"Field[{2 * contact + 2}]"
        lines += [f"{distance} = Distance;",
                  f"{distance}.{name['surfaces']} = {{contact{contact}}};",
                  f"{distance}.{name['points']} = 40;",
                  f"{size} = Threshold;",
                  f"{size}.{name['field']} = {2 * contact + 1};",
                  f"{size}.{name['least']} = {near:.6g};",
                  f"{size}.{name['most']} = {sizes.far:.6g};",
                  f"{size}.DistMin = {near:.6g};",
                  f"{size}.DistMax = {near + (sizes.far - near) / sizes.growth:.6g};"]
    fields = ", ".join(str(2 * contact + 2) for contact in range(len(cells)))
    return lines + [f"Field[{LAST_FIELD}] = Min;", f"Field[{LAST_FIELD}].FieldsList = {{{fields}}};",
                    f"Background Field = {LAST_FIELD};"]
