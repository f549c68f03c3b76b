#!/usr/bin/env python3
"""Generates the link meshes of the arm in data/robots/lwr, which resemble a light-weight robot, from formulas.

Each mesh is in its frame of lwr4.mech (metres). The script checks that the meshes are closed, consistent, outward and not
convex. Uses only the standard library.
"""
import math
import os
import sys

from mesh_from_field import (assert_closed, box, capsule, centroid, hull_volume, mesh_of, mesh_with, revolved,
                             rounded_profile, smooth_difference, smooth_union, sphere, turned, volume, write_stl)

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data", "robots", "lwr")
TRIANGLES = 4700        # per link; 14 links have about 66,000, HUG in the thesis has 70,000
LEAST_HULL = 1.10       # minimum ratio of the volumes of the convex hull and the link

GAP = 0.0015            # m, half the gap between the two shells of an elbow
DRUM = 0.072            # m, radius of an elbow's shells
JOINT_1 = 0.1185        # m above the foot, start of link 1


def along_x(profile):
    return turned(revolved(profile), lambda x, y, z: (y, z, x))


def elbow_link(length):
    """One shell of an elbow and the adjacent tube.

    The origin is the centre of the elbow, its axis is x, the shell of this link is at x > 0. The tube extends along z to
    z = length, the face of the next joint.
    """
    end = length - 0.0015
    tube = revolved(rounded_profile(
        [(0, -0.02), (0.056, -0.02), (0.061, 0.05), (0.054, 0.095), (0.060, end - 0.052), (0.069, end - 0.040),
         (0.069, end - 0.006), (0.063, end), (0, end)], 0.018))
    shell = along_x(rounded_profile(
        [(0, GAP), (DRUM, GAP), (DRUM, 0.045), (0.058, 0.076), (0.045, 0.079), (0.041, 0.068), (0, 0.068)], 0.014))
    shoulder = capsule((0.034, 0, 0.01), (0.012, 0, 0.085), 0.050, 0.052)
    other_shell = along_x(rounded_profile(
        [(0, -0.2), (DRUM + 0.010, -0.2), (DRUM + 0.010, GAP), (0, GAP)], 0.004))
    groove = along_x([(0, GAP - 0.001), (0.03, GAP - 0.001), (0.03, GAP + 0.012), (0, GAP + 0.012)])
    return smooth_difference(0.016, smooth_union(0.030, tube, shell, shoulder), other_shell, groove)


def forearm_link(length):
    """Tube from joint 5 (z = -length) to the socket of the wrist ball, below the origin."""
    start = -length + 0.0015
    tube = revolved(rounded_profile(
        [(0, start), (0.063, start), (0.069, start + 0.006), (0.069, start + 0.040), (0.060, start + 0.052),
         (0.047, -0.095), (0.052, -0.07), (0.066, -0.052), (0.066, -0.036), (0, -0.036)], 0.014))
    return smooth_difference(0.006, tube, sphere((0, 0, 0), 0.0615))


def wrist_link():
    """The ball of the wrist (origin, axis z) with the neck to joint 7, along y."""
    ball = sphere((0, 0, 0), 0.060)
    neck = turned(revolved(rounded_profile(
        [(0, 0.0), (0.031, 0.0), (0.031, 0.053), (0.043, 0.058), (0.043, 0.068), (0, 0.068)], 0.006)),
        lambda x, y, z: (z, x, y))
    # A flat face at each end of the axis, with a recess for the bearing cap.
    flat = [turned(revolved([(0, 0.043), (0.09, 0.043), (0.09, 0.2), (0, 0.2)]), lambda x, y, z, s=s: (x, y, s * z))
            for s in (1, -1)]
    bearing = [turned(revolved([(0, 0.024), (0.026, 0.024), (0.028, 0.2), (0, 0.2)]),
                      lambda x, y, z, s=s: (x, y, s * z)) for s in (1, -1)]
    return smooth_union(0.006, smooth_difference(0.006, ball, *flat, *bearing), neck)


