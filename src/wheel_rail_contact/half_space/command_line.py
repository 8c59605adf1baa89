# SPDX-License-Identifier: BSD-3-Clause
"""Command line of half_space_study."""
import sys
import time
from pathlib import Path

from ..arguments import Parser
from ..chart import table
from ..command import Failure, calculating, finish, output_folder, pyplot
from ..rail_fe import calculix, gmsh_mesh
from . import picture, report, results
from .places import PLACES
from .study import QUICK, Settings, solve_place


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("half_space_study", _run, _parser().parse_args(arguments))


def _run(options):
    places, chart_rows = _places(options.places), _chart_rows(options.chart)
    plot = pyplot()
    gmsh_mesh.program()
    calculix.program()
    output_folder(options.out)
    started = time.monotonic()

    def progress(text):
        print(f"[{time.monotonic() - started:6.1f} s] {text}", file=sys.stderr, flush=True)

    with calculating():
        found = [solve_place(place, QUICK if options.quick else Settings(), options.out / place.name, progress)
                 for place in places]
    rows = results.comparisons(found)
    results.write_comparisons(options.out / "comparisons.csv", rows)
    results.write_sections(options.out / "sections.csv", found)
    results.write_influences(options.out / "influences.csv", found)
    picture.draw_errors(plot, options.out / "half_space_error.png", rows, chart_rows)
    picture.draw_sections(plot, options.out / "half_space_pressures.png", options.out / "sections.csv")
    print(report.text(rows))
    progress(f"wrote comparisons.csv, sections.csv, influences.csv and two pictures to {options.out}")


def _places(names):
    """The places with these names; all, if none is given. Raises Failure for an unknown name."""
    known = {place.name: place for place in PLACES}
    for name in names or ():
        if name not in known:
            raise Failure(f"--places has {name}: must be one of {', '.join(known)}")
    return [known[name] for name in names or known]


def _chart_rows(path):
    """Rows of a table of contact_chart; none without a path. Raises Failure for another file."""
    if path is None:
        return []
    try:
        rows = picture.numerical_errors(table.read(path)[1])
    except (TypeError, ValueError) as error:
        raise Failure(f"--chart {path}: is not a table of contact_chart ({error})") from error
    if not rows:
        raise Failure(f"--chart {path}: has no result of auto for a wheelset")
    return rows


def _parser():
    parser = Parser(
        prog="half_space_study", description="Computes contacts of a wheel and a rail by finite elements (gmsh, CalculiX) and "
        "by three models of half-spaces, and compares maximum pressure and area. The command prints the errors, and writes "
        "tables (CSV, SI units) and pictures. Takes about a quarter of an hour.")
    parser.add_argument("--out", type=Path, default=Path("half_space_study"), metavar="DIR",
                        help="folder for all files (default: %(default)s)")
    parser.add_argument("--places", nargs="+", metavar="NAME",
                        help=f"places to compute: {', '.join(place.name for place in PLACES)} (default: all)")
    parser.add_argument("--chart", type=Path, metavar="F.csv",
                        help="table of contact_chart: its numerical errors are drawn beside the model errors")
    parser.add_argument("--quick", action="store_true", help="coarse meshes and few cells: a test of the command")
    return parser
