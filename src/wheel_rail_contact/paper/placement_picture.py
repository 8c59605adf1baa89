# SPDX-License-Identifier: BSD-3-Clause
"""Figure 3 of the paper, from our results: both placements, initial contact points, pressures on one scale."""
import numpy as np

from .colours import BLACK, BLUE, RED

SHOWN = ("without", "shifted", "turned", "own_rail")
TITLES = {"without": "without bending", "shifted": "0.2435 mm outward", "turned": "and 13 mrad inward",
          "own_rail": "paper's rail, 30 kN, coupled"}
WINDOW = (714, 778, -19, 3)  # limits of the profiles: y, z [mm]
PATCH_WINDOW = (-13, 14, -8, 8)  # limits of the pressures: across, along [mm]


def figure(study, plot):
    """Top: profiles. Bottom: pressures."""
    placements = {one.case.name: one for one in study.placements}
    values = {row["case"]: row for row in study.figures}
    drawn = plot.figure(figsize=(11, 5.4))
    grid = drawn.add_gridspec(2, 4, height_ratios=(1.1, 1), left=0.06, right=0.91, top=0.94, bottom=0.09, wspace=0.14,
                              hspace=0.45)
    for column, case in ((0, "shifted"), (2, "turned")):
        axes = drawn.add_subplot(grid[0, column:column + 2])
        _placements(axes, placements["without"], placements[case])
        axes.set_ylabel("z, up [mm]" if column == 0 else "")
    top = max(patch.pressure.max() for case in SHOWN for patch in placements[case].patches)
    for column, case in enumerate(SHOWN):
        axes = drawn.add_subplot(grid[1, column])
        mesh = _pressure(axes, placements[case].patches, top)
        _caption(axes, case, values[case])
        if column:
            axes.set_yticklabels([])
        else:
            axes.set_ylabel("along the track [mm]")
    drawn.colorbar(mesh, cax=drawn.add_axes([0.93, 0.1, 0.013, 0.33]), label="pressure [MPa]")
    return drawn


def _placements(axes, without, bent):
    for one, style, marker in ((without, "-", "o"), (bent, "--", "D")):
        label = ", without bending" if one is without else ", bent"
        for body, outline, colour in (("wheel", one.wheel, RED), ("rail", one.rail, BLUE)):
            axes.plot(*(1e3 * outline.T), style, color=colour, linewidth=1.3, label=body + label)
        axes.plot(*(1e3 * one.touch), marker, color=BLACK, markersize=8,
                  markerfacecolor=BLACK if one is without else "none", label="initial contact" + label, zorder=5)
    axes.set(aspect="equal", xlim=WINDOW[:2], ylim=WINDOW[2:], xlabel="y, to the field side [mm]")
    axes.legend(fontsize=7.5, loc="lower right", frameon=False, ncol=2)
    axes.set_title("dashed: 0.2435 mm outward" + (" and 13 mrad inward" if bent.case.name == "turned" else ""), fontsize=10)


def _edges(centres):
    """Edges of equal cells with these centres."""
    half = 0.5 * (centres[1] - centres[0])
    return np.append(centres - half, centres[-1] + half)


def _pressure(axes, patches, top):
    mesh = None
    for patch in patches:
        mesh = axes.pcolormesh(_edges(1e3 * patch.y), _edges(1e3 * patch.x),
                               np.ma.masked_less_equal(1e-6 * patch.pressure, 0), vmin=0, vmax=1e-6 * top, cmap="viridis",
                               rasterized=True)
    axes.set(aspect="equal", xlim=PATCH_WINDOW[:2], ylim=PATCH_WINDOW[2:], xlabel="across, to the field side [mm]")
    return mesh


def _caption(axes, case, values):
    def text(prefix):
        return f"{1e-6 * values[prefix + 'max_pressure']:.0f} MPa, {1e6 * values[prefix + 'area']:.0f} mm²"

    axes.set_title(f"{TITLES[case]}\nours {text('')}\n(paper {text('printed_')})", fontsize=9)
