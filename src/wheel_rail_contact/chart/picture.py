# SPDX-License-Identifier: BSD-3-Clause
"""What both pictures share: name, colour and marker of each method, ticks, file formats."""
import math

# Colours that people with any colour vision can distinguish (Okabe and Ito 2008), and a marker for each.
METHODS = {
    "hertz": ("Hertz", "#E69F00", "o"),
    "kik_piotrowski": ("Kik–Piotrowski", "#56B4E9", "s"),
    "seidel_printed": ("Seidel, as printed", "#CC79A7", "v"),
    "seidel": ("Seidel, repaired", "#D55E00", "^"),
    "conjugate_gradient": ("conjugate gradients", "#0072B2", "D"),
    "auto": ("auto", "black", "*"),
}
STYLE = {"font.size": 9, "svg.hashsalt": "chart", "svg.fonttype": "none"}


def setting_label(method, setting):
    return f"{100 * setting:g} %" if method == "auto" else f"{setting[0]}×{setting[1]}"


def grid_text(text):
    """Grid as the table states it, with a multiplication sign."""
    return text.replace("x", "×")


def set_ticks(axis, low, high):
    """Draws ticks of an axis (axes.xaxis or axes.yaxis) at the powers of ten from low to high, with labels."""
    powers = [10.0 ** n for n in range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)]
    axis.set_ticks(powers)
    axis.set_ticklabels([f"{power:g}" for power in powers])


def share_labels(points):
    """Groups consecutive points (time, error, label, ...) whose labels would overlap."""
    groups = []
    for point in points:
        last = groups[-1][-1] if groups else None
        if last and abs(math.log(point[0] / last[0])) < 0.5 and abs(math.log(point[1] / last[1])) < 0.3:
            groups[-1].append(point)
        else:
            groups.append([point])
    return groups


def save(plot, figure, paths, dpi):
    for path in paths:
        figure.savefig(path, dpi=dpi, metadata={"Date": None} if path.suffix == ".svg" else None)
    plot.close(figure)
