"""Distances and contacts, one by one and in batches."""
import threading
import tracemalloc
import unittest

import numpy as np

import abstand
from support import ROUNDING, at, random_poses

# m; the witnesses of a near answer lie within it of the nearest points (core/query/pair_query.hpp).
NEAR = 1e-5
FAR_SHARE = 0.0099
# m; points of shells are numbers of single precision, and witnesses follow from them.
SINGLE_PRECISION = 1e-8
# Of a force, what the sampling at 5 mm may cost (tests/core/query/penalty_force_test.cpp).
SAMPLING = 0.02

BALL = abstand.Structure(abstand.sphere(0.05))
LARGE = abstand.Structure(abstand.sphere(0.1))
BOX = abstand.Structure(abstand.box(0.2, 0.1, 0.3))
WALL = abstand.Structure(abstand.box(1.0, 1.0, 0.2), voxel=0.01)
PLAIN = ("distance", "bound", "at_least", "point_a", "point_b")
ALL = PLAIN + ("force", "torque_a", "torque_b", "contacts", "depth")


class ClosedForms(unittest.TestCase):
    def check(self, result, true):
        self.assertLessEqual(result.at_least, true + ROUNDING)
        self.assertGreaterEqual(result.distance, true - SINGLE_PRECISION)
        self.assertLessEqual(result.distance, true + max(NEAR, FAR_SHARE * true))

    def test_two_spheres(self):
        for X in random_poses(200, 1.0):
            centres = np.linalg.norm(X[:3, 3])
            if centres < 0.16:
                continue
            r = abstand.distance(LARGE, BALL, None, X)
            self.check(r, centres - 0.15)
            self.assertAlmostEqual(np.linalg.norm(r.point_a), 0.1, delta=ROUNDING)
            self.assertAlmostEqual(np.linalg.norm(r.point_b - X[:3, 3]), 0.05, delta=ROUNDING)
            self.assertAlmostEqual(np.linalg.norm(r.point_a - r.point_b), r.distance, delta=ROUNDING)
            self.assertEqual(float(r), r.distance)

    def test_faces_of_boxes(self):
        for gap in (0.001, 0.02, 0.09, 0.5):
            self.check(abstand.distance(BOX, BOX, at(0.3, 0, 0), at(0.5 + gap, 0, 0)), gap)
            self.check(abstand.distance(BOX, BOX, at(), at(0, 0.1 + gap, 0)), gap)
            self.check(abstand.distance(BOX, BOX, at(), at(0, 0, -0.3 - gap)), gap)

    def test_inside_the_distance_is_negative(self):
        r = abstand.distance(LARGE, BALL, None, at(0.14))
        self.assertLess(r.distance, 0)
        self.assertLessEqual(r.at_least, -0.01 + ROUNDING)

    def test_a_ball_pressed_into_a_wall(self):
        k = 1e6
        for depth in (0.01, 0.02, 0.04):
            X = at(0.1, -0.05, 0.1 + 0.05 - depth)
            c = abstand.contact(BALL, WALL, X, None, stiffness=k)
            cap = np.pi * depth**2 * (3 * 0.05 - depth) / 3
            np.testing.assert_allclose(c.force, [0, 0, k * cap], atol=SAMPLING * k * cap)
            self.assertGreater(c.contacts, 0)
            self.assertAlmostEqual(c.depth, depth, delta=c.bound + NEAR)

    def test_forces_and_torques_sum_to_zero(self):
        for X in random_poses(100, 0.12, seed=3):
            Y = at(0.03, -0.02, 0.01)
            c, back = abstand.contact(BOX, LARGE, X, Y), abstand.contact(LARGE, BOX, Y, X)
            p_a, p_b = X[:3, :3] @ BOX.centre_of_mass + X[:3, 3], Y[:3, 3] + LARGE.centre_of_mass
            size = 1 + np.abs(c.force).max()
            total = c.torque_a + c.torque_b + np.cross(p_a - p_b, c.force)
            np.testing.assert_allclose(total, 0, atol=ROUNDING * size)
            np.testing.assert_allclose(back.force, -c.force, atol=ROUNDING * size)
            self.assertEqual(back.distance, c.distance)

    def test_margins_and_laws(self):
        X = at(0, 0, 0.2)
        apart = abstand.contact(BALL, LARGE, X)
        self.assertEqual((apart.contacts, apart.depth), (0, 0.0))
        np.testing.assert_array_equal(apart.force, 0)
        within = abstand.contact(BALL, LARGE, X, margin=0.06)
        self.assertEqual(within.distance, apart.distance)
        self.assertAlmostEqual(within.depth, 0.01, delta=within.bound + NEAR)
        self.assertGreater(within.force[2], 0)
        thesis = abstand.contact(BALL, LARGE, X, margin=0.06, stiffness=1.0, law="thesis")
        self.assertGreater(thesis.force[2], 0)
        self.assertNotEqual(thesis.force[2], within.force[2])


