# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_report."""
import pathlib

import numpy as np

from ..arguments import Parser
from ..command import finish, output_folder, pyplot, writing
from . import along_line, axle, errors, histories, page, positions, pressure, running_band, stress
from .loops import loop_of
from .results import read, read_full

WORST = 2  # number of instants with the highest pressures that are shown


def _parser():
    parser = Parser(
        description="Writes pictures of the results in a bag, and a page that contains them (report.html). The bag is "
                    "written by contact_replay or rosbag record.")
    parser.add_argument("bag", help="bag with results")
    parser.add_argument("--out", required=True, metavar="DIR", help="folder for page and pictures")
    parser.add_argument("--compare", metavar="BAG", help="results of another run, for example without rail bending")
    parser.add_argument("--wheelset", metavar="NAME", help="namespace, if the bag contains several wheelsets")
    parser.add_argument("--from", dest="begin", type=float, default=-np.inf, metavar="S",
                        help="first time that is read [s] (default: all)")
    parser.add_argument("--to", dest="end", type=float, default=np.inf, metavar="S", help="last time that is read [s]")
    parser.add_argument("--limits", metavar="YAML",
                        help="parameter file of contact_check; its limits of wheels and axle (group axle) are drawn and judged")
    parser.add_argument("--at", type=float, nargs="+", default=[], metavar="S",
                        help="times [s]; the pressure of the nearest results is shown")
    return parser


def chosen_results(results, instants):
    """Results whose pressure is shown: those nearest to the instants [s], and those with the highest pressures.

    @return title by index of the result
    """
    chosen = {int(np.argmin(np.abs(results.stamp - t))): "" for t in instants}
    pressure = results.patches["max_pressure"]
    for patch in np.argsort(-pressure, kind="stable"):
        if sum(title != "" for title in chosen.values()) == WORST:
            break
        index = int(results.patches["result"][patch])
        # Results close in time have similar pressures.
        near = any(abs(results.stamp[index] - results.stamp[other]) < 0.05 * np.ptp(results.stamp) for other in chosen
                   if chosen[other])
        if not near:
            chosen[index] = "high pressure, "
    return {index: f"{title}{_instant(results, index)}" for index, title in sorted(chosen.items())}


def _instant(results, index):
    """Time and position of a result."""
    looped = (np.diff(results.stamp) < 0).any()
    return (f"{results.stamp[index]:.3f} s" + (f" of loop {loop_of(results.stamp, index)}" if looped else "")
            + (f", x = {results.x[index]:.3f} m" if along_line.travels(results) else "") + f", y = {1e3 * results.y[index]:.2f} mm")


def make_report(options):
    """Writes page and pictures; prints the path of the page."""
    pyplot()  # reports a missing matplotlib before the work
    span = options.begin, options.end
    results, topic = read(options.bag, options.wheelset, span)
    other = read(options.compare, options.wheelset, span)[0] if options.compare else None
    limits = axle.read_limits(options.limits, topic) if options.limits else None
    out = pathlib.Path(options.out)
    output_folder(out)
    with writing(out):
        _write(out, options, results, topic, other, limits)
    print(out / "report.html")


def _write(out, options, results, topic, other, limits):
    picture, left_out = histories.histories(results, other, out / "histories.png")
    pictures = [("Histories", [picture, *([f"Zero throughout, and not drawn: {'; '.join(left_out)}."] if left_out else [])])]
    if limits:
        pictures.append(("Limits of wheels and axle", axle.items(results, limits, out / "limits.png")))
    if along_line.travels(results):
        pictures.append(("Along the line", along_line.figures(results, out)))
    if len(results.patches["result"]):
        sides = [side for side in (0, 1) if running_band.can_draw(results, side)]
        if sides:
            pictures.append(("Running band from above", [path for side in sides
                                                         for path in running_band.figures(results, side, out)]))
        pictures.append(("Contact positions on the profiles", [positions.figure(results, out / "bands.png")]))
        pictures += _of_instants(out, options, results, topic)
        pictures.append(("Estimated errors", [errors.figure(results, out / "errors.png")]))
    page.write(out / "report.html", f"{pathlib.Path(options.bag).name}, {topic}", results, pictures,
               pathlib.Path(options.compare).name if options.compare else None)


def _of_instants(out, options, results, topic):
    """Pictures of single results: the pressure, and the stress if it was computed."""
    titles, worst = chosen_results(results, options.at), stress.worst_patches(results)
    of_stress = {int(results.patches["result"][patch]) for patch in worst.values()}
    messages = read_full(options.bag, topic, {*titles, *of_stress}, (options.begin, options.end))
    pressures = [pressure.figure(messages[index], title, out / f"pressure_{index}.png")
                 if any(patch.grid.nx for patch in messages[index].patches) else
                 f"{title}: no pressure ({messages[index].status_text or 'the bag contains no grids'})"
                 for index, title in titles.items()]
    stresses = stress.items(results, worst, messages, lambda index: _instant(results, index), out)
    return [("Pressure", pressures), *([("Highest stress beneath the surface", stresses)] if stresses else [])]


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("contact_report", make_report, _parser().parse_args(arguments))
