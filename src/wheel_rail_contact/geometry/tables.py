# SPDX-License-Identifier: BSD-3-Clause
"""Tables of the calculation."""
import numpy as np

from ..command import writing
from .conicity import RadiusDifference, kinematic_wavelength

GEOMETRY, CONICITY = "contact_geometry.csv", "equivalent_conicity.csv"
MM = 1e3  # millimetres per metre
STEP_ROUND_OFF = 1e-6  # in the number of steps
TOUCH = {"y": "m", "z": "m", "wheel_y": "m", "rail_y": "m", "contact_angle": "rad", "rolling_radius": "m"}
UNITS = {"y": "m", "z": "m", "roll": "rad", "rolling_radius_difference": "m",
         **{f"{side}_{name}": unit for side in ("left", "right") for name, unit in TOUCH.items()},
         "amplitude": "m", "equivalent_conicity": "-", "wavelength": "m", "centre": "m"}
LOADED = "loaded_"  # begin of the names of columns under load


def points_of(geometry):
    """Contact geometry at each lateral displacement.

    A table: columns by their names, in SI units, NaN without a result; and in the column `reason` why there is none, or "".
    """
    columns = dict(zip(("y", "z", "roll", "rolling_radius_difference"), geometry.points.T))
    for side in ("left", "right"):
        columns.update(zip((f"{side}_{name}" for name in TOUCH), geometry.touch(side).T))
    return dict(columns, reason=geometry.reasons)


def conicity_of(curve, circles, amplitudes, step):
    """Equivalent conicity, wavelength and centre of the wave for amplitudes from the first to the last: a table as above.

    curve: as for RadiusDifference. circles: distance of the running circles and rolling radius [m]
    """
    first, last = amplitudes
    amplitude = first + np.arange(int((last - first) / step + STEP_ROUND_OFF) + 1) * step
    difference = RadiusDifference(curve)
    value, centre, reasons = zip(*map(difference.conicity, amplitude))
    wavelength = [kinematic_wavelength(of_wave, *circles) for of_wave in value]
    return {"amplitude": amplitude, "equivalent_conicity": np.array(value), "wavelength": np.array(wavelength),
            "centre": np.array(centre), "reason": list(reasons)}


def write(table, loaded, path):
    """Writes a table as CSV, with the columns of that under load, which may be {}. Cells without a result are empty."""
    table = {**table, **{LOADED + name: column for name, column in loaded.items() if name not in ("y", "amplitude")}}
    with writing(path), open(path, "w", encoding="utf-8") as stream:
        units = ((name, UNITS.get(name.replace(LOADED, ""))) for name in table)
        print(*(f"{name} [{unit}]" if unit else name for name, unit in units), sep=",", file=stream)
        for row in zip(*table.values()):
            print(*("" if cell != cell else cell if isinstance(cell, str) else f"{cell:.9g}" for cell in row), sep=",",
                  file=stream)
