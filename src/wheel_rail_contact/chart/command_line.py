# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_chart."""
import itertools
from pathlib import Path

from ..arguments import Parser
from ..command import finish, output_folder, pyplot
from ..core.extension import core
from ..progress import Progress
from . import creep, creep_picture, scenes_picture, summary_picture, table
from .front import compare_auto, compare_medians, over_scenes
from .measuring import QUICK, Plan, compare
from .picture import METHODS
from .scenes import all_choices, all_scenes


def main(arguments=None):
    """Run the command; returns its exit status."""
    return finish("contact_chart", _run, _parser().parse_args(arguments))


def _run(options):
    plot = pyplot()
    output_folder(options.out)
    plan = QUICK if options.quick else Plan()
    rows = measure(plan)
    facts = {"machine": table.machine(), **core.BUILD, **plan.facts}
    table.write(options.out / "chart.csv", facts, rows)
    draw(plot, rows, facts, options.out)
    _report(rows)
    _compare_creep(plot, facts, creep.QUICK if options.quick else creep.FULL, options.out)
    print(f"wrote chart.csv, chart_creep.csv, chart.png, chart_scenes.png and chart_creep.png, and the pictures as .svg, to "
          f"{options.out}")


def measure(plan):
    """Rows of all methods on all scenes; draws the progress."""
    scenes, choices = all_scenes(), all_choices()
    progress, done = Progress(), itertools.count(1)
    try:
        return [row for scene in scenes
                for row in compare(scene, choices, plan, lambda title: progress(next(done), len(scenes) * plan.steps, title))]
    finally:
        progress.end()


def draw(plot, rows, facts, folder):
    """Writes both pictures, each as PNG and SVG."""
    for picture, name in ((summary_picture, "chart"), (scenes_picture, "chart_scenes")):
        picture.draw(plot, rows, facts, [folder / f"{name}.png", folder / f"{name}.svg"])


def _compare_creep(plot, facts, extent, folder):
    """Measures the methods for creep forces; writes their table and picture, and prints the table of doc/methods.md."""
    progress, done = Progress(), itertools.count(1)
    try:
        rows = creep.measure(extent, lambda title: progress(next(done), len(creep.RATIOS), title))
    finally:
        progress.end()
    facts = {**facts, "creep_truth": f"{extent.truth[0]} x {extent.truth[1]}"}
    table.write(folder / "chart_creep.csv", facts, rows)
    creep_picture.draw(plot, rows, facts, [folder / "chart_creep.png", folder / "chart_creep.svg"])
    print("Creep forces: median time; median and largest error, and that of the force alone, without and with spin\n"
          "| method | cells | time [µs] | no spin [%] | spin [%] |\n|---|---|---|---|---|")
    for setting, (time, *errors) in creep.summary(rows, False).items():
        texts = [" / ".join(f"{100 * error:.2g}" for error in each) for each in (errors, creep.summary(rows, True)[setting][1:])]
        method, (along, across) = setting
        print(f"| `{method}` | {along} × {across} | {1e6 * time:.2g} | {' | '.join(texts)} |")


def _report(rows):
    """Prints the tables and figures of doc/methods.md."""
    cold, rows = ([row for row in rows if row.start == start] for start in ("cold", "warm"))
    tolerances = sorted({row.tolerance for row in rows if row.method == "auto"}, reverse=True)
    print("Median time / longest time of a state [ms], and error [%]")
    print(f"| scene |{''.join(f' {100 * tolerance:g} % |' for tolerance in tolerances)}\n|---|{'---|' * len(tolerances)}")
    for scene in dict.fromkeys(row.scene for row in rows):
        own = {row.tolerance: row for row in rows if row.scene == scene and row.method == "auto"}
        print(f"| {own[tolerances[0]].title} |{''.join(f' {_values(own[tolerance])} |' for tolerance in tolerances)}")
    print("Time over that of the cheapest fixed method that meets the tolerance; met: scenes whose error is within it")
    print("| scenes | tolerance | met | median, largest | on or left of the front |\n|---|---|---|---|---|")
    groups = {"wheelsets": summary_picture.wheelsets(rows), "normal problems": summary_picture.general_gaps(rows)}
    for name, group in groups.items():
        for place, found in enumerate(compare_auto(group)):
            print(f"| {'' if place else name} | {100 * found.tolerance:g} % | {found.met} of {found.scenes} |"
                  f" {found.ratio:.2f}, {found.largest_ratio:.2f} | {found.on_front} of {found.scenes} |")
    for name, group in {"all scenes": rows, **groups}.items():
        factors = [f"{100 * tolerance:g} %: {factor:.2f}" for tolerance, factor in compare_medians(group)]
        print(f"Medians over {name}, time over that of the cheapest fixed method of the same accuracy: {', '.join(factors)}")
    for method in METHODS:
        for name, group in groups.items():
            own = [row for row in group if row.method == method]
            errors = [100 * row.error for row in own if row.has_result]
            print(f"{method}, {name}: errors {min(errors):.2g} to {max(errors):.2g} %, {len(errors)} of {len(own)} with a result")
    times = over_scenes(row for row in summary_picture.wheelsets(cold) if row.method == "auto")
    print("Cold starts of wheelsets: " + ", ".join(f"{100 * tolerance:g} %: {1e3 * times['auto', tolerance][0]:.2g} ms"
                                                   for tolerance in tolerances))


def _values(row):
    error = f"{100 * row.error:.2g}" if row.has_result else row.status
    return f"{1e3 * row.time:.2g} / {1e3 * row.time_longest:.2g}, {error}"


def _parser():
    parser = Parser(
        prog="contact_chart", description="Runs every method on every grid over fifteen scenes and draws error against "
        "time: chart.png summarises the scenes, chart_scenes.png has a panel for each scene, chart_creep.png compares the "
        "methods for creep forces. Also writes the pictures as .svg and all values to chart.csv and chart_creep.csv, and prints "
        "the tables of doc/methods.md. Takes about four minutes.")
    parser.add_argument("--out", type=Path, default=Path("."), metavar="DIR",
                        help="folder for the files (default: the current one)")
    parser.add_argument("--quick", action="store_true",
                        help="fewer repetitions, no slow grids, a coarser reference solution; a fifth of the time")
    return parser
