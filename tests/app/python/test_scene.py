"""Scenes: the same numbers as the command line's, and what is not known is said."""
import csv
import os
import subprocess
import tempfile
import threading
import unittest

import numpy as np

import abstand
from support import ROOT, ROUNDING, at

SPHERES = ROOT / "data/scenes/spheres.yaml"
PERSON = """abstand: 1
defaults: {voxel: 0.05, point: 0.05, outer_layers: 1}
humans:
  - {name: p, height: 1.75, recording: {file: r.csv}}
objects:
  - {name: ball, shape: {sphere: {radius: 0.1}}, pose: {xyz: [3, 0, 1]}}
pairs: {default: between_groups}
"""


def write_person(folder):
    """Stands for 3 s at 10 Hz; the left arm below the shoulder is lost after 1 s, the right calf and foot are never seen."""
    rest = abstand.Human(1.75).rest
    never = ("ankle_right", "toe_right")
    names = [n for i, n in enumerate(abstand.JOINTS) if np.isfinite(rest[i]).all() and n not in never]
    lines = ["t," + ",".join(f"{n}.x,{n}.y,{n}.z" for n in names)]
    for i in range(31):
        cells = [str(i / 10)]
        for n in names:
            lost = i > 10 and n in ("elbow_left", "wrist_left", "hand_left")
            cells += ["", "", ""] if lost else [repr(float(x)) for x in rest[abstand.JOINTS.index(n)]]
        lines.append(",".join(cells))
    for name, text in (("r.csv", "\n".join(lines) + "\n"), ("scene.yaml", PERSON)):
        with open(os.path.join(folder, name), "w") as file:
            file.write(text)
    return os.path.join(folder, "scene.yaml")


