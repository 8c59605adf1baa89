# SPDX-License-Identifier: BSD-3-Clause
"""Places of the study: contacts of a left wheel, without roll and yaw of the wheelset."""
from dataclasses import dataclass

from . import worn_wheel

WORN = "worn"  # wheel of worn_wheel.py


@dataclass
class Place:
    """One position of a wheel on a rail.

    title        for pictures and tables
    wheel, rail  standard profiles, or WORN
    y            lateral position of the wheelset, towards the flange of the left wheel [m]
    loads        vertical loads of the wheel [N]
    kept_out     not used to find the model error, but to check it
    inclination  of the rail, top towards the track centre [rad]
    """
    name: str
    title: str
    y: float
    loads: tuple = (20e3, 60e3, 120e3)
    wheel: str = "S1002"
    rail: str = "60E1"
    kept_out: bool = False
    inclination: float = 0.025

    def parameters(self, folder):
        """Parameters of this place. The profile of a worn wheel is written to a folder (pathlib.Path)."""
        wheel = self.wheel
        if wheel == WORN:
            path = folder / "worn_wheel.csv"
            path.write_text(worn_wheel.table(self.inclination), encoding="ascii")
            wheel = str(path.resolve())
        return {"track": {"rail_inclination": self.inclination}, "wheel": {"profile": wheel}, "rail": {"profile": self.rail}}


PLACES = (
    Place("tread", "tread", 0.0),
    Place("gauge_corner", "gauge corner", 0.0062),
    Place("root_edge", "edge of the flange root", 0.0065),
    Place("flange_root", "flange root", 0.0066),
    Place("flange", "flange", 0.008, loads=(7e3, 20e3, 40e3)),
    Place("root_worn", "worn flange root", 0.0, wheel=WORN),
    Place("two_contacts", "two contacts, rail at 1:20", 0.006, loads=(20e3, 40e3, 60e3), inclination=0.05),
    Place("root_lma", "flange root, LMA on 60E1", 0.006, wheel="LMA", kept_out=True),
    Place("root_1_20", "flange root, rail at 1:20", 0.0065, kept_out=True, inclination=0.05),
)
RADIUS = 0.46  # of the running circle of the wheels [m]
