# SPDX-License-Identifier: BSD-3-Clause
"""Command line of check_profile."""
import json
import shutil
import sys
import tempfile
from pathlib import Path

from ..arguments import Parser
from ..command import Failure, calculating, finish, native, output_folder, pyplot, writing
from . import checked, clean_table, picture, text
from .tables import Tables

CLEAN = "clean.csv"
# Options that are members of the group `profile` of a parameter file, with the same names, values and units.
WORDS = (("unit", "m|cm|mm|um|in", "length unit of the file"),
         ("y", "outward|inward", "direction of the first coordinate: to the field side, or to the gauge side"),
         ("z", "up|down", "direction of the second coordinate"),
         ("origin", "POINT", "running_circle or flange_back of a wheel; crown, gauge_corner or foot of a rail"))

# Options that are numbers: those of the group, and dimensions of the vehicle.
NUMBERS = {"rotate": ("RAD", "rotation about the origin, from outward towards up [rad]"),
           "smoothing": ("UM", "noise for which the points are smoothed [um]; 0: none (default: estimated)"),
           "tape_circle": ("M", "distance of the running circle from the flange back, wheelset/tape_circle [m]"),
           "scale": ("S", "scale of a model: its points are read as those of its original")}


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("check_profile", _run, _parser().parse_args(arguments))


def _run(options):
    _check(options)
    native()
    plot = pyplot()
    output_folder(options.out)
    refused = [file for file in options.files if not _check_file(file, options, plot)]
    if refused and len(options.files) > 1:
        print(f"check_profile: {len(refused)} of {len(options.files)} files refused", file=sys.stderr)
    return 1 if refused else 0


def _check(options):
    names = [_picture_name(file) for file in options.files]
    repeated = sorted({name for name in names if names.count(name) > 1})
    if repeated:
        raise Failure(f"{', '.join(repeated)}: two pictures would have this name; check these files in separate runs")
    if options.write and len(options.files) > 1:
        raise Failure("--write: give only one FILE")
    if options.write and options.write.exists():
        raise Failure(f"{options.write}: already exists and is not overwritten")


def _picture_name(file):
    return Path(file).name + ".png"


def _check_file(file, options, plot):
    """Checks one file: prints the report, and writes picture and table. @return False if it is refused"""
    with tempfile.TemporaryDirectory() as folder:
        clean = Path(folder, CLEAN)
        try:
            profile = _report(file, options, clean)
        except Failure as error:
            print(f"check_profile: {error}", file=sys.stderr)
            return False
        target = options.out / _picture_name(file)
        with writing(target):
            picture.draw(plot, Tables(profile), checked.text_of(Path(file).name), target)
        print(f"  wrote {checked.text_of(target)}")
        if options.write:
            _copy(clean, options.write)
            print(f"  wrote {checked.text_of(options.write)}")
    return True


def _report(file, options, clean):
    """Prints the report of a file, and writes its table to `clean` for --write. @return Checked"""
    with calculating():
        profile = checked.checked_profile(file, options.kind, json.dumps(_reading(options)))
        print(text.report(file, profile), flush=True)
        note = clean_table.write(file, profile, clean) if options.write else ""
    if note:
        print(f"  {note}")
    return profile


def _copy(source, target):
    """Copies a file to a path at which there is none."""
    try:
        with writing(target), open(source, "rb") as reader, open(target, "xb") as writer:
            shutil.copyfileobj(reader, writer)
    except FileExistsError:
        raise Failure(f"{target}: already exists and is not overwritten") from None
    except Failure:
        if target.is_file():
            target.unlink()
        raise


def _reading(options):
    """Given options as the group `profile` of a parameter file."""
    reading = {name: getattr(options, name) for name, *_ in WORDS if getattr(options, name) is not None}
    if options.shift is not None:
        reading["shift"] = dict(zip("yz", options.shift))
    for name in NUMBERS:
        if getattr(options, name) is not None:
            reading[name] = getattr(options, name)
    return dict(reading, mirror=True) if options.mirror else reading


def _parser():
    parser = Parser(
        prog="check_profile", description="Reports what is understood of profile files: format, unit, axes, noise and "
        "missing points, the measures of wheel or rail, and the nearest standard profile. Draws a picture of each, "
        "FILE.png. The exit status is 1 if a file is refused; the others are still checked.",
        epilog="Options of reading have the names, values and units of the group `profile` of a parameter file; the tape "
        "circle and the scale are those of the vehicle.")
    parser.add_argument("files", nargs="+", metavar="FILE", help="profile file, or name of a standard profile")
    kind = parser.add_mutually_exclusive_group()
    kind.add_argument("--wheel", dest="kind", action="store_const", const="wheel",
                      help="the files are wheels (default: by extension or content)")
    kind.add_argument("--rail", dest="kind", action="store_const", const="rail", help="the files are rails")
    for name, values, meaning in WORDS:
        parser.add_argument(f"--{name}", metavar=values, help=meaning)
    parser.add_argument("--shift", type=float, nargs=2, metavar=("Y", "Z"),
                        help="added to the coordinates, outward and up [m]")
    for name, (value, meaning) in NUMBERS.items():
        parser.add_argument("--" + name.replace("_", "-"), type=float, metavar=value, help=meaning)
    parser.add_argument("--mirror", action="store_true", help="change the sign of y")
    parser.add_argument("--out", type=Path, default=Path("."), metavar="DIR",
                        help="folder for the pictures (default: this folder)")
    parser.add_argument("--write", type=Path, metavar="CLEAN.csv",
                        help="write the profile as it is understood as a table y_mm,z_mm; must not exist")
    return parser
