# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the stress in a section of wheel and rail, and the surfaces in them."""
import copy
import unittest
import warnings

import matplotlib
matplotlib.use("Agg")
import numpy as np
from matplotlib import pyplot
from matplotlib.colors import to_rgba
from wheel_rail_contact import WheelsetContact, plot_stress, stress_at, von_mises
from wheel_rail_contact.core import contour
from wheel_rail_contact.core.stress_picture import YIELD
from wheel_rail_contact.core.stress_section import StressSection
from wheel_rail_contact.msg import ContactPatch, PatchStress, PressureGrid, StressPeak, WheelsetContact as Message

SIDE = 9       # number of cells along each side of the grid
HALF = 4.5e-3  # half the width of the grid [m]


def round_patch(yield_stress=0.0):
    """A patch with a parabolic pressure of 1 GPa on a circle, whose highest stress is near the depth of half its radius."""
    centres = np.linspace(-4e-3, 4e-3, SIDE)
    pressure = 1e9 * np.maximum(0, 1 - (centres[:, None]**2 + centres**2) / HALF**2)
    patch = ContactPatch(side=ContactPatch.RIGHT, max_pressure=1e9, normal_force=3e4, semi_axis_along=HALF,
                         semi_axis_across=HALF, approach=1e-4)
    patch.grid = PressureGrid(nx=SIDE, ny=SIDE, dx=1e-3, dy=1e-3, x0=-4e-3, y0=-4e-3, pressure=pressure.ravel())
    highest = float(von_mises(stress_at(patch, 0, 0, 2e-3)))
    for body in ("wheel", "rail"):
        peak = StressPeak(value=highest, depth=2e-3)
        setattr(patch, f"{body}_stress", PatchStress(von_mises=peak, shakedown_limit=4.7))
    patch.rail_stress.load_factor = np.sqrt(3) * 1e9 / yield_stress if yield_stress else 0.0
    return patch, highest


def lines_of_yield(axes):
    """Lines of the yield stress in a picture."""
    axes.figure.canvas.draw()
    return [collection for collection in axes.collections
            if len(collection.get_edgecolor()) and tuple(collection.get_edgecolor()[0]) == to_rgba(YIELD)
            and any(len(path.vertices) for path in collection.get_paths())]


def labels_of(axes):
    """Labels of isolines. Before matplotlib 3.5 they are not among the texts of the axes."""
    return [text for text in (*axes.texts, *axes.artists) if getattr(text, "get_text", str)().isdigit()]


