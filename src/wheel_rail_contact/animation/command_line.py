# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_animation."""
import argparse
import pathlib

from ..command import Failure, finish, pyplot
from ..message_constants import SIDES
from .gif import write_gif
from .run import read_run


def _parser():
    parser = argparse.ArgumentParser(
        description="Draws one side of a bag of answers as an animated GIF: section, pressure and histories; of two bags "
                    "with the same stamps beside each other, such as with and without rail bending.")
    parser.add_argument("bag", nargs="+", help="one or two bags with answers, as contact_replay writes them")
    parser.add_argument("--out", required=True, metavar="F.gif", type=pathlib.Path, help="file to write")
    parser.add_argument("--label", action="append", default=[], help="title of a bag, once for each (default: its name)")
    parser.add_argument("--side", choices=SIDES, default="left")
    parser.add_argument("--frames", type=int, default=60, help="pictures, evenly spread over the answers (default: 60)")
    parser.add_argument("--rate", type=float, default=15, help="pictures per second [Hz] (default: 15)")
    parser.add_argument("--wheelset", metavar="NAME", help="namespace, if a bag holds more than one wheelset")
    return parser


def _check(options):
    rules = ((len(options.bag) <= 2, "at most two bags"),
             (len(options.label) in (0, len(options.bag)), "--label: once for each bag, or not at all"),
             (options.frames >= 1, f"--frames {options.frames}: must be at least 1"),
             (0 < options.rate <= 50, f"--rate {options.rate}: must be above 0 and at most 50"))
    for holds, fault in rules:
        if not holds:
            raise Failure(fault)


def _animate(options):
    _check(options)
    plot = pyplot()
    from .picture import Picture  # needs what pyplot() has found
    side = SIDES.index(options.side)
    labels = options.label or [pathlib.Path(bag).stem for bag in options.bag]
    runs = [read_run(bag, label, side, options.frames, options.wheelset) for bag, label in zip(options.bag, labels)]
    if any(list(run.stamp) != list(runs[0].stamp) for run in runs):
        raise Failure("the bags' stamps differ")
    picture = Picture(plot, runs, side)
    count = len(runs[0].stamp)
    write_gif(options.out, [picture.draw(k) for k in range(count)], options.rate)
    print(f"{options.out}: {count} pictures")


def main(arguments=None):
    """Run the command; returns its exit status."""
    return finish("contact_animation", _animate, _parser().parse_args(arguments))
