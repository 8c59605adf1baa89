# SPDX-License-Identifier: BSD-3-Clause
"""Bounds of contact_check: results within the bounds, violations, and refused parameters."""
import unittest

import genpy
from wheel_rail_contact.checking.bounds import judge, read_limits
from wheel_rail_contact.checking.parameters import BadParameter
from wheel_rail_contact.msg import ContactPatch, PatchCreep, WheelsetContact


def result(status=WheelsetContact.OK, seconds=1, **quantities):
    message = WheelsetContact(status=status, status_text="" if status == 0 else "a reason")
    message.header.stamp = genpy.Time.from_sec(seconds)
    message.wheelset.position.z = 0.46
    if status <= WheelsetContact.LIFT_OFF:
        message.left_wheel.vertical_force = message.right_wheel.vertical_force = 50e3
        message.patches = [ContactPatch(side=ContactPatch.RIGHT, **quantities)]
    return message


def violations(parameters, results):
    return judge(read_limits(parameters), results)[0]


class Bounds(unittest.TestCase):
    def test_results_within_the_bounds_pass_and_the_worst_patch_outside_is_reported(self):
        parameters = {"results": 2, "flange_contact": False,
                      "bounds": {"max_pressure": {"max": 1e9}, "area": {"min": 1e-5, "max": 1e-4}}}
        good = [result(max_pressure=p, area=a, contact_angle=0.69) for p, a in ((1e9, 1e-5), (0, 1e-4))]
        self.assertEqual(violations(parameters, good), {})
        self.assertEqual(violations({}, []), {"results": "0 results, at least 1 are required"})
        results = [result(max_pressure=p, seconds=1800000000 + i) for i, p in enumerate((1e9, 3e9, 2e9, 0.5e9))]
        text = violations({"bounds": {"max_pressure": {"max": 1.5e9}}}, results)["max_pressure"]
        self.assertIn("max_pressure 3e+09 Pa is above 1.5e+09 Pa at 1800000001.000 s, right wheel", text)
        self.assertIn("2 of 4 patches", text)
        self.assertIn("area", violations({"bounds": {"area": {"max": 1}}}, [result(area=float("nan"))]))

    def test_flange_contact_is_detected_by_its_angle_also_of_the_back_of_a_flange(self):
        steep = [result(contact_angle=0.7)]
        self.assertEqual(violations({}, steep), {})
        self.assertIn("flange contact", violations({"flange_contact": False}, steep)["flange_contact"])
        self.assertEqual(violations({"flange_contact": False, "flange_angle": 0.8}, steep), {})
        parameters = {"flange_contact": False, "flange_angle": 0.7}
        for angle, words in ((-0.7, "contact_angle -0.7 rad is not above -0.7 rad"),
                             (-1.2, "contact_angle -1.2 rad is below -0.7 rad"), (1.2, "contact_angle 1.2 rad is above 0.7")):
            self.assertIn(words, violations(parameters, [result(contact_angle=angle)])["flange_contact"])
        self.assertEqual(violations(parameters, [result(contact_angle=-0.69)]), {})

    def test_every_number_of_a_patch_that_describes_its_contact_can_be_bounded(self):
        for name, unit in (("vertical_force", "N"), ("lateral_force", "N"), ("semi_axis_along", "m"),
                           ("semi_axis_across", "m"), ("rolling_radius", "m"), ("normal_stiffness", "N/m")):
            text = violations({"bounds": {name: {"min": 0.5}}}, [result(**{name: 0.25}), result(**{name: 0.75})])[name]
            self.assertIn(f"{name} 0.25 {unit} is below 0.5 {unit} at 1.000 s", text)
            self.assertIn("1 of 2 patches", text)
        creep = [result(creep=PatchCreep(adhesion_share=0.9, power=3e3))]
        found = violations({"bounds": {"adhesion_share": {"max": 0.8}, "friction_power": {"max": 4e3}}}, creep)
        self.assertIn("adhesion_share 0.9 - is above 0.8 -", found.pop("adhesion_share"))
        self.assertEqual(found, {})

    def test_refusals_lift_offs_and_implausible_forces_are_counted_separately(self):
        flagged = result()
        flagged.implausible_force, flagged.status_text = True, "the left wheel carries 18 MN"
        results = [flagged, result(WheelsetContact.OFF_PROFILE), result(WheelsetContact.LIFT_OFF)]
        found = violations({}, results)
        self.assertIn("1 results refused, 0 allowed; the first at 1.000 s: OFF_PROFILE: a reason", found["refusals"])
        self.assertIn("1 results with a wheel that carries no load", found["lift_offs"])
        self.assertEqual(found["implausible_forces"], "1 results with an implausible contact force, 0 allowed; the first at "
                         "1.000 s: OK: the left wheel carries 18 MN")
        self.assertEqual(violations({"refusals": 1, "lift_offs": 1, "implausible_forces": 1}, results), {})

    def test_loads_in_kilonewtons_are_a_violation_and_patches_of_a_held_result_are_not_checked(self):
        small = result()
        small.left_wheel.vertical_force, small.right_wheel.vertical_force = 60, 40
        self.assertEqual(violations({}, [small])["loads"], "the mean wheel load is 50 N, at least 1000 N are required; loads "
                         "must be in N, and force.z negative")
        self.assertEqual(violations({"least_load": 40}, [small]), {})
        small.wheelset.position.z *= 0.2  # a model
        self.assertEqual(violations({}, [small]), {})
        held = result(max_pressure=3e9)
        held.status, held.held = WheelsetContact.NOT_CONVERGED, True
        parameters = {"refusals": 1, "bounds": {"max_pressure": {"max": 1.5e9}}}
        self.assertEqual(violations(parameters, [result(), held]), {})

    def test_invalid_parameters_are_refused_by_name_and_numbers_may_be_strings(self):
        self.assertEqual(read_limits({"bounds": {"max_pressure": {"max": "2e9"}}}).bounds["max_pressure"][1], 2e9)
        for parameters, name in (({"result": 1}, "result = 1"), ({"results": 1.5}, "results = 1.5"),
                                 ({"refusals": -1}, "refusals"), ({"flange_contact": "no"}, "flange_contact"),
                                 ({"idle": 0}, "idle"), ({"bounds": {"presure": {"max": 1}}}, "bounds/presure"),
                                 ({"bounds": {"area": {"most": 1}}}, "bounds/area"),
                                 ({"bounds": {"area": {"max": True}}}, "bounds/area/max"),
                                 ({"bounds": {"area": {"min": 2, "max": 1}}}, "bounds/area"), ({"bounds": 3}, "bounds")):
            with self.subTest(parameters=parameters), self.assertRaises(BadParameter) as caught:
                read_limits(parameters)
            self.assertIn(name, str(caught.exception))
