# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_animation."""
import pathlib

from ..arguments import Parser
from ..command import Failure, finish, pyplot
from ..message_constants import SIDES
from .gif import write_gif
from .run import read_run


def _parser():
    parser = Parser(
        description="Draws one side of the results in a bag as an animated GIF: section, pressure and histories. Two bags "
                    "with the same stamps are drawn side by side, for example with and without rail bending.")
    parser.add_argument("bag", nargs="+", help="one or two bags with results, written by contact_replay")
    parser.add_argument("--out", required=True, metavar="F.gif", type=pathlib.Path, help="file to write")
    parser.add_argument("--label", action="append", default=[], help="title of a bag, once per bag (default: its name)")
    parser.add_argument("--side", choices=SIDES, default="left", help="side to draw (default: left)")
    parser.add_argument("--frames", type=int, default=60,
                        help="number of pictures, evenly spaced over the results (default: 60)")
    parser.add_argument("--rate", type=float, default=15, help="pictures per second [Hz] (default: 15)")
    parser.add_argument("--wheelset", metavar="NAME", help="namespace, if a bag contains several wheelsets")
    return parser


def _check(options):
    rules = ((len(options.bag) <= 2, f"{len(options.bag)} bags: must be at most two"),
             (len(options.label) in (0, len(options.bag)), "--label: must be given once per bag, or not at all"),
             (options.frames >= 1, f"--frames {options.frames}: must be at least 1"),
             (0 < options.rate <= 50, f"--rate {options.rate}: must be above 0 and at most 50"))
    for satisfied, message in rules:
        if not satisfied:
            raise Failure(message)


def _animate(options):
    _check(options)
    plot = pyplot()
    from .picture import Picture  # requires matplotlib, which pyplot() has checked
    side = SIDES.index(options.side)
    labels = options.label or [pathlib.Path(bag).stem for bag in options.bag]
    runs = [read_run(bag, label, side, options.frames, options.wheelset) for bag, label in zip(options.bag, labels)]
    if any(list(run.stamp) != list(runs[0].stamp) for run in runs):
        raise Failure("the stamps of the two bags differ")
    picture = Picture(plot, runs, side)
    count = len(runs[0].stamp)
    write_gif(options.out, [picture.draw(k) for k in range(count)], options.rate)
    print(f"{options.out}: {count} pictures")


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("contact_animation", _animate, _parser().parse_args(arguments))
