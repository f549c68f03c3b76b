#!/usr/bin/env python3
"""Generates data/scenes/hug_reach.bvh: a standing person reaches forward with the right hand and withdraws it.

Synthetic: minimum-jerk joint angles on a skeleton of 1.75 m; cm, y up, facing +z, 120 Hz, joint names of MotionBuilder.
Uses only the standard library.
"""
import math
import os

from generate_scene_motions import minimum_jerk

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data", "scenes", "hug_reach.bvh")
RATE, FRAMES = 120, 541                 # 4.5 s
START, REACH, HOLD, BACK = 0.6, 1.3, 0.5, 1.3   # s: start of the reach, and durations of the phases


def skeleton():
    """(name, parent, offset in cm), parents first; a name ending in ' end' is an end site."""
    bones = [("Hips", None, (0, 0, 0)), ("Spine", "Hips", (0, 10, 0)), ("Spine1", "Spine", (0, 20, 0)),
             ("Neck", "Spine1", (0, 23.5, 0)), ("Head", "Neck", (0, 9, 0)), ("Head end", "Head", (0, 17.5, 0))]
    for side, s in (("Left", 1), ("Right", -1)):
        bones += [(side + "Shoulder", "Spine1", (3 * s, 19, 0)), (side + "Arm", side + "Shoulder", (15 * s, 0, 0)),
                  (side + "ForeArm", side + "Arm", (30 * s, 0, 0)), (side + "Hand", side + "ForeArm", (26 * s, 0, 0)),
                  (side + "Hand end", side + "Hand", (17 * s, 0, 0))]
        bones += [(side + "UpLeg", "Hips", (9 * s, -3, 0)), (side + "Leg", side + "UpLeg", (0, -43, 0)),
                  (side + "Foot", side + "Leg", (0, -42, 0)), (side + "ToeBase", side + "Foot", (0, -6, 13)),
                  (side + "ToeBase end", side + "ToeBase", (0, 0, 7))]
    return bones


def angles(t):
    """Rotations (z, y, x) in degrees of the moving joints, and the position of the hips in cm."""
    s = minimum_jerk((t - START) / REACH) - minimum_jerk((t - START - REACH - HOLD) / BACK)
    sway = math.sin(2 * math.pi * t / 2.25)
    lean = 14 * s
    turn = {
        "Hips": (0, 4 * s, 0.5 * sway),
        "Spine": (0.6 * sway, 5 * s, 0.4 * lean),
        "Spine1": (0, 8 * s, 0.6 * lean),
        "Neck": (0, -6 * s, -0.3 * lean),
        "Head": (0, -6 * s, -0.4 * lean + 8 * s),
        "LeftArm": (-76 + 2 * sway, 0, 0), "LeftForeArm": (0, -18, 0),
        "RightArm": (76 - 28 * s, 62 * s, 0),
        "RightForeArm": (0, 18 + 55 * 4 * s * (1 - s) - 8 * s, 0),
        "LeftUpLeg": (0, -4 * s, -0.5 * sway), "RightUpLeg": (0, -4 * s, -0.5 * sway),
    }
    return turn, (0.8 * sway, 94 - 0.6 * s, 4 * s)


def main():
    bones = skeleton()
    lines = ["HIERARCHY"]

    def put(name, depth):
        parent, offset = next((p, o) for n, p, o in bones if n == name)
        pad = "\t" * depth
        kind = "End Site" if name.endswith(" end") else ("ROOT " if parent is None else "JOINT ") + name
        lines.extend([pad + kind, pad + "{", pad + "\tOFFSET " + " ".join(f"{v:g}" for v in offset)])
        if not name.endswith(" end"):
            order.append(name)
            channels = "Zrotation Yrotation Xrotation"
            lines.append(pad + ("\tCHANNELS 6 Xposition Yposition Zposition " if parent is None else "\tCHANNELS 3 ")
                         + channels)
        for child, of, _ in bones:
            if of == name:
                put(child, depth + 1)
        lines.append(pad + "}")

    order = []
    put("Hips", 0)
    lines += ["MOTION", f"Frames: {FRAMES}", f"Frame Time: {1 / RATE:.7f}"]
    for frame in range(FRAMES):
        turn, hips = angles(frame / RATE)
        values = list(hips)
        for name in order:
            values += turn.get(name, (0, 0, 0))
        lines.append(" ".join(f"{round(v, 3) + 0.0:g}" for v in values))
    with open(FILE, "w", newline="\n") as out:
        out.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
