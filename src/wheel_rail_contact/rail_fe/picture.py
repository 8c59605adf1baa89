# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the loaded section, deformed by the check load and coloured by displacement."""
import numpy as np

from ..command import pyplot

SUBTRIANGLES = {8: [(7, 0, 4), (4, 1, 5), (5, 2, 6), (6, 3, 7), (4, 5, 6), (4, 6, 7)],
                6: [(0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)]}
SHOWN_SHARE = 0.12  # drawn length of the largest displacement, at most, as a share of the section height


def write_picture(path, study, solution):
    """Writes a PNG of the section at the load, deformed and undeformed. Raises Failure if matplotlib is missing."""
    plot = pyplot()
    faces = solution.mesh.plane_faces(0, 0.0)
    position, displacement = solution.mesh.nodes[:, 1:], solution.check[:, 1:]
    size = np.linalg.norm(displacement, axis=1)
    factor = _round_factor(SHOWN_SHARE * study.section.height / size[faces].max())
    triangles = faces[:, SUBTRIANGLES[faces.shape[1]]].reshape(-1, 3)
    shown = 1e3 * (position + factor * displacement)
    figure, axes = plot.subplots(figsize=(6.4, 6.8))
    colours = axes.tripcolor(*shown.T, triangles, 1e3 * size, shading="gouraud", cmap="viridis")
    _draw_edges(axes, shown, faces)
    outline = 1e3 * np.vstack([study.section.outline, study.section.outline[:1]])
    axes.plot(*outline.T, "--", color="0.35", linewidth=1.0, label="undeformed")
    used = np.unique(faces)
    _draw_force(axes, study, position[used], shown[used])
    axes.set(aspect="equal", xlabel="y, outward [mm]", ylabel="z, up [mm]", title=_title(study, factor))
    axes.legend(loc="center left", frameon=False)
    figure.colorbar(colours, label="displacement [mm]", shrink=0.8)
    figure.tight_layout()
    figure.savefig(path, dpi=130)
    plot.close(figure)


def _draw_edges(axes, shown, faces):
    """Draws the edges of the elements through their midpoints."""
    corners = faces.shape[1] // 2
    ring = np.column_stack([faces[:, [i, corners + i]] for i in range(corners)] + [faces[:, :1]])
    gap = np.full((len(faces), 1), np.nan)
    for_y, for_z = (np.hstack([shown[ring][..., k], gap]).ravel() for k in (0, 1))
    axes.plot(for_y, for_z, color="black", linewidth=0.25, alpha=0.6)


def _draw_force(axes, study, position, shown):
    """Draws the arrow of the check load. Its tip is the displaced node nearest to the position of the load."""
    loaded = study.section.points([study.section.gauge_face(study.check_height)])[0]
    tip = shown[np.linalg.norm(position - loaded, axis=1).argmin()]
    axes.annotate("", tip, tip - [30, 0], arrowprops={"arrowstyle": "-|>", "color": "crimson", "linewidth": 2})
    axes.text(tip[0] - 31, tip[1] + 4, f"{study.force / 1e3:g} kN", color="crimson", ha="left")


def _title(study, factor):
    kind = study.supports.replace("_", " ")
    if study.pads:
        kind = f"seats of {study.pads.lateral / 1e6:g}/{study.pads.vertical / 1e6:g} kN/mm"
    return (f"{study.section.name}, {study.length:g} m, {kind}\n"
            f"{study.force / 1e3:g} kN at z = {1e3 * study.check_height:g} mm, displacements magnified {factor:g} times")


def _round_factor(factor):
    """Rounds down to 1, 2, 5, 10, 20, ..., but not below 1."""
    power = 10.0 ** np.floor(np.log10(factor))
    return max(1.0, max(step for step in (1, 2, 5) if step * power <= factor) * power)
