# SPDX-License-Identifier: BSD-3-Clause
"""Error against time in every scene, and the medians of all scenes and of the wheelsets."""
import math
from dataclasses import dataclass

from .front import longest_times, over_scenes, pareto
from .picture import METHODS, STYLE, grid_text, save, set_ticks, setting_label, share_labels

FAILURES = {"refused": ("x", "refused"), "other_wheels": ("+", "other wheels"),
            "not_run": (">", "not run: too slow")}
FRONT = "#F0E442"
COLUMNS = 4
LABELLED = {"8×16", "16×32", "24×64", "48×128"}


@dataclass(frozen=True)
class Frame:
    """Limits of a panel and sizes of its parts."""

    times: tuple  # [ms]
    errors: tuple  # [%]
    top: float  # upper end of the band for missing results, which begins at errors[1] [%]
    marker: float  # size [pt]
    title: float  # font size [pt]
    labels: bool


LARGE = Frame((1e-3, 3e3), (0.01, 150.0), 1.5e3, 8, 11, True)
SMALL = Frame((3e-4, 3e3), (2e-3, 150.0), 6e3, 5, 9, False)


@dataclass
class Point:
    """One marker. Without a result the error is None, and `failure` is its kind."""

    time: float  # [ms]
    longest: float  # time of a state of the sweep, at least `time` [ms]
    error: float  # [%]
    failure: str
    label: str = ""


