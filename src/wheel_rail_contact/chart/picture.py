# SPDX-License-Identifier: BSD-3-Clause
"""Draws error against time: a large panel over all scenes, and one for each."""
import math
from dataclasses import dataclass

from .front import over_scenes, pareto

# Colours that people with any colour vision can tell apart (Okabe and Ito 2008), and a marker for each.
METHODS = {
    "hertz": ("Hertz", "#E69F00", "o"),
    "kik_piotrowski": ("Kik–Piotrowski", "#56B4E9", "s"),
    "seidel_printed": ("Seidel, as printed", "#CC79A7", "v"),
    "seidel": ("Seidel, repaired", "#D55E00", "^"),
    "conjugate_gradient": ("conjugate gradients", "#0072B2", "D"),
    "auto": ("auto", "black", "*"),
}
FAILURES = {"refused": ("x", "refused"), "other_patches": ("+", "other patches found"),
            "not_run": (">", "not run: too slow")}
FRONT = "#F0E442"
COLUMNS = 4
LABELLED = {"8×16", "16×32", "24×56", "64×128"}


@dataclass(frozen=True)
class Frame:
    """What a panel shows, and how large."""

    times: tuple  # [ms]
    errors: tuple  # [%]
    top: float  # end of the band above the errors, for what has none [%]
    marker: float
    title: float
    labels: bool


LARGE = Frame((2e-3, 3e3), (0.02, 150.0), 1.5e3, 8, 11, True)
SMALL = Frame((3e-4, 3e3), (2e-3, 150.0), 6e3, 5, 9, False)


@dataclass
class Point:
    """One marker: time [ms] with quartiles, error [%] or None with the kind of failure."""

    time: float
    quartiles: tuple
    error: float
    failure: str
    label: str = ""


