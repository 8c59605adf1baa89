# SPDX-License-Identifier: BSD-3-Clause
"""Motion of the wheelset with prescribed contacts, and contacts that are held."""
import unittest
from types import SimpleNamespace

import numpy as np

from wheel_rail_contact.command import Failure
from wheel_rail_contact.core.derivatives import Derivatives
from wheel_rail_contact.simulation.contact import HeldContact
from wheel_rail_contact.simulation.parameters import read_parameters, step_count
from wheel_rail_contact.simulation.stability import state_matrix
from wheel_rail_contact.simulation.wheelset import Request, Wheelset


class Rails:
    """Rails that give a prescribed reply, whatever the request; without forces at first."""

    def __init__(self):
        self.left_rail, self.right_rail = (SimpleNamespace(given_vertical=0.0, vertical_slope=0.0) for _ in range(2))
        self.force, self.torque = SimpleNamespace(x=0.0, y=0.0, z=0.0), SimpleNamespace(x=0.0, y=0.0, z=0.0)
        self.rail_wrench = SimpleNamespace(force=self.force, torque=self.torque)
        self.usable, self.rotation = True, 0.0
        self.wheelset = SimpleNamespace(position=SimpleNamespace(z=0.46), roll=0.0)
        self.derivatives = Derivatives(np.zeros(60), np.zeros(48))

    def evaluate(self, _):
        return self


class Prescribed:
    """Contact with a prescribed usability in each call; its number is that of the call."""

    def __init__(self, *usable):
        self._usable, self.calls = usable, 0

    def evaluate(self, _):
        self.calls += 1
        return SimpleNamespace(usable=self._usable[self.calls - 1], number=self.calls, status="OFF_PROFILE",
                               status_text="beyond the end of a profile")


