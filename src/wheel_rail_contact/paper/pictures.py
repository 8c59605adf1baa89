# SPDX-License-Identifier: BSD-3-Clause
"""The study's pictures. Colours are Okabe and Ito's and viridis: told apart by colour-blind eyes and in grey."""
from .files import StudyError, read

BLACK, ORANGE, SKY, GREEN, BLUE, RED, PURPLE = ("#000000", "#E69F00", "#56B4E9", "#009E73", "#0072B2", "#D55E00",
                                                "#CC79A7")
DPI = 110


def check():
    """Raises StudyError if matplotlib is missing."""
    _pyplot()


def draw(folder):
    """Draws all pictures into the folder; returns their files."""
    from . import force_picture, placement_picture, scan_picture  # they need matplotlib

    return [_save(module.figure(folder, _pyplot(), read), folder / name)
            for module, name in ((placement_picture, "figure_3.png"), (scan_picture, "scan.png"),
                                 (force_picture, "forces.png"))]


def _save(figure, path):
    figure.savefig(path, dpi=DPI)
    _pyplot().close(figure)
    return path


def _pyplot():
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
    except ImportError as error:
        raise StudyError("matplotlib is not installed; on Debian: apt install python3-matplotlib") from error
    return pyplot
