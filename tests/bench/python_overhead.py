#!/usr/bin/env python3
"""What Python costs: times of the module `abstand` beside those of a bare loop in C++ over the same queries.

    PYTHONPATH=build/app/python /usr/bin/python3 tests/bench/python_overhead.py

The loop in C++ (`_engine._loop_seconds`) asks the same structures at the same poses, which it has as C++ values, and keeps
each result; it runs in this process, between the runs of Python that it is compared with. Of each figure the median of ROUNDS
rounds is printed; ratios are those of one round, so that a busy machine slows both."""
import pathlib
import statistics
import subprocess
import sys
import time

import numpy as np

import abstand
from abstand import _engine

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROUNDS = 9
CALLS = 20000
POSES = 100000


def seconds(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def median(work):
    return statistics.median(work() for _ in range(ROUNDS))


def orbit(n, radius):
    """Poses on a circle about the origin, turning about z."""
    angle = np.linspace(0, 20 * np.pi, n)
    X = np.tile(np.eye(4), (n, 1, 1))
    X[:, 0, 0] = X[:, 1, 1] = np.cos(angle)
    X[:, 1, 0], X[:, 0, 1] = np.sin(angle), -np.sin(angle)
    X[:, 0, 3], X[:, 1, 3] = radius * np.cos(angle), radius * np.sin(angle)
    return X


def imports():
    def fresh(code):
        return median(lambda: float(subprocess.run([sys.executable, "-c", "import time; t = time.perf_counter(); " + code +
                                                    "; print(time.perf_counter() - t)"],
                                                   capture_output=True, check=True).stdout))
    print(f"import abstand                  {1e3 * fresh('import abstand'):8.1f} ms")
    print(f"import numpy, abstand           {1e3 * fresh('import numpy, abstand'):8.1f} ms, "
          f"of which numpy {1e3 * fresh('import numpy'):.1f} ms")
    print(f"import abstand; abstand.Scene   {1e3 * fresh('import abstand; abstand.Scene'):8.1f} ms")


def single_calls(name, a, b, X):
    poses = np.tile(X, (CALLS, 1, 1))

    def calls(call, **options):
        def loop():
            for _ in range(CALLS):
                call(a, b, None, X, **options)
        return loop

    for label, call, warm in (("distance", abstand.distance, False), ("distance, Memory", abstand.distance, True),
                              ("contact", abstand.contact, False)):
        def over():
            options = {"memory": abstand.Memory()} if warm else {}
            return (seconds(calls(call, **options)) - _engine._loop_seconds(a, b, None, poses, warm)) / CALLS
        inside = median(lambda: _engine._loop_seconds(a, b, None, poses, warm)) / CALLS
        print(f"{name}: {label:<18} C++ {1e6 * inside:7.2f} us a query, Python {1e6 * median(over):6.2f} us more")


def batches(name, a, b, X):
    for warm in (False, True):
        out = abstand.Distances(len(X))
        inside = median(lambda: _engine._loop_seconds(a, b, None, X, warm))
        ratio = median(lambda: seconds(lambda: abstand.distances(a, b, None, X, warm=warm, out=out)) /
                       _engine._loop_seconds(a, b, None, X, warm))
        print(f"{name}: {len(X)} poses, {'warm' if warm else 'cold'}: C++ {inside:6.3f} s, Python / C++ = {ratio:.3f}")


def kinematics():
    robot = abstand.Mechanism(ROOT / "data/robots/lwr/lwr4.mech")
    q = np.random.default_rng(1).uniform(-2, 2, size=(POSES, 7))
    one = median(lambda: seconds(lambda: [robot.fk(q[0]) for _ in range(CALLS)])) / CALLS
    many = median(lambda: seconds(lambda: robot.fk(q))) / POSES
    print(f"fk of 7 joints: {1e6 * one:.2f} us a call, {1e6 * many:.2f} us a posture in a batch of {POSES}")


def main():
    ball, large = (abstand.Structure(abstand.sphere(r)) for r in (0.05, 0.1))
    link = abstand.Structure(abstand.load_mesh(ROOT / "data/robots/lwr/link3.stl"))
    arm = abstand.Structure(abstand.ellipsoid(0.05, 0.045, 0.15))
    imports()
    single_calls("two spheres", large, ball, orbit(2, 0.3)[0])
    single_calls("link and arm", link, arm, orbit(2, 0.4)[0])
    batches("two spheres", large, ball, orbit(POSES, 0.3))
    batches("link and arm", link, arm, orbit(POSES, 0.4))
    kinematics()


if __name__ == "__main__":
    main()
