# SPDX-License-Identifier: BSD-3-Clause
"""Settings in the plane of area and highest pressure, with the two points of the paper."""
from .colours import BLACK, BLUE, GREEN, ORANGE, RED

RAIL = "UIC60_manchester"
MARKED_TURNS = (-20, -16, -13, -10, -7, -4, 0, 4, 8, 12)  # [mrad]
MARKED_SHIFTS = (-3, -1, 1, 2, 3, 4)  # [mm]


def figure(study, plot):
    """Curves of displacement only, and of displacement and turn, from the same start."""
    rows = [row for row in study.scan if row["rail"] == RAIL]
    pairs = [row for row in rows if row["part"] == "pair" and abs(row["crown_lateral"] - 0.2435e-3) < 1e-9]
    start = min(pairs, key=lambda row: row["deviation_pair"])["y"]
    turned = [row for row in pairs if row["y"] == start]
    shifted = [row for row in rows if row["part"] == "shift" and row["crown_lateral"] > -4.3e-3]
    drawn, axes = plot.subplots(figsize=(9, 6.4), constrained_layout=True)
    _curve(axes, shifted, "crown_lateral", MARKED_SHIFTS, "mm", (BLUE, "s", "rail displaced only, outward positive"))
    _curve(axes, turned, "rail_turn", MARKED_TURNS, "mrad",
           (RED, "o", "displaced 0.2435 mm and turned, outward positive"))
    _forces(axes, study.forces)
    _other_inclination(axes, rows)
    for row in study.figures[:2]:
        name = "without" if row["case"] == "without" else "with"
        area, pressure = 1e6 * row["printed_area"], 1e-6 * row["printed_max_pressure"]
        axes.plot(area, pressure, "*", color=BLACK, markersize=16, zorder=6)
        axes.annotate(f"paper, {name} bending", (area, pressure), xytext=(10, 9 if name == "without" else -22),
                      textcoords="offset points", zorder=6, weight="bold",
                      bbox={"facecolor": "white", "edgecolor": "none", "pad": 1, "alpha": 0.8})
    axes.set(xlabel="area [mm²]", ylabel="highest pressure [MPa]", xlim=(90, 215), ylim=(780, 1720),
             title=f"S1002 on UIC60, 1:40, y = {1e3 * start:.2f} mm, 100 kN, unless stated otherwise")
    axes.grid(color="0.88", linewidth=0.6)
    axes.legend(fontsize=8, loc="lower left")
    return drawn


def _curve(axes, rows, key, marked, unit, look):
    colour, marker, label = look
    points = sorted((1e3 * row[key], 1e6 * row["area"], 1e-6 * row["max_pressure"]) for row in rows)
    axes.plot([p[1] for p in points], [p[2] for p in points], "-", color=colour, linewidth=1.4)
    axes.plot([], [], "-", color=colour, marker=marker, label=label)
    for value, area, pressure in points:
        if any(abs(value - wanted) < 1e-6 for wanted in marked):
            left = unit == "mrad" and value > -1e-6
            axes.plot(area, pressure, marker, color=colour, markersize=6)
            axes.annotate(f"{value:+.0f} {unit}" if abs(value) > 1e-6 else f"0 {unit}", (area, pressure),
                          xytext=(-8 if left else 8, -4), textcoords="offset points", fontsize=8, color=colour,
                          ha="right" if left else "left")


def _forces(axes, rows):
    for table, style, name in (("paper", "-", "paper's rail"), ("pads_10_25", "--", "rail on pads 10/25")):
        chosen = [row for row in rows
                  if (row["table"], row["share"]) == (table, "whole") and row["lateral_force"] <= 60e3]
        axes.plot([1e6 * row["area"] for row in chosen], [1e-6 * row["max_pressure"] for row in chosen], style,
                  color=GREEN, linewidth=2, label=f"{name}, coupled, 0 to 60 kN outward")


def _other_inclination(axes, rows):
    outward = [row for row in rows if row["part"] == "inclination" and row["rail_turn"] > 0]
    best = min(outward, key=lambda row: row["deviation_pair"])
    areas = [1e6 * best["without_area"], 1e6 * best["area"]]
    pressures = [1e-6 * best["without_max_pressure"], 1e-6 * best["max_pressure"]]
    axes.plot(areas, pressures, ":", color=ORANGE, marker="D", linewidth=2,
              label=f"inclination 1:{1 / best['inclination']:.0f}, y = {1e3 * best['y']:.1f} mm: "
              f"turned {1e3 * best['rail_turn']:.1f} mrad outward")
