"""Meshes, shapes and structures."""
import itertools
import os
import tempfile
import unittest

import numpy as np

import abstand
from support import ROOT, ROUNDING, random_poses

CUBE_CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
CUBE_TRIANGLES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                           [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])


class Meshes(unittest.TestCase):
    def test_a_cube_from_arrays(self):
        cube = abstand.Mesh(CUBE_CORNERS, CUBE_TRIANGLES)
        self.assertTrue(cube.watertight)
        self.assertAlmostEqual(cube.volume, 1.0, delta=ROUNDING)
        self.assertAlmostEqual(cube.area, 6.0, delta=ROUNDING)
        np.testing.assert_allclose(cube.extent, [1, 1, 1])

    def test_arrays_are_views_that_keep_the_mesh_alive(self):
        mesh = abstand.load_mesh(ROOT / "data/robots/lwr/link1.stl")
        vertices, triangles = mesh.vertices, mesh.triangles
        self.assertTrue(np.shares_memory(vertices, mesh.vertices))
        self.assertTrue(np.shares_memory(triangles, mesh.triangles))
        self.assertFalse(vertices.flags.owndata or vertices.flags.writeable)
        with self.assertRaises(ValueError):
            vertices[0] = 0
        before = vertices.copy()
        del mesh
        np.testing.assert_array_equal(vertices, before)
        self.assertLess(triangles.max(), len(vertices))

    def test_scale(self):
        path = ROOT / "data/robots/lwr/link1.stl"
        metres, millimetres = abstand.load_mesh(path), abstand.load_mesh(path, scale=0.001)
        np.testing.assert_allclose(millimetres.extent, 0.001 * metres.extent, rtol=1e-12)

    def test_save_and_load(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cube.obj")
            cube = abstand.Mesh(CUBE_CORNERS, CUBE_TRIANGLES)
            cube.save(path)
            np.testing.assert_array_equal(abstand.load_mesh(path).vertices, cube.vertices)

    def test_bad_input_is_named(self):
        with self.assertRaisesRegex(abstand.UsageError, r"triangles\[1\]: found the vertex 8"):
            abstand.Mesh(CUBE_CORNERS, [[0, 1, 2], [0, 1, 8]])
        with self.assertRaisesRegex(ValueError, r"vertices\[2\]"):
            abstand.Mesh([[0, 0, 0], [1, 0, 0], [0, np.nan, 0]], [[0, 1, 2]])
        with self.assertRaisesRegex(ValueError, "expected one of shape"):
            abstand.Mesh(np.zeros((4, 2)), [[0, 1, 2]])
        with self.assertRaisesRegex(abstand.ParseError, "nowhere.stl: error: no such file") as caught:
            abstand.load_mesh("nowhere.stl")
        self.assertEqual(caught.exception.file, "nowhere.stl")


class Shapes(unittest.TestCase):
    def test_volumes(self):
        for shape, volume in ((abstand.sphere(0.1), 4 / 3 * np.pi * 1e-3),
                              (abstand.ellipsoid(0.1, 0.2, 0.3), 4 / 3 * np.pi * 6e-3),
                              (abstand.box(0.1, 0.2, 0.3), 6e-3),
                              (abstand.cylinder(0.1, 0.5), np.pi * 5e-3),
                              (abstand.capsule(0.1, 0.5), np.pi * 5e-3 + 4 / 3 * np.pi * 1e-3)):
            self.assertAlmostEqual(shape.volume, volume, delta=ROUNDING, msg=repr(shape))
            self.assertTrue(shape.mesh(0.01).watertight)

    def test_bad_dimensions(self):
        for make in (lambda: abstand.sphere(-1), lambda: abstand.sphere(np.nan), lambda: abstand.box(1, 0, 1)):
            self.assertRaises(abstand.UsageError, make)


class Structures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.ball = abstand.Structure(abstand.sphere(0.1), voxel=0.01, name="ball")
        cls.link = abstand.Structure(abstand.load_mesh(ROOT / "data/robots/lwr/link3.stl"), voxel=0.01)

    def test_points_lie_on_the_surface_and_normals_point_inwards(self):
        points, normals = self.ball.points, self.ball.normals
        np.testing.assert_allclose(np.linalg.norm(points, axis=1), 0.1, atol=1e-6)
        np.testing.assert_allclose(normals, -points / 0.1, atol=1e-4)
        # The areas of a shape sum to its area (core/shell/pointshell.hpp).
        self.assertAlmostEqual(self.ball.areas.sum(), 4 * np.pi * 0.01, delta=1e-6)
        self.assertIs(points, self.ball.points)
        self.assertTrue(np.shares_memory(self.ball.areas, self.ball.areas))
        self.assertFalse(points.flags.writeable)

    def test_facts(self):
        self.assertEqual((self.ball.name, self.ball.voxel, self.ball.spacing), ("ball", 0.01, 0.01))
        self.assertAlmostEqual(self.ball.volume, abstand.sphere(0.1).volume, delta=ROUNDING)
        self.assertGreater(self.ball.memory, 1000)
        self.assertTrue(self.link.watertight)

    def test_the_number_of_threads_does_not_matter(self):
        shape = abstand.ellipsoid(0.05, 0.1, 0.07)
        one, two = (abstand.Structure(shape, voxel=0.01, threads=n) for n in (1, 2))
        np.testing.assert_array_equal(one.points, two.points)

    def test_saved_and_loaded_they_give_the_same_bits(self):
        X = random_poses(200, 0.3)
        shapes = [abstand.Structure(s, voxel=0.01) for s in (
            abstand.ellipsoid(0.05, 0.1, 0.07), abstand.box(0.1, 0.2, 0.05), abstand.cylinder(0.05, 0.1),
            abstand.capsule(0.05, 0.1))]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "body.structure")
            for body, trusted in itertools.product([self.ball, self.link, *shapes], (False, True)):
                body.save(path)
                loaded = abstand.Structure.load(path, trusted=trusted)
                self.assertEqual(loaded.name, body.name)
                for name in ("points", "normals", "areas", "centre_of_mass"):
                    np.testing.assert_array_equal(getattr(loaded, name), getattr(body, name))
                before, after = (abstand.contacts(b, self.ball, None, X, margin=0.05) for b in (body, loaded))
                for name in ("distance", "bound", "point_a", "force", "torque_b"):
                    np.testing.assert_array_equal(getattr(after, name), getattr(before, name))

    def test_a_damaged_file_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "ball.structure")
            self.ball.save(path)
            with open(path, "rb") as file:
                whole = file.read()
            for damaged in (b"", b"x" + whole[1:], whole[:-1], whole[:200], whole + b"x",
                            whole[:-100] + bytes([whole[-100] ^ 1]) + whole[-99:]):
                with open(path, "wb") as file:
                    file.write(damaged)
                with self.assertRaises(abstand.ParseError) as caught:
                    abstand.Structure.load(path)
                self.assertIn("ball.structure", str(caught.exception))
            with self.assertRaises(abstand.ParseError):
                abstand.Structure.load(os.path.join(folder, "none"))

    def test_bad_options(self):
        shape = abstand.sphere(0.1)
        for options in ({"voxel": 0}, {"voxel": np.nan}, {"spacing": -1}, {"field": "square"}, {"threads": -1}):
            with self.assertRaises(abstand.UsageError, msg=options):
                abstand.Structure(shape, **options)
        with self.assertRaises(TypeError):
            abstand.Structure("ball.stl")


if __name__ == "__main__":
    unittest.main()