def draw(plot, rows, facts, paths):
    """Writes the picture of the warm rows to each path."""
    rows = [row for row in rows if row.start == "warm"]
    scenes = list(dict.fromkeys(row.scene for row in rows))
    lines = len(scenes) // COLUMNS + 1  # the last one has room for the legend
    with plot.rc_context(STYLE):
        figure = plot.figure(figsize=(14, 6.2 + 3.2 * lines))
        grid = figure.add_gridspec(2, 1, height_ratios=[1.75, lines], hspace=0.14, left=0.05, right=0.985, top=0.97,
                                   bottom=0.085)
        _draw_top(figure, grid[0].subgridspec(1, 2, wspace=0.1), rows)
        places = grid[1].subgridspec(lines, COLUMNS, hspace=0.34, wspace=0.17)
        for place, scene in enumerate(scenes):
            axes = figure.add_subplot(places[place // COLUMNS, place % COLUMNS])
            _draw_scene(axes, [row for row in rows if row.scene == scene])
            axes.set(xlabel="time per evaluation [ms]" if place >= len(scenes) - COLUMNS else "",
                     ylabel="error [%]" if place % COLUMNS == 0 else "")
        _draw_legend(figure.add_subplot(places[-1, len(scenes) % COLUMNS:]), rows)
        figure.text(0.05, 0.012, _origin(facts), fontsize=9, color="0.25", va="bottom", linespacing=1.5)
        save(plot, figure, paths, dpi=100)


def _draw_top(figure, places, rows):
    wheelsets = [row for row in rows if row.kind == "wheelset"]
    for place, shown, title in ((0, rows, "All scenes: median error against median time"),
                                (1, wheelsets, "Wheelsets alone, complete calculation: medians")):
        axes = figure.add_subplot(places[place])
        _draw_panel(axes, _median_points(shown), title, LARGE)
        axes.set(xlabel="time per evaluation [ms]", ylabel="error [%]" if place == 0 else "")


def _origin(facts):
    return (f"{facts['machine']}; {facts['compiler']}, {facts['build']}; wheel_rail_contact {facts['version']}.\n"
            "Time: CPU time of one thread for one evaluation, warm start; markers: median of steps of 0.05 mm, bars: to the "
            "longest time of a state of a sweep.\n"
            f"Error: largest relative error of peak pressure, area and approach up to {facts['reach']} to either side, "
            f"against conjugate gradients on {grid_text(facts['truth'])} cells (reference). Hatched: error of the "
            "reference.\n"
            "Wheelset: both wheels; search, gap and balance included. Normal problem: pressure of one wheel alone. "
            "In the medians, a missing result counts as the largest error.")


def _draw_scene(axes, rows):
    kind = "wheelset" if rows[0].kind == "wheelset" else "normal problem"
    points = {}
    for row in rows:
        points.setdefault(row.method, []).append(
            Point(1e3 * row.time, 1e3 * max(row.time, row.time_longest or 0),
                  100 * row.error if row.has_result else None, row.status))
    _draw_panel(axes, points, f"{rows[0].title} ({kind})", SMALL)
    floor = SMALL.errors[0]
    axes.axhspan(floor, max(100 * rows[0].truth_error, floor), facecolor="none", edgecolor="0.75", hatch="////",
                 linewidth=0)


def _median_points(rows):
    points = {}
    longest = longest_times(rows)
    for (method, setting), (time, error) in over_scenes(rows).items():
        failed = math.isinf(error)
        statuses = [row.status for row in rows
                    if row.method == method and row.setting == setting and not row.has_result]
        time, error = 1e3 * time, None if failed else 100 * error
        failure = max(statuses, key=statuses.count) if failed else ""
        points.setdefault(method, []).append(
            Point(time, 1e3 * longest[method, setting], error, failure, setting_label(method, setting)))
    return points


def _draw_panel(axes, points, title, frame):
    axes.set(xscale="log", yscale="log", xlim=frame.times, ylim=(frame.errors[0], frame.top))
    axes.set_title(title, fontsize=frame.title)
    set_ticks(axes.yaxis, *frame.errors)
    set_ticks(axes.xaxis, *frame.times)
    axes.minorticks_off()
    axes.grid(color="0.92", zorder=0)
    axes.axhspan(frame.errors[1], frame.top, color="0.93", zorder=0)
    axes.text(frame.times[0] * 1.25, frame.top / 1.25, "no result", color="0.4", fontsize=8, va="top")
    axes.axvline(1, color="0.35", linestyle="--", linewidth=1, zorder=1)
    axes.text(1.1, frame.errors[0] * 1.15, "1 ms", color="0.35", fontsize=8, va="bottom")
    _draw_front(axes, points, frame)
    for place, method in enumerate(METHODS):
        _draw_results(axes, method, [point for point in points.get(method, []) if point.error is not None], frame)
        failures = [point for point in points.get(method, []) if point.error is None]
        _draw_failures(axes, method, failures, (place + 0.7) / (len(METHODS) + 0.4), frame)


def _draw_front(axes, points, frame):
    """Steps along the Pareto front of the fixed methods."""
    best = pareto((point.time, max(point.error, frame.errors[0])) for method, group in points.items()
                  if method != "auto" for point in group if point.error is not None)
    if best:
        times, errors = zip(*best)
        axes.step([times[0], *times, frame.times[1]], [frame.errors[1], *errors, errors[-1]], where="post",
                  color=FRONT, linewidth=6, alpha=0.75, zorder=2, solid_capstyle="butt")


def _draw_results(axes, method, points, frame):
    if not points:
        return
    _, colour, marker = METHODS[method]
    times = [point.time for point in points]
    errors = [min(max(point.error, frame.errors[0]), frame.errors[1]) for point in points]
    axes.errorbar(times, errors, xerr=[[0] * len(points), [point.longest - point.time for point in points]],
                  color=colour, marker=marker, linewidth=0.8, elinewidth=0.7, capsize=0.3 * frame.marker,
                  markersize=frame.marker * (1.6 if method == "auto" else 1), markeredgecolor="white",
                  markeredgewidth=0.5, zorder=5 if method == "auto" else 4)
    if frame.labels and method in ("auto", "conjugate_gradient"):
        _label(axes, method, points)


def _draw_failures(axes, method, points, height, frame):
    """In the upper band, each method at its own height."""
    level = frame.errors[1] * (frame.top / frame.errors[1]) ** height
    for point in points:
        axes.plot(min(point.time, frame.times[1] / 1.5), level, color=METHODS[method][1],
                  marker=FAILURES[point.failure][0], markersize=0.8 * frame.marker, linestyle="none", zorder=4)


def _label(axes, method, points):
    """Tolerances of auto to the left, some grids of conjugate gradients to the right."""
    from matplotlib.patheffects import withStroke
    points = [(point.time, point.error, point.label) for point in points]
    groups = (share_labels(points) if method == "auto"
              else [[point] for point in points if point[2] in LABELLED])
    left = method == "auto"
    rim = [withStroke(linewidth=2.5, foreground="white")]
    for group in groups:
        axes.annotate(", ".join(label for _, _, label in group), group[0][:2],
                      (-9, -7) if left else (8, 7), textcoords="offset points", ha="right" if left else "left",
                      va="center", fontsize=8.5, color=METHODS[method][1], zorder=6, path_effects=rim)


def _draw_legend(axes, rows):
    """In axes of its own: methods with their numbers of missing results, kinds of failure, the front."""
    from matplotlib.lines import Line2D
    axes.axis("off")
    grids = {row.setting for row in rows if row.method == "conjugate_gradient"}
    handles = []
    for method, (name, colour, marker) in METHODS.items():
        own = [row for row in rows if row.method == method]
        failed = sum(not row.has_result for row in own)
        handles.append(Line2D([], [], color=colour, marker=marker, markersize=12 if method == "auto" else 8,
                              label=name + (f"\n(no result: {failed} of {len(own)})" if failed else "")))
    for marker, name in FAILURES.values():
        handles.append(Line2D([], [], color="0.3", marker=marker, linestyle="none", markersize=7, label=name))
    handles.append(Line2D([], [], color=FRONT, linewidth=6, alpha=0.75,
                          label="best of the fixed\nmethods (Pareto front)"))
    legend = axes.legend(handles=handles, loc="upper left", frameon=False, fontsize=8, labelspacing=0.6, borderaxespad=0,
                         ncol=2, columnspacing=1, handlelength=1.2, title_fontsize=8, bbox_to_anchor=(-0.1, 1),
                         title=f"Methods on {len(grids)} grids, 8×16 to 64×192;\nauto at 10, 3, 1 and 0.3 %")
    legend.get_children()[0].align = "left"  # the argument `alignment` is newer than the oldest supported matplotlib
