# SPDX-License-Identifier: BSD-3-Clause
"""A run that violates its bounds fails as a rostest, with a readable message; of several nodes, each has its own verdict."""
import os
import pathlib
import subprocess
import tempfile
import unittest

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "launch" / "manchester_check.test"


class Failing(unittest.TestCase):
    def test_violated_bounds_are_reported(self):
        with tempfile.TemporaryDirectory() as folder:
            bounds = pathlib.Path(folder) / "bounds.yaml"
            bounds.write_text("results: 201\nnodes:\n  tight: {topic: contact_node/contact, flange_contact: false, bounds: "
                              "{normal_force: {max: 1.2e+5}, area: {min: 0}}}\n  wide: {topic: contact_node/contact, "
                              "axle: {bounds: {quotient: {max: 3}, lateral_sum: {max: 2.0e+5}}}}\n")
            run = subprocess.run(["rostest", EXAMPLE, f"bounds:={bounds}"], capture_output=True, text=True, check=False,
                                 cwd=folder, env={**os.environ, "ROS_HOME": folder})
            results = "".join(path.read_text() for path in pathlib.Path(folder).rglob("rosunit-contact_check.xml"))
        self.assertNotEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("flange contact: contact_angle 1.", results)
        self.assertRegex(results, r"normal_force \d+ N is above 120000 N at \S+ s, right wheel, y = -\S+ mm")
        self.assertRegex(results, r"sum Y -\d+ N is below -200000 N at \S+ s, distance = 0.000 m")
        self.assertRegex(results, r'failures="3"')
        self.assertTrue("test_tight_area" in results and "test_wide_axle_quotient" in results)
