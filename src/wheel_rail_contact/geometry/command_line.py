# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_geometry."""
import argparse
import math
import sys
from pathlib import Path

from ..arguments import DefaultsFormatter, Parser
from ..command import Failure, calculating, contact_model, finish, load_doubt, native, output_folder, pyplot
from . import picture, tables
from .loaded import loaded_points
from .tables import CONICITY, GEOMETRY, MM

PICTURE = "contact_geometry.png"
FARTHEST = 100.0  # largest lateral displacement from the track centre [mm]
MOST_STEPS = 20000  # of the lateral displacement
AMPLITUDES = (1.0, 8.0)  # if the range of the lateral displacement contains them [mm]
ROUND_OFF = 1e-9  # of a length [mm]


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("contact_geometry", _run, _parser().parse_args(arguments))


def _run(options):
    if not hasattr(options, "amplitudes"):
        options.amplitudes = [min(value, _largest_amplitude(options.y)) for value in AMPLITUDES]
    _check(options)
    core, plot = native(), pyplot()
    model = contact_model(options.config)
    if options.distance is not None and None not in model.rail_profiles:
        raise Failure(f"--distance {options.distance:g}: must be omitted, because no rail has a profile that changes")
    output_folder(options.out)
    for note in [*model.notes, *_notes(model.parameters, options)]:
        print(f"contact_geometry: {note}", file=sys.stderr)
    y, step = [value / MM for value in options.y], options.step / MM
    with calculating():
        geometry = core.contact_geometry(model, *y, step, options.roll == "solved", options.distance or 0.0)
        points = tables.points_of(geometry)
    loaded, curve = {}, None
    if options.load:
        loaded, curve = loaded_points(options.config, points["y"], options.load, options.distance)
    tables.write(points, loaded, options.out / GEOMETRY)
    waves = core.running_circles(model), [value / MM for value in options.amplitudes], step
    conicity = tables.conicity_of(geometry.curve, *waves)
    loaded_conicity = tables.conicity_of(curve, *waves) if loaded else {}
    tables.write(conicity, loaded_conicity, options.out / CONICITY)
    picture.draw(plot, (points, loaded), (conicity, loaded_conicity),
                 options.title or ", ".join(options.config) or "config/default.yaml", options.out / PICTURE)
    _report(points, conicity)
    if loaded:
        print(f"elastic, under {1e-3 * options.load:g} kN on each wheel:")
        _report(loaded, loaded_conicity)
    print(f"wrote {GEOMETRY}, {CONICITY} and {PICTURE} to {options.out}")


def _notes(parameters, options):
    """Notes on parameters that move the rails, which lie in the ideal track and deflect only under a load; and on the load."""
    for name, ideal in (("rail_bending/model", "none"), ("track/line", ""), ("track/displacement", "none")):
        is_used = options.load and name == "rail_bending/model"
        if parameters.get(name) != ideal and not is_used:  # None: a group, such as {file: line.csv}
            yield f"{name} is not used: the rails are rigid, in the ideal track"
    if options.load:
        yield from filter(None, [load_doubt(options.load, options.config)])


def _check(options):
    for name, values in (("y", options.y), ("amplitudes", options.amplitudes), ("step", [options.step]),
                         ("distance", [options.distance or 0.0]), ("load", [options.load or 0.0])):
        if not all(math.isfinite(value) for value in values):
            raise Failure(f"--{name} {_text(values)}: must be a number")
    first, last = options.y
    if not -FARTHEST <= first < last <= FARTHEST:
        raise Failure(f"--y {_text(options.y)}: must increase, within ±{FARTHEST:g} mm")
    if options.load is not None and not options.load > 0:
        raise Failure(f"--load {options.load:g}: must be above 0")
    if not options.step > 0:
        raise Failure(f"--step {options.step:g}: must be above 0")
    if last - first < options.step - ROUND_OFF:
        raise Failure(f"--y {_text(options.y)}: must be a range of at least one --step, {options.step:g} mm; both are in mm")
    if last - first > MOST_STEPS * options.step:
        raise Failure(f"--step {options.step:g}: gives more than {MOST_STEPS} steps from {first:g} mm to {last:g} mm")
    if not 0 < options.amplitudes[0] <= options.amplitudes[1]:
        raise Failure(f"--amplitudes {_text(options.amplitudes)}: must be above 0, and not decrease")
    if options.amplitudes[1] > _largest_amplitude(options.y) + ROUND_OFF:
        raise Failure(f"--amplitudes {_text(options.amplitudes)}: must be at most {_largest_amplitude(options.y):g} mm, half "
                      f"of the range of --y {_text(options.y)}")


