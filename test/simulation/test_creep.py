# SPDX-License-Identifier: BSD-3-Clause
"""Creep forces in Python are those in C++, with any number of contacts on each wheel."""
import os
import subprocess
import unittest
from types import SimpleNamespace

import numpy as np

from wheel_rail_contact.simulation.creep import Contacts, creep_forces

PRINT_RAIL_FORCES = os.environ["PRINT_RAIL_FORCES"]
HAS_MODULE = os.environ["HAS_PYTHON_MODULE"] == "1"
SHEAR_MODULUS = 8.2e10  # default of CreepParameters [Pa]
SPEED, ROLL = 30.0, 0.002


def patch(side, ratio, size, normal_force, angle, x=0.0):
    """Patch of a wheel, with semi-axes a = ratio * b and sqrt(a b) = size [m]."""
    left = 1 if side == "left" else -1
    return SimpleNamespace(side=side, normal_force=normal_force, semi_axis_along=size * ratio ** 0.5,
                           semi_axis_across=size / ratio ** 0.5,
                           pose=SimpleNamespace(position=np.array([x, left * (0.75 - 0.03 * angle), -0.46]), roll=left * angle))


def result(*patches):
    return SimpleNamespace(patches=patches, wheelset=SimpleNamespace(position=np.zeros(3), roll=ROLL))


def in_python(of, creep, motion):
    """Creep forces along y and z, moments about x, z and the axle; motion: yaw, y', yaw', spin."""
    columns = np.reshape(motion, (4, 1, 1))
    return np.concatenate(creep_forces(Contacts(of, creep), columns[0], columns[1:], SPEED))


def case(of, creep, motion):
    """Line of a case for the C++ program."""
    numbers = [creep["poisson"], creep["friction"], *motion, ROLL, SPEED, len(of.patches)]
    for p in of.patches:
        numbers += [p.side == "left", *(p.pose.position - of.wheelset.position), p.pose.roll, p.normal_force,
                    p.semi_axis_along, p.semi_axis_across]
    return " ".join(repr(float(number)) if isinstance(number, float) else str(int(number)) for number in numbers)


def in_cpp(cases):
    done = subprocess.run([PRINT_RAIL_FORCES], input="\n".join(case(*one) for one in cases), stdout=subprocess.PIPE,
                          universal_newlines=True, timeout=60, check=True)
    return np.array([line.split() for line in done.stdout.splitlines()], dtype=float)


@unittest.skipUnless(HAS_MODULE, "the Python module is not built")
class CreepForces(unittest.TestCase):
    def compare(self, cases):
        """Python and C++ evaluate the same formulas: they differ by rounding."""
        expected = in_cpp(cases)
        self.assertEqual(len(expected), len(cases))
        for one, forces in zip(cases, expected):
            np.testing.assert_allclose(in_python(*one), forces, rtol=1e-9, atol=1e-9 * np.max(np.abs(forces)),
                                       err_msg=case(*one))
        return expected

    def test_forces_of_the_linear_theory_are_those_in_cpp(self):
        # Small creepages at a high friction; one contact: no cancellation.
        motions = ([0.0, 0.0, 0.0, SPEED / 0.46 * 1.00001], [0.0, 3e-4, 0.0, SPEED / 0.46], [0.0, 0.0, 3e-3, SPEED / 0.46])
        self.compare([(result(patch("left", ratio, 5e-3, 1e5, 0.05)),
                       {"poisson": poisson, "friction": 100.0, "shear_modulus": SHEAR_MODULUS}, motion)
                      for ratio in (0.05, 0.25, 1.0, 1.6, 20.0) for poisson in (0.0, 0.28, 0.5) for motion in motions])

    def test_forces_of_several_contacts_are_those_in_cpp_below_and_above_saturation(self):
        seed = 7
        random = np.random.RandomState(seed)
        creep = {"poisson": 0.28, "friction": 0.3, "shear_modulus": SHEAR_MODULUS}
        cases = []
        for sides in (("left", "right"), ("left", "left", "right"), ("left", "right", "right"), ("left",), ("right", "right"),
                      ()):
            for size in (1e-3, 1e-2) * 10:
                patches = [patch(side, 10 ** random.uniform(-1, 1), 5e-3, random.uniform(1e4, 2e5), random.uniform(0, 1.2),
                                 random.uniform(-0.01, 0.01)) for side in sides]
                motion = random.uniform(-1, 1, 4) * size * [1, SPEED, SPEED, SPEED] + [0, 0, 0, SPEED / 0.46]
                cases.append((result(*patches), creep, motion))
        forces = self.compare(cases)
        self.assertTrue(np.all(forces[-20:] == 0))
        self.assertTrue(np.all(np.any(forces[:-20] != 0, axis=1)))

    def test_unloaded_wheels_have_no_creep_force(self):
        from wheel_rail_contact import WheelsetContact
        contact = WheelsetContact()
        creep = {"poisson": 0.28, "friction": 0.3, "shear_modulus": SHEAR_MODULUS}
        motion = [1e-3, 0.02, 0.01, SPEED / 0.46]
        # A moment of +160 kN m moves 107 kN from the left wheel to the right one.
        for force_z, torque_x, sides in ((-200e3, 6e4, {"left", "right"}), (-200e3, 1.6e5, {"right"}),
                                         (-200e3, -1.6e5, {"left"}), (50e3, 0.0, set())):
            of = contact.evaluate(y=0.002, yaw=1e-3, force_z=force_z, torque_x=torque_x)
            self.assertTrue(of.usable)
            self.assertEqual({p.side for p in of.patches}, sides)
            forces = in_python(of, creep, motion)
            self.assertTrue(np.all(np.isfinite(forces)))
            self.assertEqual(np.any(forces != 0), bool(sides))
