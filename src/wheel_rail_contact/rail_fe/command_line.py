# SPDX-License-Identifier: BSD-3-Clause
"""Command line of rail_compliance."""
import shlex
import sys
import time
from pathlib import Path

from ..arguments import Parser
from ..command import Failure, finish, pyplot, shipped
from . import calculix, gmsh_mesh
from .analysis import COARSER, estimated_error, solve
from .mesh import FACES
from .picture import write_picture
from .section import read_section
from .study import Study
from .supports import KINDS, Pads
from .table_file import table_text

NEIGHBOURS = (1.8, 2.5)  # axle distances of common bogies [m]
PAD_OPTIONS = {"pad_lateral": "lateral", "pad_vertical": "vertical", "pad_roll": "roll", "pad_length": "seat_length",
               "spacing": "spacing", "bays": "bays"}  # of the command line -> of Pads


def main(arguments=None):
    """Runs the command and returns its exit status."""
    arguments = sys.argv[1:] if arguments is None else arguments
    options = _parser().parse_args(arguments)
    return finish("rail_compliance", _run, options, shlex.join(["rail_compliance", *arguments]))


def _run(options, command):
    study = _study(options)
    study.validate()
    _check_requirements(options)
    started = time.monotonic()

    def progress(text):
        print(f"[{time.monotonic() - started:6.1f} s] {text}", file=sys.stderr, flush=True)

    if options.keep_deck:
        options.keep_deck.mkdir(parents=True, exist_ok=True)
    progress("coarser mesh, for the error estimate")
    coarse = solve(study, COARSER * study.mesh_size, progress)
    progress("mesh of the given size")
    fine = solve(study, study.mesh_size, progress, options.keep_deck)
    options.out.write_text(table_text(options.out.stem, study, fine, coarse, command), encoding="utf-8")
    progress(f"wrote {options.out}")
    if options.picture:
        write_picture(options.picture, study, fine)
        progress(f"wrote {options.picture}")
    _report(study, fine, coarse)


def _check_requirements(options):
    """Raises Failure for a missing program or folder, before the analysis starts."""
    gmsh_mesh.program()
    calculix.program()
    for path in (options.out, options.picture):
        if path and not path.parent.is_dir():
            raise Failure(f"{path}: folder {path.parent} does not exist")
    if options.picture:
        pyplot()


def _report(study, fine, coarse):
    print("  ".join(f"{name} {value:.4e}" for name, value in fine.compliance.items()) + "  (SI)")
    print(f"estimated discretisation error {100 * estimated_error(fine, coarse):.2g} %")
    print(f"{study.force / 1e3:g} kN outward at {1e3 * study.check_height:g} mm: "
          f"crown {1e3 * fine.check_crown:.4f} mm, head roll {1e3 * fine.check_roll:.3f} mrad")


def _study(options):
    """The study defined by the options. Raises Failure if options contradict each other."""
    pads = _pads(options)
    length = options.length
    if length is None:
        length = pads.bays * pads.spacing if pads else Study.length
    neighbours = options.neighbours
    if neighbours is None:
        neighbours = [distance for distance in NEIGHBOURS if pads and distance < 0.5 * length]
    section = read_section(options.section or shipped("config/rails/sections/60E1.csv"))
    return Study(section=section, supports=options.supports, pads=pads, length=length, young=options.young,
                 poisson=options.poisson, element_type=options.element, mesh_size=options.mesh_size,
                 neighbours=tuple(sorted(set(neighbours))), head_depth=options.head_depth, force=options.force,
                 force_height=options.force_height)


def _pads(options):
    """Pads from the given options; None if the supports are not seats."""
    given = {name: getattr(options, option) for option, name in PAD_OPTIONS.items()}
    given = {name: value for name, value in given.items() if value is not None}
    if options.supports != "seats":
        if given:
            raise Failure("options of seats (pads, --spacing, --bays) require --supports seats")
        return None
    if "lateral" not in given or "vertical" not in given:
        raise Failure("--supports seats requires --pad-lateral and --pad-vertical")
    return Pads(**given)


def _parser():
    parser = Parser(
        prog="rail_compliance", description="Computes the compliance of a rail head under a wheel with finite elements "
        "(gmsh, CalculiX), and writes it as a table for the contact node. All units are SI.")
    add = parser.add_argument
    add("--supports", required=True, choices=KINDS, help="supports of the rail")
    add("--out", required=True, type=Path, metavar="F.yaml", help="compliance table to write; F is the name of the table")
    add("--section", type=Path, metavar="F.csv", help="closed outline, header y_mm,z_mm (default: 60E1 of the package)")
    add("--length", type=float, metavar="M", help="length of the rail (default: 1; with seats: bays times spacing)")
    add("--young", type=float, default=Study.young, metavar="PA", help="Young's modulus (default: %(default)g)")
    add("--poisson", type=float, default=Study.poisson, metavar="NU", help="Poisson's ratio (default: %(default)g)")
    add("--element", choices=sorted(FACES), default=Study.element_type,
        help="10-node tetrahedra or 20-node bricks (default: %(default)s)")
    add("--mesh-size", type=float, default=Study.mesh_size, metavar="M",
        help="size of the elements in the section (default: %(default)g)")
    add("--head-depth", type=float, default=Study.head_depth, metavar="M",
        help="height of the head below the crown; its rigid motion is fitted (default: %(default)g)")
    add("--force", type=float, default=Study.force, metavar="N",
        help="check load: lateral force on the gauge face (default: %(default)g)")
    add("--force-height", type=float, metavar="M",
        help="height of the check load above the foot (default: 14 mm below the crown)")
    add("--keep-deck", type=Path, metavar="DIR", help="folder in which the files of gmsh and CalculiX are kept")
    add("--picture", type=Path, metavar="F.png", help="picture of the loaded section under the check load")
    _add_seat_options(parser.add_argument_group("with --supports seats").add_argument)
    return parser


def _add_seat_options(add):
    add("--pad-lateral", type=float, metavar="N/M", help="lateral stiffness of a seat")
    add("--pad-vertical", type=float, metavar="N/M", help="vertical stiffness of a seat")
    add("--pad-roll", type=float, metavar="NM/RAD",
        help="roll stiffness of a seat (default: of the vertical stiffness, evenly distributed under the foot)")
    add("--pad-length", type=float, metavar="M", help=f"length of a seat along the rail (default: {Pads.seat_length:g})")
    add("--spacing", type=float, metavar="M", help=f"distance between the seats (default: {Pads.spacing:g})")
    add("--bays", type=int, metavar="N",
        help=f"number of bays; even: load between two seats; odd: load over a seat (default: {Pads.bays})")
    add("--neighbours", type=float, nargs="*", metavar="M", help="distances along the rail at which the influence "
        f"of another wheel is computed (default: {' and '.join(map(str, NEIGHBOURS))})")
