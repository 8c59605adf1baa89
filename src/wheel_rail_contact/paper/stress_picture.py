# SPDX-License-Identifier: BSD-3-Clause
"""Sections of the rail with the von Mises stress, on one scale."""
from types import SimpleNamespace

import numpy as np

from .report import RAILS

# Rail and lateral force [kN] of each section, from top to bottom, first the left column.
SHOWN = (("without", 0), ("shifted", 0), ("turned", 0), ("paper", 30),
         ("pads_40_100", 30), ("pads_40_100", 60), ("pads_10_25", 30), ("pads_10_25", 60))
ROWS = 4
WINDOW = (14, -12, -10.3, 0.9)  # limits: y (left, positive to the left), z [mm]


def figure(folder, plot, read):
    """One section for each setting of SHOWN. Raises ImportError if the package was built without its Python module."""
    from ..core import stress_picture, stress_section
    rows = {_key(row): row for row in read(folder / "stress.csv")}
    cells = read(folder / "stress_patches.csv")
    top = max(rows[key]["von_mises"] for key in SHOWN)
    drawn, panels = plot.subplots(ROWS, 2, figsize=(11, 10), sharex=True, sharey=True)
    drawn.subplots_adjust(left=0.055, right=0.89, top=0.955, bottom=0.075, wspace=0.05, hspace=0.28)
    for axes, key in zip(panels.T.flat, SHOWN):
        row = rows[key]
        patch = _patch(row, [cell for cell in cells if _key(cell) == key])
        section = stress_section.StressSection(patch, poisson=dict.fromkeys(stress_section.BODIES, row["poisson"]))
        section.bodies = [body for body in section.bodies if body.name == "rail"]
        stress_picture.draw(axes, section, top, colorbar=False)
        _finish(axes, row, key)
    panels[0, 0].legend(loc="lower right", fontsize="x-small")
    for axes in panels[:, 0]:
        axes.set_ylabel("z [mm]")
    for axes in panels[-1]:
        axes.set_xlabel("across the track, the field side is on the left [mm]")
    mesh = panels[0, 0].collections[0]
    drawn.colorbar(mesh, cax=drawn.add_axes([0.91, 0.1, 0.013, 0.8]), label="von Mises stress [MPa]")
    return drawn


def _key(row):
    return row["rail"], round(1e-3 * row["lateral_force"])


def _finish(axes, row, key):
    """Sets the limits and the title."""
    axes.get_legend().remove()
    axes.set(xlim=WINDOW[:2], ylim=WINDOW[2:], xlabel="", ylabel="")
    force = f", {key[1]} kN" if key[1] else ""
    axes.set_title(f"{RAILS[key[0]]}{force}: {1e-6 * row['max_pressure']:.0f} MPa, {1e6 * row['area']:.0f} mm²",
                   fontsize=9)


def _patch(row, cells):
    """Patch for StressSection, with the same stress in both bodies."""
    x, y = np.unique([cell["x"] for cell in cells]), np.unique([cell["y"] for cell in cells])
    peak = SimpleNamespace(value=row["von_mises"], x=row["von_mises_x"], y=row["von_mises_y"],
                           depth=row["von_mises_depth"])
    stress = SimpleNamespace(von_mises=peak, load_factor=row["load_factor"], shakedown_limit=row["shakedown_limit"])
    return SimpleNamespace(
        side="left", x=x, y=y, dx=x[1] - x[0], dy=y[1] - y[0],
        pressure=np.array([cell["pressure"] for cell in cells]).reshape(len(y), len(x)).T,
        semi_axis_along=row["semi_axis_along"], semi_axis_across=row["semi_axis_across"],
        max_pressure=row["max_pressure"], wheel_stress=stress, rail_stress=stress)
