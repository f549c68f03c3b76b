#!/usr/bin/env python3
"""Plots the smallest distance between a person and a robot over time, with its certified lower bound.

    examples/python/distance_over_time.py data/scenes/hug_reach.yaml --out distance.png

Needs python3-matplotlib. Without --out a window opens."""
import argparse

import numpy as np

import abstand


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("scene", help="scene file with a person and a robot")
    arguments.add_argument("--rate", type=float, help="Hz (default: the frames of the recording)")
    arguments.add_argument("--out", help="image file to write")
    options = arguments.parse_args()

    import matplotlib
    if options.out:
        matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    scene = abstand.Scene(options.scene)
    run = scene.run(rate=options.rate)
    k = np.unravel_index(run.distance.argmin(), run.distance.shape)[1]
    print(f"closest: {run.distance.min():.4f} m, {' to '.join(scene.pairs[k])}")
    for reservation in run.reservations:
        print(f"reservation ({reservation['kind']}): {reservation['text']}")

    figure, axes = plt.subplots(figsize=(9, 4.5), layout="constrained")
    axes.plot(run.t, run.distance.min(axis=1), label="smallest distance")
    # If a position is unknown, there is no certified distance, and no point in the plot.
    certain = run.at_least.min(axis=1)
    axes.plot(run.t, np.where(np.isfinite(certain), certain, np.nan), ":", label="certified: distance - bound - pose uncertainty")
    axes.fill_between(run.t, 0, 1, where=~run.fresh.all(axis=1), transform=axes.get_xaxis_transform(), color="tab:red", alpha=0.2,
                      label="a pose is unknown")
    axes.axhline(0, color="black", linewidth=0.8)
    axes.set(xlabel="time [s]", ylabel="distance [m]", title=options.scene)
    axes.legend()
    if options.out:
        figure.savefig(options.out, dpi=120)
    else:
        plt.show()


if __name__ == "__main__":
    main()