def draw(plot, rows, facts, paths):
    """Writes the picture of the warm rows to each path."""
    rows = [row for row in rows if row.start == "warm"]
    scenes = list(dict.fromkeys(row.scene for row in rows))
    lines = math.ceil(len(scenes) / COLUMNS)
    with plot.rc_context({"font.size": 9, "svg.hashsalt": "chart", "svg.fonttype": "none"}):
        figure = plot.figure(figsize=(14, 6.2 + 3.2 * lines))
        grid = figure.add_gridspec(2, 1, height_ratios=[1.75, lines], hspace=0.14, left=0.05, right=0.985, top=0.97,
                                   bottom=0.085)
        _draw_top(figure, grid[0].subgridspec(1, 3, width_ratios=[2, 2, 1.05], wspace=0.14), rows)
        places = grid[1].subgridspec(lines, COLUMNS, hspace=0.34, wspace=0.17)
        for place, scene in enumerate(scenes):
            axes = figure.add_subplot(places[place // COLUMNS, place % COLUMNS])
            _draw_scene(axes, [row for row in rows if row.scene == scene])
            axes.set(xlabel="time of an answer [ms]" if place >= len(scenes) - COLUMNS else "",
                     ylabel="error [%]" if place % COLUMNS == 0 else "")
        figure.text(0.05, 0.012, _origin(facts), fontsize=9, color="0.25", va="bottom", linespacing=1.5)
        for path in paths:
            figure.savefig(path, dpi=100, metadata={"Date": None} if path.suffix == ".svg" else None)
        plot.close(figure)


def _draw_top(figure, places, rows):
    wheelsets = [row for row in rows if row.kind == "wheelset"]
    for place, shown, title in ((0, rows, "All scenes: median error against median time"),
                                (1, wheelsets, "Wheelsets alone, everything included: medians")):
        axes = figure.add_subplot(places[place])
        _draw_panel(axes, _median_points(shown), title, LARGE)
        axes.set(xlabel="time of an answer [ms]", ylabel="error [%]" if place == 0 else "")
    _draw_legend(figure.add_subplot(places[2]), rows)


def _origin(facts):
    return (f"{facts['machine']}; {facts['compiler']}, {facts['build']}; wheel_rail_contact {facts['version']}. Time: "
            "CPU time of one thread for an answer, starting from the one 0.05 mm before; markers: medians, bars: "
            "quartiles.\nError: largest relative error of highest pressure, area and approach on the way, "
            f"{facts['reach']} to either side, against conjugate gradients on {facts['truth'].replace('x', '×')} cells, "
            "whose own error is hatched.\n"
            "Wheelset: both wheels, search, gap and balance included. Normal problem: pressure under one wheel alone. "
            "In the medians, no answer counts as the largest error.")


def _draw_scene(axes, rows):
    kind = "wheelset" if rows[0].kind == "wheelset" else "normal problem"
    points = {}
    for row in rows:
        points.setdefault(row.method, []).append(
            Point(1e3 * row.time, (1e3 * row.time_quartile_1, 1e3 * row.time_quartile_3),
                  100 * row.error if row.answered else None, row.status))
    _draw_panel(axes, points, f"{rows[0].title} ({kind})", SMALL)
    floor = SMALL.errors[0]
    axes.axhspan(floor, max(100 * rows[0].truth_error, floor), facecolor="none", edgecolor="0.75", hatch="////",
                 linewidth=0)


def _median_points(rows):
    points = {}
    for (method, rung), (time, error, _, _) in over_scenes(rows).items():
        label = f"{100 * rung:g} %" if method == "auto" else f"{rung[0]}×{rung[1]}"
        failed = math.isinf(error)
        statuses = [row.status for row in rows if row.method == method and row.rung == rung and not row.answered]
        time, error = 1e3 * time, None if failed else 100 * error
        failure = max(statuses, key=statuses.count) if failed else ""
        points.setdefault(method, []).append(Point(time, (time, time), error, failure, label))
    return points


def _draw_panel(axes, points, title, frame):
    axes.set(xscale="log", yscale="log", xlim=frame.times, ylim=(frame.errors[0], frame.top))
    axes.set_title(title, fontsize=frame.title)
    axes.set_yticks(*_ticks(*frame.errors))
    axes.set_xticks(*_ticks(*frame.times))
    axes.minorticks_off()
    axes.grid(color="0.92", zorder=0)
    axes.axhspan(frame.errors[1], frame.top, color="0.93", zorder=0)
    axes.text(frame.times[0] * 1.25, frame.top / 1.25, "no answer", color="0.4", fontsize=8, va="top")
    axes.axvline(1, color="0.35", linestyle="--", linewidth=1, zorder=1)
    axes.text(1.1, frame.errors[0] * 1.15, "1 ms", color="0.35", fontsize=8, va="bottom")
    _draw_front(axes, points, frame)
    for place, method in enumerate(METHODS):
        _draw_answers(axes, method, [point for point in points.get(method, []) if point.error is not None], frame)
        failures = [point for point in points.get(method, []) if point.error is None]
        _draw_failures(axes, method, failures, (place + 0.7) / (len(METHODS) + 0.4), frame)


def _ticks(low, high):
    powers = [10.0 ** n for n in range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)]
    return powers, [f"{power:g}" for power in powers]


def _draw_front(axes, points, frame):
    """Steps along the best of the fixed methods."""
    best = pareto((point.time, max(point.error, frame.errors[0])) for method, group in points.items()
                  if method != "auto" for point in group if point.error is not None)
    if best:
        times, errors = zip(*best)
        axes.step([times[0], *times, frame.times[1]], [frame.errors[1], *errors, errors[-1]], where="post",
                  color=FRONT, linewidth=6, alpha=0.75, zorder=2, solid_capstyle="butt")


def _draw_answers(axes, method, points, frame):
    if not points:
        return
    _, colour, marker = METHODS[method]
    times = [point.time for point in points]
    errors = [min(max(point.error, frame.errors[0]), frame.errors[1]) for point in points]
    spread = [[point.time - point.quartiles[0] for point in points],
              [point.quartiles[1] - point.time for point in points]]
    axes.errorbar(times, errors, xerr=spread, color=colour, marker=marker, linewidth=0.8, elinewidth=1,
                  markersize=frame.marker * (1.6 if method == "auto" else 1), markeredgecolor="white",
                  markeredgewidth=0.5, zorder=5 if method == "auto" else 4)
    if frame.labels and method in ("auto", "conjugate_gradient"):
        _label(axes, method, points)


def _draw_failures(axes, method, points, share, frame):
    """In the band, each method on a level of its own."""
    level = frame.errors[1] * (frame.top / frame.errors[1]) ** share
    for point in points:
        axes.plot(min(point.time, frame.times[1] / 1.5), level, color=METHODS[method][1],
                  marker=FAILURES[point.failure][0], markersize=0.8 * frame.marker, linestyle="none", zorder=4)


def _label(axes, method, points):
    """Tolerances of auto to the left, some grids of conjugate gradients to the right; points on one spot share a
    label."""
    from matplotlib.patheffects import withStroke
    groups = []
    for point in points:
        last = groups[-1][-1] if groups else None
        if last and abs(math.log(point.time / last.time)) < 0.15 and abs(math.log(point.error / last.error)) < 0.3:
            groups[-1].append(point)
        else:
            groups.append([point])
    if method == "conjugate_gradient":
        groups = [[point] for point in points if point.label in LABELLED]
    left = method == "auto"
    rim = [withStroke(linewidth=2.5, foreground="white")]
    for group in groups:
        axes.annotate(", ".join(point.label for point in group), (group[0].time, group[0].error),
                      (-9, -7) if left else (8, 5), textcoords="offset points", ha="right" if left else "left",
                      va="center", fontsize=8.5, color=METHODS[method][1], zorder=6, path_effects=rim)


def _draw_legend(axes, rows):
    """In a place of its own: methods with what they left unanswered, kinds of failure, the front."""
    from matplotlib.lines import Line2D
    axes.axis("off")
    grids = {row.rung for row in rows if row.method == "conjugate_gradient"}
    handles = []
    for method, (name, colour, marker) in METHODS.items():
        own = [row for row in rows if row.method == method]
        failed = sum(not row.answered for row in own)
        handles.append(Line2D([], [], color=colour, marker=marker, markersize=12 if method == "auto" else 8,
                              label=name + (f"\n(no answer: {failed} of {len(own)})" if failed else "")))
    for marker, name in FAILURES.values():
        handles.append(Line2D([], [], color="0.3", marker=marker, linestyle="none", markersize=7, label=name))
    handles.append(Line2D([], [], color=FRONT, linewidth=6, alpha=0.75,
                          label="best of the fixed methods\n(Pareto front)"))
    axes.legend(handles=handles, loc="upper left", frameon=False, fontsize=9.5, labelspacing=0.8, borderaxespad=0,
                title=f"Methods on {len(grids)} grids,\n8×16 to 64×128; auto at\n10, 3, 1 and 0.3 %", title_fontsize=9.5,
                alignment="left")
