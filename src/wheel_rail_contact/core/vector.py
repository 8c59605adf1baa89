# SPDX-License-Identifier: BSD-3-Clause
"""Points, vectors and quaternions as arrays that also have the names of messages."""
import numpy as np


class Vector(np.ndarray):
    """Array (3,) or (4,) whose numbers are also x, y, z and w."""

    x, y, z, w = (property(lambda self, i=i: self.item(i)) for i in range(4))


def vector(*numbers):
    """Read-only Vector of numbers."""
    array = np.array(numbers).view(Vector)
    array.flags.writeable = False
    return array
