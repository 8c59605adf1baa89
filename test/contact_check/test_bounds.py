# SPDX-License-Identifier: BSD-3-Clause
"""Bounds of contact_check: what breaks them, what does not, and parameters that are refused."""
import unittest

import genpy
from wheel_rail_contact.checking.bounds import BadParameter, check_names, complaint, read_limits
from wheel_rail_contact.msg import ContactPatch, WheelsetContact


def answer(status=WheelsetContact.OK, seconds=1, **quantities):
    message = WheelsetContact(status=status, status_text="" if status == 0 else "a reason")
    message.header.stamp = genpy.Time(seconds)
    if status <= WheelsetContact.LIFT_OFF:
        message.patches = [ContactPatch(side=ContactPatch.RIGHT, **quantities)]
    return message


def complaints(parameters, answers):
    limits = read_limits(parameters)
    found = {name: complaint(name, limits, answers) for name in check_names(limits)}
    return {name: text for name, text in found.items() if text}


class Bounds(unittest.TestCase):
    def test_answers_within_bounds_pass(self):
        parameters = {"answers": 2, "flange_contact": False,
                      "bounds": {"max_pressure": {"max": 1e9}, "area": {"min": 1e-5, "max": 1e-4}}}
        good = [answer(max_pressure=p, area=a, contact_angle=0.69) for p, a in ((1e9, 1e-5), (0, 1e-4))]
        self.assertEqual(complaints(parameters, good), {})

    def test_worst_patch_is_named_with_time_side_and_count(self):
        answers = [answer(max_pressure=p, seconds=1800000000 + i) for i, p in enumerate((1e9, 3e9, 2e9, 0.5e9))]
        text = complaints({"bounds": {"max_pressure": {"max": 1.5e9}}}, answers)["max_pressure"]
        self.assertIn("max_pressure 3e+09 Pa is above 1.5e+09 Pa at 1800000001.000 s, right wheel", text)
        self.assertIn("2 of 4 patches", text)

    def test_too_small_breaks_a_bound_too(self):
        text = complaints({"bounds": {"area": {"min": 1e-5}}}, [answer(area=9e-6)])["area"]
        self.assertIn("area 9e-06 m^2 is below 1e-05 m^2", text)

    def test_not_a_number_breaks_every_bound(self):
        self.assertIn("area", complaints({"bounds": {"area": {"max": 1}}}, [answer(area=float("nan"))]))

    def test_flange_contact_is_found_by_its_angle(self):
        steep = [answer(contact_angle=0.7)]
        self.assertEqual(complaints({}, steep), {})
        self.assertIn("flange contact", complaints({"flange_contact": False}, steep)["flange_contact"])
        self.assertEqual(complaints({"flange_contact": False, "flange_angle": 0.8}, steep), {})

    def test_refusals_and_lift_offs_are_counted_apart(self):
        answers = [answer(), answer(WheelsetContact.OFF_PROFILE), answer(WheelsetContact.LIFT_OFF)]
        found = complaints({}, answers)
        self.assertIn("1 answers refused, 0 allowed; the first at 1.000 s: OFF_PROFILE: a reason", found["refusals"])
        self.assertIn("1 answers with a wheel off the rail", found["lift_offs"])
        self.assertEqual(complaints({"refusals": 1, "lift_offs": 1}, answers), {})

    def test_silence_fails(self):
        self.assertEqual(complaints({}, []), {"answers": "0 answers, at least 1 are asked for"})

    def test_numbers_may_be_strings_as_yaml_reads_them(self):
        self.assertEqual(read_limits({"bounds": {"max_pressure": {"max": "2e9"}}}).bounds["max_pressure"][1], 2e9)

    def test_wrong_parameters_are_refused_by_name(self):
        for parameters, name in (({"answer": 1}, "answer = 1"), ({"answers": 1.5}, "answers = 1.5"),
                                 ({"refusals": -1}, "refusals"), ({"flange_contact": "no"}, "flange_contact"),
                                 ({"idle": 0}, "idle"), ({"bounds": {"presure": {"max": 1}}}, "bounds/presure"),
                                 ({"bounds": {"area": {"most": 1}}}, "bounds/area"),
                                 ({"bounds": {"area": {"max": True}}}, "bounds/area/max"),
                                 ({"bounds": {"area": {"min": 2, "max": 1}}}, "bounds/area"), ({"bounds": 3}, "bounds")):
            with self.subTest(parameters=parameters), self.assertRaises(BadParameter) as caught:
                read_limits(parameters)
            self.assertIn(name, str(caught.exception))


if __name__ == "__main__":
    unittest.main()