def _largest_amplitude(y):
    """Amplitude of the largest wave in a range of the lateral displacement; longer ones have no result."""
    return 0.5 * (y[1] - y[0])


def _text(values):
    return " ".join(f"{value:g}" for value in values)


def _report(points, conicity):
    """Prints the conicity of the amplitudes in whole millimetres, or of all if none is whole, and why results are missing."""
    print("amplitude [mm]  equivalent conicity  wavelength [m]  centre of the wave [mm]")
    amplitudes = MM * conicity["amplitude"]
    whole = [i for i, amplitude in enumerate(amplitudes) if abs(amplitude - round(amplitude)) <= 1e-6]
    for i in whole or range(len(amplitudes)):
        if conicity["reason"][i]:
            print(f"{amplitudes[i]:14.6g}  none: {conicity['reason'][i]}")
        else:
            centre = MM * conicity["centre"][i]
            print(f"{amplitudes[i]:14.6g}  {conicity['equivalent_conicity'][i]:19.4f}  {conicity['wavelength'][i]:14.2f}  "
                  f"{centre + 0.0 if abs(centre) > 5e-4 else 0.0:23.3f}")
    if all(conicity["reason"]):
        print("contact_geometry: no amplitude has an equivalent conicity", file=sys.stderr)
    if 0 < len(whole) < len(amplitudes):
        print(f"{CONICITY} contains all {len(amplitudes)} amplitudes")
    for name, table, column in (("y", points, "y"), ("amplitude", conicity, "amplitude")):
        for reason in sorted(set(filter(None, table["reason"]))):
            values = [MM * value for value, found in zip(table[column], table["reason"]) if found == reason]
            print(f"no result for {len(values)} of {len(table['reason'])} values of the {name}, {min(values):.4g} mm to "
                  f"{max(values):.4g} mm: {reason}")


def _parser():
    parser = Parser(
        prog="contact_geometry", formatter_class=DefaultsFormatter,
        description="Computes where the wheels of a rigid wheelset touch the rails over its lateral displacement: contact "
        "positions and angles, rolling radii and their difference, roll, and the equivalent conicity after EN 15302 over "
        "the amplitude. Writes two tables (CSV, SI units) and a picture.")
    parser.add_argument("--config", action="append", default=[], metavar="F.yaml",
                        help="parameters of the node, applied over config/default.yaml and the files given before")
    parser.add_argument("--out", type=Path, default=Path("contact_geometry"), metavar="DIR", help="folder for the files")
    parser.add_argument("--y", type=float, nargs=2, default=(-10.0, 10.0), metavar=("FIRST", "LAST"),
                        help="range of the lateral displacement, to the left positive, in millimetres [mm]")
    parser.add_argument("--step", type=float, default=0.1, metavar="MM",
                        help="step of the lateral displacement and of the amplitude [mm]")
    parser.add_argument("--amplitudes", type=float, nargs=2, default=argparse.SUPPRESS, metavar=("FIRST", "LAST"),
                        help="range of the amplitude of the wave, up to half the range of --y [mm] (default: 1 to 8, if "
                        "it is not larger)")
    parser.add_argument("--roll", choices=("solved", "none"), default="solved",
                        help="solved: both wheels touch; none: roll is neglected, as in the reference results of EN 15302")
    parser.add_argument("--distance", type=float, metavar="M",
                        help="place on the line, for rails whose profile changes [m] (default: 0)")
    parser.add_argument("--load", type=float, metavar="N",
                        help="also computes the contact of elastic wheels with this vertical force on each wheel [N]")
    parser.add_argument("--title", metavar="TEXT", help="title of the picture, instead of the names of the files")
    return parser
