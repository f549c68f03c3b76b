"""Forward kinematics."""
import json
import os
import subprocess
import tempfile
import unittest

import numpy as np

import abstand
from support import ROOT, ROUNDING

PLANAR = """units
    length  m
    angle   degrees
end_units
mapping
    dof 0   1
    dof 1   2
end_mapping
chain
    frame   1   0    0  0  theta
    frame   2   0.5  0  0  theta
    frame   3   0.3  0  0  0
end_chain
"""
URDF = """<robot name="slide"><link name="base"/><link name="arm">
<collision><origin xyz="0 0 0.5"/><geometry><sphere radius="0.1"/></geometry></collision></link>
<joint name="lift" type="prismatic"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="2" velocity="3" effort="4"/></joint></robot>"""


def load(text, name):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, name)
        with open(path, "w") as file:
            file.write(text)
        return abstand.Mechanism(path)


class PlanarArm(unittest.TestCase):
    def setUp(self):
        self.arm = load(PLANAR, "arm.mech")

    def test_the_tip(self):
        self.assertEqual((self.arm.dof, self.arm.frames), (2, ["1", "2", "3"]))
        q = np.random.default_rng(1).uniform(-4, 4, size=(50, 2))
        X = self.arm.fk(q)
        self.assertEqual(X.shape, (50, 3, 4, 4))
        a, b = q[:, 0], q.sum(axis=1)
        np.testing.assert_allclose(X[:, 2, 0, 3], 0.5 * np.cos(a) + 0.3 * np.cos(b), atol=ROUNDING)
        np.testing.assert_allclose(X[:, 2, 1, 3], 0.5 * np.sin(a) + 0.3 * np.sin(b), atol=ROUNDING)
        np.testing.assert_allclose(X[:, 2, 1, 0], np.sin(b), atol=ROUNDING)
        np.testing.assert_array_equal(X[:, :, 3], np.tile([0, 0, 0, 1], (50, 3, 1)))

    def test_the_jacobian_is_that_of_small_steps(self):
        q, h = np.array([0.3, -1.1]), 1e-6
        J = self.arm.jacobian(q, "3")
        tip = lambda q: self.arm.fk(q)[2, :3, 3]
        steps = [(tip(q + h * e) - tip(q - h * e)) / (2 * h) for e in np.eye(2)]
        np.testing.assert_allclose(J[:3], np.transpose(steps), atol=1e-8)
        np.testing.assert_array_equal(J[3:], [[0, 0], [0, 0], [1, 1]])
        np.testing.assert_array_equal(self.arm.jacobian([q, q], 2)[1], J)

    def test_batches_have_the_bits_of_single_postures(self):
        lwr = abstand.Mechanism(ROOT / "data/robots/lwr/lwr4.mech")
        q = np.random.default_rng(2).uniform(-2, 2, size=(1000, 7))
        one, two = lwr.fk(q), lwr.fk(q, threads=2)
        np.testing.assert_array_equal(one, two)
        for i in (0, 255, 256, 999):
            np.testing.assert_array_equal(lwr.fk(q[i]), one[i])
        np.testing.assert_array_equal(lwr.fk(q.T.copy().T), one)

    def test_the_poses_of_fk_go_into_queries_as_they_are(self):
        ball = abstand.Structure(abstand.sphere(0.05), voxel=0.01)
        q = np.random.default_rng(3).uniform(-3, 3, size=(20, 2))
        tips = self.arm.fk(q)[:, 2]
        d = abstand.distances(ball, ball, tips, None)
        true = np.linalg.norm(tips[:, :3, 3], axis=1) - 0.1
        self.assertTrue((d.at_least <= true + ROUNDING).all() and (d.distance >= true - ROUNDING).all())

    def test_bad_input(self):
        for q, words in (([1, 2, 3], r"expected \(2,\)"), ([[1, 2], [np.nan, 0]], r"q\[1\]"), (1.0, "q: found"),
                         ([np.inf, 0], "q: found")):
            with self.assertRaisesRegex(ValueError, words):
                self.arm.fk(q)
        with self.assertRaisesRegex(ValueError, "no frame 'hand'"):
            self.arm.jacobian([0, 0], "hand")
        with self.assertRaisesRegex(ValueError, "expected 0 to 2"):
            self.arm.jacobian([0, 0], 3)
        with self.assertRaises(abstand.ParseError) as caught:
            load(PLANAR.replace("frame   2", "fraem   2"), "bad.mech")
        self.assertEqual(caught.exception.line, 11)


class Files(unittest.TestCase):
    def test_a_urdf(self):
        robot = load(URDF, "slide.urdf")
        self.assertEqual((robot.dof, robot.joints), (1, ["lift"]))
        for values, expected in ((robot.lower, -1), (robot.upper, 2), (robot.velocity, 3), (robot.effort, 4)):
            np.testing.assert_array_equal(values, [expected])
        arm = robot.frames.index("arm")
        np.testing.assert_allclose(robot.fk([0.7])[arm, :3, 3], [0, 0, 0.7], atol=ROUNDING)
        ((frame, shape, X),) = robot.geometry()
        self.assertEqual((frame, shape.name, shape.dimensions), ("arm", "sphere", (0.1,)))
        np.testing.assert_allclose(X[:3, 3], [0, 0, 0.5], atol=ROUNDING)

    def test_the_same_as_the_command_line(self):
        path = ROOT / "data/robots/lwr/lwr4.mech"
        answer = json.loads(subprocess.run(
            [os.environ["ABSTAND_PROGRAM"], "fk", path, "--q", "0.1,0.5,0,-1.2,0.2,0.8,0", "--json"],
            capture_output=True, check=True).stdout)
        frames = [np.reshape(f["T"], (3, 4)) for f in answer["frames"]]
        np.testing.assert_array_equal(abstand.Mechanism(path).fk([0.1, 0.5, 0, -1.2, 0.2, 0.8, 0])[:, :3], frames)


if __name__ == "__main__":
    unittest.main()