def hand_link():
    """Flange (its face is the plane of the origin, z outward) and the handle for the user."""
    flange = revolved(rounded_profile(
        [(0, -0.0085), (0.040, -0.0085), (0.043, -0.005), (0.043, 0.008), (0.030, 0.014), (0, 0.014)], 0.004))
    stem = capsule((0, 0, 0), (0, 0, 0.034), 0.021, 0.017)
    bow = []
    points = []
    for i in range(17):
        angle = math.pi * i / 16
        points.append((0.062 * math.cos(angle), 0.0, 0.098 - 0.062 * math.sin(angle) ** 0.8))
    for p, q in zip(points, points[1:]):
        bow.append(capsule(p, q, 0.0125))
    grip = capsule((-0.064, 0, 0.098), (0.064, 0, 0.098), 0.0165)
    swell = capsule((-0.025, 0, 0.098), (0.025, 0, 0.098), 0.0185)
    return smooth_union(0.012, flange, stem, smooth_union(0.004, *bow), smooth_union(0.01, grip, swell))


def base_profile():
    return rounded_profile(
        [(0, 0.0), (0.092, 0.0), (0.092, 0.016), (0.070, 0.024), (0.062, 0.065), (0.069, 0.078),
         (0.069, JOINT_1 - 0.0075), (0.063, JOINT_1 - 0.0015), (0, JOINT_1 - 0.0015)], 0.010)


def base_link():
    body = revolved(base_profile())
    plug = capsule((0, 0.05, 0.040), (0, 0.088, 0.040), 0.018)
    return smooth_union(0.008, body, plug)


# The shell of an elbow is on the side +x in the coordinates of elbow_link(); these transforms move it to the frames of the arm.
# Shells alternate: link 1 is on one side of the arm, 2 and 3 on the other, 4 on the first.
LINKS = {
    "link1": (turned(elbow_link(0.3105 - JOINT_1), lambda x, y, z: (y, x, -z)), 0.20),
    "link2": (turned(elbow_link(0.200), lambda x, y, z: (z, x, y)), 0.21),
    "link3": (turned(elbow_link(0.200), lambda x, y, z: (-y, x, -z)), 0.21),
    "link4": (turned(elbow_link(0.195), lambda x, y, z: (z, x, -y)), 0.205),
    "link5": (forearm_link(0.195), 0.20),
    "link6": (wrist_link(), 0.08),
    "link7": (hand_link(), 0.12),
    "base": (base_link(), 0.13),
}


def main():
    wanted = sys.argv[1:] or list(LINKS)
    os.makedirs(FOLDER, exist_ok=True)
    for name in wanted:
        field, reach = LINKS[name]
        # A coarse mesh first, to determine the bounds of the grid.
        coarse = mesh_with(field, (-reach,) * 3, (reach,) * 3, 1200, 0.3)[0]
        lower = [min(v[m] for v in coarse) - 0.006 for m in range(3)]
        upper = [max(v[m] for v in coarse) + 0.006 for m in range(3)]
        vertices, triangles = mesh_with(field, lower, upper, TRIANGLES)
        assert_closed(name, vertices, triangles)
        assert 3000 <= len(triangles) <= 5000, f"{name}: {len(triangles)} triangles"
        hull = hull_volume(vertices) / volume(vertices, triangles)
        assert hull >= LEAST_HULL, f"{name}: its hull has only {hull:.3f} times its volume"
        write_stl(os.path.join(FOLDER, name + ".stl"), name, vertices, triangles)
        print(f"{name}: {len(triangles)} triangles, {1e3 * volume(vertices, triangles):.3f} l, hull {hull:.2f} times, "
              f"centre {' '.join(f'{c:.4f}' for c in centroid(vertices, triangles))}", flush=True)


if __name__ == "__main__":
    main()
