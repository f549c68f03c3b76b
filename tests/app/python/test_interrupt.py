"""What a handler of a signal raises ends long calls, from Ctrl-C to a timer."""
import os
import signal
import tempfile
import unittest

import numpy as np

import abstand
from support import ROOT, at


class Stopped(Exception):
    pass


def stop(*_):
    raise Stopped


class Interrupts(unittest.TestCase):
    def setUp(self):
        self.before = signal.signal(signal.SIGALRM, stop)

    def tearDown(self):
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, self.before)

    def stopped(self, work):
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        self.assertRaises(Stopped, work)

    def test_batches(self):
        # Seconds of work; the poses are one in memory.
        a, b = (abstand.Structure(abstand.sphere(r)) for r in (0.05, 0.1))
        X = np.broadcast_to(at(0.3), (6_000_000, 4, 4))
        for threads in (1, 2):
            out = abstand.Distances(len(X))
            out.distance[-1] = -1
            self.stopped(lambda: abstand.distances(a, b, X, threads=threads, out=out))
            self.assertEqual(out.distance[-1], -1)

    def test_builds(self):
        for threads in (1, 2):
            self.stopped(lambda: abstand.Structure(abstand.box(1, 0.8, 0.6), voxel=0.001, spacing=0.004, threads=threads))

    def test_scenes(self):
        spheres = abstand.Scene(ROOT / "data/scenes/spheres.yaml", threads=1)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.yaml")
            with open(path, "w") as file:
                file.write("abstand: 1\ndefaults: {voxel: 0.001, point: 0.004}\nobjects:\n"
                           "  - {name: a, shape: {cuboid: {size: [1, 0.8, 0.6]}}}\n"
                           "  - {name: b, shape: {sphere: {radius: 0.5}}}\n")
            self.stopped(lambda: abstand.Scene(path))
        self.stopped(lambda: spheres.run(rate=1e6))
        self.assertEqual(len(spheres.step(0.0).distance), 3)


if __name__ == "__main__":
    unittest.main()
