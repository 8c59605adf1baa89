# SPDX-License-Identifier: BSD-3-Clause
"""Meshing with gmsh: the section is swept along x in layers. Reads the quadratic elements for CalculiX."""
import shutil
import subprocess

import numpy as np

from ..command import Failure
from .mesh import Mesh

# Element types of gmsh, and for each node of CalculiX its index in gmsh.
TYPE_NUMBER = {"C3D10": 11, "C3D20": 17}
NODE_ORDER = {
    "C3D10": [0, 1, 2, 3, 4, 5, 6, 7, 9, 8],
    "C3D20": [0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15],
}
SPLINE_PARTS = 8  # number of outline points on each spline
SCRIPT_HEAD = """\
// Half a rail, swept along x (metres). Written by rail_compliance; mesh it with: gmsh -3 rail.geo
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = {incomplete};
Mesh.RecombinationAlgorithm = 3; // blossom, quadrilaterals only
Mesh.MshFileVersion = 2.2;
Mesh.Binary = 0;
"""


def rail_mesh(section, cuts, size, element_type, directory):
    """Mesh of the section swept along the stations `cuts` [m], elements of about `size` [m] in the section.

    `directory` (pathlib.Path) receives rail.geo and rail.msh. Raises Failure if gmsh is missing or fails.
    """
    (directory / "rail.geo").write_text(_script(section, cuts, size, element_type), encoding="ascii")
    run = subprocess.run([program(), "-3", "rail.geo", "-o", "rail.msh", "-nopopup"], cwd=directory, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if run.returncode != 0 or not (directory / "rail.msh").exists():
        errors = [line for line in run.stdout.splitlines() if line.startswith(("Error", "terminate"))]
        raise Failure(f"gmsh could not mesh section {section.name} with size {size:g} m: "
                        + (" ".join(errors) or f"exit status {run.returncode}"))
    return read(directory / "rail.msh", element_type)


def program():
    """Path of gmsh; raises Failure if it is not installed."""
    path = shutil.which("gmsh")
    if path is None:
        raise Failure("gmsh is not installed; on Debian: apt install gmsh")
    return path


def version():
    """Version of gmsh."""
    run = subprocess.run([program(), "--version"], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                         check=True)
    return run.stdout.strip().splitlines()[-1]


def _script(section, cuts, size, element_type):
    """gmsh script: the section, extruded along x in layers."""
    bricks = element_type == "C3D20"
    layers = ", ".join(f"{share:.9g}" for share in cuts[1:] / cuts[-1])
    ones = ", ".join(["1"] * (len(cuts) - 1))
    lines = _outline_script(section, size) + ["Plane Surface(1) = {1};"] + ["Recombine Surface {1};"] * bricks
    lines += [f"Extrude {{{cuts[-1]:.9g}, 0, 0}} {{ Surface{{1}}; Layers{{ {{{ones}}}, {{{layers}}} }};"
              + (" Recombine; }" if bricks else " }")]
    return SCRIPT_HEAD.format(incomplete=int(bricks)) + "\n".join(lines + ["Physical Volume(1) = {1};", ""])


def _outline_script(section, size):
    """The outline as a loop of splines, each meshed by two edges of about `size` [m].

    There are two, because the full-quadrilateral recombination starts from every second point of the boundary.
    """
    arcs = section.cuts(2 * size)
    lengths = np.diff(np.append(arcs, arcs[0] + section.perimeter))
    n, shares = len(arcs), np.arange(SPLINE_PARTS) / SPLINE_PARTS
    lines = []
    for i, (y, z) in enumerate(section.points((arcs[:, None] + shares * lengths[:, None]).ravel())):
        near = 0.25 * (lengths[i // SPLINE_PARTS] + lengths[i // SPLINE_PARTS - 1])
        lines.append(f"Point({i + 1}) = {{0, {y:.9g}, {z:.9g}, {near:.4g}}};")
    for i in range(n):
        first, last = SPLINE_PARTS * i + 1, SPLINE_PARTS * ((i + 1) % n) + 1
        lines.append(f"Spline({i + 1}) = {{{first}:{first + SPLINE_PARTS - 1}, {last}}};")
    return lines + [f"Transfinite Curve {{1:{n}}} = 3;", f"Curve Loop(1) = {{1:{n}}};"]


def read(path, element_type):
    """Reads a mesh file of format 2.2. It must contain only volume elements of one type."""
    lines = path.read_text(encoding="ascii").splitlines()
    start = lines.index("$Nodes") + 2
    count = int(lines[start - 1])
    table = np.array([line.split() for line in lines[start:start + count]], float)
    start = lines.index("$Elements") + 2
    rows = [line.split() for line in lines[start:start + int(lines[start - 1])]]
    if {row[1] for row in rows} != {str(TYPE_NUMBER[element_type])}:
        raise Failure(f"the mesh of gmsh does not consist of {element_type} only: try another --mesh-size")
    order = NODE_ORDER[element_type]
    elements = np.array(rows, dtype=int)[:, -len(order):][:, order]
    place = np.full(int(table[:, 0].max()) + 1, -1)
    used = np.unique(elements)
    place[used] = np.arange(len(used))
    row = np.zeros_like(place)
    row[table[:, 0].astype(int)] = np.arange(len(table))
    return Mesh(element_type, table[row[used], 1:], place[elements])
