# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the study."""
from . import force_picture, placement_picture, scan_picture, stress_picture

DPI = 110
PICTURES = ((placement_picture, "figure_3.png"), (scan_picture, "scan.png"), (force_picture, "forces.png"),
            (stress_picture, "stress.png"))


def draw(plot, study, folder):
    """Draws all pictures of a Study into the folder. Yields the path of each of them."""
    for module, name in PICTURES:
        figure = module.figure(study, plot)
        figure.savefig(folder / name, dpi=DPI)
        plot.close(figure)
        yield folder / name
