#!/usr/bin/env python3
"""Generates the joint motions of the scenes in data/scenes/motion: CSV with the columns t,q0,q1,... (s, rad or m).

Uses only the standard library. The motions of the two arms of HUG are mirror images of each other.
"""
import math
import os

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data", "scenes", "motion")

# Postures of the left arm: hands apart in front of the column; handles 3 cm apart.
APART = (0.016, -0.909, -1.175, 1.933, -0.955, -0.321, 0.142)
CLOSE = (-0.174, -1.747, -1.240, 1.838, 0.593, 0.421, -0.667)

ALONE_PERIOD, ALONE_TIMES = 5.0, 4            # s, and number of repetitions
GENTLE_LENGTH = 31.0                          # s, longer than the recording
GENTLE = ((0.08, 7.0), (0.10, 6.0), (0.10, 9.0), (0.12, 5.0), (0.15, 4.0), (0.10, 3.5), (0.20, 4.5))  # rad, s

SPHERE_CORNER = 0.25                          # m, half the side of the square of the centres
SPHERE_TIME = 8.0                             # s

# Two robots on a table. The large one swings its hand from side to side; the small one moves between positions and lowers its
# quill at each.
TABLE_TIME = 32.0                             # s, longer than the recordings
LWR_REST = (0.35, -0.8, 0.0, 1.2, 0.0, -1.1, 0.0)
LWR_SWING = ((0.5, 4.0), (0.15, 5.0), (0.1, 7.0), (0.2, 6.0), (0.2, 3.0), (0.2, 3.5), (0.5, 4.5))  # rad, s
SCARA_PLACES = ((0.6, 1.2), (1.6, 0.7), (2.4, -0.9), (1.2, -0.4))  # rad
SCARA_MOVE, SCARA_DOWN, SCARA_STROKE = 0.8, 0.35, 0.07        # s, s, m

ROD_TURN, ROD_TIME = math.pi / 2, 2.0         # rad and s, from side by side to contact


def minimum_jerk(s):
    """Minimum-jerk interpolation from 0 to 1, with zero velocity and acceleration at both ends."""
    s = min(max(s, 0.0), 1.0)
    return s ** 3 * (10 - 15 * s + 6 * s * s)


def mirrored(q):
    """Joint values of the right arm for the mirrored posture of the left arm."""
    return tuple(v if i % 2 else -v for i, v in enumerate(q))


def write(name, rows):
    with open(os.path.join(FOLDER, name), "w", newline="\n") as out:
        out.write("t," + ",".join(f"q{i}" for i in range(len(rows[0][1]))) + "\n")
        for t, q in rows:
            out.write(f"{t:.6g}," + ",".join(f"{v:.6g}" for v in q) + "\n")


def times(end, step):
    return [i * step for i in range(round(end / step) + 1)]


def hug_alone():
    """Repeatedly moves the hands together and apart."""
    rows = []
    for t in times(ALONE_PERIOD * ALONE_TIMES, 0.05):
        phase = t % ALONE_PERIOD / ALONE_PERIOD
        s = minimum_jerk(phase / 0.45) if phase < 0.5 else minimum_jerk((0.95 - phase) / 0.45)
        rows.append((t, tuple(a + s * (b - a) for a, b in zip(APART, CLOSE))))
    return rows


def hug_gentle():
    """Slow oscillation of every joint around the posture with the hands apart."""
    return [(t, tuple(q + size * math.sin(2 * math.pi * t / period) for q, (size, period) in zip(APART, GENTLE)))
            for t in times(GENTLE_LENGTH, 0.05)]


def bouncing(start, direction, speed):
    """Moves back and forth on the diagonal between -end and end at constant speed; rows only at the reversals."""
    end = SPHERE_CORNER * math.sqrt(2)
    t, q = 0.0, start * end
    rows = [(t, (q,))]
    while t < SPHERE_TIME:
        wall = direction * end
        if wall != q:
            t += abs(wall - q) / speed
            q = wall
            rows.append((t, (q,)))
        direction = -direction
    return rows


def rod():
    """Rotates into the other rod, rests there, rotates back."""
    rows = []
    for t in times(3 * ROD_TIME, 0.02):
        s = minimum_jerk(t / ROD_TIME) if t < 1.5 * ROD_TIME else minimum_jerk((3 * ROD_TIME - t) / ROD_TIME)
        rows.append((t, (s * ROD_TURN,)))
    return rows


def lwr_at_table():
    return [(t, tuple(q + size * math.sin(2 * math.pi * t / period) for q, (size, period) in zip(LWR_REST, LWR_SWING)))
            for t in times(TABLE_TIME, 0.05)]


def scara_at_table():
    """Repeats: move to the next position, lower, raise."""
    cycle = SCARA_MOVE + 2 * SCARA_DOWN
    rows = []
    for t in times(TABLE_TIME, 0.05):
        n, phase = int(t / cycle), t % cycle
        here, there = (SCARA_PLACES[k % len(SCARA_PLACES)] for k in (n, n + 1))
        s = minimum_jerk(phase / SCARA_MOVE)
        down = minimum_jerk(1 - abs(phase - SCARA_MOVE - SCARA_DOWN) / SCARA_DOWN)
        q0, q1 = (a + s * (b - a) for a, b in zip(here, there))
        rows.append((t, (q0, q1, 0.03 + SCARA_STROKE * down, 2.0 * math.sin(0.8 * t))))
    return rows


def main():
    os.makedirs(FOLDER, exist_ok=True)
    for name, rows in (("hug_alone", hug_alone()), ("hug_gentle", hug_gentle())):
        write(name + "_left.csv", rows)
        write(name + "_right.csv", [(t, mirrored(q)) for t, q in rows])
    # The fast spheres take 0.5 s for half a diagonal. The slow one starts halfway out, so that it passes the centre together
    # with them every second time; starting from a corner, at half the speed, it never would.
    half = SPHERE_CORNER * math.sqrt(2)
    write("sphere_fast.csv", bouncing(-1.0, 1, half / 0.5))
    write("sphere_slow.csv", bouncing(0.5, 1, half / 1.0))
    write("rod.csv", rod())
    write("two_people_lwr.csv", lwr_at_table())
    write("two_people_scara.csv", scara_at_table())


if __name__ == "__main__":
    main()
