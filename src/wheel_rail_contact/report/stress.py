# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the von Mises stress in wheel and rail, at the instant when that of a wheel is highest."""
import re

import numpy as np

from ..command import pyplot
from ..message_constants import SIDES
from .drawing import save
from .positions import contact_points
from .results import rail_outline

SIZE = (8.0, 5.8)  # [inch] of a picture
BODIES = ("wheel", "rail")


def worst_patches(results):
    """Index of the patch with the highest von Mises stress of each wheel, by side; none of a wheel without stress."""
    highest = np.maximum(*(results.patches[f"{name}_stress.von_mises.value"] for name in BODIES))
    stressed = {side: np.flatnonzero((results.patches["side"] == side) & (highest > 0)) for side in (0, 1)}
    return {side: int(patches[highest[patches].argmax()]) for side, patches in stressed.items() if len(patches)}


def items(results, worst, messages, title, out):
    """Pictures of the worst patches, or sentences instead of them, for the page.

    @param worst as of worst_patches()
    @param messages message with grids of each result that is needed, by its index
    @param title function: index of a result -> its title
    @param out folder for the pictures
    """
    if not worst:
        return []
    try:
        poisson = [poisson_ratios(results.parameters, side) for side in ("left", "right")]
    except ImportError as error:  # Builds with sanitizers have no extension module.
        return [f"The pictures of the stress are left out: {error}."]
    return [_item(results, side, patch, (messages, title, poisson, out)) for side, patch in sorted(worst.items())]


def _item(results, side, patch, shown):
    messages, title, poisson, out = shown
    result = int(results.patches["result"][patch])
    message = messages[result].patches[patch - int(np.searchsorted(results.patches["result"], result))]
    if not message.grid.nx:
        return f"{SIDES[side]} wheel, {title(result)}: no picture of the stress (the bag contains no grids)"
    return figure(message, title(result), _surfaces(results, side, patch, message), poisson[side], out / f"stress_{side}.png")


def figure(patch, heading, surfaces, poisson, path):
    """Section of wheel and rail beneath a patch. Returns the path.

    @param patch message ContactPatch with grid and stress
    @param surfaces, poisson as for StressSection
    """
    from ..core import stress_picture, stress_section
    section = stress_section.StressSection(patch, surfaces, poisson)
    picture, axis = pyplot().subplots(figsize=SIZE)
    stress_picture.draw(axis, section)
    axis.set_title(f"{heading}\n{stress_picture.title(patch, section)}", fontsize=stress_picture.TITLE)
    return save(picture, path)


def poisson_ratios(parameters, side):
    """Poisson's ratios of wheel and rail in the parameters of a replay; those of config/default.yaml where they are not known.

    @param parameters text with a line "material/wheel/poisson: VALUE"; empty for a recording of a live node
    @param side "left" or "right"
    @throw ImportError if there is no extension module
    """
    from ..core import stress_picture
    return stress_picture.poisson_ratios(dict(re.findall(r"^(\S+/poisson): (\S+)$", parameters, re.MULTILINE)), side)


def _surfaces(results, side, patch, message):
    """Surfaces for StressSection, from the outlines of the profiles; None if the bag does not contain them."""
    from ..core import contour
    if "wheel" not in results.outlines[side]:
        return None
    distance = results.distance[results.patches["result"][patch]]
    outlines = {"wheel": results.outlines[side]["wheel"], "rail": rail_outline(results, side, distance)}
    of_side = int(np.count_nonzero(results.patches["side"][:patch] == side))
    places = {name: points[of_side] for name, points in zip(("rail", "wheel"), contact_points(results, side))}

    def surfaces(reach):
        return {name: contour.about(outlines[name], places[name], SIDES[side], message.semi_axis_across, reach)
                for name in BODIES}

    return surfaces
