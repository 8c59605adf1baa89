# SPDX-License-Identifier: BSD-3-Clause
"""Physics of the closed loop in process: S1002 on 60E1, 100 kN on each wheel."""
import contextlib
import io
import math
import os
import tempfile
import unittest
from pathlib import Path

import numpy as np
from sweep import Sweep

from wheel_rail_contact.line.command_line import main as make_irregular_line
from wheel_rail_contact.simulation.closed_loop import run_closed_loop
from wheel_rail_contact.simulation.contact import HeldContact, open_contact
from wheel_rail_contact.simulation.parameters import read_parameters, step_count
from wheel_rail_contact.simulation.stability import Stability
from wheel_rail_contact.simulation.wheelset import Wheelset


SOFT = 0.05e6, 0.05e6  # waves of every amplitude on the tread grow at 40 m/s
STIFF = 5e6, 2e6


def free_wheelset(**run):
    """A wheelset without suspension."""
    p = read_parameters(run=run)
    p["suspension"].update(longitudinal_stiffness=0.0, lateral_stiffness=0.0, vertical_stiffness=0.0)
    return p


def guided(stiffness, **run):
    """On a suspension with these longitudinal and lateral stiffnesses of an axle box [N/m]."""
    p = read_parameters(run={"speed": 40.0, **run})
    p["suspension"].update(zip(("longitudinal_stiffness", "lateral_stiffness"), stiffness))
    return p


def left_forces(contact, step):
    """Q of the left wheel at 40 m/s in 0.5 s, in rows of 20 ms [N]."""
    forces, p = [], guided(STIFF, y=0.0, duration=0.5, step=step)
    run_closed_loop(p, contact, lambda request, reply, is_held: forces.append(reply.left_wheel.vertical_force))
    return np.reshape(forces, (25, -1))


def half_waves(p):
    """Places of the zero crossings of a run, and the largest displacement before each."""
    wheelset, held = Wheelset(p), HeldContact(open_contact(), 0)
    crossings, amplitudes, extreme, last = [], [], 0.0, 0.0
    for i in range(step_count(p["run"])):
        y = wheelset.position[0]
        wheelset.advance(held)
        if i and (y > 0) != (last > 0):
            crossings.append(p["run"]["speed"] * p["run"]["step"] * (i - y / (y - last)))
            amplitudes.append(extreme)
            extreme = 0.0
        extreme, last = max(extreme, abs(y)), y
    return crossings, amplitudes


