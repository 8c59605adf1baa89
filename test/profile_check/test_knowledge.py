# SPDX-License-Identifier: BSD-3-Clause
"""What is known of the running surface."""
import unittest

import numpy as np

from wheel_rail_contact.profile_check.knowledge import surface_knowledge

MM = 1e-3  # [m]


class Sections:
    """Straight sections of 10 mm, from y = 0, in the place of a Curve."""
    boundaries = 10 * MM * np.arange(7)
    curvature_errors = np.array([2, 0, 100, 7, 0, 50])  # [1/m]
    missing = np.array([0, 0, 1, 0, 0, 0])

    def at(self, u):
        return np.column_stack([u, *np.zeros((5, len(u)))])

    def errors(self, u):
        section = (np.asarray(u) / (10 * MM)).astype(int)
        return np.column_stack([np.zeros(len(section)), self.curvature_errors[section], self.missing[section]])


class SurfaceKnowledge(unittest.TestCase):
    def test_counts_only_the_running_surface_and_its_known_parts(self):
        known = surface_knowledge(Sections(), (5 * MM, 45 * MM))
        self.assertAlmostEqual(known.missing, 0.25, delta=1e-12)
        self.assertEqual(known.curvature_error, 7)
        self.assertAlmostEqual(known.y, 35 * MM, delta=1e-12)

    def test_usual_error_is_the_median_over_the_length(self):
        self.assertEqual(surface_knowledge(Sections(), (0, 10 * MM)).usual_error, 2)
        self.assertEqual(surface_knowledge(Sections(), (5 * MM, 12 * MM)).usual_error, 2)
        self.assertEqual(surface_knowledge(Sections(), (35 * MM, 43 * MM)).usual_error, 7)
        self.assertEqual(surface_knowledge(Sections(), (48 * MM, 60 * MM)).usual_error, 50)
