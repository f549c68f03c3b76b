#!/usr/bin/env python3
"""Generates the column and the table of HUG: data/robots/hug/column.stl and table.stl (metres, z up, floor at z = 0).

The column includes the feet of both arms: their frames 0 are the `base` poses of the scenes data/scenes/hug_*.yaml.
Uses only the standard library. The script checks that both meshes are closed.
"""
import math
import os

from generate_lwr_meshes import JOINT_1
from mesh_from_field import (assert_closed, box, capsule, mesh_of, revolved, rounded_profile, smooth_union, turned,
                             write_stl)

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data", "robots", "hug")

# Position and axis of the foot of the left arm; the right arm is mirrored in y.
FOOT = (-0.08, 0.16, 1.25)
AXIS = tuple(c / math.sqrt(0.45 ** 2 + 0.85 ** 2 + 0.25 ** 2) for c in (0.45, 0.85, 0.25))
POST = (-0.30, 0.0)


def foot(side):
    """The foot of an arm up to joint 1, thicker than base.stl because the grid is coarser."""
    profile = rounded_profile([(0, -0.02), (0.084, -0.02), (0.084, 0.026), (0.064, 0.050), (0.069, 0.085),
                               (0.069, JOINT_1 - 0.0015), (0, JOINT_1 - 0.0015)], 0.012)
    axis = (AXIS[0], side * AXIS[1], AXIS[2])
    start = (FOOT[0], side * FOOT[1], FOOT[2])

    def to_local(x, y, z):
        p = (x - start[0], y - start[1], z - start[2])
        h = sum(p[m] * axis[m] for m in range(3))
        return math.sqrt(max(sum(c * c for c in p) - h * h, 0.0)), 0.0, h

    return turned(revolved(profile), to_local)


def bracket(side):
    inward = tuple(FOOT[m] + 0.035 * AXIS[m] for m in range(3))
    return capsule((POST[0], side * 0.02, 1.19), (inward[0], side * inward[1], inward[2]), 0.075, 0.055)


def column():
    plate = box((-0.22, 0, 0.02), (0.56, 0.62, 0.04), 0.012)
    post = box((POST[0], POST[1], 0.67), (0.17, 0.20, 1.32), 0.03)
    return smooth_union(0.02, smooth_union(0.05, plate, post),
                        smooth_union(0.03, bracket(1), bracket(-1)), foot(1), foot(-1))


def spaced(parts):
    """Concatenated grid coordinates of [(from, to, step), ...]."""
    axis = []
    for lower, upper, step in parts:
        n = max(1, round((upper - lower) / step))
        axis += [lower + i * (upper - lower) / n for i in range(n)]
    return axis + [parts[-1][1]]


def table():
    """A table top on four legs with sharp edges, from the filled cells of a small grid."""
    xs = [-0.20, -0.17, -0.13, 0.0, 0.13, 0.17, 0.20]
    ys = [-0.35, -0.32, -0.28, -0.14, 0.0, 0.14, 0.28, 0.32, 0.35]
    zs = [0.0, 0.175, 0.35, 0.525, 0.70, 0.73]
    filled = {(i, j, 4) for i in range(len(xs) - 1) for j in range(len(ys) - 1)}
    filled |= {(i, j, k) for i in (1, len(xs) - 3) for j in (1, len(ys) - 3) for k in range(4)}
    index, vertices, triangles = {}, [], []

    def vertex(i, j, k):
        if (i, j, k) not in index:
            index[i, j, k] = len(vertices)
            vertices.append((xs[i], ys[j], zs[k]))
        return index[i, j, k]

    for cell in sorted(filled):
        for m in range(3):
            for side in (0, 1):
                beyond = list(cell)
                beyond[m] += 2 * side - 1
                if tuple(beyond) in filled:
                    continue
                ring = []
                for b, c in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = list(cell)
                    corner[m] += side
                    corner[(m + 1) % 3] += b
                    corner[(m + 2) % 3] += c
                    ring.append(vertex(*corner))
                ring = ring if side else ring[::-1]
                triangles += [tuple(ring[:3]), (ring[0], ring[2], ring[3])]
    return vertices, triangles


def main():
    os.makedirs(FOLDER, exist_ok=True)
    axes = (spaced([(-0.53, -0.40, 0.043), (-0.40, -0.20, 0.028), (-0.20, 0.08, 0.0185)]),
            spaced([(-0.34, 0.34, 0.0185)]),
            spaced([(-0.03, 0.08, 0.0276), (0.08, 1.06, 0.11), (1.06, 1.40, 0.0185)]))
    for name, (vertices, triangles) in (("column", mesh_of(column(), axes)), ("table", table())):
        assert_closed(name, vertices, triangles)
        write_stl(os.path.join(FOLDER, name + ".stl"), name, vertices, triangles)
        print(f"{name}: {len(triangles)} triangles")


if __name__ == "__main__":
    main()
