# SPDX-License-Identifier: BSD-3-Clause
"""WheelsetContact.evaluate_many()."""
import contextlib
import io
import os
import signal
import threading
import time
import unittest

import numpy as np
from wheel_rail_contact import WheelsetContact

LOAD = -200e3  # of the axle [N]
WITH_STRESS = {"stress": {"depths": 4}, "material": {"wheel": {"poisson": 0.3}}}
COLUMNS = ("z", "roll", "patches", "vertical_force", "lateral_force", "max_pressure", "area", "error_estimate", "contact_angle",
           "rolling_radius", "mean_rolling_radius", "wheel_von_mises", "rail_von_mises", "rail_lateral", "rail_vertical", "rail_roll",
           "above_tolerance", "implausible_force")


class ManyEqualsOne(unittest.TestCase):
    def setUp(self):
        self.contact = WheelsetContact(WITH_STRESS)

    def cold(self, **state):
        self.contact.reset()
        return self.contact.evaluate(**state)

    def test_each_row_is_that_of_a_cold_evaluation(self):
        y, torque = np.linspace(-6e-3, 6e-3, 9), np.linspace(-1e5, 3e5, 9)
        many = self.contact.evaluate_many(y=y, force_z=LOAD, torque_x=torque, threads=2, results=True)
        self.assertEqual(len(many), 9)
        self.assertEqual(set(many.status), {"OK", "LIFT_OFF"})
        for i in range(9):
            one = self.cold(y=y[i], force_z=LOAD, torque_x=torque[i])
            self.assertEqual((many.status[i], many.status_text[i], many.z[i], many.roll[i]),
                             (one.status, one.status_text, one.wheelset.position.z, one.wheelset.roll))
            for side, name in enumerate(("left", "right")):
                patches = [patch for patch in one.patches if patch.side == name]
                self.assertEqual(many.patches[i, side], len(patches))
                self.assertEqual(many.max_pressure[i, side], max((patch.max_pressure for patch in patches), default=0))
                for body in ("wheel", "rail"):
                    highest = max((getattr(patch, f"{body}_stress").von_mises.value for patch in patches), default=0)
                    self.assertEqual(getattr(many, f"{body}_von_mises")[i, side], highest)
                self.assertEqual(many.area[i, side], sum(patch.area for patch in patches))
                self.assertEqual(many.vertical_force[i, side], getattr(one, f"{name}_wheel").vertical_force)
                self.assertEqual(many.rail_vertical[i, side], getattr(one, f"{name}_rail").vertical)
                main = max(patches, key=lambda patch: patch.normal_force, default=None)
                np.testing.assert_equal(many.contact_angle[i, side], main.contact_angle if main else np.nan)
                force = sum(patch.normal_force for patch in patches)
                mean = sum(patch.normal_force * patch.rolling_radius for patch in patches) / force if patches else np.nan
                np.testing.assert_allclose(many.mean_rolling_radius[i, side], mean, rtol=1e-14)
            np.testing.assert_array_equal(many.results[i].patches[0].pressure, one.patches[0].pressure)

    def test_the_number_of_threads_changes_no_bit(self):
        y = np.linspace(-6e-3, 6e-3, 40)
        for sequences in (None, 8):
            one, three = (self.contact.evaluate_many(y=y, yaw=2 * y, force_z=LOAD, sequences=sequences, threads=threads)
                          for threads in (1, 3))
            for name in COLUMNS:
                np.testing.assert_array_equal(getattr(one, name), getattr(three, name), name)
            self.assertEqual(one.results, [])

    def test_a_sequence_is_a_loop_of_evaluate(self):
        y = np.linspace(2e-3, 6e-3, 15)
        many = self.contact.evaluate_many(y=y, force_z=LOAD, sequences=[9, 6], threads=2, results=True)
        for i, result in enumerate(many.results):
            one = self.cold(y=y[i], force_z=LOAD) if i in (0, 9) else self.contact.evaluate(y=y[i], force_z=LOAD)
            self.assertEqual((many.z[i], len(result.patches)), (one.wheelset.position.z, len(one.patches)))
            for patch, expected in zip(result.patches, one.patches):
                np.testing.assert_array_equal(patch.pressure, expected.pressure)
        self.assertTrue(np.any(many.z != self.contact.evaluate_many(y=y, force_z=LOAD).z))

    def test_the_start_of_evaluate_is_not_changed(self):
        other = WheelsetContact(WITH_STRESS)
        for contact in (self.contact, other):
            contact.evaluate(y=4e-3, force_z=LOAD)
        self.contact.evaluate_many(y=np.zeros(3), force_z=LOAD)
        a, b = (contact.evaluate(y=4.1e-3, force_z=LOAD) for contact in (self.contact, other))
        np.testing.assert_array_equal(a.patches[0].pressure, b.patches[0].pressure)

    def test_unusable_rows_are_nan_with_a_reason(self):
        many = self.contact.evaluate_many(y=[0.0, np.nan, 0.09], force_z=LOAD)
        self.assertEqual(list(many.usable), [True, False, False])
        self.assertEqual(many.status[1], "INVALID_INPUT")
        self.assertTrue(np.isnan(many.max_pressure[1:]).all() and np.isfinite(many.max_pressure[0]).all())
        self.assertTrue(all(many.status_text[1:]))
        self.assertEqual(repr(many), "<ManyResults: 3 states, 1 usable>")

    def test_numbers_and_arrays_are_combined(self):
        many = self.contact.evaluate_many(y=[0.0, 1e-3], force_z=np.array([LOAD, LOAD / 2]), x=3)
        self.assertEqual(len(many), 2)
        self.assertEqual(len(self.contact.evaluate_many(force_z=LOAD)), 1)
        self.assertEqual(len(self.contact.evaluate_many(y=[], force_z=LOAD)), 0)
        displaced = self.contact.evaluate_many(y=[0.0, 0.0], force_z=LOAD,
                                               rail_displacement=[np.zeros((2, 3)), [[1e-3, 0, 0], [2e-3, 0, 0]]])
        np.testing.assert_allclose(displaced.rail_lateral, [[0, 0], [1e-3, 2e-3]])

    def test_misuse_is_refused_by_name(self):
        for arguments, error, text in (({"y": [1, 2], "yaw": [1, 2, 3]}, ValueError, "same length: y has 2, yaw has 3"),
                                       ({"y": np.zeros((2, 2))}, ValueError, r"y: has the shape \(2, 2\)"),
                                       ({"y": ["a"]}, TypeError, "y = .*must be a number"),
                                       ({"threads": 0}, ValueError, "threads = 0: must be from 1 to 1024"),
                                       ({"threads": 1.5}, TypeError, "threads = 1.5: must be an integer"),
                                       ({"y": np.zeros(6), "sequences": 4}, ValueError, "divides the number of states, 6"),
                                       ({"sequences": [2, -1]}, ValueError, "or lengths above 0 with this sum"),
                                       ({"sequences": 1.0}, TypeError, "sequences = 1.0: must be the length"),
                                       ({"progress": "yes"}, TypeError, "progress = 'yes': must be True, False or a")):
            with self.subTest(arguments=arguments), self.assertRaisesRegex(error, text):
                self.contact.evaluate_many(force_z=LOAD, **arguments)


