# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the study."""
from . import force_picture, placement_picture, scan_picture, stress_picture
from .files import read

DPI = 110
PICTURES = ((placement_picture, "figure_3.png"), (scan_picture, "scan.png"), (force_picture, "forces.png"),
            (stress_picture, "stress.png"))


def draw(plot, folder):
    """Draws all pictures into the folder. Yields a sentence for each of them."""
    for module, name in PICTURES:
        try:
            figure = module.figure(folder, plot, read)
        except ImportError as error:  # The Python module is optional in a build.
            yield f"left out {name}: {error}"
            continue
        figure.savefig(folder / name, dpi=DPI)
        plot.close(figure)
        yield f"wrote {folder / name}"
