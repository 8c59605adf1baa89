# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of runs of simulate_wheelset."""
import numpy as np

MM = 1e3   # mm per m
KN = 1e-3  # kN per N
DPI = 100
SIDES = (("left", "tab:blue"), ("right", "tab:orange"))


def draw_motion(plot, run, path, length):
    """Draws lateral displacement and yaw of the whole run, and the creep forces at its end, over the place on the track.

    run: CsvTable of simulate_wheelset. length: of the part with the creep forces [m].
    """
    figure, axes = plot.subplots(3, 1, figsize=(9, 8), constrained_layout=True)
    distance = run["distance"]
    axes[0].plot(distance, MM * run["y"], color="k", linewidth=0.8)
    axes[0].set(ylabel="y, to the left [mm]", title="Lateral displacement (black) and yaw (red) of the wheelset",
                xlim=_ends(distance))
    yaw = axes[0].twinx()
    yaw.plot(distance, 1e3 * run["yaw"], color="tab:red", linewidth=0.6, alpha=0.8)
    yaw.set_ylabel("yaw, to the left [mrad]", color="tab:red")
    end = distance >= distance[-1] - length
    for axis, quantity, title in ((axes[1], "creep_x", "Longitudinal creep force on each wheel, forward"),
                                  (axes[2], "creep_y", "Lateral creep force on each wheel, to the left")):
        for side, colour in SIDES:
            axis.plot(distance[end], KN * run[f"{side}_{quantity}"][end], color=colour, linewidth=1.0, label=f"{side} wheel")
        _mark_saturated(axis, run, end)
        axis.set(ylabel="[kN]", title=title, xlim=_ends(distance[end]))
    axes[2].legend(fontsize=8, loc="lower right")
    axes[2].set_xlabel("place along the track [m]")
    _finish(plot, figure, axes, path)


def draw_phase(plot, runs, path):
    """Draws the yaw over the lateral displacement of each run.

    runs: pairs of a label and a CsvTable of simulate_wheelset.
    """
    figure, axis = plot.subplots(figsize=(6.5, 5.5), constrained_layout=True)
    for (label, run), colour in zip(runs, ("tab:blue", "tab:orange", "tab:green", "tab:red")):
        y, yaw = MM * run["y"], 1e3 * run["yaw"]
        axis.plot(y, yaw, color=colour, linewidth=0.7, label=label)
        axis.plot(y[0], yaw[0], "o", color=colour, markersize=6)
    axis.legend(fontsize=8, loc="center", title="start (dot)", title_fontsize=8)
    axis.set(xlabel="lateral displacement y, to the left [mm]", ylabel="yaw, to the left [mrad]",
             title="Phase plot: runs from different starts")
    _finish(plot, figure, [axis], path)


def _mark_saturated(axis, run, rows):
    """Shades the steps in which the creep force of a contact is at the friction limit."""
    distance = run["distance"][rows]
    limited = np.maximum(run["left_saturated"], run["right_saturated"])[rows] > 0
    axis.fill_between(distance, 0, 1, where=limited, transform=axis.get_xaxis_transform(), color="0.85", step="mid",
                      linewidth=0)


def _ends(values):
    return values[0], values[-1]


def _finish(plot, figure, axes, path):
    for axis in axes:
        axis.grid(color="0.9", linewidth=0.6)
        axis.title.set_fontsize(10)
    figure.savefig(path, dpi=DPI)
    plot.close(figure)
