# SPDX-License-Identifier: BSD-3-Clause
"""Sections of the rail with the von Mises stress, on one scale."""
from types import SimpleNamespace

from ..core import stress_picture, stress_section
from .report import RAILS
from .stress import POISSON

# Rail and lateral force [kN] of each section, from top to bottom, first the left column.
SHOWN = (("without", 0), ("shifted", 0), ("turned", 0), ("paper", 30),
         ("pads_40_100", 30), ("pads_40_100", 60), ("pads_10_25", 30), ("pads_10_25", 60))
ROWS = 4
WINDOW = (14, -12, -10.3, 0.9)  # limits: y (left, positive to the left), z [mm]


def figure(study, plot):
    """One section for each setting of SHOWN."""
    found = {_key(one): one for one in study.stresses}
    top = max(found[key].highest.von_mises.value for key in SHOWN)
    drawn, panels = plot.subplots(ROWS, 2, figsize=(11, 10), sharex=True, sharey=True)
    drawn.subplots_adjust(left=0.055, right=0.89, top=0.955, bottom=0.075, wspace=0.05, hspace=0.28)
    for axes, key in zip(panels.T.flat, SHOWN):
        section = stress_section.StressSection(_patch(found[key]), poisson=dict.fromkeys(stress_section.BODIES, POISSON))
        section.bodies = [body for body in section.bodies if body.name == "rail"]
        stress_picture.draw(axes, section, top, colorbar=False)
        _finish(axes, found[key].patch, key)
    panels[0, 0].legend(loc="lower right", fontsize="x-small")
    for axes in panels[:, 0]:
        axes.set_ylabel("z [mm]")
    for axes in panels[-1]:
        axes.set_xlabel("across the track, the field side is on the left [mm]")
    mesh = panels[0, 0].collections[0]
    drawn.colorbar(mesh, cax=drawn.add_axes([0.91, 0.1, 0.013, 0.8]), label="von Mises stress [MPa]")
    return drawn


def _key(one):
    return one.rail, round(1e-3 * one.lateral_force)


def _finish(axes, patch, key):
    """Sets the limits and the title."""
    axes.get_legend().remove()
    axes.set(xlim=WINDOW[:2], ylim=WINDOW[2:], xlabel="", ylabel="")
    force = f", {key[1]} kN" if key[1] else ""
    axes.set_title(f"{RAILS[key[0]]}{force}: {1e-6 * patch.max_pressure:.0f} MPa, {1e6 * patch.area:.0f} mm²", fontsize=9)


def _patch(one):
    """Patch for StressSection, with the stress of the study in both bodies."""
    stress = SimpleNamespace(von_mises=one.highest.von_mises, load_factor=one.load_factor,
                             shakedown_limit=one.shakedown_limit)
    names = ("side", "x", "y", "dx", "dy", "pressure", "semi_axis_along", "semi_axis_across", "max_pressure")
    return SimpleNamespace(**{name: getattr(one.patch, name) for name in names}, wheel_stress=stress, rail_stress=stress)
