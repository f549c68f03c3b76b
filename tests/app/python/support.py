"""What the tests of the Python module share."""
import pathlib

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
ROUNDING = 1e-9


def at(x=0.0, y=0.0, z=0.0):
    """A pose without rotation."""
    X = np.eye(4)
    X[:3, 3] = (x, y, z)
    return X


def random_poses(n, spread, seed=1):
    """(n, 4, 4): uniformly random rotations, places within a cube of +-spread (m)."""
    rng = np.random.default_rng(seed)
    q = rng.normal(size=(n, 4))
    q /= np.linalg.norm(q, axis=1)[:, None]
    x, y, z, w = q.T
    X = np.zeros((n, 4, 4))
    X[:, 3, 3] = 1.0
    X[:, :3, :3] = np.stack([
        1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
        2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
        2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)], axis=1).reshape(n, 3, 3)
    X[:, :3, 3] = rng.uniform(-spread, spread, size=(n, 3))
    return X
