#!/usr/bin/env python3
"""Times a study of many short clips with one job and with several, in turns: `tune --jobs` on one machine.

usage: tests/bench/study_jobs.py ABSTAND [--clips 200] [--jobs 2] [--rounds 3]

Prints the seconds of each round and the ratio of the medians. Other work on the machine makes the ratio smaller; the load before each
round is printed beside it."""
import argparse
import os
import pathlib
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
RATE, SECONDS = 100.0, 2.0
STAND = {"Hips": (0, 0, 1.0), "Neck": (0, 0, 1.5), "Head": (0, 0, 1.72), "LeftShoulder": (0, 0.2, 1.45), "LeftElbow": (0, 0.2, 1.15),
         "LeftWrist": (0.1, 0.2, 0.95), "RightShoulder": (0, -0.2, 1.45), "RightElbow": (0, -0.2, 1.15),
         "RightWrist": (0.1, -0.2, 0.95)}


def write_clip(path, number):
    """Somebody who walks to and fro beside the robot, each at another pace."""
    columns = [f"{joint}.{axis}" for joint in STAND for axis in "xyz"]
    with open(path, "w", encoding="utf-8") as out:
        out.write("t," + ",".join(columns) + "\n")
        for i in range(int(RATE * SECONDS) + 1):
            t = i / RATE
            shift = (0.2 + 0.001 * number) * t
            cells = [v + (shift if axis == 0 else 0.0) for p in STAND.values() for axis, v in enumerate(p)]
            out.write(f"{t}," + ",".join(f"{v:.6f}" for v in cells) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("abstand")
    parser.add_argument("--clips", type=int, default=200)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--rounds", type=int, default=3)
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        environment = dict(os.environ, ABSTAND_CACHE=str(folder / "cache"))
        for i in range(args.clips):
            write_clip(folder / f"clip{i}.csv", i)
        (folder / "plan.yaml").write_text("abstand_plan: 1\nscenes: [cell.yaml]\nrecordings:\n" +
                                          "".join(f"  - clip{i}.csv\n" for i in range(args.clips)))
        (folder / "cell.yaml").write_text(f"""abstand: 1
defaults: {{voxel: 0.02, point: 0.02, outer_layers: 1}}
mechanisms:
  - name: rail7
    file: {ROOT}/data/robots/rail7/rail7.urdf
    base: {{xyz: [0, -0.65, 0]}}
    motion: {ROOT}/data/scenes/motion/rail7.csv
humans:
  - {{name: person, height: 1.75}}
""")
        seconds = {1: [], args.jobs: []}
        for number in range(args.rounds + 1):
            for jobs in seconds:
                out = folder / f"out{number}_{jobs}"
                load = os.getloadavg()[0]
                begin = time.monotonic()
                subprocess.run([args.abstand, "tune", str(folder / "plan.yaml"), "--out", str(out), "--jobs", str(jobs), "--quiet"],
                               check=True, env=environment, stdout=subprocess.DEVNULL)
                took = time.monotonic() - begin
                if number > 0:  # The first round fills the cache.
                    seconds[jobs].append(took)
                print(f"round {number}, jobs {jobs}: {took:.2f} s, load {load:.1f}", flush=True)
        ratio = statistics.median(seconds[1]) / statistics.median(seconds[args.jobs])
        print(f"{args.clips} clips: {ratio:.2f} times as fast with {args.jobs} jobs")


if __name__ == "__main__":
    main()