class Memories(unittest.TestCase):
    def test_it_changes_no_bound(self):
        memory = abstand.Memory()
        for x in np.linspace(0.16, 0.5, 200):
            r = abstand.distance(LARGE, BALL, None, at(x), memory=memory)
            self.assertLessEqual(r.at_least, x - 0.15 + ROUNDING)
            self.assertGreaterEqual(r.distance, x - 0.15 - ROUNDING)

    def test_distances_are_within_the_tolerance(self):
        for tolerance in (0.0, 0.002, 0.1):
            memory = abstand.Memory()
            for x in np.linspace(0.26, 1.5, 100):
                r = abstand.distance(LARGE, BALL, None, at(x), memory=memory, tolerance=tolerance)
                self.assertLessEqual(r.distance, (x - 0.15) * (1 + tolerance + 1e-4) + 1e-5)
        for invalid in (-0.1, 0.2, np.nan):
            with self.assertRaisesRegex(ValueError, "tolerance"):
                abstand.distance(LARGE, BALL, None, at(1), memory=memory, tolerance=invalid)
            with self.assertRaisesRegex(ValueError, "tolerance"):
                abstand.distances(LARGE, BALL, None, at(1)[None], warm=True, tolerance=invalid)

    def test_it_belongs_to_one_pair(self):
        memory = abstand.Memory()
        abstand.distance(LARGE, BALL, None, at(1), memory=memory)
        for a, b in ((BALL, LARGE), (LARGE, BOX)):
            with self.assertRaisesRegex(ValueError, "another pair"):
                abstand.distance(a, b, None, at(1), memory=memory)
        memory.clear()
        abstand.distance(LARGE, BOX, None, at(1), memory=memory)