class PlotStress(unittest.TestCase):
    def setUp(self):
        self.addCleanup(pyplot.close, "all")
        self.patch, self.highest = round_patch()

    def test_both_bodies_are_drawn_in_true_proportions_on_one_scale(self):
        axes = plot_stress(self.patch)
        axes.figure.canvas.draw()
        box, (left, right, low, high) = axes.get_window_extent(), axes.axis()
        self.assertAlmostEqual(box.width / box.height, (left - right) / (high - low), places=3)
        self.assertGreater(left, right, "y points to the left")
        meshes = [each for each in axes.collections if each.get_array() is not None and each.get_array().size > 100]
        self.assertEqual(len(meshes), 2)
        for mesh in meshes:
            np.testing.assert_allclose(mesh.get_clim(), (0, 1e-6 * self.highest))
        self.assertIn("field side is on the right", axes.get_xlabel())
        texts = " ".join(text.get_text() for text in axes.texts)
        for body in ("wheel", "rail"):
            self.assertIn(f"{body}: {1e-6 * self.highest:.0f} MPa, 2.00 mm deep", texts)

    def test_the_stress_in_the_picture_is_that_of_the_pressure(self):
        section = StressSection(self.patch)
        for body, sign in zip(section.bodies, (1, -1)):  # wheel above, rail below
            y, z = body.points[40, 20]
            self.assertGreater(sign * z, 0)
            self.assertAlmostEqual(body.stress[40, 20] / von_mises(stress_at(self.patch, 0, y, abs(z))), 1, places=9)
            np.testing.assert_allclose(body.place, (0, sign * 2e-3), atol=1e-12)
        np.testing.assert_allclose(section.loaded, [[(-HALF, 0), (HALF, 0)]], atol=1e-12)

    def test_only_an_exceeded_yield_stress_has_a_line(self):
        for share, number, text in ((0.9, 1, ""), (1.1, 0, ", not reached")):
            axes = plot_stress(round_patch(share * self.highest)[0])
            self.assertEqual(len(lines_of_yield(axes)), number)
            self.assertIn(f"yield stress {1e-6 * share * self.highest:.0f} MPa{text}\nload factor", axes.texts[-1].get_text())
        self.assertFalse(lines_of_yield(plot_stress(self.patch)))

    def test_given_axes_and_scale_are_used(self):
        _, (first, second) = pyplot.subplots(1, 2)
        self.assertIs(plot_stress(self.patch, ax=second, max_stress=2e9, colorbar=False), second)
        self.assertEqual(second.collections[0].get_clim(), (0, 2000))
        self.assertFalse(first.collections)
        self.assertEqual(len(first.figure.axes), 2)

    def test_a_scale_far_above_the_stress_has_no_isolines(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            axes = plot_stress(self.patch, max_stress=1e12)
        self.assertFalse(labels_of(axes))
        self.assertTrue(labels_of(plot_stress(self.patch)))

    def test_of_a_result_the_patch_with_the_highest_stress_is_drawn(self):
        lower = copy.deepcopy(self.patch)
        lower.side, lower.rail_stress.von_mises.value = ContactPatch.LEFT, 1.0
        lower.wheel_stress.von_mises.value = 1.0
        axes = plot_stress(Message(patches=[lower, self.patch]))
        self.assertIn("right wheel and rail", axes.get_title())

    def test_misuse_is_refused(self):
        empty = copy.deepcopy(self.patch)
        empty.grid.pressure = [0] * SIDE**2
        for message, arguments in (("has no stress; set stress/depths above 0", {"patch": ContactPatch(grid=self.patch.grid)}),
                                   ("the result has no patch", {"patch": Message()}),
                                   ("grid has no pressure above 0", {"patch": empty}),
                                   ("max_stress = 0: must be above 0", {"patch": self.patch, "max_stress": 0})):
            with self.assertRaisesRegex(ValueError, message):
                plot_stress(**arguments)

    def test_a_result_of_python_is_drawn_on_its_profiles(self):
        contact = WheelsetContact({"stress": {"depths": 8}, "material": {"wheel": {"poisson": 0.3}}})
        result = contact.evaluate(y=4e-3, force_z=-2e5)
        axes = plot_stress(result, contact, colorbar=False)
        self.assertIn("ν = 0.28 and 0.3", axes.get_title())
        curved = [line.get_ydata() for line in axes.lines if len(line.get_ydata()) > 50]
        self.assertEqual(len(curved), 2)
        for heights in curved:
            self.assertGreater(np.ptp(heights), 0.1, "a surface is plane [mm]")


class Contours(unittest.TestCase):
    def arc(self, radius, side):
        """Outline of a circular rail with its centre at (1, -radius), from the gauge side to the field side [m]."""
        angle = np.linspace(-1.5, 1.5, 2000)
        return contour.about(np.column_stack([1 + radius * np.sin(angle), radius * (np.cos(angle) - 1)]),
                             (1 + radius * np.sin(0.4), radius * (np.cos(0.4) - 1)), side, 1e-3, 5e-3)

    def test_a_circle_is_turned_to_the_tangent_plane_at_the_contact(self):
        for side in ("left", "right"):
            found = self.arc(0.05, side)
            np.testing.assert_allclose(found.s[[0, -1]], (-5e-3, 5e-3))
            np.testing.assert_allclose(found.points, np.column_stack(
                [0.05 * np.sin(found.s / 0.05), 0.05 * (np.cos(found.s / 0.05) - 1)]), atol=1e-7)
            # The ends are left out: there the directions are averaged to one side.
            np.testing.assert_allclose(found.normals[50:-50, 0], np.sin(found.s[50:-50] / 0.05), atol=1e-4)

    def test_the_field_side_of_the_left_rail_is_at_positive_y(self):
        outline = np.array([(-0.03, 0.0), (0.0, 0.0), (0.03, -0.01)])  # falls to the field side
        for side, sign in (("left", 1), ("right", -1)):
            found = contour.about(outline, (-1e-3, 0), side, 5e-4, 0.02)
            np.testing.assert_allclose(np.interp(-sign * 0.01, found.points[:, 0], found.points[:, 1]), 0, atol=1e-9)
            self.assertLess(np.interp(sign * 0.01, found.points[:, 0], found.points[:, 1]), -1e-3)

    def test_the_points_of_a_sharp_edge_do_not_cross_in_the_body(self):
        depth = np.full(400, 10e-3)
        sharp = self.arc(0.006, "left")
        sharp_depth = depth[:len(sharp.s)]
        self.assertLess(np.diff(sharp.at(sharp.s, sharp_depth)[:, 0]).min(), 0, "the normals of the surface itself cross")
        self.assertGreater(np.diff(sharp.for_depth(10e-3, 1).at(sharp.s, sharp_depth)[:, 0]).min(), 0)

    def test_a_contour_ends_where_the_surface_is_steep(self):
        found = self.arc(0.004, "left")
        self.assertGreaterEqual(found.normals[:, 1].min(), contour.STEEPEST)
        self.assertLess(found.s[-1], 4.5e-3)

    def test_a_pressed_wheel_is_nowhere_below_the_rail(self):
        rail, wheel = self.arc(0.05, "left"), contour.plane(5e-3)
        pressed = contour.pressed_on(wheel, rail, 1e-5)
        ground = np.interp(pressed.points[:, 0], rail.points[:, 0], rail.points[:, 1])
        self.assertTrue((pressed.points[:, 1] >= ground).all())
        self.assertAlmostEqual(pressed.points[1, 1], 0, delta=1e-8)  # in the contact both coincide, apart from interpolation
        self.assertAlmostEqual(pressed.points[0, 1], -1e-5, delta=1e-12)
