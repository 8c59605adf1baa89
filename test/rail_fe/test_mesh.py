# SPDX-License-Identifier: BSD-3-Clause
import tempfile
import unittest
from pathlib import Path

import numpy as np
from rails import needs_programs, rail_60e1

from wheel_rail_contact.rail_fe.gmsh_mesh import rail_mesh
from wheel_rail_contact.rail_fe.stations import stations
from wheel_rail_contact.rail_fe.surface import FacePoints, shape_functions, shape_slopes


class Surface(unittest.TestCase):
    def test_shape_functions_are_one_at_their_node_and_sum_to_one(self):
        for count, r, s in ((8, [-1, 1, 1, -1, 0, 1, 0, -1], [-1, -1, 1, 1, -1, 0, 1, 0]),
                            (6, [0, 1, 0, 0.5, 0.5, 0], [0, 0, 1, 0, 0.5, 0.5])):
            at_nodes = shape_functions(count, np.array(r, float), np.array(s, float))
            np.testing.assert_allclose(at_nodes, np.eye(count), atol=1e-12)
            slopes = shape_slopes(count, np.array([0.3]), np.array([0.2]))
            np.testing.assert_allclose([slope.sum() for slope in slopes], 0, atol=1e-9)

    def test_nodal_forces_have_the_resultant_of_the_pressure(self):
        # One quadrilateral 2 x 3 with the pressure x: resultant 2*3*1, moment about x = 0: 3*(2^3/3).
        nodes = np.array([[0, 0, 0], [2, 0, 0], [2, 3, 0], [0, 3, 0], [1, 0, 0], [2, 1.5, 0], [1, 3, 0], [0, 1.5, 0]])
        points = FacePoints(nodes.astype(float), np.arange(8)[None], 60)
        forces = points.nodal(points.position[..., 0], 8)
        self.assertAlmostEqual(forces.sum(), 6, delta=1e-9)
        self.assertAlmostEqual(forces @ nodes[:, 0], 8, delta=8 / 60**2)  # midpoint rule: error 1/(2 n^2) at most


class Stations(unittest.TestCase):
    def test_stations_include_required_positions_and_are_finest_at_the_load(self):
        cuts = stations(3.6, 0.012, [0.225, 0.375, 1.8])
        steps = np.diff(cuts)
        self.assertEqual((cuts[0], cuts[-1]), (0, 3.6))
        for position in (0.225, 0.375, 1.8):
            self.assertIn(position, cuts)
        self.assertTrue((steps > 0).all())
        self.assertLessEqual(steps[0], 0.012)
        self.assertLessEqual(steps.max(), 6 * 0.012 + 1e-12)
        self.assertGreater(steps[-1], 3 * steps[0])


@needs_programs
class RailMesh(unittest.TestCase):
    def mesh(self, element_type, size):
        with tempfile.TemporaryDirectory() as directory:
            return rail_mesh(rail_60e1(), np.array([0.0, 0.02, 0.05]), size, element_type, Path(directory))

    def test_meshed_section_has_the_properties_of_the_outline(self):
        exact = rail_60e1().properties()
        for element_type in ("C3D20", "C3D10"):
            mesh = self.mesh(element_type, 0.012)
            points = FacePoints(mesh.nodes, mesh.plane_faces(0, 0.05), 8)
            y, z = points.position[..., 1], points.position[..., 2] - exact["centroid_height"]
            for name, moment in (("area", 1 + 0 * y), ("second_moment_y", z**2), ("second_moment_z", y**2)):
                self.assertAlmostEqual((moment * points.area).sum() / exact[name], 1, delta=1e-3, msg=name)

    def test_faces_in_a_section_within_the_rail_are_shared_and_those_at_the_ends_are_not(self):
        mesh = self.mesh("C3D20", 0.02)
        section_faces = len(mesh.plane_faces(0, 0.02))
        self.assertEqual(len(mesh.elements), 2 * section_faces)
        outer = mesh.nodes[mesh.outer_faces()][:, :, 0]
        self.assertEqual((np.ptp(outer, axis=1) < 1e-9).sum(), 2 * section_faces)

    def test_underside_has_the_area_of_the_flat_foot(self):
        mesh = self.mesh("C3D10", 0.02)
        points = FacePoints(mesh.nodes, mesh.plane_faces(2, 0.0), 4)
        self.assertAlmostEqual(points.area.sum(), 0.05 * rail_60e1().foot_width(), delta=1e-9)
