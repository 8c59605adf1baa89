# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_report."""
import argparse
import pathlib

import numpy as np

from ..command import finish, pyplot, writing
from . import figures, page
from .answers import full, read

WORST = 2  # instants of highest pressure that are shown


def _parser():
    parser = argparse.ArgumentParser(
        description="Makes pictures and a page (report.html, self-contained) of a bag of answers, as contact_replay or "
                    "rosbag record write it.")
    parser.add_argument("bag", help="bag with answers")
    parser.add_argument("--out", required=True, metavar="DIR", help="folder for page and pictures; made if it is not there")
    parser.add_argument("--compare", metavar="BAG", help="answers of another run, such as one without rail bending")
    parser.add_argument("--wheelset", metavar="NAME", help="namespace, if the bag holds more than one wheelset")
    parser.add_argument("--at", type=float, nargs="+", default=[], metavar="S", help="instants whose pressure is shown [s]")
    return parser


def chosen_answers(answers, instants):
    """Indices of the answers whose pressure is shown, with a title each: those nearest the instants, and the worst."""
    chosen = {int(np.argmin(np.abs(answers.stamp - t))): "" for t in instants}
    pressure = answers.patches["max_pressure"]
    for patch in np.argsort(-pressure, kind="stable"):
        if sum(title != "" for title in chosen.values()) == WORST:
            break
        index = int(answers.patches["answer"][patch])
        # Neighbours in time show the same.
        near = any(abs(answers.stamp[index] - answers.stamp[other]) < 0.05 * np.ptp(answers.stamp) for other in chosen
                   if chosen[other])
        if not near:
            chosen[index] = "high pressure, "
    return {index: f"{title}{answers.stamp[index]:.3f} s, y = {1e3 * answers.y[index]:.2f} mm"
            for index, title in sorted(chosen.items())}


def make_report(options):
    """Writes page and pictures; prints the page's path."""
    pyplot()  # before any time is spent
    answers, topic = read(options.bag, options.wheelset)
    other = read(options.compare, options.wheelset)[0] if options.compare else None
    out = pathlib.Path(options.out)
    with writing(out):
        out.mkdir(parents=True, exist_ok=True)
        _write(out, options, answers, topic, other)
    print(out / "report.html")


def _write(out, options, answers, topic, other):
    pictures = [("Histories", [figures.histories(answers, other, out / "histories.png")])]
    if len(answers.patches["answer"]):
        pictures.append(("Where it runs", [figures.bands(answers, out / "bands.png")]))
        titles = chosen_answers(answers, options.at)
        shown = [figures.pressure_maps(message, titles[index], out / f"pressure_{index}.png")
                 if any(patch.grid.nx for patch in message.patches) else
                 f"{titles[index]}: no pressure, {message.status_text or 'the bag was made without grids'}"
                 for index, message in full(options.bag, topic, titles).items()]
        pictures.append(("Pressure", shown))
        pictures.append(("Estimated errors", [figures.quality(answers, out / "errors.png")]))
    page.write(out / "report.html", f"{pathlib.Path(options.bag).name}, {topic}", answers, pictures,
               pathlib.Path(options.compare).name if options.compare else None)


def main(arguments=None):
    """Run the command; returns its exit status."""
    return finish("contact_report", make_report, _parser().parse_args(arguments))