@unittest.skipUnless(os.environ["HAS_PYTHON_MODULE"] == "1", "the Python module is not built")
class ClosedLoop(unittest.TestCase):
    def assert_ratio(self, value, reference, tolerance):
        self.assertAlmostEqual(value / reference, 1, delta=tolerance)

    def test_free_wheelset_at_low_speed_follows_klingel(self):
        # Half waves between zero crossings, with the amplitude of their extreme. The amplitude falls by a fifth per wave.
        crossings, amplitudes = half_waves(free_wheelset(speed=2.0, y=0.003, step=2e-3, duration=14.0))
        sweep = Sweep(open_contact(), 0.0032)
        self.assertGreaterEqual(len(crossings), 6)
        for half_wave, amplitude in zip(np.diff(crossings), amplitudes[1:]):
            # The amplitude falls by 9 % in a half wave, and with it the wavelength by 0.8 %: which amplitude within the half
            # wave counts is open within this.
            self.assert_ratio(2 * half_wave, sweep.kinematic_wavelength(amplitude), 0.01)

    def test_soft_guidance_ends_in_one_limit_cycle_from_both_sides(self):
        runs = [run_closed_loop(guided(SOFT, **start), open_contact())
                for start in ({"y": 0.0015, "duration": 5.0}, {"y": 0.0, "yaw": 0.0065, "duration": 2.0})]
        growing, falling = waves = [run.waves() for run in runs]
        for run, wave in zip(runs, waves):
            self.assertEqual(run.held, 0)
            self.assertGreater(run.saturated, 0)
            self.assertGreaterEqual(wave.count, 3)
        # In 120 m a wave that is not yet settled would still change by more.
        self.assert_ratio(falling.largest_y, growing.largest_y, 0.01)
        self.assert_ratio(falling.wavelength, growing.wavelength, 0.01)

        # Amplitude: waves grow until the gauge corner carries load (the left contact turns steeper than the tread), and the
        # flange, which is steeper than 45 degrees, ends the growth.
        sweep = Sweep(open_contact(), 0.0068)
        self.assertGreater(growing.largest_y, sweep.steep_from(0.2))
        self.assertLess(growing.largest_y, sweep.steep_from(math.atan(1)))

        # Wavelength: harmonic balance of m y'' + d1 y' + K1 y = V d1 psi and I psi'' + d2 psi' + K2 psi = -(V d2 / l^2) y.
        # Here l is the kinematic wavelength over 2 pi, and the dampings d1, d2 of the creep forces may have any size, as the
        # saturation leaves it. A steady wave of frequency w has (K1 - m w^2) d2 + (K2 - I w^2) d1 = 0: both brackets differ
        # in sign. Then w^2 = (V / l)^2 + (K1 - m w^2) (K2 - I w^2) / (d1 d2) is below (V / l)^2, and the wave longer than
        # the kinematic one of its amplitude. It is shorter than that of the tread, as the gauge corner raises the conicity.
        self.assertGreater(growing.wavelength, sweep.kinematic_wavelength(growing.largest_y))
        self.assertLess(growing.wavelength, sweep.kinematic_wavelength(0.002))

        # Energy: the work of the drag becomes heat in the contacts. The step of 1 ms leaves 0.8 %.
        work = 40 * growing.drag
        self.assertGreater(work, 800)
        self.assert_ratio(growing.friction_power, work, 0.02)

    def test_small_waves_grow_as_the_linear_theory_states(self):
        stability = Stability(read_parameters(), open_contact())
        for speed, y, duration in ((25.0, 3e-4, 1.2), (50.0, 1e-4, 0.9)):
            crossings, amplitudes = half_waves(read_parameters(run={"speed": speed, "y": y, "duration": duration}))
            times = np.array(crossings[1:]) / speed  # after the first half wave, the other motions have decayed
            motion = stability.motion(speed)
            growth = np.polyfit(times, np.log(amplitudes[1:]), 1)[0]
            self.assertAlmostEqual(growth, motion.growth, delta=0.1)  # grids within the tolerance of 1 % change it by 0.05
            self.assert_ratio(1 / (2 * np.mean(np.diff(times))), motion.frequency, 0.01)
            self.assertEqual(growth > 0, speed > 40)

    def test_stiff_guidance_damps_the_wave(self):
        run = run_closed_loop(guided(STIFF, y=0.003, duration=1.5), open_contact())
        self.assertLess(run.waves().largest_y, 0.1 * 0.003)
        self.assertEqual(run.saturated, 0)

    def test_given_height_has_the_forces_of_smaller_steps_and_of_solved_height(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
            line, config = Path(folder) / "line.csv", Path(folder) / "config.yaml"
            make_irregular_line([str(line), "--length", "50"])
            config.write_text(f"track: {{line: {line}}}\n", encoding="ascii")
            solved = left_forces(open_contact(config), 1e-3)
            config.write_text(f"track: {{line: {line}}}\nwheelset: {{free: []}}\ncontact: {{derivatives: true}}\n")
            given, fine = (left_forces(open_contact(config), step) for step in (1e-3, 0.25e-3))
        # Smaller steps resolve more of the motion on the contact stiffness, 200 Hz, of which means over 20 ms have little. The
        # solved height has none of it. The line moves the means by 1.8 kN.
        solved_mean, given_mean, fine_mean = (np.mean(forces, axis=1) for forces in (solved, given, fine))
        self.assertGreater(np.std(fine_mean), 1000)
        np.testing.assert_allclose(given_mean, fine_mean, rtol=0, atol=400)
        np.testing.assert_allclose(given_mean, solved_mean, rtol=0, atol=400)
        self.assertLess(np.std(given), 1.2 * np.std(fine))  # nothing grows

    def test_wheelset_follows_a_misaligned_track(self):
        size, length = 0.004, 30.0  # a smooth step to the left, in both rails [m]
        x = np.arange(-10.0, 201.0)
        share = np.clip(x / length, 0, 1)
        y = size * share**2 * (3 - 2 * share)
        with tempfile.TemporaryDirectory() as folder:
            line, config = Path(folder) / "line.csv", Path(folder) / "config.yaml"
            np.savetxt(line, np.transpose([x, y, -y]), delimiter=",", comments="",  # outward: the right rail moves inward
                       header="x [m], rail_lateral_left [m], rail_lateral_right [m]")
            config.write_text(f"track: {{line: {line}}}\n", encoding="ascii")
            run = run_closed_loop(free_wheelset(speed=10.0, y=0.0, duration=12.0, step=4e-3), open_contact(config))
        self.assertEqual(run.held, 0)
        # The wheelset oscillates about the displaced track: its largest displacement is beyond the track, below twice of it.
        self.assertGreater(run.waves().largest_y, size)
        self.assertLess(run.waves().largest_y, 2 * size)
