# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the study."""
from . import force_picture, placement_picture, scan_picture
from .files import read

DPI = 110
PICTURES = ((placement_picture, "figure_3.png"), (scan_picture, "scan.png"), (force_picture, "forces.png"))


def draw(plot, folder):
    """Draws all pictures into the folder and returns their paths."""
    return [_save(plot, module.figure(folder, plot, read), folder / name) for module, name in PICTURES]


def _save(plot, figure, path):
    figure.savefig(path, dpi=DPI)
    plot.close(figure)
    return path
