# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the von Mises stress in a section of wheel and rail: of results of Python, and of messages."""
import numpy as np

from . import contour, stress
from .pressure import KN, MM, MPA, side_of
from .stress_section import BODIES, SIGNS, StressSection

COLOURS = "YlOrRd"
BODY, LINE, YIELD = "0.93", "0.25", "tab:blue"  # colours of a body beyond the field, of its surface, and of yield
ISOLINES = 8         # largest number of isolines
UNLABELLED = 0.3     # [-] share of the points along the depth, near the surface, where the isolines have no labels
ELSEWHERE = 0.02     # [-] distance of a peak from the section, as a share of the drawn depth, which is stated
SEE_THROUGH = 0.75   # opacity behind texts [-]
TITLE = "small"      # font size
DARK = 0.65          # [-] share of the colours above which lines on them are white
PAD = 0.05           # distance of the colour bar from the axes, as a share of these
BAR = 0.12           # width of the colour bar with its labels, as a share of the axes
POINTS = 4000        # number of points of a profile


def plot_stress(patch, contact=None, ax=None, max_stress=None, colorbar=True):
    """Draws the von Mises stress in wheel and rail, in the section across the track through the place of the highest one.

    patch: PatchResult, or message ContactPatch, with stress (stress/depths); or WheelsetResult, or message WheelsetContact: of
        its patches, the one with the highest von Mises stress
    contact: WheelsetContact with the parameters of the result. Its profiles are drawn, and its Poisson's ratios used. Default:
        both surfaces are the tangent plane, and Poisson's ratio is that of config/default.yaml. A rail with several parts, or
        that changes along the line, is drawn with the tangent plane, too
    ax: axes of matplotlib; default: those of a new figure
    max_stress: stress at the upper end of the colours [Pa]; default: the highest one of the patch
    colorbar: False omits the colour bar

    The picture is in true proportions, in mm, and seen in the direction of travel: y (left, in the tangent plane) points to the
    left, z (normal, out of the rail) up; both from the centre of pressure. Where the yield stress (material/*/yield) is given
    and exceeded, a line surrounds this region.

    Returns the axes. Raises ValueError for a patch without stress, a message without its grid, or max_stress below or equal to
    0.
    """
    if max_stress is not None and not max_stress > 0:
        raise ValueError(f"max_stress = {max_stress}: must be above 0")
    chosen = worst_patch(patch.patches) if hasattr(patch, "patches") else patch
    section = StressSection(chosen, *(_of_model(contact, chosen) if contact else ()))
    if ax is None:
        from matplotlib import pyplot
        ax = pyplot.subplots()[1]
    draw(ax, section, max_stress, colorbar)
    ax.set_title(title(chosen, section), fontsize=TITLE)
    return ax


def worst_patch(patches):
    """The patch with the highest von Mises stress. Raises ValueError if there is no patch."""
    if not len(patches):
        raise ValueError("patch: the result has no patch")
    return max(patches, key=lambda patch: max(getattr(patch, f"{name}_stress").von_mises.value for name in BODIES))


def _of_model(contact, patch):
    """Surfaces and Poisson's ratios for StressSection, by the parameters of a WheelsetContact."""
    profiles = {name: getattr(contact, f"{name}_profiles")[side_of(patch) == "right"] for name in BODIES}
    poisson = poisson_ratios(contact.config, side_of(patch))

    def surfaces(reach):
        return {name: _contour(profile, getattr(patch, f"{name}_s"), patch, reach) for name, profile in profiles.items()}

    whole = all(profile and len(profile.parts) == 1 for profile in profiles.values())
    return surfaces if whole else None, poisson


def poisson_ratios(parameters, side):
    """Poisson's ratios of wheel and rail on a side: of that side, of both sides, or the default.

    parameters: values by the names of the parameters, for example "material/wheel/poisson"
    side: "left" or "right"
    """
    def ratio(name):
        both = parameters.get(f"material/{name}/poisson", stress.core.DEFAULT_POISSON)
        return float(parameters.get(f"{name}/{side}/material/poisson", both))

    return {name: ratio(name) for name in BODIES}


def _contour(profile, s, patch, reach):
    """Contour of a profile about the place with the arc length s from its origin [m]."""
    points = np.stack(profile.at(np.linspace(*profile.parts[0], POINTS)), axis=1)
    arc = np.append(0, np.cumsum(np.hypot(*np.diff(points, axis=0).T)))
    arc -= arc[np.hypot(*points.T).argmin()]
    place = [np.interp(s, arc, column) for column in points.T]
    return contour.about(points, place, side_of(patch), patch.semi_axis_across, reach)


def title(patch, section):
    """Title of the picture of a section: two lines."""
    poisson = " and ".join(sorted({f"{body.poisson:g}" for body in section.bodies}))
    return (f"{section.side} wheel and rail: von Mises stress in the section x = {_millimetres(section.x)}\n"
            f"highest pressure {MPA * patch.max_pressure:.0f} MPa, N = {KN * patch.normal_force:.1f} kN, "
            f"contact angle {np.degrees(patch.contact_angle):.1f}°, ν = {poisson}")


def _millimetres(length):
    """A length [m] as text, without a sign of zero."""
    return f"{round(MM * length, 2) + 0.0:.2f} mm"


