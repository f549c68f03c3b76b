#!/usr/bin/env python3
"""Generates data/robots/rail7: the seven-axis arm of data/robots/lwr, with its meshes, on a linear axis of 1.8 m, as a URDF,
and the motion of data/scenes/rail7.yaml. Uses only the standard library.
"""
import math
import os
import struct

from robot_builder import Robot, box, mesh, write_motion

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data")
FOLDER = os.path.join(DATA, "robots", "rail7")
LWR = os.path.join(DATA, "robots", "lwr")
DENSITY = 1000.0

# alpha, d, limit and speed in degrees, effort in N m: the table of lwr4.mech; the limits are the published ones of
# the KUKA LWR 4+.
JOINTS = ((0, 0.3105, 170, 110, 200), (90, 0, 120, 110, 200), (-90, 0.4, 170, 128, 100), (-90, 0, 120, 128, 100),
          (90, 0.39, 170, 204, 100), (90, 0, 120, 184, 30), (-90, 0.078, 170, 184, 30))


def read_stl(file):
    with open(file, "rb") as data:
        data.seek(80)
        count, = struct.unpack("<I", data.read(4))
        vertices = []
        for _ in range(count):
            values = struct.unpack("<12fH", data.read(50))
            vertices += [values[3:6], values[6:9], values[9:12]]
    return vertices, [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(count)]


def arm_link(name):
    return mesh(f"../lwr/{name}.stl", *read_stl(os.path.join(LWR, name + ".stl")))


def main():
    os.makedirs(FOLDER, exist_ok=True)
    robot = Robot("rail7", "Seven-axis arm on a linear axis, made by scripts/generate_rail7.py")
    none = (0, 0, 0)
    robot.link("rail", [box((2.6, 0.30, 0.20), ((0, 0, 0.50), none)), box((0.20, 0.30, 0.40), ((-1.0, 0, 0.20), none)),
                        box((0.20, 0.30, 0.40), ((1.0, 0, 0.20), none))], 900.0)
    robot.link("carriage", [box((0.40, 0.36, 0.045), ((0, 0, 0.0275), none))], 2700.0)
    robot.link("arm_base", [arm_link("base")], DENSITY)
    robot.joint("slide", "prismatic", "rail", "carriage", ((0, 0, 0.60), none), (1, 0, 0), (-0.9, 0.9, 1.0, 2000))
    robot.joint("arm_base_fixed", "fixed", "carriage", "arm_base", ((0, 0, 0.05), none))
    parent = "arm_base"
    for i, (alpha, d, limit, speed, effort) in enumerate(JOINTS, 1):
        a = math.radians(alpha)
        robot.link(f"link{i}", [arm_link(f"link{i}")], DENSITY)
        robot.joint(f"joint{i}", "revolute", parent, f"link{i}",
                    ((0, round(-math.sin(a) * d, 12), round(math.cos(a) * d, 12)), (a, 0, 0)), (0, 0, 1),
                    (-math.radians(limit), math.radians(limit), math.radians(speed), effort))
        parent = f"link{i}"
    robot.write(os.path.join(FOLDER, "rail7.urdf"))

    def posture(t):
        s = 2 * math.pi * t / 8.0
        return (0.8 * math.sin(s), 0.5 * math.sin(s), 0.6 + 0.3 * math.sin(2 * s), 0.3 * math.sin(s + 1),
                -1.2 + 0.5 * math.sin(2 * s), 0.4 * math.sin(s), 0.8 + 0.4 * math.sin(s + 2), math.sin(s))

    write_motion(os.path.join(DATA, "scenes", "motion", "rail7.csv"), 8.0, posture)


if __name__ == "__main__":
    main()
