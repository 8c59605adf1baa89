# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a profile: its section, curvature, and the distance of the points from the curve."""
import textwrap

import numpy as np

MM, UM = 1e3, 1e6  # per metre
CURVE, POINTS, STANDARD, MISSING, MARK = "#0072B2", "#707070", "#E69F00", "#D55E00", "#009E73"
DPI = 110
WRAP = 150  # characters in a line of the report
MARGIN = 6  # around the section [mm]


def draw(plot, tables, name, path):
    """Draws the picture.

    tables: Tables of the profile. name: of the file. path: of the picture, a PNG file.
    """
    figure = plot.figure(figsize=(10, 10))
    top, middle, bottom = figure.subplots(3, 1, gridspec_kw={"height_ratios": (2.1, 1, 0.8)})
    lines = textwrap.wrap(tables.values["report"], WRAP) + textwrap.wrap(tables.values["nearest"], WRAP)
    figure.subplots_adjust(left=0.085, right=0.975, top=0.925 - 0.0145 * len(lines), bottom=0.055, hspace=0.33)
    figure.suptitle(f"{name}: {tables.values['kind']}", fontsize=13, y=0.985)
    figure.text(0.5, 0.955, "\n".join(lines), fontsize=8, ha="center", va="top")
    _section(top, tables)
    _curvature(middle, tables)
    _residuals(bottom, tables)
    for axes in (top, middle, bottom):
        axes.grid(color="0.9", linewidth=0.6)
        axes.set_axisbelow(True)
    for axes in (middle, bottom):
        axes.set_xlim(0, MM * tables.curve["arc_length"][-1])
        for begin, end in tables.missing_ranges():
            axes.axvspan(MM * begin, MM * end, color=MISSING, alpha=0.15, linewidth=0)
    figure.savefig(path, dpi=DPI)
    plot.close(figure)


def _section(axes, tables):
    curve, points, standard = tables.curve, tables.points, tables.standard
    y, z = MM * curve["y"], MM * curve["z"]
    if points["y"].size:
        axes.plot(MM * points["y"], MM * points["z"], ".", color=POINTS, markersize=4, label="points of the file")
    missing = curve["missing"] > 0
    axes.plot(np.where(missing, np.nan, y), np.where(missing, np.nan, z), color=CURVE, linewidth=1.4, label="curve")
    if missing.any():
        axes.plot(np.where(missing, y, np.nan), np.where(missing, z, np.nan), "--", color=MISSING, linewidth=1.4,
                  label="points missing")
    if standard["y"].size:
        axes.plot(MM * standard["y"], MM * standard["z"], color=STANDARD, linewidth=0.7,
                  label=f"nearest standard: {tables.values['standard']}")
    axes.set(aspect="equal", xlim=(y.min() - MARGIN, y.max() + MARGIN), ylim=(z.min() - MARGIN, z.max() + MARGIN),
             xlabel="y, to the field side [mm]", ylabel="z, up [mm]")
    axes.set_title("Section, in true proportion", fontsize=10)
    marks = {name: (MM * place[0], MM * place[1]) for name, place in tables.marks.items()}
    (_mark_wheel if tables.values["kind"] == "wheel" else _mark_rail)(axes, marks)
    wheel = tables.values["kind"] == "wheel"
    axes.legend(fontsize=8, loc="lower right" if wheel else "lower center", framealpha=1)


def _text(place):
    return "({:.2f}, {:.2f})".format(*(value if abs(value) >= 0.005 else 0 for value in place))


def _point(axes, place, text, offset, align="center"):
    axes.plot(*place, "o", color=MARK, markersize=5, zorder=5)
    if text:
        axes.annotate(text, place, xytext=offset, textcoords="offset points", color=MARK, fontsize=8, ha=align,
                      va="center")


def _dimension(axes, begin, end, text, offset, align):
    """Arrow between two points, with a text at its middle."""
    axes.annotate("", begin, xytext=end, arrowprops={"arrowstyle": "<->", "color": MARK, "linewidth": 0.9,
                                                     "shrinkA": 0, "shrinkB": 0})
    middle = (0.5 * (begin[0] + end[0]), 0.5 * (begin[1] + end[1]))
    axes.annotate(text, middle, xytext=offset, textcoords="offset points", color=MARK, fontsize=8, ha=align, va="center")


def _mark_wheel(axes, marks):
    circle, tip = marks["running_circle"], marks["flange_tip"]
    _point(axes, circle, "running circle", (0, 10))
    axes.plot((tip[0], circle[0]), (tip[1], tip[1]), ":", color=MARK, linewidth=0.9)
    _dimension(axes, (0, tip[1]), circle, f"Sh {circle[1] - tip[1]:.2f}", (4, 0), "left")
    _point(axes, tip, "", (0, 0))
    if "front" in marks:
        back, front = marks["flange_back"], marks["front"]
        _point(axes, front, "", (0, 0))
        _dimension(axes, back, front, f"Sd {front[0] - back[0]:.2f}", (0, 7), "center")
    if "front" in marks and "upper" in marks:
        upper = marks["upper"]
        _point(axes, upper, f"qR {marks['front'][0] - upper[0]:.2f}", (8, 0), "left")


def _mark_rail(axes, marks):
    top = marks["top"]
    _point(axes, top, f"top {_text(top)}", (0, 9))
    if "gauge_point" in marks:
        place = marks["gauge_point"]
        _point(axes, place, f"gauge point\n{_text(place)}", (10, -22), "left")
    if "gauge_side" in marks and "field_side" in marks:
        left, right = marks["gauge_side"], marks["field_side"]
        _dimension(axes, left, right, f"width {right[0] - left[0]:.2f}, {top[1] - left[1]:.4g} below the top", (0, 7), "center")


def _curvature(axes, tables):
    curve = tables.curve
    s, value, error = MM * curve["arc_length"], curve["curvature"], curve["curvature_error"]
    known = curve["missing"] == 0
    drawn, band = np.where(known, value, np.nan), np.where(known, error, np.nan)
    axes.fill_between(s, drawn - 2 * band, drawn + 2 * band, color=CURVE, alpha=0.25, linewidth=0,
                      label="± 2 standard deviations")
    axes.plot(s, drawn, color=CURVE, linewidth=1, label="curvature")
    axes.axhline(0, color="0.6", linewidth=0.8)
    if known.any():
        # Single sharp places and poorly known ones would hide the rest.
        low, high = np.percentile(value[known], (1, 99))
        margin = 0.25 * max(high - low, 1)
        axes.set_ylim(low - margin, high + margin)
    axes.set(xlabel="arc length from the gauge side [mm]", ylabel="curvature [1/m]")
    axes.set_title("Curvature, positive where the curve is hollow from above", fontsize=10)
    axes.legend(fontsize=8, loc="best", framealpha=1)


def _residuals(axes, tables):
    points = tables.points
    axes.axhline(0, color=CURVE, linewidth=1)
    smoothing = UM * tables.values["smoothing"]
    if points["y"].size:
        axes.plot(MM * points["arc_length"], UM * points["residual"], ".", color=POINTS, markersize=2.5)
    if smoothing > 0:
        axes.axhspan(-2 * smoothing, 2 * smoothing, color=CURVE, alpha=0.15, linewidth=0)
        axes.set_title(f"Points minus curve. Band: ± 2 × {smoothing:.2g} µm, the noise for which the curve is smoothed",
                       fontsize=10)
    else:
        axes.set_title("Points minus curve: not smoothed, the curve passes through all points", fontsize=10)
        axes.set_ylim(-1, 1)
    axes.set(xlabel="arc length from the gauge side [mm]", ylabel="above the curve [µm]")
