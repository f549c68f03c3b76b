#!/usr/bin/env python3
"""Generates data/robots/humanoid: a humanoid with 47 degrees of freedom on wheels, as a URDF of boxes, cylinders and
spheres, and the motions of data/scenes/humanoid.yaml and humanoid_self.yaml. Uses only the standard library.

    wheeled base   4   x, y and yaw on the floor (one planar joint), and the spread of its four legs (three mimic the first)
    torso          3   yaw, pitch, chest pitch
    two arms    7 + 7
    two hands  12 + 12 four fingers of three joints each; the outermost joint of each finger mimics the middle one
    head           2   pan, tilt
                  47
"""
import math
import os

from robot_builder import NOWHERE, Robot, box, cylinder, sphere, write_motion

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data")
FOLDER = os.path.join(DATA, "robots", "humanoid")
NONE = (0, 0, 0)
X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
ALONG_X = (0, math.pi / 2, 0)
ALONG_Y = (math.pi / 2, 0, 0)


def at(x, y, z, rpy=NONE):
    return ((x, y, z), rpy)


def deg(lower, upper, velocity, effort):
    return (*(math.radians(v) for v in (lower, upper, velocity)), effort)


def platform(robot):
    robot.link("floor")
    robot.link("platform", [box((0.46, 0.40, 0.22), at(0, 0, 0.24))], 900)
    robot.joint("drive", "planar", "floor", "platform", NOWHERE, Z, (-1e6, 1e6, 1.0, 400))
    legs = (("front_left", 1, 1), ("front_right", 1, -1), ("rear_left", -1, 1), ("rear_right", -1, -1))
    for name, sx, sy in legs:
        yaw = math.atan2(sy, sx)
        robot.link(f"leg_{name}", [box((0.14, 0.07, 0.07), at(-0.02, 0, 0.04)),
                                   cylinder(0.08, 0.05, at(0.03, 0.07, -0.02, ALONG_Y))], 1500)
        robot.joint(f"span_{name}", "prismatic", "platform", f"leg_{name}", at(0.34 * sx, 0.29 * sy, 0.10, (0, 0, yaw)), X,
                    (0.0, 0.15, 0.2, 300), None if name == "front_left" else ("span_front_left", 1.0))


def torso(robot):
    robot.link("waist", [cylinder(0.11, 0.10, at(0, 0, 0.055))], 1200)
    robot.joint("torso_yaw", "revolute", "platform", "waist", at(0, 0, 0.352), Z, deg(-120, 120, 90, 230))
    robot.link("spine", [box((0.16, 0.17, 0.30), at(0, 0, 0.20))], 900)
    robot.joint("torso_pitch", "revolute", "waist", "spine", at(0, 0, 0.12), Y, deg(-30, 75, 90, 230))
    robot.link("chest", [box((0.24, 0.30, 0.26), at(0, 0, 0.18)), box((0.10, 0.10, 0.06), at(0, 0, 0.33))], 700)
    robot.joint("chest_pitch", "revolute", "spine", "chest", at(0, 0, 0.37), Y, deg(-45, 60, 90, 200))


def head(robot):
    robot.link("neck", [cylinder(0.045, 0.06, at(0, 0, 0.035))], 1000)
    robot.joint("head_pan", "revolute", "chest", "neck", at(0, 0, 0.362), Z, deg(-90, 90, 180, 20))
    robot.link("head", [box((0.14, 0.16, 0.14), at(0.02, 0, 0.115)), sphere(0.035, at(0.10, 0, 0.12))], 700)
    robot.joint("head_tilt", "revolute", "neck", "head", at(0, 0, 0.07), Y, deg(-40, 60, 180, 20))


def finger(robot, hand, name, pose, side):
    """Spread about z, then two joints and one mimic joint about y; the finger points along x."""
    f = f"{hand}_{name}"
    robot.link(f"{f}_base", [sphere(0.0115)], 1500)
    robot.joint(f"{f}_spread", "revolute", f"{hand}_palm", f"{f}_base", pose, Z, deg(-20, 20, 360, 2.4))
    robot.link(f"{f}_proximal", [cylinder(0.0105, 0.045, at(0.036, 0, 0, ALONG_X))], 1500)
    robot.joint(f"{f}_flexion", "revolute", f"{f}_base", f"{f}_proximal", NOWHERE, Y, deg(-10, 90, 360, 2.4))
    robot.link(f"{f}_medial", [cylinder(0.010, 0.022, at(0.020, 0, 0, ALONG_X))], 1500)
    robot.joint(f"{f}_medial_flexion", "revolute", f"{f}_proximal", f"{f}_medial", at(0.068, 0, 0), Y, deg(0, 100, 360, 1.2))
    robot.link(f"{f}_distal", [cylinder(0.0095, 0.018, at(0.018, 0, 0, ALONG_X)), sphere(0.0095, at(0.027, 0, 0))], 1500)
    robot.joint(f"{f}_distal_flexion", "revolute", f"{f}_medial", f"{f}_distal", at(0.039, 0, 0), Y, deg(0, 100, 360, 1.2),
                (f"{f}_medial_flexion", 1.0))


