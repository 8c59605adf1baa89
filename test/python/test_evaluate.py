# SPDX-License-Identifier: BSD-3-Clause
"""WheelsetContact.evaluate()."""
import gc
import json
import math
import os
import pathlib
import resource
import subprocess
import tempfile
import unittest
import warnings

import numpy as np
import rosbag
from wheel_rail_contact import WheelsetContact, named_derivatives, to_array
from wheel_rail_contact.core.derivatives import Derivatives
from wheel_rail_contact.message_constants import SIDES, STATUSES
from wheel_rail_contact.msg import ContactDerivatives
from wheel_rail_contact.states.state import State, write_bag

REPLAY = os.environ["CONTACT_REPLAY"]
LOAD = -200e3  # of the axle [N]
DERIVATIVES = {"contact": {"derivatives": True}}
PADS = {"rail_bending": {"model": "compliance", "table": "config/rails/pads_40_100.yaml"}}
NUMBERS = ("float64", "uint32")  # of the messages of patches, wheels and rails
ROUNDING = 1e-7  # of numbers in messages, relative: the pressures are float32, poses are quaternions


def replayed(states, config):
    """Messages that contact_replay writes for states of one second."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        write_bag(folder / "in.bag", states)
        (folder / "config.yaml").write_text(json.dumps(config))
        subprocess.run([REPLAY, folder / "in.bag", folder / "out.bag", "--config", folder / "config.yaml"], check=True,
                       stdout=subprocess.DEVNULL)
        with rosbag.Bag(str(folder / "out.bag")) as bag:
            return [message for _, message, _ in bag.read_messages("/contact_node/contact")]


class EvaluateEqualsReplay(unittest.TestCase):
    def assert_close(self, value, expected, name):
        np.testing.assert_allclose(value, expected, rtol=ROUNDING, atol=ROUNDING * np.abs(expected).max(), err_msg=name)

    def assert_equal_numbers(self, value, message):
        """Compares all fields of a message that are numbers."""
        names = [name for name, kind in zip(message.__slots__, message._slot_types) if kind in NUMBERS]
        self.assertTrue(names)
        for name in names:
            self.assert_close(getattr(value, name), getattr(message, name), name)

    def assert_equal_patch(self, patch, message):
        self.assertEqual(patch.side, SIDES[message.side])
        self.assertEqual(patch.method, message.method)
        self.assert_equal_numbers(patch, message)
        grid = message.grid
        self.assert_close(patch.pressure, to_array(grid), "pressure")  # float32 in the message
        self.assert_close(patch.x, grid.x0 + grid.dx * np.arange(grid.nx), "x")
        self.assert_close(patch.y, grid.y0 + grid.dy * np.arange(grid.ny), "y")
        self.assert_equal_pose(patch.pose, message.pose)
        self.assert_equal_numbers(patch.creep, message.creep)
        for name in ("traction_x", "traction_y") if message.creep.traction_x else ():
            expected = np.reshape(getattr(message.creep, name), (grid.ny, grid.nx)).T
            self.assert_close(getattr(patch.creep, name), expected, name)

    def assert_equal_pose(self, pose, message):
        for name, axes in (("position", "xyz"), ("orientation", "xyzw")):
            expected = [getattr(getattr(message, name), axis) for axis in axes]
            self.assert_close(getattr(pose, name), expected, name)
            self.assertEqual([getattr(getattr(pose, name), axis) for axis in axes], list(getattr(pose, name)))

    def assert_equal_result(self, result, message):
        self.assertEqual(result.status, STATUSES[message.status])
        self.assertEqual((result.status_text, result.held), (message.status_text, message.held))
        for name in ("distance", "speed", "rotation"):
            self.assert_close(getattr(result, name), getattr(message, name), name)
        self.assert_equal_pose(result.wheelset, message.wheelset)
        orientation = message.wheelset.orientation
        self.assertAlmostEqual(result.wheelset.roll, 2 * math.atan2(orientation.x, orientation.w), delta=1e-10)  # [rad]
        for side in SIDES:
            for body in ("rail", "wheel"):
                self.assert_equal_numbers(getattr(result, f"{side}_{body}"), getattr(message, f"{side}_{body}"))
        for name in ("force", "torque"):
            expected = getattr(message.rail_wrench, name)
            self.assert_close(getattr(result.rail_wrench, name), [expected.x, expected.y, expected.z], name)
        derivatives, expected = result.derivatives, named_derivatives(message.derivatives)
        for value, matrix in ((derivatives.forces, expected.forces), (derivatives.solution, expected.solution)):
            self.assertEqual((value.rows, value.columns), (matrix.rows, matrix.columns))
            np.testing.assert_allclose(value, matrix, rtol=1e-6, atol=1e-6 * np.abs(np.nan_to_num(matrix)).max(initial=0))
        self.assertEqual(len(result.patches), len(message.patches))
        for patch, expected in zip(result.patches, message.patches):
            self.assert_equal_patch(patch, expected)

    def test_the_same_states_give_the_same_results(self):
        # From the right flange to the left one, and a wheel without load.
        lateral = np.linspace(-6.5e-3, 6.5e-3, 21)
        states = [State(1_000_000_000 + i * 10_000_000, y=y, force_z=LOAD, torque_x=torque)
                  for i, (y, torque) in enumerate([*((y, 1e6 * y) for y in lateral), (0.0, 3e5)])]
        messages = replayed(states, {**PADS, **DERIVATIVES})
        contact = WheelsetContact([PADS, DERIVATIVES])
        self.assertEqual([len(messages[0].derivatives.forces), len(messages[0].derivatives.solution)], [24, 24])
        self.assertEqual(len(messages), len(states))
        self.assertEqual({STATUSES[message.status] for message in messages}, {"OK", "LIFT_OFF"})
        for state, message in zip(states, messages):
            result = contact.evaluate(y=state.y, force_z=state.force_z, torque_x=state.torque_x)
            self.assert_equal_result(result, message)

    def test_velocities_and_friction_are_the_same(self):
        pose = {"y": 2e-3, "z": 0.4597}
        twist = {"speed": 20.0, "lateral_velocity": 0.02, "vertical_velocity": 0.01, "roll_rate": 0.1, "yaw_rate": 0.04,
                 "rotation": 43.4}
        config = {"creep": {"method": "exact", "field": True, "rotation": "topic"}, "track": {"displacement": "topic"},
                  "wheelset": {"free": []}}
        message, = replayed([State(1_000_000_000, **pose, force_z=LOAD, **twist, left_rail_lateral_velocity=0.03)], config)
        result = WheelsetContact(config).evaluate(**pose, twist=twist, rail_displacement=np.zeros((2, 3)),
                                                  rail_velocity=[[0.03, 0, 0], [0, 0, 0]])
        self.assert_equal_result(result, message)
        self.assertTrue(message.patches[0].creep.traction_x)

    def test_yaw_has_the_same_sense(self):
        message, = replayed([State(1_000_000_000, x=12.5, y=5e-3, yaw=0.02, force_z=LOAD)], {})
        result = WheelsetContact().evaluate(x=12.5, y=5e-3, yaw=0.02, force_z=LOAD)
        self.assertAlmostEqual(result.wheelset.yaw, 0.02, delta=1e-12)
        self.assert_equal_pose(result.wheelset, message.wheelset)
        self.assertEqual(len(result.patches), len(message.patches))
        for patch, expected in zip(result.patches, message.patches):
            self.assertGreater(abs(expected.pose.position.x - 12.5), 1e-4)
            # The quaternion rounds the yaw. The tolerance of the solution is 1 %.
            np.testing.assert_allclose([patch.pose.position.x - 12.5, patch.max_pressure],
                                       [expected.pose.position.x - 12.5, expected.max_pressure], rtol=0.01)


class DerivativesHaveNames(unittest.TestCase):
    def test_names_and_numbers_are_indices(self):
        numbers = np.arange(60.0).reshape(6, 10)
        forces = named_derivatives(ContactDerivatives(forces=numbers.ravel(), solution=())).forces
        np.testing.assert_array_equal(forces, numbers)
        self.assertEqual((forces["force_y", "yaw"], forces[1, 3], forces["torque_z"][0]), (13, 13, 50))
        rows, columns = ["torque_z", "force_y"], ["lateral_velocity", "y"]
        np.testing.assert_array_equal(forces[rows, columns], [[55, 50], [15, 10]])
        np.testing.assert_array_equal(forces[:, "rotation"], numbers[:, 9])

    def test_other_names_and_numbers_of_entries_are_refused(self):
        with self.assertRaisesRegex(KeyError, "'pitch' is none of y, z, roll, yaw"):
            Derivatives(np.zeros(24), ()).forces["force_y", "pitch"]
        with self.assertRaisesRegex(KeyError, "'z' is none of the names, because there are no derivatives"):
            WheelsetContact().evaluate(force_z=LOAD).derivatives.solution["z", "y"]
        for count in (23, 66):
            with self.assertRaises(ValueError):
                Derivatives(np.zeros(count), ())

    def test_solved_forces_follow_from_those_at_given_height_and_the_height(self):
        derivatives = WheelsetContact(DERIVATIVES).evaluate(y=2e-3, force_z=LOAD).derivatives
        forces, solution = derivatives.forces, derivatives.solution
        force_y = forces["force_y", "y"] + forces["force_y", ["z", "roll"]] @ solution[["z", "roll"], "y"]
        sides = solution["right_lateral_force", "y"] - solution["left_lateral_force", "y"]
        self.assertAlmostEqual(force_y, sides, delta=1e-3 * abs(forces["force_y", "y"]))

    def test_columns_of_motion_are_differences(self):
        contact = WheelsetContact([DERIVATIVES, {"creep": {"method": "linear"}, "wheelset": {"free": []}}])
        twist = {"speed": 20.0, "lateral_velocity": 0.01}

        def forces(name, velocity):
            wrench = contact.evaluate(z=0.4599, twist={**twist, name: twist.get(name, 0.0) + velocity}).rail_wrench
            return np.concatenate([wrench.force, wrench.torque])

        derivatives = contact.evaluate(z=0.4599, twist=twist).derivatives.forces
        for name in ("lateral_velocity", "vertical_velocity", "roll_rate", "yaw_rate"):
            column = derivatives[:, name]
            difference = (forces(name, 1e-4) - forces(name, -1e-4)) / 2e-4
            np.testing.assert_allclose(column, difference, atol=0.01 * np.abs(column).max(), err_msg=name)


class ResultIsAValue(unittest.TestCase):
    def test_a_result_survives_later_calls_and_its_contact(self):
        contact = WheelsetContact()
        result = contact.evaluate(y=3e-3, force_z=LOAD)
        pressure, z, text = result.patches[0].pressure, result.wheelset.position.z, repr(result)
        copy = pressure.copy()
        for y in (-6e-3, 0.0, 6e-3):
            contact.evaluate(y=y, force_z=LOAD)
        del contact, result
        gc.collect()
        np.testing.assert_array_equal(pressure, copy)
        self.assertEqual((z > 0.4, text[:19]), (True, "<WheelsetResult OK:"))

    def test_evaluations_leak_no_memory(self):
        contact = WheelsetContact()

        def evaluate(count):
            for i in range(count):
                contact.evaluate(y=1e-3 + 1e-7 * (i % 10), force_z=LOAD)
            return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # [kB]

        before = evaluate(1000)
        # 10 000 results take about 50 MB.
        self.assertLess(evaluate(10_000) - before, 4000)

    def test_the_pressure_carries_the_load_and_is_read_only(self):
        patch = WheelsetContact().evaluate(force_z=LOAD).patches[0]
        self.assertEqual(patch.pressure.shape, (len(patch.x), len(patch.y)))
        force = patch.pressure.sum() * patch.dx * patch.dy
        np.testing.assert_allclose(force, patch.normal_force, rtol=0.01)  # each column has its own normal
        with self.assertRaisesRegex(ValueError, "read-only"):
            patch.pressure[0, 0] = 1

    def test_texts_are_short(self):
        result = WheelsetContact().evaluate(force_z=LOAD)
        self.assertRegex(repr(result), r"^<WheelsetResult OK: y 0\.000 mm, z \d+\.\d+ mm, .* 2 patches, \d+ MPa>$")
        self.assertRegex(repr(result.patches[0]), r"^<PatchResult left: \d+ MPa, 10\d\.\d+ kN, \d+\.\d mm², \d\.\d+°>$")
        self.assertEqual(repr(WheelsetContact()), "<WheelsetContact: wheels S1002, rails 60E1, method auto>")
        for value in (result.left_wheel, result.right_rail, result.rail_wrench, result.wheelset,
                      result.patches[0].pose):
            self.assertRegex(repr(value), rf"^<{type(value).__name__}: [^<>]*>$")


class EarlierNames(unittest.TestCase):
    def setUp(self):
        contact = WheelsetContact(PADS)
        state = {"x": 12.5, "y": 5e-3, "yaw": 0.02, "force_z": LOAD, "rail_displacement": [[1e-3, 2e-3, 3e-3], [0, 0, 0]]}
        self.result, self.many = contact.evaluate(**state), contact.evaluate_many(**state)

    def assert_warns(self, owner, old, new, value):
        with self.assertWarnsRegex(DeprecationWarning, rf"{type(owner).__name__}\.{old} is now {new}") as caught:
            self.assertEqual(getattr(owner, old), value)
        self.assertEqual(caught.filename, __file__)

    def test_they_have_their_values_and_warn(self):
        result, rail, pose = self.result, self.result.left_rail, self.result.patches[0].pose
        position = result.wheelset.position
        for name in "xyz":
            self.assert_warns(result, name, f"wheelset.position.{name}", getattr(position, name))
        for name in ("yaw", "roll"):
            self.assert_warns(result, name, f"wheelset.{name}", getattr(result.wheelset, name))
        self.assert_warns(result, "reason", "status_text", result.status_text)
        self.assert_warns(self.many, "reason", "status_text", self.many.status_text)
        self.assert_warns(pose, "x", "position.x, which is not counted from the axle centre", pose.position.x - 12.5)
        self.assertLess(0, abs(pose.position.x - 12.5))
        self.assert_warns(pose, "y", "position.y", pose.position.y)
        self.assert_warns(pose, "angle", "roll", pose.roll)
        self.assert_warns(rail, "deflection", "lateral, vertical, roll", rail)
        with self.assertWarns(DeprecationWarning):
            given = rail.given
        np.testing.assert_allclose([given.lateral, given.vertical, given.roll], [1e-3, 2e-3, 3e-3], rtol=1e-12)
        with self.assertWarns(DeprecationWarning):
            np.testing.assert_array_equal(result.rail_wrench.moment, result.rail_wrench.torque)

    def test_todays_names_do_not_warn(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for owner in (self.result, self.many, self.result.left_rail, self.result.rail_wrench, self.result.patches[0].pose):
                repr(owner)
            self.assertEqual(self.result.left_rail.given_lateral, 1e-3)


class Stiffness(unittest.TestCase):
    def test_stiffness_is_that_of_the_last_result(self):
        contact = WheelsetContact()
        self.assertFalse(contact.stiffness("left").any())
        contact.evaluate(force_z=LOAD)
        stiffness = contact.stiffness("left")
        np.testing.assert_allclose(stiffness, stiffness.T)
        self.assertGreater(stiffness[1, 1], 1e9)  # of a wheel of 100 kN that approaches by less than 0.1 mm
        mirror = np.diag([-1, 1, -1])
        np.testing.assert_allclose(contact.stiffness("right"), mirror @ stiffness @ mirror, rtol=1e-6)
        with self.assertRaisesRegex(ValueError, "side = 'middle': must be 'left' or 'right'"):
            contact.stiffness("middle")


class Misuse(unittest.TestCase):
    def setUp(self):
        self.contact = WheelsetContact()

    def test_unknown_arguments_and_values_of_a_wrong_type_or_shape_are_refused(self):
        for name, value, error, text in (("lateral", 1e-3, TypeError, "lateral"),
                                         ("y", "left", TypeError, "y = 'left': must be a number"),
                                         ("yaw", 1j, TypeError, "yaw = 1j: must be a number"),
                                         ("yaw", "1e-3", TypeError, "yaw = '1e-3': must be a number"),
                                         ("yaw", True, TypeError, "yaw = True: must be a number"),
                                         ("y", [1e-3, 2e-3], ValueError, r"y: has the shape \(2,\), but must be a number"),
                                         ("rail_displacement", [1, 2], ValueError, r"must be an array \(2, 3\)")):
            with self.subTest(name=name, value=value), self.assertRaisesRegex(error, text):
                self.contact.evaluate(force_z=LOAD, **{name: value})

    def test_results_are_made_by_evaluations_only(self):
        result = self.contact.evaluate(force_z=LOAD)
        for kind in type(result), type(result.patches[0]), type(self.contact.evaluate_many(force_z=LOAD)):
            with self.subTest(kind=kind), self.assertRaises(TypeError):
                kind.__new__(kind)

    def test_required_values_are_named(self):
        given = WheelsetContact({"wheelset": {"free": []}})
        topics = WheelsetContact([PADS, {"rail_bending": {"lateral_force": "topic"}, "track": {"distance": "topic"}}])
        for contact, arguments, name in ((self.contact, {}, "force_z"), (given, {"force_z": LOAD}, "z"),
                                         (topics, {"force_z": LOAD, "distance": 1.0}, "rail_lateral_force"),
                                         (topics, {"force_z": LOAD, "rail_lateral_force": (0, 0)}, "distance")):
            with self.subTest(name=name), self.assertRaisesRegex(TypeError, f"{name} is missing: it is required"):
                contact.evaluate(**arguments)

    def test_an_argument_that_would_not_be_used_is_refused(self):
        for name, value in (("rail_lateral_force", (1e3, 1e3)), ("distance", 3.0)):
            with self.assertRaisesRegex(ValueError, f"{name}: must be omitted, because it would not be used; set "):
                self.contact.evaluate(force_z=LOAD, **{name: value})

    def test_a_state_out_of_range_is_a_status(self):
        for arguments in ({"y": math.nan}, {"y": 5.0}, {"yaw": 1.0}):
            result = self.contact.evaluate(force_z=LOAD, **arguments)
            self.assertEqual((result.status, result.usable, result.patches), ("INVALID_INPUT", False, []))
            self.assertTrue(result.status_text)


class Inputs(unittest.TestCase):
    def test_given_height_and_roll_give_the_forces_of_the_solved_ones(self):
        fine = {"contact": {"tolerance": 1e-3}}
        solved = WheelsetContact(fine).evaluate(y=2e-3, force_z=LOAD)
        given = WheelsetContact([fine, {"wheelset": {"free": []}}]).evaluate(y=2e-3, z=solved.wheelset.position.z,
                                                                           roll=solved.wheelset.roll)
        for a, b in zip(solved.patches, given.patches):
            np.testing.assert_allclose(b.normal_force, a.normal_force, rtol=3e-3)  # a few tolerances

    def test_a_displacement_of_both_rails_moves_the_contact(self):
        contact = WheelsetContact()
        at_rest = contact.evaluate(y=0.0, force_z=LOAD)
        moved = contact.evaluate(y=1e-3, force_z=LOAD, rail_displacement=[[1e-3, 0, 0], [-1e-3, 0, 0]])
        self.assertAlmostEqual(moved.patches[0].pose.position.y - at_rest.patches[0].pose.position.y, 1e-3, delta=1e-6)
        self.assertAlmostEqual(moved.left_rail.lateral, 1e-3)
        self.assertAlmostEqual(moved.right_rail.lateral, -1e-3)

    def test_a_lateral_force_deflects_its_rail_outward(self):
        contact = WheelsetContact([PADS, {"rail_bending": {"lateral_force": "topic"}}])
        result = contact.evaluate(force_z=LOAD, rail_lateral_force=(20e3, 0.0))
        self.assertGreater(result.left_rail.lateral, result.right_rail.lateral + 1e-4)
        self.assertEqual(result.left_rail.lateral_force, 20e3)
