# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the estimated errors."""
import numpy as np

from ..command import pyplot
from .drawing import save

SMALLEST = 1e-12  # estimated errors below it are drawn as this value [-]


def figure(results, path):
    """Histogram of the estimated errors of the patches, by method."""
    picture, axis = pyplot().subplots(figsize=(7, 3), constrained_layout=True)
    errors = np.maximum(results.patches["error_estimate"], SMALLEST)
    edges = np.geomspace(errors.min() / 1.1, errors.max() * 1.1, 40)
    for method in sorted(set(results.patches["method"])):
        axis.hist(errors[results.patches["method"] == method], bins=edges, alpha=0.6, label=method)
    axis.set(xscale="log", xlabel="estimated relative error of a patch", ylabel="patches")
    axis.legend(fontsize="small")
    return save(picture, path)