class Threads(unittest.TestCase):
    def test_another_thread_of_python_runs_meanwhile(self):
        contact, ticks, ended = WheelsetContact(), [], threading.Event()

        def tick():
            while not ended.wait(1e-3):
                ticks.append(time.monotonic())

        other = threading.Thread(target=tick)
        other.start()
        try:
            begin = time.monotonic()
            contact.evaluate_many(y=np.linspace(-5e-3, 5e-3, 1500), force_z=LOAD, threads=2)
            end = time.monotonic()
        finally:
            ended.set()
            other.join()
        # With the lock of the interpreter there would be one or two, at the beginning and at the end.
        self.assertGreater(sum(begin < each < end for each in ticks), 10)

    def test_threads_of_python_can_share_an_object(self):
        contact, pressures = WheelsetContact(), {}

        def evaluate(y):
            pressures[y] = [contact.evaluate(y=y, force_z=LOAD).patches[0].max_pressure for _ in range(200)]

        threads = [threading.Thread(target=evaluate, args=(y,)) for y in (1e-3, 4e-3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for y, found in pressures.items():
            contact.reset()
            expected = contact.evaluate(y=y, force_z=LOAD).patches[0].max_pressure
            np.testing.assert_allclose(found, expected, rtol=0.01)  # the tolerance: their starts differ
        self.assertEqual(len(pressures), 2)

    def test_ctrl_c_ends_the_evaluation_within_a_sequence(self):
        for sequences in (1, 300_000):
            timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                WheelsetContact().evaluate_many(y=np.zeros(300_000), force_z=LOAD, sequences=sequences)  # takes a minute
            timer.join()


class Progress(unittest.TestCase):
    def test_it_is_called_up_to_the_end(self):
        calls = []
        WheelsetContact().evaluate_many(y=np.zeros(1000), force_z=LOAD, progress=lambda *counts: calls.append(counts))
        self.assertEqual(calls[-1], (1000, 1000))
        self.assertEqual(calls, sorted(calls))
        terminal = io.StringIO()
        terminal.isatty = lambda: True
        with contextlib.redirect_stderr(terminal):
            WheelsetContact().evaluate_many(force_z=LOAD, progress=True)
        self.assertRegex(terminal.getvalue(), r"100 % .* 1 of 1 states +\n$")

    def test_its_exception_ends_the_evaluation(self):
        with self.assertRaises(ZeroDivisionError):
            WheelsetContact().evaluate_many(y=np.zeros(300_000), force_z=LOAD, progress=lambda done, total: 1 / 0)
