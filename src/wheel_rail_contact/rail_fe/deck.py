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
        _write_supports(deck, model.supports, len(model.mesh.elements))
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


def _write_supports(deck, supports, last_element):
    for name, (nodes, _) in supports.fixed.items():
        _write_set(deck, name, nodes)
    for name, (_, freedoms) in supports.fixed.items():
        deck.write("*BOUNDARY\n" + "".join(f"{name}, {freedom}\n" for freedom in freedoms))
    for number, (node, freedom, stiffness) in enumerate(supports.springs, start=1):
        deck.write(f"*ELEMENT, TYPE=SPRING1, ELSET=PAD{number}\n{last_element + number}, {node + 1}\n"
                   f"*SPRING, ELSET=PAD{number}\n{freedom}\n{stiffness:.9e}\n")


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
