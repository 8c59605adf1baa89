# SPDX-License-Identifier: BSD-3-Clause
"""Compliance of the cells on a body by finite elements: CalculiX solves each cell's unit force with one decomposition."""
import subprocess

import numpy as np

from ..command import Failure
from ..rail_fe import calculix

RING = (0.022, 0.034)  # distances of the nodes from the contact whose rigid motion is subtracted [m]


def compliance(mesh, body, loads, centre, material, directory):
    """Mean displacement of each cell along its force by a force of 1 N on each half-cell, (n, n) [m/N], symmetric.

    Displacements are relative to the rigid motion of the nodes around the contact, in the plane x = 0.

    @param loads      CellLoad of each cell
    @param centre     y and z of the middle of the contact [m]
    @param material   Young's modulus [Pa] and Poisson's ratio
    @param directory  receives the files of CalculiX (pathlib.Path)

    Raises Failure if ccx is missing or fails.
    """
    ring = _ring(mesh, centre)
    _write_deck(directory / f"{body.name}.inp", mesh, body, loads, ring, material)
    _run(directory, body.name)
    first = len(mesh.nodes) + 1
    table = _read(directory / f"{body.name}.dat", len(loads), first + len(loads))
    own = table[:, first:first + len(loads), 0]
    fit = _rigid_fit(mesh.nodes[ring][:, 1:])
    motion = table[:, ring + 1, 1:].reshape(len(loads), -1) @ fit.T
    openings = np.array([_projection(mesh, load) for load in loads])
    result = own - motion @ openings.T
    return 0.5 * (result + result.T)


def _ring(mesh, centre):
    distance = np.hypot(*(mesh.nodes[:, 1:] - centre).T)
    ring = np.flatnonzero((mesh.nodes[:, 0] < 1e-7) & (distance > RING[0]) & (distance < RING[1]))
    if len(ring) < 6:
        raise Failure(f"only {len(ring)} nodes are around the contact: must be at least 6")
    return ring


def _rigid_fit(points):
    """Matrix (3, 2 n) that gives the rigid motion (y, z [m], roll about the origin [rad]) from displacements."""
    motion = np.zeros((len(points), 2, 3))
    motion[:, 0, 0] = motion[:, 1, 1] = 1
    motion[:, 0, 2], motion[:, 1, 2] = -points[:, 1], points[:, 0]
    return np.linalg.pinv(motion.reshape(-1, 3))


def _projection(mesh, load):
    """Mean displacement of a cell along its force by a rigid motion: per y, z and roll about the origin."""
    y, z = load.weights @ mesh.nodes[load.nodes][:, 1:]
    dy, dz = load.direction
    return dy, dz, dz * y - dy * z


def _write_deck(path, mesh, body, loads, ring, material):
    with open(path, "w", encoding="ascii") as deck:
        deck.write("** Half a body (x >= 0), written by half_space_study. Units: m, N, Pa.\n*NODE, NSET=ALL\n")
        count = len(mesh.nodes)
        np.savetxt(deck, np.column_stack([np.arange(1, count + 1), mesh.nodes]), fmt="%d, %.12g, %.12g, %.12g")
        deck.write("*NODE, NSET=CELLS\n" + "".join(f"{count + 1 + k}, 0, 0, 0\n" for k in range(len(loads))))
        deck.write("*ELEMENT, TYPE=C3D10, ELSET=BODY\n")
        np.savetxt(deck, np.column_stack([np.arange(1, len(mesh.elements) + 1), mesh.elements + 1]), fmt="%d", delimiter=", ")
        deck.write(f"*MATERIAL, NAME=STEEL\n*ELASTIC\n{material[0]:.9g}, {material[1]:.9g}\n"
                   "*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL\n")
        _write_set(deck, "HELD", _held(mesh, body))
        _write_set(deck, "MIDDLE", mesh.plane_nodes(0, 0.0))
        _write_set(deck, "RING", ring)
        deck.write("*BOUNDARY\nHELD, 1, 3\n*BOUNDARY\nMIDDLE, 1\n")
        for k, load in enumerate(loads):
            _write_equation(deck, count + 1 + k, load)
        deck.write("*STEP\n*GREEN\n*CLOAD\n" + "".join(f"{count + 1 + k}, 1, 1.\n" for k in range(len(loads)))
                   + "*NODE PRINT, NSET=CELLS\nU\n*NODE PRINT, NSET=RING\nU\n*END STEP\n")


def _held(mesh, body):
    """Nodes at the cut of a body. That of a wheel is a surface about the axle."""
    first, second = body.closing[list(body.held)]
    section = mesh.nodes[:, 1:]
    if body.axle_z is not None:
        section = np.column_stack([section[:, 0],
                                   body.axle_z - np.hypot(mesh.nodes[:, 0], body.axle_z - mesh.nodes[:, 2])])
    along = (second - first) / np.hypot(*(second - first))
    across = (section - first) @ np.array([-along[1], along[0]])
    place = (section - first) @ along
    return np.flatnonzero((np.abs(across) < 1e-5) & (place > -1e-6) & (place < np.hypot(*(second - first)) + 1e-6))


def _write_set(deck, name, nodes):
    deck.write(f"*NSET, NSET={name}\n")
    for start in range(0, len(nodes), 12):
        deck.write(", ".join(str(node + 1) for node in nodes[start:start + 12]) + ",\n")


def _write_equation(deck, number, load):
    """The first degree of freedom of node `number` is the mean displacement of a cell along its force.

    A dependent degree of freedom can carry no unit force in *GREEN. The dependent one is therefore that of the middle
    node of the cell, which belongs to no other cell.
    """
    terms = [(node + 1, 2 + axis, weight * load.direction[axis])
             for node, weight in zip(load.nodes, load.weights) for axis in (0, 1) if abs(load.direction[axis]) > 1e-9]
    terms.sort(key=lambda term: -abs(term[2]))
    terms.append((number, 1, -1.0))
    deck.write(f"*EQUATION\n{len(terms)}\n")
    for start in range(0, len(terms), 4):
        deck.write(", ".join(f"{node}, {axis}, {weight:.12g}" for node, axis, weight in terms[start:start + 4]) + "\n")


def _run(directory, job):
    run = subprocess.run([calculix.program(), job], cwd=directory, text=True, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, check=False)
    errors = [line.strip() for line in run.stdout.splitlines() if "*ERROR" in line]
    if run.returncode != 0 or errors:
        raise Failure("ccx failed: " + (" ".join(errors[:5]) or f"exit status {run.returncode}"))


def _read(path, count, highest):
    """Printed displacements (cases, highest + 1, 3) [m], by number of the node."""
    result = np.zeros((count, highest + 1, 3))
    case = -1
    with open(path, encoding="ascii") as lines:
        for line in lines:
            if "E I G E N V A L U E" in line:
                case += 1
                continue
            fields = line.split()
            if len(fields) == 4 and fields[0].isdigit():
                result[case, int(fields[0])] = [float(field) for field in fields[1:]]
    if case + 1 != count:
        raise Failure(f"ccx solved {case + 1} of {count} unit forces")
    return result
