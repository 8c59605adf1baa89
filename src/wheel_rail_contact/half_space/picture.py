# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the study: model error beside the numerical error, and pressures across the track."""
import numpy as np

from ..chart.front import over_scenes
from ..chart.picture import set_ticks
from ..csv_table import CsvTable
from ..paper.colours import BLACK, BLUE, ORANGE, RED
from .places import PLACES

STYLE = {"font.size": 9}
COLOURS = {"planar": ORANGE, "curved": BLUE, "turned": BLACK}
NAMES = {"planar": "one plane", "curved": "curved surface", "turned": "curved surface, turned normals"}
LIMITS = (0.01, 30)  # of the errors [%]
TITLES = {place.name: place.title for place in PLACES}


def draw_errors(plot, path, rows, chart_rows):
    """Model error over half_space_ratio, beside the numerical error of the method `auto` over its time.

    @param rows        Comparisons
    @param chart_rows  numerical_errors(); none: without the second panel
    """
    with plot.rc_context(STYLE):
        figure, axes = plot.subplots(1, 2 if chart_rows else 1, figsize=(8.3 if chart_rows else 5, 4), squeeze=False,
                                     sharey=True)
        _draw_model_errors(axes[0, 0], rows)
        if chart_rows:
            _draw_numerical_errors(axes[0, 1], chart_rows)
        figure.tight_layout()
        figure.savefig(path, dpi=150)
        plot.close(figure)


def numerical_errors(chart_rows):
    """Rows of the table of contact_chart that are drawn: `auto` for wheelsets, started from the previous result."""
    return [row for row in chart_rows if row.start == "warm" and row.kind == "wheelset" and row.method == "auto"]


def _draw_model_errors(axes, rows):
    for name, colour in COLOURS.items():
        for kept_out in (False, True):
            points = [(row.ratio, 100 * row.error(name)) for row in rows if row.kept_out == kept_out]
            if points:
                axes.plot(*zip(*points), linestyle="none", marker="o", markersize=5, color=colour,
                          markerfacecolor="none" if kept_out else colour,
                          label=None if kept_out else NAMES[name])
    for model, style in (("turned", "-"), ("curved", ":")):
        points = sorted((row.ratio, 100 * row.stated) for row in rows if row.package == model)
        if points:
            axes.plot(*zip(*points), color=RED, linestyle=style, linewidth=1.2, label="model_error (dotted: parallel normals)" if model == "turned" else None)
    axes.set(yscale="log", xlabel="half_space_ratio [rad]", ylabel="error of maximum pressure or area [%]", ylim=LIMITS,
             title="Model error (open: kept out)")
    set_ticks(axes.yaxis, *LIMITS)
    axes.grid(color="0.9")
    axes.legend(frameon=True, fontsize=8, loc="lower right")


def _draw_numerical_errors(axes, rows):
    points = sorted(over_scenes(rows).items(), key=lambda item: item[1])
    times, errors = zip(*[(1e3 * time, 100 * error) for _, (time, error) in points])
    axes.plot(times, errors, color=BLACK, marker="*", markersize=10)
    for (_, tolerance), (time, error) in points:
        axes.annotate(f"tolerance {100 * tolerance:g} %", (1e3 * time, 100 * error), textcoords="offset points",
                      xytext=(8, 2))
    axes.set(xscale="log", xlabel="time per wheelset [ms]", title="Numerical error of auto")
    axes.set_xlim(0.5 * min(times), 6 * max(times))
    set_ticks(axes.xaxis, *axes.get_xlim())
    axes.grid(color="0.9")


def draw_sections(plot, path, table):
    """Pressure across the track at the largest load of each place.

    @param table  path of the table of sections
    """
    sections = CsvTable(table, texts=("place",))
    places = list(dict.fromkeys(sections["place"]))
    columns = min(3, len(places))
    rows = -(-len(places) // columns)
    with plot.rc_context(STYLE):
        figure, axes = plot.subplots(rows, columns, figsize=(2.9 * columns, 2.3 * rows + 0.3), squeeze=False)
        for one in axes.ravel()[len(places):]:
            one.axis("off")
        for one, place in zip(axes.ravel(), places):
            _draw_section(one, sections, place)
        axes[0, -1].legend(fontsize=7, frameon=False, loc="upper left")
        figure.tight_layout()
        figure.savefig(path, dpi=150)
        plot.close(figure)


def _draw_section(axes, sections, place):
    of_place = np.array(sections["place"]) == place
    load = sections["load"][of_place].max()
    contacts = np.unique(sections["contact"][of_place])
    for contact in contacts:
        here = of_place & (sections["load"] == load) & (sections["contact"] == contact)
        arc = 1e3 * sections["arc"][here]
        if len(contacts) > 1:
            arc = arc + 22 * (contact - 0.5 * (len(contacts) - 1))  # beside one another
        axes.fill_between(arc, 1e-6 * sections["elements"][here], color="0.8", label="elements" if contact == 0 else None)
        for name, colour in COLOURS.items():
            axes.plot(arc, 1e-6 * sections[name][here], color=colour, linewidth=0.9, label=name if contact == 0 else None)
    axes.set_title(f"{TITLES[place]}, {1e-3 * load:g} kN", fontsize=9)
    axes.set_xlabel("arc across the track [mm]")
    axes.set_ylabel("pressure [MPa]")
    axes.set_ylim(bottom=0)
