# SPDX-License-Identifier: BSD-3-Clause
"""The paper's rail, bent by the friction of a wheelset with a yaw of 5 mrad (doc/paper.md). The only argument is the folder of the
picture."""
import sys
from pathlib import Path

import numpy as np

import wheel_rail_contact

from ..command import pyplot

MM, KN, MPA = 1e3, 1e-3, 1e-6
PLACE = {"y": 0.572e-3, "yaw": -5e-3, "force_z": -200e3}  # towards the left flange, turned to the right: slides to the left
SPEED, FRICTION = 20.0, 0.3  # [m/s], [-]
HEIGHT = 0.014  # of the crown above the reference point of the head [m]
METHODS = ("none", "linear", "fastsim", "exact")
GRID = {"grid": {"along": 48, "across": 96}}


def wheelset(method, **parameters):
    """Contact of the wheelset with the rails of the paper, which bend by the forces of the contacts."""
    creep = {"method": method, "friction": FRICTION, "field": method == "exact"}
    contact = wheel_rail_contact.WheelsetContact(
        ["config/paper.yaml", {"rail_bending": {"lateral_force": "contact"}, "creep": creep, **parameters}])
    return contact.evaluate(**PLACE, **({} if method == "none" else {"twist": {"speed": SPEED}}))


def print_table():
    """Prints the rows of the table in doc/paper.md."""
    for method in METHODS:
        result = wheelset(method)
        for side, wheel, rail in (("left", result.left_wheel, result.left_rail), ("right", result.right_wheel, result.right_rail)):
            patch, = (patch for patch in result.patches if patch.side == side)
            print(f"| {method} | {side} | {KN * wheel.lateral_force:.2f} | {KN * wheel.friction_lateral_force:.2f} "
                  f"| {MM * (rail.lateral + HEIGHT * rail.roll):.4f} | {MM * rail.roll:.2f} "
                  f"| {MPA * patch.max_pressure:.0f} / {1e6 * patch.area:.1f} | {100 * patch.creep.adhesion_share:.1f} % |")


def draw(path):
    """Draws the patch of the left wheel without and with friction, and the tractions on the wheel."""
    plot = pyplot()
    figure, axes = plot.subplots(1, 2, figsize=(9, 4.4), sharex=True, sharey=True, constrained_layout=True)
    patches = [wheelset(method, contact=GRID).patches[0] for method in ("none", "exact")]
    highest = max(patch.pressure.max() for patch in patches)
    for axis, patch, title in zip(axes, patches, ("without friction", f"µ = {FRICTION:g}, arrows: traction on the wheel")):
        wheel_rail_contact.plot_pressure(patch, axis, max_pressure=highest, colorbar=False)
        axis.set_title(f"{title}\n{MPA * patch.max_pressure:.0f} MPa, {1e6 * patch.area:.1f} mm²", fontsize=10)
    patch, few = patches[1], (slice(1, None, 4), slice(1, None, 6))
    x, y = np.meshgrid(MM * patch.x, MM * patch.y, indexing="ij")
    loaded = patch.pressure[few] > 0
    axes[1].quiver(x[few][loaded], y[few][loaded], patch.creep.traction_x[few][loaded], patch.creep.traction_y[few][loaded],
                   color="white", scale=3e9, width=0.004)
    figure.colorbar(axes[0].collections[0], ax=axes, label="pressure [MPa]")
    figure.savefig(path, dpi=100)


if __name__ == "__main__":
    print_table()
    draw(Path(sys.argv[1]) / "paper_friction.png")
