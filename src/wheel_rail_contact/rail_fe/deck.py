# SPDX-License-Identifier: BSD-3-Clause
"""CalculiX input deck of the half rail (SI units: m, N, Pa)."""
import numpy as np


def write_deck(path, model, fields):
    """Writes the deck of an analysis.Model to `path`. Node and element numbers start at 1.

    @param fields true: ccx also writes the displacements and stresses of all nodes, for a display with cgx
    """
    with open(path, "w", encoding="ascii") as deck:
        deck.write("** Half a rail (x >= 0, symmetric about x = 0), written by rail_compliance. Units: m, N, Pa.\n"
                   "** The forces of each step act on the half rail: half of 1 N on the whole rail.\n")
        _write_mesh(deck, model.mesh)
        deck.write(f"*MATERIAL, NAME=STEEL\n*ELASTIC\n{model.young:.9g}, {model.poisson:.9g}\n"
                   "*SOLID SECTION, ELSET=RAIL, MATERIAL=STEEL\n")
        _write_fixed(deck, model.supports.fixed)
        _write_springs(deck, model.supports.springs, model.mesh)
        _write_set(deck, "REPORTED", model.reported)
        for case in model.cases:
            _write_step(deck, case, fields)


def _write_mesh(deck, mesh):
    deck.write("*NODE, NSET=ALL\n")
    numbers = np.arange(1, len(mesh.nodes) + 1)
    np.savetxt(deck, np.column_stack([numbers, mesh.nodes]), fmt="%d, %.12g, %.12g, %.12g")
    deck.write(f"*ELEMENT, TYPE={mesh.element_type}, ELSET=RAIL\n")
    for number, element in enumerate(mesh.elements + 1, start=1):
        deck.write(_wrapped([number, *element], 11))


def _write_fixed(deck, fixed):
    for name, (nodes, _) in fixed.items():
        _write_set(deck, name, nodes)
    for name, (_, freedoms) in fixed.items():
        deck.write("*BOUNDARY\n" + "".join(f"{name}, {freedom}\n" for freedom in freedoms))


def _write_springs(deck, springs, mesh):
    """Each spring connects its node with a fixed node, 1 m away in the direction of its degree of freedom. CalculiX 2.11
    has no springs to the ground."""
    if not springs:
        return
    nodes, freedoms, _ = zip(*springs)
    ends = mesh.nodes[list(nodes)] + np.eye(3)[np.array(freedoms) - 1]
    numbers = len(mesh.nodes) + 1 + np.arange(len(springs))
    deck.write("*NODE, NSET=GROUND\n")
    np.savetxt(deck, np.column_stack([numbers, ends]), fmt="%d, %.12g, %.12g, %.12g")
    deck.write("*BOUNDARY\nGROUND, 1, 3\n")
    for number, (node, _, stiffness) in enumerate(springs, start=1):
        deck.write(f"*ELEMENT, TYPE=SPRINGA, ELSET=PAD{number}\n"
                   f"{len(mesh.elements) + number}, {node + 1}, {numbers[number - 1]}\n"
                   f"*SPRING, ELSET=PAD{number}\n\n{stiffness:.9e}\n")


def _write_set(deck, name, nodes):
    deck.write(f"*NSET, NSET={name}\n" + "".join(_wrapped(part + 1, 12) for part in _parts(nodes, 12)))


def _parts(nodes, length):
    return [nodes[i:i + length] for i in range(0, len(nodes), length)]


def _wrapped(numbers, per_line):
    """Numbers separated by commas, at most `per_line` in a line. All lines but the last one end with a comma."""
    lines = [", ".join(str(n) for n in part) for part in _parts(list(numbers), per_line)]
    return ",\n".join(lines) + "\n"


def _write_step(deck, case, fields):
    deck.write(f"** {case.name}\n*STEP\n*STATIC\n*CLOAD, OP=NEW\n")
    for node, freedom in zip(*np.nonzero(case.forces)):
        deck.write(f"{node + 1}, {freedom + 1}, {case.forces[node, freedom]:.12e}\n")
    deck.write("*NODE PRINT, NSET=REPORTED\nU\n" + ("*NODE FILE\nU\n*EL FILE\nS\n" if fields else "") + "*END STEP\n")
