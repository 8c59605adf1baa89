# SPDX-License-Identifier: BSD-3-Clause
"""Pressure and area against the lateral force: for each table, and for parts of the deflection of one table."""
from .colours import BLACK, BLUE, GREEN, ORANGE, PURPLE, RED

TABLES = {"paper": ("paper's rail", BLACK, "o"), "pads_100_500": ("pads 100/500 kN/mm", BLUE, "s"),
          "pads_40_100": ("pads 40/100", GREEN, "^"), "pads_20_60": ("pads 20/60", ORANGE, "D"),
          "pads_10_25": ("pads 10/25", RED, "v")}
SHARES = {"whole": ("whole deflection", GREEN, "^"),
          "without_moment": ("without the moment of the wheel load", PURPLE, "x"),
          "shift_only": ("displacement only, no roll", BLACK, "+")}
PANELS = (("max_pressure", 1e-6, "highest pressure [MPa]"), ("area", 1e6, "area [mm²]"))


def figure(study, plot):
    """Left: all tables. Right: parts of the deflection of one table."""
    rows = study.forces
    divided = next(row["table"] for row in rows if row["share"] != "whole")
    end = max(1e-3 * row["lateral_force"] for row in rows if row["table"] == divided and row["in_range"])
    drawn, axes = plot.subplots(2, 2, figsize=(11, 7.4), sharex=True, sharey="row", constrained_layout=True)
    for line, (quantity, unit, label) in enumerate(PANELS):
        for key, look in TABLES.items():
            _curve(axes[line, 0], [r for r in rows if (r["table"], r["share"]) == (key, "whole")], quantity, unit, look)
        for key, look in SHARES.items():
            _curve(axes[line, 1], [r for r in rows if (r["table"], r["share"]) == (divided, key)], quantity, unit, look)
        axes[line, 0].set_ylabel(label)
        for panel in axes[line]:
            panel.axvspan(end, 80, color="0.9", zorder=0)
            panel.grid(color="0.85", linewidth=0.6)
            panel.set_xlim(0, 80)
    for panel in axes[1]:
        panel.set_xlabel("lateral force Y on both rails, outward [kN]")
    axes[0, 0].set_title("five rails, Q = 100 kN, y = 0.572 mm")
    axes[0, 1].set_title(TABLES[divided][0] + " kN/mm, parts of the deflection")
    axes[0, 0].legend(fontsize=8)
    axes[0, 1].legend(fontsize=8, loc="upper left")
    axes[1, 0].text(end + 1, axes[1, 0].get_ylim()[1], "Y/Q > 0.6:\nfoot may lift,\ntables too stiff", va="top",
                    fontsize=8)
    return drawn


def _curve(axes, rows, quantity, unit, look):
    label, colour, marker = look
    forces = [1e-3 * row["lateral_force"] for row in rows]
    values = [unit * row[quantity] or float("nan") for row in rows]
    inside = sum(row["in_range"] > 0 for row in rows)
    axes.plot(forces[:inside], values[:inside], "-", color=colour, marker=marker, markersize=5, linewidth=1.4,
              label=label, fillstyle="none")
    axes.plot(forces[inside - 1:], values[inside - 1:], ":", color=colour, linewidth=1.6)
