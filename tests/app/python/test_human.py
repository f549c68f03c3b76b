"""The parametric person."""
import types
import unittest

import numpy as np

import abstand
from support import ROUNDING

JOINT = {name: i for i, name in enumerate(abstand.JOINTS)}
PART = {name: i for i, name in enumerate(abstand.PARTS)}


def standing(human, n, rate=10.0):
    """Frames of one who stands, as Human.poses takes them."""
    return types.SimpleNamespace(t=np.arange(n) / rate, joints=np.tile(human.rest, (n, 1, 1)))


class Model(unittest.TestCase):
    def test_the_parts(self):
        human = abstand.Human(1.8, sex="f", mass=70)
        self.assertEqual(tuple(p.name for p in human.parts), abstand.PARTS)
        self.assertEqual((len(abstand.PARTS), len(abstand.JOINTS)), (14, 22))
        self.assertAlmostEqual(sum(p.mass for p in human.parts), 70, delta=ROUNDING)
        for part in human.parts:
            self.assertIn(part.shape.name, ("ellipsoid", "cuboid"))
            self.assertIn(part.proximal, abstand.JOINTS)
            self.assertTrue((np.linalg.eigvalsh(part.inertia) > 0).all())

    def test_standing(self):
        for preset in ("thesis", "anthropometric"):
            human = abstand.Human(1.7, preset=preset)
            X = human.pose()
            self.assertEqual(X.shape, (14, 4, 4))
            np.testing.assert_allclose(X[:, :3, :3], np.tile(np.eye(3), (14, 1, 1)), atol=1e-6)
            self.assertAlmostEqual(human.rest[JOINT["head_top"], 2], 1.7, delta=0.01)

    def test_of_a_percentile(self):
        large, usual = abstand.Human(percentile=95, sex="m"), abstand.Human(1.87, percentile=50, sex="m")
        self.assertAlmostEqual(large.stature, 1.87, delta=ROUNDING)
        self.assertAlmostEqual(large.mass, 110.7, delta=1e-9)
        thigh = PART["thigh_left"]
        self.assertAlmostEqual((large.parts[thigh].contour - usual.parts[thigh].contour) / (2 * np.pi), 0.016, delta=0.0005)
        self.assertEqual(abstand.Human(1.7, percentile=95).stature, 1.7)
        self.assertEqual(abstand.Human().stature, 1.75)

    def test_out_of_range(self):
        for options in ({"percentile": 0}, {"percentile": 100}, {"percentile": 95, "preset": "thesis"}, {"stature": 3}, {"stature": np.nan}, {"preset": "giant"}, {"sex": "x"}, {"mass": 1}):
            with self.assertRaises(abstand.UsageError, msg=options):
                abstand.Human(**options)


class Poses(unittest.TestCase):
    def setUp(self):
        self.human = abstand.Human(1.75)

    def test_a_turned_person_is_turned(self):
        R = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
        X = self.human.pose(self.human.rest @ R.T + [1, 2, 0])
        still = self.human.pose()
        np.testing.assert_allclose(X[:, :3, 3], still[:, :3, 3] @ R.T + [1, 2, 0], atol=1e-9)
        np.testing.assert_allclose(X[:, :3, :3], R @ still[:, :3, :3], atol=1e-9)

    def test_what_was_never_seen_has_no_pose(self):
        joints = self.human.rest.copy()
        joints[[JOINT["ankle_right"], JOINT["toe_right"]]] = np.nan
        X = self.human.pose(joints)
        unknown = np.isnan(X).any(axis=(1, 2))
        self.assertTrue(unknown[PART["calf_right"]] and unknown[PART["foot_right"]])
        self.assertFalse(unknown[PART["calf_left"]] or unknown[PART["torso"]])
        ball = abstand.Structure(abstand.sphere(0.1), voxel=0.02)
        with self.assertRaisesRegex(ValueError, rf"X_a\[{PART['calf_right']}\]"):
            abstand.distances(ball, ball, X)
        missing = np.full(22, 2)
        missing[[JOINT["ankle_right"], JOINT["toe_right"]]] = 0
        np.testing.assert_array_equal(self.human.pose(self.human.rest, missing), X)

    def test_what_is_lost_is_held_and_reaches_farther_with_time(self):
        frames = standing(self.human, 31)
        lost = [JOINT[j] for j in ("elbow_left", "wrist_left", "hand_left")]
        frames.joints[11:, lost] = np.nan
        poses = self.human.poses(frames)
        arm, torso = PART["forearm_left"], PART["torso"]
        self.assertTrue((poses.states[:11, arm] == 3).all() and (poses.states[11:, arm] == 1).all())
        self.assertTrue((poses.states[:, torso] == 3).all())
        np.testing.assert_allclose(poses.age[11:, arm], frames.t[11:] - 1.0, atol=ROUNDING)
        np.testing.assert_allclose(poses.reach[11:, arm], 2.0 * (frames.t[11:] - 1.0), atol=ROUNDING)
        np.testing.assert_array_equal(poses.reach[:, torso], 0)
        np.testing.assert_array_equal(poses.X[11:, arm], np.tile(poses.X[10, arm], (20, 1, 1)))

    def test_one_who_is_never_seen_may_be_anywhere(self):
        frames = standing(self.human, 3)
        frames.joints[:] = np.nan
        poses = self.human.poses(frames)
        self.assertTrue(np.isnan(poses.X).all() and np.isinf(poses.reach).all() and (poses.states == 0).all())

    def test_states_and_spread_of_the_frames_count(self):
        frames = standing(self.human, 2)
        frames.states = np.full((2, 22), 2)
        frames.states[:, JOINT["wrist_right"]] = 1
        frames.spread = np.zeros((2, 22))
        frames.spread[:, JOINT["wrist_left"]] = 0.01
        poses = self.human.poses(frames)
        self.assertEqual(poses.states[0, PART["forearm_right"]], 2)
        self.assertAlmostEqual(poses.spread[0, PART["forearm_left"]], 0.01, delta=ROUNDING)
        self.assertGreater(poses.reach[0, PART["forearm_left"]], 0.03)

    def test_bad_input(self):
        with self.assertRaisesRegex(ValueError, "joints: .*expected \\(22, 3\\)"):
            self.human.pose(np.zeros((21, 3)))
        with self.assertRaisesRegex(ValueError, "states: found 3"):
            self.human.pose(self.human.rest, np.full(22, 3))
        with self.assertRaisesRegex(ValueError, "joints"):
            self.human.poses(types.SimpleNamespace(t=np.zeros(2), joints=np.zeros((3, 22, 3))))
        with self.assertRaises(AttributeError):
            self.human.poses(7)


if __name__ == "__main__":
    unittest.main()
