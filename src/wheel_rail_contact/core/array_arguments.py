# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that are numbers."""
import numpy as np


def numbers_of(name, value, words="a number or an array of numbers"):
    """An argument as an array of float.

    Raises TypeError for what numpy takes as numbers but is none, text and True, and for all else that is none.
    """
    try:
        array = np.asarray(value)
    except ValueError:  # lists of different lengths
        array = np.array(None)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} = {value!r}: must be {words}")
    return array.astype(float)
