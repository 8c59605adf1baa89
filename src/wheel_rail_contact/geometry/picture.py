# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the contact geometry over the lateral displacement, and of the conicity over the amplitude."""
import numpy as np

from .tables import MM

SIDES = (("left", "tab:blue"), ("right", "tab:orange"))
DPI = 110


def draw(plot, both_points, both_conicities, title, path):
    """Draws the picture.

    both_points, both_conicities: as of tables.points_of() and tables.conicity_of(), rigid and under load; the latter may be {}.
    title: describes wheels and track.
    """
    (points, loaded), (conicity, loaded_conicity) = both_points, both_conicities
    figure, axes = plot.subplots(2, 2, figsize=(10, 7), constrained_layout=True)
    figure.suptitle(title, fontsize=11)
    y = MM * points["y"]
    _radius_difference(axes[0, 0], y, points, loaded)
    _positions(axes[0, 1], y, points)
    _roll(axes[1, 0], y, points)
    _conicity(axes[1, 1], conicity, loaded_conicity)
    for axis in axes.flat:
        axis.grid(color="0.88", linewidth=0.6)
    figure.savefig(path, dpi=DPI)
    plot.close(figure)


def _over_y(axis, y, title, label):
    axis.set(title=title, xlabel="lateral displacement y, to the left [mm]", ylabel=label, xlim=(y[0], y[-1]))
    axis.title.set_fontsize(10)
    axis.axvline(0, color="0.7", linewidth=0.8)


def _curves(axis, x, curve, loaded):
    """Draws the curve of rigid bodies, and one under load if it is not None."""
    axis.plot(x, curve, ".-", color="k", markersize=3, linewidth=0.8, label="rigid")
    if loaded is not None:
        axis.plot(x, loaded, "-", color="tab:green", linewidth=1.2, label="elastic, under load")
        axis.legend(fontsize=8)


def _radius_difference(axis, y, points, loaded):
    _curves(axis, y, MM * points["rolling_radius_difference"], MM * loaded["rolling_radius_difference"] if loaded else None)
    axis.axhline(0, color="0.7", linewidth=0.8)
    _over_y(axis, y, "Rolling radius difference", "left minus right [mm]")


def _positions(axis, y, points):
    for side, colour in SIDES:
        axis.plot(y, MM * points[f"{side}_wheel_y"], "o", color=colour, markersize=2.2, label=f"{side}, on the wheel")
        axis.plot(y, MM * points[f"{side}_rail_y"], "x", color=colour, markersize=3.2, markeredgewidth=0.7,
                  label=f"{side}, on the rail")
    _over_y(axis, y, "Contact position on the profiles", "from the origin to the field side [mm]")
    axis.legend(fontsize=7, loc="lower center")


def _roll(axis, y, points):
    roll = points["roll"]
    axis.plot(y, 1e3 * roll, ".-", color="k", markersize=3, linewidth=0.8)
    neglected = not np.any(roll[np.isfinite(roll)])
    _over_y(axis, y, "Roll: neglected" if neglected else "Roll of the wheelset", "left wheel up [mrad]")


def _conicity(axis, conicity, loaded):
    amplitude, value = MM * conicity["amplitude"], conicity["equivalent_conicity"]
    _curves(axis, amplitude, value, loaded.get("equivalent_conicity"))
    known = np.flatnonzero(np.isfinite(value))
    if known.size:
        nearest = known[np.argmin(abs(amplitude[known] - 3))]
        if abs(amplitude[nearest] - 3) < 1e-6:
            axis.plot(3, value[nearest], "o", color="tab:red")
            axis.annotate(f"{value[nearest]:.3f} at 3 mm", (3, value[nearest]), xytext=(8, -14), color="tab:red",
                          textcoords="offset points")
        axis.set_ylim(0, max(1.05 * np.nanmax([*value, *loaded.get("equivalent_conicity", ())]), 0.05))
    else:
        axis.text(0.5, 0.5, "no result; see the CSV file", ha="center", va="center", transform=axis.transAxes)
    axis.set(title="Equivalent conicity (EN 15302)", xlabel="amplitude of the wave [mm]", ylabel="tan γe [-]")
    axis.title.set_fontsize(10)