class Motion(unittest.TestCase):
    def setUp(self):
        self.p, self.rails = read_parameters(), Rails()
        self.held = HeldContact(self.rails, 0)

    def near(self, value, expected, delta):
        self.assertAlmostEqual(value, expected, delta=delta)

    def test_load_has_no_force_of_the_rails(self):
        self.p["wheelset"]["gyroscopic"] = 0.0
        self.rails.wheelset.roll = 0.002
        self.force, self.torque = self.rails.force, self.rails.torque
        self.force.x, self.force.y, self.force.z = -100.0, 5e3, 200e3
        self.torque.x, self.torque.y, self.torque.z = 8e3, 30.0, 2e3
        wheelset = Wheelset(self.p)
        wheelset.advance(self.held)
        request, s, step = wheelset.request(), self.p["suspension"], self.p["run"]["step"]
        self.near(request.torque_x, -2 * s["vertical_stiffness"] * s["half_spacing"]**2 * 0.002, 1e-9)
        self.assertEqual(request.force_z, -self.p["wheelset"]["axle_load"])
        # The forces of the rails move the wheelset.
        spring = 2 * s["lateral_stiffness"] * wheelset.position[0]
        turning = 2 * s["longitudinal_stiffness"] * s["half_spacing"]**2 * wheelset.position[3]
        self.near(request.lateral_velocity, step * (5e3 - spring) / self.p["wheelset"]["mass"], 1e-12)
        self.near(request.yaw_rate, step * (2e3 - turning) / self.p["wheelset"]["yaw_inertia"], 1e-12)

    def test_small_motions_are_those_of_masses_on_springs_and_of_a_gyroscope(self):
        w, s, arm = self.p["wheelset"], self.p["suspension"], self.p["suspension"]["half_spacing"]**2
        contact, compliance, rotation = np.zeros((3, 5)), 1e-6, 87.0
        contact[2, 2] = compliance  # roll by torque [rad/(N m)]
        values = np.linalg.eigvals(state_matrix(self.p, contact, rotation))
        # The roll is that of compliance and springs under the torque I_y W yaw'; its rate acts as an inertia about z.
        softness = compliance / (1 + compliance * 2 * arm * s["vertical_stiffness"])
        inertia = w["yaw_inertia"] + softness * (w["spin_inertia"] * rotation)**2
        lateral = np.sqrt(2 * s["lateral_stiffness"] / w["mass"])
        yaw = np.sqrt(2 * arm * s["longitudinal_stiffness"] / inertia)
        np.testing.assert_allclose(sorted(values.imag), sorted([-lateral, -yaw, yaw, lateral]), rtol=1e-12)
        np.testing.assert_allclose(values.real, 0, atol=1e-9)

    def test_a_gyroscopic_wheelset_conserves_its_angular_momentum(self):
        # Without moments about z, I_z yaw' + I_y W roll is constant.
        self.p["suspension"].update(longitudinal_stiffness=0.0, vertical_stiffness=0.0)
        self.rails.rotation, roll = 87.0, 1e-3
        wheelset = Wheelset(self.p)
        for share in (0, 0.5, 1, 1, 1):
            self.rails.wheelset.roll = share * roll
            wheelset.advance(self.held)
        momentum = self.p["wheelset"]["spin_inertia"] * 87
        self.near(wheelset.velocity[3], -momentum * roll / self.p["wheelset"]["yaw_inertia"], 1e-9)
        # The turn of the axle to the right raises the right wheel: the moment on the axle is negative.
        self.near(wheelset.request().torque_x, momentum * wheelset.velocity[3], 1e-9)

    def test_load_has_the_inertia_on_a_line(self):
        self.p["suspension"]["vertical_stiffness"] = 0.0
        rise, turn, w = 3.0, 2.0, self.p["wheelset"]  # [m/s^2], [rad/s^2]
        for is_on in (1.0, 0.0):
            w["line_inertia"] = is_on
            wheelset = Wheelset(self.p)
            for i in range(4):
                half_square = 0.5 * (i * self.p["run"]["step"])**2
                self.rails.left_rail.given_vertical = half_square * (rise + 0.75 * turn)
                self.rails.right_rail.given_vertical = half_square * (rise - 0.75 * turn)
                wheelset.advance(self.held)
            self.near(wheelset.request().force_z, -w["axle_load"] - is_on * w["mass"] * rise, 1e-3)
            self.near(wheelset.request().torque_x, -is_on * w["yaw_inertia"] * turn, 1e-3)

    def test_given_height_settles_on_stiff_rails(self):
        # Linear rails, on which the wheelset has 200 Hz: a step of 1 ms damps this motion, and Newton's first change is exact.
        stiffness, rails, requests, forces = 1500 * (2 * np.pi * 200)**2, self.rails, [], np.zeros((6, 10))
        forces[2, 1] = -stiffness

        def evaluate(request):
            requests.append(request)
            rails.force.z = stiffness * (0.46 - request.z)
            return rails

        rails.evaluate, rails.static_start, rails.derivatives = evaluate, lambda _: rails, Derivatives(forces, [])
        wheelset = Wheelset(self.p, height_given=True)
        wheelset.start(rails)
        self.assertEqual(wheelset.position[1], 0.46)
        for _ in range(200):
            wheelset.advance(self.held)
        self.near(rails.force.z, self.p["wheelset"]["axle_load"], 1e-3)
        self.assertLess(len(requests), 2 * 200)

    def test_step_is_a_whole_number_of_nanoseconds(self):
        self.p["run"].update(step=1 / 3000, duration=0.1)
        self.assertEqual(step_count(self.p["run"]), 301)  # 300 steps of 333333 ns end 100 ns before 0.1 s
        wheelset = Wheelset(self.p)
        wheelset.advance(self.held)
        self.assertEqual(wheelset.request().time, 333333)
        # The rounding changes the step by 1e-6.
        way = wheelset.position[0] - self.p["run"]["y"]
        self.near(way / (333333e-9 * wheelset.velocity[0]), 1, 1e-8)


class Held(unittest.TestCase):
    def test_last_usable_contact_is_held_and_counted(self):
        contact = HeldContact(Prescribed(True, False, False, True, False, False), 2)
        for number, is_held in ((1, False), (1, True), (1, True), (4, False), (4, True), (4, True)):
            self.assertEqual(contact.evaluate(Request()).number, number)
            self.assertEqual(contact.in_a_row > 0, is_held)
        self.assertEqual(contact.held, 4)

    def test_too_many_successive_steps_or_none_before_stop_with_the_reason(self):
        contact = HeldContact(Prescribed(True, False, False, False), 2)
        for _ in range(3):
            contact.evaluate(Request())
        with self.assertRaises(Failure) as failure:
            contact.evaluate(Request())
        self.assertEqual(str(failure.exception), "no usable contact in 3 successive steps, at 0.000000 s, y = 0.000000 mm: "
                                                 "OFF_PROFILE: beyond the end of a profile")
        with self.assertRaises(Failure):
            HeldContact(Prescribed(False), 5).evaluate(Request())  # the first step must be usable