def draw(ax, section, max_stress=None, colorbar=True):
    """Draws a section.

    ax: axes of matplotlib
    section: StressSection
    max_stress, colorbar: as for plot_stress()
    """
    highest = MPA * max(body.beneath.von_mises.value for body in section.bodies)
    end = MPA * max_stress if max_stress else highest
    levels = _levels(end)
    for body in section.bodies:
        mesh = _draw_body(ax, section, body, end, levels)
    for line in section.loaded:
        ax.plot(*(MM * line.T), color="black", linewidth=2.5, solid_capstyle="butt", zorder=3)
    for body in section.bodies:
        _draw_peak(ax, section, body)
    depth = MM * section.depth
    ax.set(xlim=MM * section.width[::-1], ylim=(-depth, depth), aspect="equal", ylabel="z [mm]",
           xlabel=f"y [mm], left: +; the field side is on the {section.side}")
    _legend(ax, section)
    if colorbar:
        _colorbar(ax, mesh, levels, "max" if highest > end else "neither")


def _legend(ax, section):
    ax.plot([], [], color="black", linewidth=2.5, label="contact")
    ax.plot([], [], "+", color="black", markersize=9, markeredgewidth=1.5, label="highest stress")
    if any(0 < body.yield_stress < body.beneath.von_mises.value for body in section.bodies):
        ax.plot([], [], color=YIELD, linewidth=2, label="yield stress")
    ax.legend(loc="lower right", fontsize="x-small", framealpha=SEE_THROUGH)


def _colorbar(ax, mesh, levels, extend):
    """Colour bar with the height of the picture, and ticks at the isolines."""
    figure, place = ax.figure, ax.get_position(original=True)
    low, high = ax.get_ylim()
    left, right = ax.get_xlim()
    width, height = place.width * figure.get_figwidth() * (1 - BAR - PAD), place.height * figure.get_figheight()
    shrink = min(1, width * (high - low) / (left - right) / height)
    figure.colorbar(mesh, ax=ax, fraction=BAR, pad=PAD, shrink=shrink, aspect=20 * shrink, extend=extend, format="%g",
                    ticks=np.append(0, levels), label="von Mises stress [MPa]")


def _levels(highest):
    """Stresses of the isolines [MPa]: round numbers above 0 and below the highest stress."""
    step = 10 ** np.floor(np.log10(highest / ISOLINES))
    step *= next(factor for factor in (1, 2, 5, 10) if factor * step * ISOLINES >= highest)
    return step * np.arange(1, int(np.ceil(highest / step)))


def _draw_body(ax, section, body, end, levels):
    """Body with its stress; returns the coloured mesh."""
    outline, far = MM * body.surface.points, -3 * SIGNS[body.name] * MM * section.depth
    ax.fill(*np.vstack([outline, [(outline[-1, 0], far), (outline[0, 0], far)]]).T, facecolor=BODY, edgecolor="none", zorder=0)
    y, z, stress = MM * body.points[..., 0], MM * body.points[..., 1], MPA * body.stress
    mesh = ax.pcolormesh(y, z, stress, vmin=0, vmax=end, cmap=COLOURS, shading="gouraud", zorder=1)
    below = int(UNLABELLED * stress.shape[1])
    _isolines(ax, (y[:, :below + 1], z[:, :below + 1], stress[:, :below + 1]), levels, end)
    labelled = _isolines(ax, (y[:, below:], z[:, below:], stress[:, below:]), levels, end)
    if labelled:
        ax.clabel(labelled, fmt="%g", fontsize="x-small")
    ax.plot(*outline.T, color=LINE, linewidth=1, zorder=2)
    if 0 < MPA * body.yield_stress < stress.max():
        ax.contour(y, z, stress, levels=[MPA * body.yield_stress], colors=YIELD, linewidths=2, zorder=3)
    return mesh


def _isolines(ax, field, levels, end):
    """Draws the isolines of a field (y, z, stress); returns them, or None if it has none."""
    inside = [level for level in levels if field[2].min() < level < field[2].max()]
    if not inside:
        return None
    colours = ["white" if level > DARK * end else LINE for level in inside]
    return ax.contour(*field, levels=inside, colors=colours, linewidths=0.6, zorder=2)


def _draw_peak(ax, section, body):
    """Mark of the highest stress of a body, and its text in a corner of the body."""
    ax.plot(*(MM * body.place[:, None]), "+", color="black", markersize=9, markeredgewidth=1.5, zorder=4)
    peak = body.beneath.von_mises
    text = f"{body.name}: {MPA * peak.value:.0f} MPa, {MM * peak.depth:.2f} mm deep"
    if abs(peak.x - section.x) > ELSEWHERE * section.depth:
        text += f", at x = {_millimetres(peak.x)}"
    if body.yield_stress:
        text += f"\nyield stress {MPA * body.yield_stress:.0f} MPa"
        text += "" if peak.value > body.yield_stress else ", not reached"
        text += f"\nload factor {body.beneath.load_factor:.2f}, shakedown limit {body.beneath.shakedown_limit:.2f}"
    above = SIGNS[body.name] < 0
    ax.text(0.015, 0.975 if above else 0.025, text, transform=ax.transAxes, va="top" if above else "bottom", fontsize="small",
            bbox={"facecolor": "white", "edgecolor": "none", "alpha": SEE_THROUGH, "pad": 2}, zorder=5)
