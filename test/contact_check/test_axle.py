# SPDX-License-Identifier: BSD-3-Clause
"""Limits of wheels and axle: low-pass and sliding mean against analytic values, verdicts, and results without values."""
import random
import unittest

import numpy as np
from wheel_rail_contact.checking.axle import Sample, history, read_axle_limits
from wheel_rail_contact.checking.axle_verdict import violation
from wheel_rail_contact.checking.bounds import judge, read_nodes
from wheel_rail_contact.checking.low_pass import LowPass, SlidingMean
from wheel_rail_contact.checking.parameters import BadParameter

STANDARD = {"low_pass": 20, "mean_length": 2, "static_load": 60e3}


def gain(frequency, steps):
    """Amplitude of a sine behind the low-pass of 20 Hz, after steps of time [s], in the second half of the run."""
    low_pass, times = LowPass(20, 0.0), np.cumsum(steps)
    values = np.array([low_pass.step(step, np.sin(2 * np.pi * frequency * t)) for step, t in zip(steps, times)])
    phase = 2 * np.pi * frequency * times[len(times) // 2:]
    waves = np.column_stack([np.sin(phase), np.cos(phase)])
    return np.hypot(*np.linalg.lstsq(waves, values[len(times) // 2:], rcond=None)[0])


def run(count=2000, speed=40.0, **changes):
    """Samples of a steady run, one each ms, with Q = 60 kN and Y = 6 and 3 kN. A change is a function of the time."""
    times = 1e-3 * np.arange(count)
    samples = [Sample(1 + t, speed * t, speed * t, [6e3, 3e3], [60e3, 60e3], [1.0, 1.0], True) for t in times]
    return [one._replace(**{name: change(t) for name, change in changes.items()}) for one, t in zip(samples, times)]


def found(bounds, samples, **parameters):
    """Violations of bounds, as texts by their names."""
    limits = read_axle_limits({**STANDARD, **parameters, "bounds": bounds})
    quantities = history(limits, samples)
    return {name: text for name, text in ((name, violation(name, limits, quantities)) for name in bounds) if text}


class Filters(unittest.TestCase):
    def test_low_pass_has_the_gain_of_a_butterworth_filter_at_any_rate(self):
        random.seed(7)
        uneven = [1e-3 * (1 + 0.9 * random.uniform(-1, 1)) for _ in range(2000)]
        for steps in ([1e-2] * 200, [1e-3] * 2000, uneven):
            self.assertAlmostEqual(gain(20, steps), np.sqrt(0.5), delta=1e-4)  # of the uneven steps, 2e-5
        for frequency in (5, 10, 40):  # at 5 kHz, the warped frequency differs by up to 2e-4
            self.assertAlmostEqual(gain(frequency, [2e-4] * 10000), 1 / np.sqrt(1 + (frequency / 20)**8), delta=1e-4)

    def test_mean_of_a_sine_over_its_length_is_zero_and_of_a_slope_its_middle(self):
        random.seed(8)
        for steps, delta in (([0.04] * 200, 1e-12), ([0.02 * (1 + random.random()) for _ in range(200)], 1e-3)):  # chords
            sine, slope, places = SlidingMean(2), SlidingMean(2), np.cumsum(steps)
            for place, step in zip(places, steps):
                mean, middle = sine.step(step, np.sin(np.pi * place)), slope.step(step, 3 * place)
                self.assertEqual(np.isnan(mean), place - places[0] < 2 - 1e-9)
                if np.isfinite(mean):
                    self.assertAlmostEqual(mean, 0, delta=delta)
                    self.assertAlmostEqual(middle, 3 * (place - 1), delta=1e-9)

    def test_values_depend_on_earlier_results_only(self):
        samples, limits = run(lateral=lambda t: [6e3 * np.sin(40 * t), 3e3]), read_axle_limits(STANDARD)
        for name, values in history(limits, samples).values.items():
            np.testing.assert_array_equal(history(limits, samples[:700]).values[name], values[:700])
            self.assertTrue(np.isfinite(values[699]).all(), name)


class Verdicts(unittest.TestCase):
    def test_only_the_violated_limit_is_named_by_wheel_value_and_place(self):
        bounds = {"vertical_force": {"max": 80e3}, "lateral_force": {"max": 60e3}, "quotient": {"max": 0.9},
                  "unloading": {"max": 0.6}, "lateral_sum": {"k1": 1}}
        steep = run(lateral=lambda t: [6e3, 50e3 if 0.999 < t < 1.5 else 3e3])
        self.assertEqual(found(bounds, steep), {})
        text, = found({**bounds, "quotient": {"max": 0.8}}, steep).values()
        # Behind the step at 40 m, the low-pass overshoots by 10.8 % within the 2 m.
        self.assertRegex(text, r"^Y/Q 0\.85\d+ - is above 0\.8 - at 2\.084 s, right wheel, distance = 43\.360 m \(\d+ of 3700 "
                         r"values are outside; this is the worst; low-pass 20 Hz, mean over the last 2 m of distance\)$")

    def test_sum_is_that_to_the_left_and_its_limit_follows_from_the_static_load(self):
        for lateral, text in (([42.4e3, 0], ""), ([42.6e3, 0], "sum Y 42600 N is above 42500 N"), ([50e3, 8e3], ""),
                              ([0, 42.6e3], "sum Y -42600 N is below -42500 N")):  # 0.85 (10 kN + 2 60 kN / 3) = 42.5 kN
            texts = found({"lateral_sum": {"k1": 0.85}}, run(200, lateral=lambda t, force=lateral: force))
            self.assertEqual(texts.get("lateral_sum", "").partition(" at ")[0], text)

    def test_percentile_leaves_out_the_rarest_values(self):
        peak = run(1000, vertical=lambda t: [60e3, 20e3 if 0.5 < t < 0.5015 else 60e3])  # one of 1000
        self.assertEqual([bool(found({"unloading": {"max": 0.5}}, peak, low_pass=0, percentile=p)) for p in (100, 99.85)],
                         [True, False])

    def test_missing_friction_is_stated(self):
        for friction in (0.0, -5.0):
            texts = found({"lateral_force": {"max": 1e3}, "vertical_force": {"max": 1e3}},
                          run(200, friction=lambda t, force=friction: [0, force]))
            self.assertEqual(["no friction" in text for text in texts.values()], [friction == 0, False])

    def test_results_without_values_are_counted_by_their_reason(self):
        settling, short = "results while the low-pass settles", "results before the length of the mean is travelled"
        unusable, restart = "results that are not usable", "restarts because "
        cases = (({}, 100, 50, {}), ({"usable": lambda t: not 0.9995 < t < 1.0065}, 100, 50, {unusable: 7}),
                 ({"usable": lambda t: not 0.9995 < t < 1.0125}, 200, 100, {
                     unusable: 13, restart + "a step of time is longer than 12.5 ms": 1}),
                 ({"stamp": lambda t: t % 1.0005 + 1}, 200, 100, {restart + "time goes back": 1}),
                 ({"distance": lambda t: 40 * abs(1 - t)}, 100, 100, {restart + "the wheelset changes its direction": 1}),
                 ({"distance": lambda t: 40 * (t % 1.0005)}, 100, 100, {restart + "a step of way is longer than 0.5 m": 1}))
        for changes, settled, shorter, counts in cases:
            with self.subTest(counts=counts):
                self.assertEqual(history(read_axle_limits(STANDARD), run(**changes)).counts,
                                 {settling: settled, short: shorter, **counts})
        bounds, standing = {"quotient": {"max": 0.05}, "vertical_force": {"max": 80e3}}, run(300, speed=0.0)
        self.assertEqual(found(bounds, standing), {
            "quotient": f"Y/Q has no value: 100 {settling}; 1 {short}; 199 results that do not advance on the way"})
        self.assertRegex(found(bounds, standing, place="time", speed=40)["quotient"], r"40 m/s times the time = [45]\d\.\d+ m")

    def test_quotient_of_a_wheel_without_load_is_undefined_and_counted(self):
        lifted = run(lateral=lambda t: [6e3, 0 if 0.9995 < t < 1.0095 else 3e3],
                     vertical=lambda t: [60e3, 0 if 0.9995 < t < 1.0095 else 60e3])
        quantities = history(read_axle_limits(STANDARD), lifted)
        self.assertEqual(quantities.counts, {
            "results while the low-pass settles": 100, "results before the length of the mean is travelled": 100,
            "values of Y/Q that are undefined because the wheel carries no load": 109})
        np.testing.assert_allclose(quantities.values["quotient"][-1], (0.1, 0.05), rtol=1e-9)
        self.assertEqual(np.isnan(quantities.values["quotient"]).sum(axis=0).tolist(), [150, 150 + 109 + 50])

    def test_nodes_have_their_own_limits_over_the_common_ones_and_invalid_parameters_are_refused(self):
        nodes = read_nodes({"results": 2, "axle": {"low_pass": 20, "static_load": 60e3}, "nodes": {
            "front": {"topic": "/front/contact"}, "rear": {"topic": "/rear/contact", "axle": {"static_load": 50e3}}}})
        self.assertEqual([(name, topic, limits.results, limits.axle.low_pass, limits.axle.static_load)
                          for name, (topic, limits) in nodes.items()],
                         [("front", "/front/contact", 2, 20, 60e3), ("rear", "/rear/contact", 2, 20, 50e3)])
        self.assertEqual(judge(read_nodes({"results": 0})[""][1], []), ({}, []))
        for parameters, name in (({"low_pass": -1}, "low_pass"), ({"filter": 20}, "axle/filter"), ({"place": "z"}, "place"),
                                 ({"place": "time"}, "axle/speed"), ({"speed": 40}, "axle/speed"),
                                 ({"percentile": 50}, "percentile"), ({"bounds": {"area": {}}}, "bounds/area"),
                                 ({"bounds": {"unloading": {"max": 0.6}}}, "requires axle/static_load"),
                                 ({"bounds": {"lateral_sum": {"k1": 1}}}, "requires axle/static_load"),
                                 ({"bounds": {"lateral_sum": {"min": 1}}}, "max or k1")):
            with self.subTest(parameters=parameters), self.assertRaisesRegex(BadParameter, name):
                read_axle_limits(parameters)
        for nodes in (3, {}, {"front": {}}, {"1": {"topic": "contact"}}, {"front": {"topic": 1}}):
            with self.assertRaisesRegex(BadParameter, "nodes = "):
                read_nodes({"nodes": nodes})
