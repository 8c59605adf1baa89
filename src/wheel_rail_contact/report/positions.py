# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the contact positions on the profiles."""
import numpy as np

from ..command import pyplot
from ..message_constants import SIDES
from .drawing import save

ENTIRE = 8         # [inch] width of the two columns of profiles
MAX_OUTLINES = 8   # largest number of places at which a rail that changes is drawn
FLATTEST = 0.25    # smallest ratio of height to width of a picture of a profile


def contact_points(results, side):
    """Positions of the patches of a side on the undeflected rail and on the wheel.

    @return two arrays (n, 2) of y, z [m] y outward
    """
    patches = results.patches
    chosen = patches["side"] == side
    index, sign = patches["result"][chosen], (1, -1)[side]
    y, z = patches["y"][chosen], patches["z"][chosen]
    lateral, vertical, tilt = (np.nan_to_num(results.rail[index, side, column]) for column in (0, 1, 2))
    on_rail = np.column_stack([sign * y - lateral, z - vertical])
    if "reference" in results.outlines[side]:  # centre of rotation of the rail roll
        reference = results.outlines[side]["reference"][0]
        dy, dz = (on_rail - reference).T
        on_rail = reference + np.column_stack([np.cos(tilt) * dy - np.sin(tilt) * dz,
                                               np.cos(tilt) * dz + np.sin(tilt) * dy])
    # To the axes of the wheelset. Yaw is neglected: it moves the contact along the track, not across it.
    dy, dz, roll = y - results.y[index], z - results.z[index], results.roll[index]
    on_wheel = np.column_stack([sign * (np.cos(roll) * dy + np.sin(roll) * dz), np.cos(roll) * dz - np.sin(roll) * dy])
    return on_rail, on_wheel


def figure(results, path):
    """Contact positions: on the outlines of the profiles, or along the profiles if the bag contains no outlines."""
    known = any("rail" in outlines for outlines in results.outlines) or any(results.sections)
    return (_on_outlines if known else _along_profiles)(results, path)


def _outlines(results, side, kind):
    """Outlines of a wheel or rail; of a rail that changes, some along the way of the wheelset."""
    if kind == "rail" and results.sections[side]:
        places = np.array([x for x, _ in results.sections[side]])
        way = np.linspace(results.distance.min(), results.distance.max(), MAX_OUTLINES)
        drawn = {places[np.argmin(np.abs(places - x))] for x in way}
        return [outline for x, outline in results.sections[side] if x in drawn]
    return [results.outlines[side][kind]] if kind in results.outlines[side] else []


def _ratio(curves):
    """Ratio of height to width of the picture of several curves (n, 2)."""
    height, width = np.ptp(np.vstack(curves), axis=0)[::-1]
    return max(FLATTEST, height / width)


def _draw_profile(axis, outlines, points, pressure, scale, sign):
    """Outlines and points (n, 2), outward y and z [m]; the points with the highest pressures are drawn last."""
    for outline in outlines:
        axis.plot(sign * 1e3 * outline[:, 0], 1e3 * outline[:, 1], color="0.4", linewidth=1.5 if len(outlines) == 1 else 0.7)
    order = np.argsort(pressure, kind="stable")
    return axis.scatter(sign * 1e3 * points[order, 0], 1e3 * points[order, 1], c=pressure[order], s=14, norm=scale,
                        cmap="viridis", zorder=3)


def _on_outlines(results, path):
    """Contact positions on both profiles, coloured by the highest pressure."""
    plot = pyplot()
    pressure = 1e-6 * results.patches["max_pressure"]
    scale = plot.Normalize(0, pressure.max())
    outlines = [[_outlines(results, side, kind) for side in (0, 1)] for kind in ("wheel", "rail")]
    points = [[contact_points(results, side)[k] for side in (0, 1)] for k in (1, 0)]
    ratios = [max(_ratio([*outlines[row][side], points[row][side]]) for side in (0, 1)
                  if outlines[row][side] or len(points[row][side])) for row in (0, 1)]
    picture, axes = plot.subplots(2, 2, figsize=(11, 1.8 + ENTIRE / 2 * sum(ratios)), constrained_layout=True,
                                  gridspec_kw={"height_ratios": ratios})
    for row, kind in enumerate(("wheel", "rail")):
        for side, axis in enumerate(axes[row]):
            colours = _draw_profile(axis, outlines[row][side], points[row][side],
                                    pressure[results.patches["side"] == side], scale, (1, -1)[side])
            axis.set(title=f"{SIDES[side]} {kind}", aspect="equal", xlabel="y [mm]", ylabel="z [mm]")
            axis.grid(alpha=0.3)
            # The left side is at positive y. With this direction it is drawn on the left, as seen in travel direction.
            axis.invert_xaxis()
    picture.colorbar(colours, ax=axes, label="highest pressure [MPa]", shrink=0.9)
    return save(picture, path)


def _along_profiles(results, path):
    """Highest pressure of each patch over its place on the profile of wheel and rail, coloured by the contact angle."""
    plot, patches = pyplot(), results.patches
    angle = np.degrees(patches["contact_angle"])
    scale = plot.Normalize(min(0, angle.min()), max(1, angle.max()))
    picture, axes = plot.subplots(2, 2, sharey=True, figsize=(11, 6.5), constrained_layout=True)
    for row, (kind, name, origin) in enumerate((("wheel", "wheel_s", "running circle"), ("rail", "rail_s", "crown"))):
        limits = 1e3 * np.array([patches[name].min(), patches[name].max()])
        limits += max(0.05 * np.ptp(limits), 1) * np.array([-1, 1])
        for side, axis in enumerate(axes[row]):
            chosen = patches["side"] == side
            colours = axis.scatter(1e3 * patches[name][chosen], 1e-6 * patches["max_pressure"][chosen], c=angle[chosen],
                                   s=10, norm=scale, cmap="viridis")
            axis.set(title=f"{SIDES[side]} {kind}", xlabel=f"arc length from the {origin} [mm], outward: +",
                     ylabel="highest pressure [MPa]", xlim=limits if side else limits[::-1])  # as seen in travel direction
            axis.grid(alpha=0.3)
    axes[0][0].set_ylim(0, None)
    picture.colorbar(colours, ax=axes, label="contact angle [°]")
    return save(picture, path)