def command_line(scene, *options):
    """The rows of --pairs-out, as {column: array}."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "pairs.csv")
        subprocess.run([os.environ["ABSTAND_PROGRAM"], "run", str(scene), "--react", "off", "--pairs-out", path, *options],
                       check=True, capture_output=True)
        with open(path) as file:
            rows = list(csv.DictReader(file))
    return {key: np.array([row[key] if key in "ab" else float(row[key]) for row in rows]) for key in rows[0]}


class SameNumbers(unittest.TestCase):
    def compare(self, scene, path, *options, **range_):
        run = scene.run(**range_, fields=("distance", "bound", "reach", "point_a", "point_b", "force", "torque_a", "contacts"))
        rows = command_line(path, *options)
        n, m = run.distance.shape
        self.assertEqual(len(rows["t"]), n * m)
        for name in ("distance", "bound", "reach", "contacts"):
            np.testing.assert_array_equal(getattr(run, name).ravel(), rows[name], name)
        for name, columns in (("point_a", "ax ay az"), ("point_b", "bx by bz"), ("force", "fx fy fz"), ("torque_a", "tx ty tz")):
            expected = np.stack([rows[c] for c in columns.split()], axis=1)
            np.testing.assert_array_equal(getattr(run, name).reshape(-1, 3), expected, name)
        self.assertEqual(list(zip(rows["a"][:m], rows["b"][:m])), scene.pairs)
        np.testing.assert_array_equal(np.repeat(run.t, m), rows["t"])

    def test_spheres(self):
        scene = abstand.Scene(SPHERES, threads=1)
        self.compare(scene, SPHERES, "--start", "0.4", "--end", "0.6", start=0.4, end=0.6)
        self.compare(scene, SPHERES, "--rate", "100", "--end", "2", rate=100, end=2)

    def test_a_person_with_gaps(self):
        with tempfile.TemporaryDirectory() as folder:
            path = write_person(folder)
            self.compare(abstand.Scene(path), path)

    def test_a_tolerance(self):
        self.compare(abstand.Scene(SPHERES, tolerance=0.05), SPHERES, "--tolerance", "0.05", "--end", "0.5", end=0.5)
        with self.assertRaisesRegex(ValueError, "tolerance"):
            abstand.Scene(SPHERES, tolerance=0.2)

    def test_the_middle_of_the_square(self):
        # At 0.5 s two of the spheres are in the middle, at one place: the depth is a diameter at most.
        step = abstand.Scene(SPHERES).step(0.5, cold=True)
        self.assertLess(step.distance[0], 0)
        np.testing.assert_allclose(step.X[0, :3, 3], step.X[1, :3, 3], atol=1e-3)

    def test_distances_between_spheres(self):
        run = abstand.Scene(SPHERES).run(times=np.linspace(0, 8, 500), fields=("distance", "bound", "at_least", "X", "fresh"))
        self.assertTrue(run.fresh.all())
        for k, (a, b) in enumerate(abstand.Scene(SPHERES).pair_indices):
            true = np.linalg.norm(run.X[:, a, :3, 3] - run.X[:, b, :3, 3], axis=1) - 0.1
            apart = true > 0.0
            self.assertTrue((run.at_least[apart, k] <= true[apart] + ROUNDING).all())
            self.assertTrue((run.distance[apart, k] >= true[apart] - ROUNDING).all())

    def test_runs_repeat(self):
        scene = abstand.Scene(SPHERES)
        first = scene.run(end=0.3)
        scene.step(1.0)
        np.testing.assert_array_equal(scene.run(end=0.3).distance, first.distance)
        np.testing.assert_array_equal(abstand.Scene(SPHERES, threads=2).run(end=0.3).distance, first.distance)


class Unknown(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.scene = abstand.Scene(write_person(cls.folder.name), threads=1)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def pair(self, part):
        return next(i for i, pair in enumerate(self.scene.pairs) if f"p/{part}" in pair)

    def test_it_is_never_safe(self):
        for t in (0.0, 1.0, 2.0, 3.0):
            step = self.scene.step(t)
            certain = step.distance - step.bound - step.reach
            np.testing.assert_array_equal(step.at_least, certain)
            calf, arm, torso = (self.pair(p) for p in ("calf_right", "forearm_left", "torso"))
            self.assertEqual((step.at_least[calf], step.fresh[calf]), (-np.inf, False))
            self.assertEqual(step.fresh[arm], t <= 1.0)
            self.assertAlmostEqual(step.reach[arm], 2.0 * max(0.0, t - 1.0), delta=ROUNDING)
            self.assertEqual((step.reach[torso], step.fresh[torso]), (0.0, True))
            states = dict(zip(self.scene.objects, step.pose_states))
            self.assertEqual((states["p/calf_right"], states["p/torso"]), (2, 0))

    def test_it_is_said(self):
        for run in (self.scene.run(), self.scene.run(times=self.scene.times)):
            kinds = {r["kind"] for r in run.reservations if r["fails"] == "always"}
            self.assertTrue(kinds, run.reservations)
            self.assertIn("stale_pose", {r["kind"] for r in run.reservations})
        self.assertTrue(self.scene.reservations)


class Poses(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        path = os.path.join(self.folder.name, "scene.yaml")
        with open(path, "w") as file:
            file.write("abstand: 1\nobjects:\n  - {name: a, shape: {sphere: {radius: 0.1}}}\n"
                       "  - {name: b, shape: {sphere: {radius: 0.05}}, pose: {xyz: [1, 0, 0]}}\n")
        self.scene = abstand.Scene(path)

    def tearDown(self):
        self.folder.cleanup()

    def test_objects_are_moved(self):
        self.assertAlmostEqual(self.scene.step(0.0).distance[0], 0.85, delta=0.0099 * 0.85)
        self.scene.set_pose("b", at(0.2), t=0.1, reach=0.02)
        step = self.scene.step(0.1)
        self.assertAlmostEqual(step.distance[0], 0.05, delta=1e-5)
        self.assertAlmostEqual(step.at_least[0], 0.03, delta=1e-5)
        self.scene.set_pose("b", at(0.14), t=0.2)
        step = self.scene.step(0.2)
        np.testing.assert_array_equal(step.object_force.sum(axis=0), 0)
        self.assertTrue(step.colliding.all())
        self.assertGreater(step.contacts[0], 0)

    def test_bad_input(self):
        for arguments, words in ((("c", at()), "no object 'c'"), (("a", np.zeros((4, 4))), "X: found"),
                                 (("a", at(), np.nan), "t: "), (("a", at(), 0.0, np.nan), "reach")):
            with self.assertRaisesRegex(ValueError, words):
                self.scene.set_pose(*arguments)
        with self.assertRaisesRegex(ValueError, "moved by the scene"):
            abstand.Scene(SPHERES).set_pose("sphere1", at())
        with self.assertRaisesRegex(ValueError, "did you mean 'distance'"):
            self.scene.run(fields=["distnace"])
        for times in ([np.nan], [0.0, np.inf]):
            with self.assertRaisesRegex(ValueError, "times"):
                self.scene.run(times=times)
        with self.assertRaisesRegex(ValueError, "t: expected seconds"):
            self.scene.step(np.inf)
        with self.assertRaisesRegex(abstand.ParseError, "nowhere.yaml"):
            abstand.Scene("nowhere.yaml")


class Threads(unittest.TestCase):
    def test_two_at_once_are_refused(self):
        scene = abstand.Scene(SPHERES, threads=1)
        refused = []
        for _ in range(20):
            worker = threading.Thread(target=scene.run)
            worker.start()
            while worker.is_alive() and not refused:
                try:
                    scene.step(0.0)
                except RuntimeError as error:
                    refused.append(error)
            worker.join()
            if refused:
                break
        self.assertIn("another thread", str(refused[0]))


if __name__ == "__main__":
    unittest.main()
