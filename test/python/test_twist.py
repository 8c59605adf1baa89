# SPDX-License-Identifier: BSD-3-Clause
"""Friction of rolling wheels: the arguments twist and rail_velocity, and the fields of the results."""
import math
import unittest

import numpy as np
from wheel_rail_contact import WheelsetContact

LOAD = -200e3  # of the axle [N]
EXACT = {"creep": {"method": "exact", "field": True}}
SPEED = 20.0   # [m/s]


def left(result):
    return result.patches[0]


class Friction(unittest.TestCase):
    def test_parts_and_wholes_of_all_fields_agree(self):
        result = WheelsetContact(EXACT).evaluate(yaw=2e-3, force_z=LOAD, twist={"speed": SPEED})
        self.assertEqual(result.speed, SPEED)
        self.assertAlmostEqual(result.rotation, SPEED / 0.46, delta=0.01 * result.rotation)
        for patch, wheel, outward in zip(result.patches, (result.left_wheel, result.right_wheel), (1, -1)):
            creep, cell = patch.creep, patch.dx * patch.dy
            self.assertAlmostEqual(creep.creepage_y, -2e-3, delta=1e-5)  # the wheel heads to the left of its way
            self.assertGreater(creep.force_y, 15e3)
            np.testing.assert_allclose([creep.traction_x.sum() * cell, creep.traction_y.sum() * cell],
                                       [creep.force_x, creep.force_y], rtol=1e-3)  # columns lie along the curved rail
            np.testing.assert_allclose([creep.lateral_force, creep.vertical_force],
                                       [-outward * creep.force_y * math.cos(patch.pose.roll),
                                        creep.force_y * math.sin(patch.pose.roll)], atol=1e-3 * creep.force_y)
            self.assertEqual(creep.lateral_force, wheel.friction_lateral_force)  # one patch on each side
            self.assertEqual((patch.lateral_force, patch.vertical_force), (wheel.lateral_force, wheel.vertical_force))
            share = math.hypot(creep.force_x, creep.force_y) / (0.3 * patch.normal_force)
            np.testing.assert_allclose(creep.adhesion_share, share, rtol=1e-3)
            self.assertGreater(creep.power, -SPEED * creep.creepage_y * creep.force_y * 0.99)
            self.assertRegex(repr(creep), r"^<PatchCreep: [^<>]*>$")

    def test_many_states_have_their_own_twists(self):
        contact, speeds = WheelsetContact(EXACT), np.array([SPEED, -10.0])
        many = contact.evaluate_many(yaw=1e-3, force_z=LOAD, twist={"speed": speeds, "lateral_velocity": 5e-3}, threads=2)
        for i, speed in enumerate(speeds):
            contact.reset()
            one = contact.evaluate(yaw=1e-3, force_z=LOAD, twist={"speed": speed, "lateral_velocity": 5e-3})
            self.assertEqual(many.rotation[i], one.rotation)
            wheels = one.left_wheel, one.right_wheel
            self.assertEqual([*many.friction_lateral_force[i]], [wheel.friction_lateral_force for wheel in wheels])
            self.assertEqual([*many.friction_vertical_force[i]], [wheel.friction_vertical_force for wheel in wheels])
            self.assertEqual([*many.adhesion_share[i]], [patch.creep.adhesion_share for patch in one.patches])
            self.assertEqual([*many.friction_power[i]], [patch.creep.power for patch in one.patches])

    def test_misuse_is_refused_by_name(self):
        free, given = WheelsetContact(EXACT), WheelsetContact({"creep": {"method": "linear", "rotation": "topic"}})
        for contact, arguments, error, text in ((free, {}, TypeError, "twist is missing: it is required, because creep/method"),
                (free, {"twist": [SPEED]}, TypeError, "twist = .*: must be a dict of velocities"),
                (free, {"twist": {"speed": None}}, TypeError, "twist: speed is missing"),
                (free, {"twist": {"speed": SPEED, "spin": 0}}, TypeError, "twist: 'spin' is unknown; valid names are speed,"),
                (given, {"twist": {"speed": SPEED}}, TypeError, "twist: rotation is missing: .* creep/rotation is topic"),
                (WheelsetContact(), {"twist": {"speed": SPEED}}, ValueError, "twist: must be omitted, .* set creep/method"),
                (WheelsetContact(), {"rail_velocity": np.zeros((2, 3))}, ValueError, "rail_velocity: must be omitted")):
            with self.subTest(arguments=arguments), self.assertRaisesRegex(error, text):
                contact.evaluate(force_z=LOAD, **arguments)
        self.assertEqual(free.evaluate(force_z=LOAD, twist={"speed": math.inf}).status, "INVALID_INPUT")

    def test_without_friction_everything_of_it_is_zero(self):
        for result in (WheelsetContact().evaluate(force_z=LOAD),
                       WheelsetContact(EXACT).evaluate(force_z=LOAD, twist={"speed": 0.0})):
            creep = left(result).creep
            self.assertEqual((result.speed, result.rotation, creep.force_y, creep.power), (0, 0, 0, 0))
            self.assertEqual((creep.traction_x.shape, result.left_wheel.friction_lateral_force), ((0, 0), 0))
