# SPDX-License-Identifier: BSD-3-Clause
"""Draws one instant of one or two runs: section and plan of each contact, and the histories of both below."""
import matplotlib
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patches import FancyArrowPatch

from ..message_constants import SIDES, USABLE
from ..report.drawing import interrupted
from ..report.loops import loops

SIZE, DPI = (9.6, 6.6), 100     # [inch], pixels per inch
COLOURS = ("#D55E00", "#0072B2")  # of the runs; distinguishable by colour-blind readers (Okabe and Ito 2008)
STEEL, WHEEL, INK = "#CBD2D9", "#6C7B8A", "#26303A"
BEYOND = (-44, 28)              # y limits of the section, from the reference point of the rail head [mm]
HEIGHT = (-24, 29)              # z limits of the section [mm]
ALONG = 13                      # half length of the plan [mm]
LEVELS = 20                     # largest number of steps of the colour scale
PRESSURE_HEIGHT = 14            # drawn height of the largest pressure of the scale above the rail surface [mm]
FORCE_LENGTH = 0.15             # length of the arrow per normal force [mm/kN]
POINTS = 160                    # number of points across a patch
FAINT = 0.02                    # smallest pressure that is drawn, as a share of the end of the scale


class Picture:
    """A figure that is redrawn for each instant.

    @param plot command.pyplot()
    @param runs animation.run.Run, one or two
    @param side index into SIDES
    """

    def __init__(self, plot, runs, side):
        self.runs, self.side = runs, side
        self.highest = max(np.nanmax(run.pressure) for run in runs)
        step = 10 ** np.floor(np.log10(self.highest / LEVELS))
        step *= next(m for m in (1, 2, 5, 10) if m * step * LEVELS >= self.highest)
        self.levels = step * np.arange(int(np.ceil(self.highest / step)) + 1)
        self.colours = matplotlib.colors.BoundaryNorm(self.levels, 256)
        self.map = plot.get_cmap("viridis")
        self.figure = plot.figure(figsize=SIZE, dpi=DPI)
        self._arrange()
        self._histories()

    def _arrange(self):
        grid = self.figure.add_gridspec(3, len(self.runs), height_ratios=(53, 26, 24), left=0.06, right=0.9, top=0.955,
                                        bottom=0.075, hspace=0.12, wspace=0.05)
        self.sections = [self.figure.add_subplot(grid[0, k]) for k in range(len(self.runs))]
        self.plans = [self.figure.add_subplot(grid[1, k], sharex=axis) for k, axis in enumerate(self.sections)]
        below = grid[2, :].subgridspec(2, 3, wspace=0.22, height_ratios=(1, 3))
        self.rows = [self.figure.add_subplot(below[1, k]) for k in range(3)]
        scale = self.figure.add_axes((0.915, 0.36, 0.016, 0.595))
        bar = self.figure.colorbar(matplotlib.cm.ScalarMappable(self.colours, self.map), cax=scale, spacing="proportional")
        bar.set_label("pressure [MPa]", fontsize=9)
        bar.ax.tick_params(labelsize=8)

    def _histories(self):
        self.cursors = []
        for axis, (title, values) in zip(self.rows, (("rail head outward [mm]", "lateral"), ("outward force [kN]", "force"),
                                                     ("highest pressure [MPa]", "pressure"))):
            axis.set_title(title, fontsize=9, color=INK)
            for run, colour in zip(self.runs, COLOURS):
                axis.plot(*interrupted([(run.outward[part], getattr(run, values)[part]) for part in loops(run.stamp)]),
                          color=colour, linewidth=1.4)
                self.cursors.append((axis.plot([], [], "o", color=colour, markersize=6)[0], run, values))
            axis.tick_params(labelsize=8)
            axis.grid(alpha=0.3)
            axis.set_xlabel(f"wheelset towards the {SIDES[self.side]} rail [mm]", fontsize=8)
            for edge in ("top", "right"):
                axis.spines[edge].set_visible(False)

    def draw(self, instant):
        """Picture at an instant (index into the histories of the runs), as (height, width, 3) bytes."""
        for axis, plan, run, colour in zip(self.sections, self.plans, self.runs, COLOURS):
            self._draw_section(axis, run, instant, colour)
            self._draw_plan(plan, run, instant)
        for line, run, values in self.cursors:
            line.set_data([run.outward[instant]], [getattr(run, values)[instant]])
        self.figure.canvas.draw()
        return np.asarray(self.figure.canvas.buffer_rgba())[..., :3].copy()

    def _draw_section(self, axis, run, instant, colour):
        axis.clear()
        shown = run.sections[instant]
        centre = run.reference[0]
        axis.set(aspect="equal", xlim=centre + np.array(BEYOND), ylim=HEIGHT)
        axis.axis("off")
        axis.set_title(run.label, fontsize=11, color=colour, fontweight="bold")
        axis.fill(*_closed(shown.rail, HEIGHT[0] - 1).T, facecolor=STEEL, edgecolor=INK, linewidth=1.2)
        axis.plot(*run.rest.T, color=INK, linewidth=0.9, linestyle=(0, (3, 3)))
        usable = run.status[instant] in USABLE
        if usable:
            axis.fill(*_closed(shown.wheel, HEIGHT[1] + 1).T, facecolor=WHEEL, edgecolor=INK, linewidth=1.2)
        for patch in shown.patches:
            self._draw_pressure(axis, patch)
            self._draw_force(axis, patch)
        axis.text(0.02, 0.97, run.texts[instant], transform=axis.transAxes, fontsize=9, color="white" if usable else INK,
                  va="top", family="monospace", linespacing=1.4, zorder=6)
        if self.side == SIDES.index("left"):
            axis.invert_xaxis()

    def _draw_pressure(self, axis, patch):
        """Draws the highest pressure of each column along the patch normal, from the rail surface outward."""
        column = np.linspace(0, 1, len(patch.surface))
        fine = np.linspace(0, 1, POINTS)
        pressure = np.interp(fine, column, patch.pressure.max(axis=0))
        base = np.column_stack([np.interp(fine, column, patch.surface[:, k]) for k in (0, 1)])
        top = base + PRESSURE_HEIGHT / self.levels[-1] * pressure[:, None] * patch.normal
        loaded = np.flatnonzero((pressure[1:] > 0) | (pressure[:-1] > 0))
        quads = [(base[k], base[k + 1], top[k + 1], top[k]) for k in loaded]
        mean = 0.5 * (pressure[loaded] + pressure[loaded + 1])
        colours = self.map(self.colours(mean))
        axis.add_collection(PolyCollection(quads, facecolors=colours, edgecolors=colours, linewidths=0.3, zorder=4))
        axis.add_collection(LineCollection([top[loaded]], colors=INK, linewidths=0.9, zorder=5))

    @staticmethod
    def _draw_force(axis, patch):
        """Draws the normal force on the rail, from the centre of pressure."""
        start = patch.pressure.sum(axis=0) @ patch.surface / patch.pressure.sum()
        axis.add_patch(FancyArrowPatch(start, start - FORCE_LENGTH * patch.force * patch.normal, zorder=5, color=INK,
                                       linewidth=1.6, arrowstyle="-|>", mutation_scale=12, shrinkA=0, shrinkB=0))

    def _draw_plan(self, axis, run, instant):
        axis.clear()
        axis.set(aspect="equal", ylim=(-ALONG, ALONG), xlim=self.sections[0].get_xlim())
        axis.tick_params(labelsize=8)
        axis.set_facecolor("#F3F5F7")
        axis.grid(alpha=0.35)
        for patch in run.sections[instant].patches:
            y, pressure = patch.surface[:, 0], patch.pressure
            axis.contourf(y, patch.x, pressure, levels=[FAINT * self.levels[-1], *self.levels[1:]], norm=self.colours,
                          cmap=self.map)
        axis.set_xlabel("y [mm], top view", fontsize=8, labelpad=1)
        if axis is self.plans[0]:
            axis.set_ylabel("x [mm]", fontsize=8, labelpad=1)


def _closed(curve, height):
    """The curve, closed by a horizontal line at `height` outside the picture."""
    return np.vstack([curve, [curve[-1, 0], height], [curve[0, 0], height]])
