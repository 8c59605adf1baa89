# SPDX-License-Identifier: BSD-3-Clause
import tempfile
import unittest
from pathlib import Path

import numpy as np
from rails import CONFIG, bar, rail_60e1

from wheel_rail_contact.command import Failure
from wheel_rail_contact.rail_fe import outline_60e1
from wheel_rail_contact.rail_fe.section import Section, read_section

SQUARE = np.array([[-1.0, 0.0], [1.0, 0.0], [1.0, 2.0], [-1.0, 2.0]])


class Rail60E1(unittest.TestCase):
    def test_area_and_second_moments_are_those_of_the_standard(self):
        properties = rail_60e1().properties()
        # EN 13674-1, 60E1: 76.70 cm2, 3038.3 cm4, 512.3 cm4, printed with four or five digits
        self.assertAlmostEqual(properties["area"] / 76.70e-4, 1, delta=1e-3)
        self.assertAlmostEqual(properties["second_moment_y"] / 3038.3e-8, 1, delta=1e-3)
        self.assertAlmostEqual(properties["second_moment_z"] / 512.3e-8, 1, delta=1e-3)

    def test_height_and_widths_are_those_of_the_standard(self):
        section = rail_60e1()
        self.assertAlmostEqual(section.height, 0.172, delta=1e-9)
        np.testing.assert_allclose(np.ptp(section.outline, axis=0), [0.150, 0.172], atol=1e-9)
        # EN 13674-1: the head is 72 mm wide at 14.3 mm below the crown. 1e-6: the printed dimension is rounded.
        np.testing.assert_allclose(section.points([section.gauge_face(0.172 - 0.0143)])[0, 0], -0.036, atol=1e-6)

    def test_file_of_the_package_is_the_outline_of_the_arcs(self):
        written = np.loadtxt(CONFIG / "sections" / "60E1.csv", delimiter=",", skiprows=4)
        np.testing.assert_allclose(written, outline_60e1.outline(), atol=1e-6)  # printed to 1e-6 mm

    def test_outline_is_symmetric_and_smooth(self):
        outline = outline_60e1.outline()
        np.testing.assert_allclose(outline[1:], (outline * [-1, 1])[:0:-1], atol=1e-9)
        edge = np.roll(outline, -1, axis=0) - outline
        before = np.roll(edge, 1, axis=0)
        turn = np.arctan2(before[:, 0] * edge[:, 1] - before[:, 1] * edge[:, 0], (before * edge).sum(axis=1))
        # All arcs are tangent: the largest angle of a vertex is that of a chord at the smallest radius, 2 mm.
        self.assertLess(np.abs(turn).max(), np.sqrt(8 * outline_60e1.CHORD_DEVIATION / 2))


class AnyOutline(unittest.TestCase):
    def test_rectangle_has_its_closed_form_properties(self):
        properties = bar(0.06, 0.12).properties()
        self.assertAlmostEqual(properties["area"], 0.06 * 0.12)
        self.assertAlmostEqual(properties["centroid_height"], 0.06)
        self.assertAlmostEqual(properties["second_moment_y"], 0.06 * 0.12**3 / 12)
        self.assertAlmostEqual(properties["second_moment_z"], 0.12 * 0.06**3 / 12)

    def test_clockwise_and_closed_outlines_are_accepted(self):
        closed = np.vstack([SQUARE, SQUARE[:1]])[::-1]
        self.assertAlmostEqual(Section("square", closed).properties()["area"], 4)

    def test_lowest_point_is_moved_to_zero(self):
        self.assertEqual(Section("square", SQUARE + [0, 5]).outline[:, 1].min(), 0)

    def test_cuts_include_corners_and_have_the_given_size(self):
        section = bar(0.06, 0.12)
        points = section.points(section.cuts(0.01))
        for corner in section.outline:
            self.assertLess(np.linalg.norm(points - corner, axis=1).min(), 1e-9)
        lengths = np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1)
        np.testing.assert_allclose(lengths, 0.01, rtol=0.01)

    def test_projection_returns_the_arc_length_of_outline_points(self):
        section = rail_60e1()
        arcs = np.linspace(0, section.perimeter, 50, endpoint=False)
        np.testing.assert_allclose(section.project(section.points(arcs)), arcs, atol=1e-9)

    def test_outline_that_crosses_itself_is_refused(self):
        with self.assertRaisesRegex(Failure, "crosses itself"):
            Section("bow tie", SQUARE[[0, 2, 1, 3]])

    def test_height_above_the_crown_is_refused(self):
        with self.assertRaisesRegex(Failure, "does not reach z = 3 m"):
            Section("square", SQUARE).gauge_face(3.0)


class File(unittest.TestCase):
    def read(self, text):
        with tempfile.TemporaryDirectory() as directory:
            path = Path(directory) / "some_rail.csv"
            path.write_text(text, encoding="utf-8")
            return read_section(path)

    def test_millimetres_are_converted_to_metres_and_the_section_has_the_name_of_the_file(self):
        section = self.read("# a square\ny_mm,z_mm\n-10,0\n10,0\n10,20\n-10,20\n")
        self.assertEqual(section.name, "some_rail")
        self.assertAlmostEqual(section.properties()["area"], 4e-4)

    def test_invalid_files_are_reported_with_reason(self):
        for text, reason in (("-10,0\n10,0\n0,9\n", "must be y_mm,z_mm"), ("y_mm,z_mm\n1,a\n", "could not convert"),
                                ("y_mm,z_mm\n0,0\n1,1\n", "at least three"), ("y_mm,z_mm\n0,0,1\n1,0,1\n", "two columns"),
                                ("y_mm,z_mm\n0,0\n1,0\n0,nan\n", "finite")):
            with self.subTest(text), self.assertRaisesRegex(Failure, reason):
                self.read(text)

    def test_missing_file_is_reported_by_name(self):
        with self.assertRaisesRegex(Failure, "nowhere.csv: cannot be read"):
            read_section("nowhere.csv")