def arm(robot, side, s):
    """s: 1 for the left arm, -1 for the right. At zero, the arm hangs along -z, with the shoulder offset along y."""
    robot.link(f"{side}_shoulder", [cylinder(0.065, 0.09, at(0, 0.055 * s, 0, ALONG_Y))], 1300)
    robot.joint(f"{side}_shoulder_pitch", "revolute", "chest", f"{side}_shoulder", at(0, 0.165 * s, 0.22), Y,
                deg(-170, 170, 110, 180))
    robot.link(f"{side}_shoulder_cap", [sphere(0.062)], 1300)
    robot.joint(f"{side}_shoulder_roll", "revolute", f"{side}_shoulder", f"{side}_shoulder_cap", at(0, 0.175 * s, 0), X,
                deg(-20, 120, 110, 180) if s > 0 else deg(-120, 20, 110, 180))
    robot.link(f"{side}_upper_arm", [cylinder(0.055, 0.20, at(0, 0, -0.175))], 1300)
    robot.joint(f"{side}_upper_arm_yaw", "revolute", f"{side}_shoulder_cap", f"{side}_upper_arm", NOWHERE, Z,
                deg(-170, 170, 130, 100))
    robot.link(f"{side}_elbow", [sphere(0.055)], 1300)
    robot.joint(f"{side}_elbow_pitch", "revolute", f"{side}_upper_arm", f"{side}_elbow", at(0, 0, -0.34), Y,
                deg(-135, 5, 130, 100))
    robot.link(f"{side}_forearm", [cylinder(0.048, 0.19, at(0, 0, -0.165))], 1300)
    robot.joint(f"{side}_forearm_yaw", "revolute", f"{side}_elbow", f"{side}_forearm", NOWHERE, Z, deg(-170, 170, 200, 100))
    robot.link(f"{side}_wrist", [sphere(0.042)], 1300)
    robot.joint(f"{side}_wrist_roll", "revolute", f"{side}_forearm", f"{side}_wrist", at(0, 0, -0.31), X,
                deg(-60, 60, 180, 30))
    robot.link(f"{side}_palm", [box((0.045, 0.10, 0.085), at(0, 0, -0.095))], 1300)
    robot.joint(f"{side}_wrist_pitch", "revolute", f"{side}_wrist", f"{side}_palm", NOWHERE, Y, deg(-90, 90, 180, 30))
    # Fingers along -z, the thumb forward and opposite to them.
    down = (0, math.pi / 2, 0)
    for name, y in (("index", 0.034), ("middle", 0.0), ("ring", -0.034)):
        finger(robot, side, name, at(-0.002, y * s, -0.150, down), s)
    finger(robot, side, "thumb", at(0.036, 0.030 * s, -0.085, (math.pi, math.pi / 2, 0)), s)


def main():
    os.makedirs(FOLDER, exist_ok=True)
    robot = Robot("humanoid", "Humanoid of 47 degrees of freedom on wheels, made by scripts/generate_humanoid.py")
    platform(robot)
    torso(robot)
    for side, s in (("left", 1), ("right", -1)):
        arm(robot, side, s)
    head(robot)
    assert robot.dofs == 47, robot.dofs
    robot.write(os.path.join(FOLDER, "humanoid.urdf"))

    def posture(t):
        s = math.sin(2 * math.pi * t / 6.0)
        r = math.sin(2 * math.pi * t / 3.0)
        base = (0.2 * s, 0.1 * r, 0.3 * s, 0.06 + 0.05 * r)
        body = (0.4 * s, 0.15 + 0.1 * r, 0.1 * s)
        arms = []
        for side in (1, -1):
            reach = 0.5 + 0.5 * s * side
            arms += [-0.6 - 0.5 * reach, side * (0.3 + 0.2 * r), 0.2 * s * side, -1.1 - 0.4 * reach, 0.3 * r, 0.2 * s, 0.2 * r]
            grip = 0.5 + 0.4 * r
            arms += [0.05 * side, grip, 0.8 * grip] * 4
        return (*base, *body, *arms, 0.4 * s, 0.2 + 0.2 * r)

    write_motion(os.path.join(DATA, "scenes", "motion", "humanoid.csv"), 6.0, posture)

    def both_hands_to_one_place(t):
        w = (1 - math.cos(2 * math.pi * t / 4.0)) / 2
        arms = []
        for side in (1, -1):
            arms += [-0.5 - 0.3 * w, side * (0.3 - 0.6 * w), -0.8 * side * w, -1.1 - 0.6 * w, 0, 0, 0]
            arms += [0.05 * side, 0.5, 0.4] * 4
        return (0, 0, 0, 0.06, 0, 0.05, 0, *arms, 0, 0.1)

    write_motion(os.path.join(DATA, "scenes", "motion", "humanoid_self.csv"), 4.0, both_hands_to_one_place)
    within_an_arm(robot)


def within_an_arm(robot):
    """Writes the pairs within an arm and its hand, which are always near each other and must not be pushed apart."""
    with open(os.path.join(DATA, "scenes", "humanoid_self.pairs"), "w") as out:
        out.write("# Pairs within an arm and its hand, by scripts/generate_humanoid.py: near in every posture.\nverdict,a,b\n")
        for side in ("left", "right"):
            arm = [b for b in robot.bodies if b.startswith(f"{robot.name}/{side}_")]
            for i, a in enumerate(arm):
                for b in arm[i + 1:]:
                    out.write(f"user,{a},{b}\n")


if __name__ == "__main__":
    main()
