# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the methods for creep forces: error against time without and with spin."""
from . import creep
from .picture import STYLE, grid_text, save, set_ticks, setting_label

METHODS = {"linear": ("linear law with saturation", "#E69F00", "o"), "fastsim": ("FASTSIM", "#D55E00", "s"),
           "exact": ("complete theory (exact)", "#0072B2", "D")}
SIZE = (8.3, 4.9)  # [in]; as the picture of the normal methods
PERCENT, MICROSECONDS = 100, 1e6


def draw(plot, rows, facts, paths):
    """Writes the picture to each path."""
    truth_error = PERCENT * max(row.truth_error for row in rows)
    with plot.rc_context(STYLE):
        figure, places = plot.subplots(1, 2, sharex=True, sharey=True, figsize=SIZE)
        figure.subplots_adjust(left=0.075, right=0.99, top=0.87, bottom=0.24, wspace=0.04)
        for axes, spin in zip(places, (False, True)):
            number = len({(row.a_over_b, row.creepage_x, row.creepage_y, row.spin) for row in rows if (row.spin != 0) == spin})
            axes.set_title(f"{'With' if spin else 'Without'} spin: {number} states", fontsize=10)
            axes.set_xlabel("time per patch [µs]")
            axes.axhspan(1e-9, truth_error, color="0.93", zorder=0)
            _draw_panel(axes, creep.summary(rows, spin))
        places[0].set_ylabel("error [%]")
        places[0].text(0.02, truth_error, " estimated error of the reference", color="0.35", va="top",
                       transform=places[0].get_yaxis_transform())
        _scale(places[0], [creep.summary(rows, spin) for spin in (False, True)])
        handles, names = places[0].get_legend_handles_labels()
        figure.legend(handles, names, loc="upper center", ncol=len(METHODS), frameon=False, borderaxespad=0.4)
        figure.text(0.012, 0.015, _note(facts), fontsize=8.5, color="0.25", va="bottom", linespacing=1.35)
        save(plot, figure, paths, dpi=200)


def _draw_panel(axes, points):
    for method, (name, colour, marker) in METHODS.items():
        own = {grid: point for (other, grid), point in points.items() if other == method}
        times, errors, largest = zip(*((MICROSECONDS * time, PERCENT * error, PERCENT * worst)
                                       for time, error, worst, _ in own.values()))
        axes.vlines(times, errors, largest, color=colour, linewidth=0.9, alpha=0.7)
        axes.plot(times, largest, color=colour, marker="_", markersize=9, linestyle="none")
        axes.plot(times, errors, color=colour, marker=marker, markersize=6, linewidth=1.2, markeredgecolor="white",
                  markeredgewidth=0.6, zorder=3, label=name)
        for grid, time, error in zip(own, times, errors):
            if method == "exact":
                axes.annotate(setting_label(method, grid), (time, error), (-6, -6), textcoords="offset points", ha="right",
                              va="center", color=colour, fontsize=8)
    axes.set(xscale="log", yscale="log")
    axes.grid(color="0.9")
    axes.set_axisbelow(True)


def _scale(axes, panels):
    times, errors, largest, _ = zip(*(point for points in panels for point in points.values()))
    axes.set(xlim=(MICROSECONDS * min(times) / 2, MICROSECONDS * max(times) * 2),
             ylim=(PERCENT * min(errors) / 2, PERCENT * max(largest) * 2))
    set_ticks(axes.xaxis, *axes.get_xlim())
    set_ticks(axes.yaxis, *axes.get_ylim())
    axes.minorticks_off()


def _note(facts):
    return ("Error: of the force over µN or of the moment over µN √(ab), whichever is larger, against the complete theory on "
            f"{grid_text(facts['creep_truth'])} cells.\n"
            f"Time: CPU time of one thread on {facts['machine']}, cold start, pressure given.\n"
            "Markers: medians; bars: to the largest error. Labels: cells of the complete theory; FASTSIM has the same, the "
            "linear law none.\n"
            "States: ellipses with a/b from 0.2 to 5, below, near and above saturation.")