class Batches(unittest.TestCase):
    def test_they_have_the_bits_of_single_queries(self):
        X, Y = random_poses(300, 0.3, seed=1), random_poses(300, 0.1, seed=2)
        batch, touching = abstand.distances(BOX, LARGE, X, Y), abstand.contacts(BOX, LARGE, X, Y, margin=0.05)
        self.assertEqual(len(batch), 300)
        for i in range(300):
            one, touch = abstand.distance(BOX, LARGE, X[i], Y[i]), abstand.contact(BOX, LARGE, X[i], Y[i], margin=0.05)
            for name in PLAIN:
                np.testing.assert_array_equal(getattr(batch, name)[i], getattr(one, name), name)
            for name in ALL:
                np.testing.assert_array_equal(getattr(touching, name)[i], getattr(touch, name), name)

    def test_threads_do_not_change_them(self):
        X = random_poses(1000, 0.3)
        for warm in (False, True):
            results = [abstand.contacts(BOX, LARGE, X, threads=n, warm=warm) for n in (1, 2, 7, 0)]
            for other in results[1:]:
                for name in ALL:
                    np.testing.assert_array_equal(getattr(results[0], name), getattr(other, name), name)

    def test_warm_ones_keep_the_bound(self):
        X = np.array([at(x) for x in np.linspace(0.16, 1.0, 1000)])
        warm = abstand.distances(LARGE, BALL, None, X, warm=True)
        true = X[:, 0, 3] - 0.15
        self.assertTrue((warm.at_least <= true + ROUNDING).all())
        self.assertTrue((warm.distance >= true - ROUNDING).all())

    def test_any_layout_of_the_input_is_right(self):
        X = random_poses(50, 0.3)
        expected = abstand.distances(BOX, LARGE, X).distance
        wide = np.zeros((50, 3, 4, 8))
        wide[:, 1, :, ::2] = X
        unaligned = np.frombuffer(b"x" + X.tobytes(), dtype=np.uint8)[1:].view(np.float64).reshape(X.shape)
        for same in (np.asfortranarray(X), wide[:, 1, :, ::2], X[::-1][::-1], X.astype(">f8"), X.tolist(),
                     unaligned):
            np.testing.assert_array_equal(abstand.distances(BOX, LARGE, same).distance, expected)
        single = X.astype(np.float32)  # rotations within 1e-6, so they are taken
        self.assertEqual(len(abstand.distances(BOX, LARGE, single)), 50)

    def test_one_pose_serves_for_all(self):
        X = random_poses(20, 0.3)
        fixed = at(0.1, 0.2, 0.3)
        one = abstand.distances(BOX, LARGE, X, fixed).distance
        np.testing.assert_array_equal(one, abstand.distances(BOX, LARGE, X, np.tile(fixed, (20, 1, 1))).distance)
        self.assertEqual(len(abstand.distances(BOX, LARGE)), 1)
        self.assertEqual(len(abstand.distances(BOX, LARGE, X[:0])), 0)

    def test_out_is_written_into(self):
        X = random_poses(20, 0.3)
        out = abstand.Distances(20)
        column = out.distance
        self.assertIs(abstand.distances(BOX, LARGE, X, out=out), out)
        np.testing.assert_array_equal(column, abstand.distances(BOX, LARGE, X).distance)
        with self.assertRaisesRegex(ValueError, "room for 20 poses, expected 19"):
            abstand.distances(BOX, LARGE, X[1:], out=out)

    def test_nothing_is_copied(self):
        X = random_poses(20000, 0.5)
        out = abstand.Distances(len(X))
        for poses in (X, X[:, ::1].transpose(0, 2, 1).copy().transpose(0, 2, 1)):
            tracemalloc.start()
            abstand.distances(BOX, LARGE, poses, out=out)
            peak = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            self.assertLess(peak, X.nbytes // 10)

    def test_other_threads_run_meanwhile(self):
        # Somebody sees the first answer while the last is not there yet: so both ran at once.
        for n in (100000, 400000, 1600000):
            X = np.tile(at(0.3), (n, 1, 1))
            out = abstand.Distances(n)
            out.distance[:] = np.nan
            worker = threading.Thread(target=abstand.distances, args=(LARGE, BALL, None, X), kwargs={"out": out})
            worker.start()
            seen = False
            while worker.is_alive() and not seen:
                seen = not np.isnan(out.distance[0]) and bool(np.isnan(out.distance[-1]))
            worker.join()
            if seen:
                return
        self.fail("no other thread ran during a batch")


class BadInput(unittest.TestCase):
    def refused(self, words, *poses, **options):
        for call in (abstand.distances, abstand.contacts):
            with self.assertRaisesRegex(ValueError, words):
                call(BOX, BALL, *poses, **options)

    def test_the_row_that_is_no_rigid_transform_is_named(self):
        def with_row_7(change):
            X = random_poses(10, 1.0)
            change(X[7])
            return X

        def put(index, value):
            return lambda X: X.__setitem__(index, value)

        for change, words in ((put((0, 3), np.nan), "not finite"), (put((1, 1), np.inf), "not finite"),
                              (put((slice(0, 3), slice(0, 3)), 2 * np.eye(3)), "orthonormal"),
                              (put((slice(0, 3), slice(0, 3)), -np.eye(3)), "reflection"),
                              (put((3, 0), 0.1), "last row"), (put((3, 3), 2.0), "last row"),
                              (put((0, 3), 1e7), "beyond")):
            self.refused(r"X_a\[7\]: found .*" + words, with_row_7(change))
            self.refused(r"X_b\[7\]: found .*" + words, None, with_row_7(change))
            with self.assertRaisesRegex(ValueError, "X_b: found .*" + words):
                abstand.distance(BOX, BALL, None, with_row_7(change)[7])

    def test_wrong_shapes(self):
        self.refused(r"X_a: found an array \(3, 3\)", np.eye(3))
        self.refused(r"X_b: found an array \(2, 4, 3\)", None, np.zeros((2, 4, 3)))
        self.refused("3 and 2 poses", random_poses(3, 1), random_poses(2, 1))
        self.refused("X_a: found", "here")
        self.refused("threads", None, threads=-1)
        with self.assertRaisesRegex(ValueError, "many poses"):
            abstand.distance(BOX, BALL, random_poses(2, 1))

    def test_numbers_out_of_range(self):
        for options in ({"margin": -1}, {"margin": np.nan}, {"stiffness": np.inf}, {"law": "hooke"}):
            with self.assertRaisesRegex(ValueError, next(iter(options))):
                abstand.contact(BOX, BALL, **options)
        with self.assertRaises(TypeError):
            abstand.distance(BOX, None)


if __name__ == "__main__":
    unittest.main()
