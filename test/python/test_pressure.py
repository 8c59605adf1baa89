# SPDX-License-Identifier: BSD-3-Clause
"""Pressures of messages as arrays and pictures."""
import unittest

import matplotlib
matplotlib.use("Agg")
import numpy as np
from matplotlib import pyplot
from wheel_rail_contact import plot_pressure, to_array
from wheel_rail_contact.msg import ContactPatch, PressureGrid

GRID = PressureGrid(nx=2, ny=3, dx=1e-3, dy=2e-3, x0=-0.5e-3, y0=-2e-3, pressure=[1e8, 2e8, 3e8, 4e8, 5e8, 0])
PATCH = ContactPatch(side=ContactPatch.RIGHT, max_pressure=5.5e8, normal_force=3e3, grid=GRID)


class ToArray(unittest.TestCase):
    def test_rows_of_the_message_become_columns_of_x(self):
        np.testing.assert_array_equal(to_array(GRID), [[1e8, 3e8, 5e8], [2e8, 4e8, 0]])

    def test_a_grid_without_its_values_is_refused(self):
        for grid in (PressureGrid(), PressureGrid(nx=2, ny=2, pressure=[1, 2, 3])):
            message = f"has {len(grid.pressure)} values, but must have nx ny = {grid.nx * grid.ny}"
            with self.assertRaisesRegex(ValueError, message):
                to_array(grid)


class PlotPressure(unittest.TestCase):
    def setUp(self):
        self.addCleanup(pyplot.close, "all")

    def test_the_cells_are_drawn_in_true_proportions(self):
        axes = plot_pressure(PATCH)
        mesh = axes.collections[0]
        # Masked: without pressure.
        np.testing.assert_allclose(np.ma.filled(mesh.get_array(), 0).ravel(), [100, 200, 300, 400, 500, 0])
        axes.figure.canvas.draw()
        box, limits = axes.get_window_extent(), axes.axis()
        self.assertAlmostEqual(box.width / box.height, (limits[1] - limits[0]) / (limits[3] - limits[2]), places=3)
        np.testing.assert_allclose(limits, [-1, 1, -3, 3])  # the cells, in mm
        self.assertEqual(axes.get_title(), "right: 550 MPa, 3.0 kN")
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("x, forward [mm]", "y, left [mm]"))

    def test_given_axes_and_scale_are_used(self):
        _, (first, second) = pyplot.subplots(1, 2)
        self.assertIs(plot_pressure(PATCH, second, max_pressure=2e9, colorbar=False), second)
        self.assertEqual(second.collections[0].get_clim(), (0, 2000))
        self.assertFalse(first.collections)
        self.assertEqual(len(first.figure.axes), 2)

    def test_a_scale_below_the_highest_pressure_is_marked(self):
        axes = plot_pressure(PATCH, max_pressure=3e8)
        self.assertEqual(axes.collections[0].colorbar.extend, "max")

    def test_misuse_is_refused(self):
        with self.assertRaisesRegex(ValueError, "max_pressure = 0: must be above 0"):
            plot_pressure(PATCH, max_pressure=0)
        with self.assertRaisesRegex(ValueError, "has 0 values"):
            plot_pressure(ContactPatch())

    def test_a_result_is_drawn_as_its_message(self):
        class Result:
            """The members of a PatchResult that a picture shows."""
            side, max_pressure, normal_force = "right", 5.5e8, 3e3
            pressure, dx, dy = to_array(GRID), GRID.dx, GRID.dy
            x, y = GRID.x0 + GRID.dx * np.arange(2), GRID.y0 + GRID.dy * np.arange(3)

        a, b = plot_pressure(Result()), plot_pressure(PATCH)
        np.testing.assert_array_equal(a.collections[0].get_array(), b.collections[0].get_array())
        self.assertEqual((a.axis(), a.get_title()), (b.axis(), b.get_title()))
