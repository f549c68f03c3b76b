#!/usr/bin/env python3
"""Generates data/robots/arm6: an industrial six-axis arm with a reach of about 1.2 m, as a URDF with meshes, and the
motion of data/scenes/arm6.yaml. The arm is our own design, similar to others of its size. Uses only the standard library.
"""
import math
import os

from mesh_from_field import box as box_field
from mesh_from_field import capsule, revolved, rounded_profile, smooth_union, turned
from robot_builder import Robot, mesh_from, write_motion

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data")
FOLDER = os.path.join(DATA, "robots", "arm6")
TRIANGLES = 1200
DENSITY = 1300.0        # kg/m^3, mean of hollow castings with motors


def drum_y(radius, y0, y1, x=0.0, z=0.0):
    """Cylinder along y."""
    body = revolved(rounded_profile([(0, y0), (radius, y0), (radius, y1), (0, y1)], 0.02))
    return turned(body, lambda px, py, pz: (px - x, pz - z, py))


def along_x(profile):
    body = revolved(rounded_profile(profile, 0.015))
    return turned(body, lambda x, y, z: (y, z, x))


def slab(field, y0, y1):
    """Intersection of the field with the slab between two planes."""
    return lambda x, y, z: max(field(x, y, z), y0 - y, y - y1)


def base():
    return revolved(rounded_profile([(0, 0), (0.19, 0), (0.19, 0.03), (0.14, 0.06), (0.13, 0.296), (0, 0.296)], 0.02))


def shoulder():
    turret = revolved(rounded_profile([(0, 0.004), (0.13, 0.004), (0.13, 0.10), (0.09, 0.16), (0, 0.16)], 0.02))
    neck = capsule((0.02, 0.10, 0.09), (0.15, 0.11, 0.18), 0.055)
    return smooth_union(0.03, turret, neck, drum_y(0.105, 0.062, 0.16, 0.15, 0.18))


def upper_arm():
    return slab(capsule((0, 0, 0), (0, 0, 0.60), 0.105, 0.085), -0.06, 0.056)


def elbow():
    housing = box_field((0.03, 0.0, 0.13), (0.13, 0.17, 0.14), 0.03)
    neck = capsule((0.0, 0.105, 0.0), (0.02, 0.05, 0.125), 0.045)
    return smooth_union(0.03, housing, neck, drum_y(0.085, 0.062, 0.15))


def forearm():
    tube = along_x([(0, 0.004), (0.075, 0.004), (0.075, 0.06), (0.062, 0.12), (0.062, 0.29), (0, 0.29)])
    prongs = [capsule((0.27, 0.060 * s, 0), (0.42, 0.066 * s, 0), 0.017) for s in (1, -1)]
    ends = [drum_y(0.042, 0.049, 0.080, 0.42), drum_y(0.042, -0.080, -0.049, 0.42)]
    return smooth_union(0.02, tube, *prongs, *ends)


def wrist():
    return smooth_union(0.015, drum_y(0.046, -0.045, 0.045), capsule((0, 0, 0), (0.058, 0, 0), 0.030))


def flange():
    return along_x([(0, 0.003), (0.045, 0.003), (0.045, 0.022), (0.030, 0.030), (0, 0.030)])


def deg(lower, upper, velocity, effort):
    return (*(math.radians(v) for v in (lower, upper, velocity)), effort)


def main():
    os.makedirs(FOLDER, exist_ok=True)
    robot = Robot("arm6", "Six-axis industrial arm, made by scripts/generate_arm6.py")
    for name, field, reach in (("base", base(), 0.31), ("shoulder", shoulder(), 0.31), ("upper_arm", upper_arm(), 0.72),
                               ("elbow", elbow(), 0.25), ("forearm", forearm(), 0.48), ("wrist", wrist(), 0.12),
                               ("flange", flange(), 0.07)):
        robot.link(name, [mesh_from(FOLDER, name, field, reach, TRIANGLES)], DENSITY)
    robot.link("tool0")
    y, z, x = (0, 1, 0), (0, 0, 1), (1, 0, 0)
    none = (0, 0, 0)
    robot.joint("axis1", "revolute", "base", "shoulder", ((0, 0, 0.30), none), z, deg(-170, 170, 180, 500))
    robot.joint("axis2", "revolute", "shoulder", "upper_arm", ((0.15, 0, 0.18), none), y, deg(-90, 125, 150, 500))
    robot.joint("axis3", "revolute", "upper_arm", "elbow", ((0, 0, 0.60), none), y, deg(-160, 75, 180, 250))
    robot.joint("axis4", "revolute", "elbow", "forearm", ((0.10, 0, 0.13), none), x, deg(-185, 185, 300, 80))
    robot.joint("axis5", "revolute", "forearm", "wrist", ((0.42, 0, 0), none), y, deg(-120, 120, 300, 60))
    robot.joint("axis6", "revolute", "wrist", "flange", ((0.09, 0, 0), none), x, deg(-350, 350, 420, 40))
    robot.joint("tool0_fixed", "fixed", "flange", "tool0", ((0.03, 0, 0), (0, math.pi / 2, 0)))
    robot.write(os.path.join(FOLDER, "arm6.urdf"))

    def posture(t):
        s = 2 * math.pi * t / 6.0
        return (0.9 * math.sin(s), 0.35 + 0.35 * math.sin(s / 1 + 0.5), 0.25 + 0.45 * math.sin(2 * s), 0.6 * math.sin(s),
                0.6 + 0.5 * math.sin(2 * s + 1), 1.5 * math.sin(s))

    write_motion(os.path.join(DATA, "scenes", "motion", "arm6.csv"), 6.0, posture)


if __name__ == "__main__":
    main()
