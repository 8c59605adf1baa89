# SPDX-License-Identifier: BSD-3-Clause
"""Summary for the README: median error against median and longest time, of wheelsets and of the normal problem alone."""
import math

from .front import longest_times, over_scenes
from .picture import METHODS, STYLE, grid_text, save, set_ticks, setting_label, share_labels

SIZE = (8.3, 5.15)  # [in]; a browser that shows the picture 830 px wide shows 9 pt as 12.5 px
EXACT = 0.002  # errors of Hertz's formula below this are those of the reference [-]
# Grids of conjugate gradients with a label: its offset [pt] and alignment.
LABELLED = {"8×16": ((-6, -7), "right"), "16×48": ((-6, -7), "right"), "48×128": ((-2, -9), "right")}


def draw(plot, rows, facts, paths):
    """Writes the picture of the warm rows to each path."""
    rows = [row for row in rows if row.start == "warm"]
    panels = ((wheelsets(rows), "Complete wheelset", "time per wheelset [ms]"),
              (general_gaps(rows), "Pressure of one wheel alone", "time per pressure calculation [ms]"))
    with plot.rc_context(STYLE):
        figure, places = plot.subplots(1, 2, sharex=True, sharey=True, figsize=SIZE)
        figure.subplots_adjust(left=0.075, right=0.99, top=0.87, bottom=0.24, wspace=0.04)
        points = []
        for axes, (group, title, xlabel) in zip(places, panels):
            axes.set_title(f"{title}: median of {len({row.scene for row in group})} scenes", fontsize=10)
            axes.set_xlabel(xlabel)
            points += _draw_panel(axes, medians(group))
        places[0].set_ylabel("error [%]")
        places[0].text(0.025, 0.03, "↙ faster and more accurate", transform=places[0].transAxes, color="0.35")
        _scale(places[0], points)
        figure.legend(*_legend(), loc="upper center", ncol=len(METHODS), frameon=False, borderaxespad=0.4,
                      columnspacing=1.2, handlelength=1.5, handletextpad=0.4)
        figure.text(0.012, 0.015, _note(facts), fontsize=8.5, color="0.25", va="bottom", linespacing=1.35)
        save(plot, figure, paths, dpi=200)


def wheelsets(rows):
    return [row for row in rows if row.kind == "wheelset"]


def general_gaps(rows):
    """The normal problems without those in which Hertz's formula is exact."""
    exact = {row.scene for row in rows if row.method == "hertz" and row.has_result and row.error < EXACT}
    return [row for row in rows if row.kind == "normal" and row.scene not in exact]


def medians(rows):
    """{method: [(time [ms], error [%], label, longest time [ms])]}, without the settings whose median error is infinite."""
    points = {}
    longest = longest_times(rows)
    for (method, setting), (time, error) in over_scenes(rows).items():
        if error < math.inf:
            points.setdefault(method, []).append((1e3 * time, 100 * error, setting_label(method, setting),
                                                  1e3 * longest[method, setting]))
    return points


def _draw_panel(axes, points):
    """Returns all points."""
    for place, (method, (_, colour, marker)) in enumerate(METHODS.items()):
        times, errors, _, longest = zip(*points[method]) if method in points else ((), (), (), ())
        auto = method == "auto"
        axes.hlines(errors, times, longest, color=colour, linewidth=1.6 if auto else 0.7, alpha=0.9 if auto else 0.6,
                    zorder=2 + 0.1 * place)
        axes.plot(longest, errors, color=colour, marker="|", markersize=9 if auto else 6, linestyle="none",
                  zorder=2 + 0.1 * place)
        axes.plot(times, errors, color=colour, marker=marker, markersize=13 if auto else 6, linewidth=1.2,
                  markeredgecolor="white", markeredgewidth=0.6, zorder=3 + place)
    axes.set(xscale="log", yscale="log")
    axes.grid(color="0.9")
    axes.set_axisbelow(True)
    for point in points.get("conjugate_gradient", []):
        if point[2] in LABELLED:
            _label(axes, "conjugate_gradient", point[2], point, *LABELLED[point[2]])
    for place, group in enumerate(share_labels(points.get("auto", []))):
        text = ", ".join(point[2] for point in group)
        end = max(point[3] for point in group), group[0][1]  # of the longest bar
        _label(axes, "auto", text if place else f"auto {text}", end, (5, 0), "left")
    return [point for series in points.values() for point in series]


def _label(axes, method, text, point, offset, alignment):
    from matplotlib.patheffects import withStroke
    axes.annotate(text, point[:2], offset, textcoords="offset points", ha=alignment, va="center",
                  color=METHODS[method][1], zorder=20, path_effects=[withStroke(linewidth=2.5, foreground="white")])


def _scale(axes, points):
    times, errors, _, longest = zip(*points)
    axes.set(xlim=(min(times) / 2, 2 * max(longest)), ylim=(min(errors) / 2, 2 * max(errors)))
    set_ticks(axes.xaxis, *axes.get_xlim())
    set_ticks(axes.yaxis, *axes.get_ylim())
    axes.minorticks_off()


def _legend():
    from matplotlib.lines import Line2D
    handles = [Line2D([], [], color=colour, marker=marker, markersize=11 if method == "auto" else 6)
               for method, (_, colour, marker) in reversed(METHODS.items())]
    return handles, [name for name, _, _ in reversed(METHODS.values())]


def _note(facts):
    return ("Error: largest relative error of peak pressure, area and approach, against a reference on "
            f"{grid_text(facts['truth'])} cells.\n"
            f"Time: CPU time of one thread on {facts['machine']}, warm start.\n"
            "Markers: medians; bars: to the longest time of a state in any scene. Labels: tolerance of auto (black), cells "
            "(blue).\n"
            "Not drawn: grids without a result in half or more of the scenes. Right: only where Hertz's formula is not exact.")
