#!/usr/bin/python3
"""Run time over the number of spheres: case.toml at several sizes, beside the report's own times.

usage: sizes.py [--scree PROGRAM] [--sizes A,B] [--steps N] [--picture FILE.png]

Prints the processor's time per step: that of a run of N steps less that of one of N / 5, so that the start does not count.
"""

import argparse
import csv
import json
import pathlib
import re
import resource
import subprocess
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
PERIOD = 2.0943951023931953  # of the flow [m]
PER_PERIOD = 2500
BOXES = {10_000: (1, 2, 2), 30_000: (2, 2, 3), 100_000: (2, 4, 5), 300_000: (4, 5, 6), 1_000_000: (5, 8, 10),
         3_000_000: (10, 10, 12), 10_000_000: (10, 20, 20)}  # in periods
REPORT_STEPS = 10_000


def size_settings(particles):
    """What makes the case this large."""
    box = [n * PERIOD for n in BOXES[particles]]
    return ["--set", f"domain.max={box}", "--set", f"particles.0.count={particles}"]


def processor_seconds(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measured(program, particles, steps):
    """Seconds of the processor for one step, and contacts per sphere."""
    step = 5e-4
    with tempfile.TemporaryDirectory() as place:
        command = [program, "run", HERE / "case.toml", "-o", place, "--force", "--threads", "1", "--quiet",
                   *size_settings(particles), "--set", "output.series=5", "--set", "analysis.agglomerates=false"]
        few = processor_seconds([*command, "--until", f"{steps // 5 * step!r}"])
        many = processor_seconds([*command, "--until", f"{steps * step!r}"])
        summary = json.loads((pathlib.Path(place) / "summary.json").read_text())
    return (many - few) / (steps - steps // 5), summary["contacts"] / summary["particle_steps"]


def memory(program, particles):
    """Bytes that `scree check` says the case needs."""
    told = subprocess.run([program, "check", HERE / "case.toml", *size_settings(particles)], capture_output=True, text=True)
    number, unit = re.search(r"memory +([0-9.]+) (\w+)", told.stdout).groups()
    return float(number) * {"kB": 1e3, "MB": 1e6, "GB": 1e9}[unit]


def report_times():
    with open(HERE / "report_times.csv", newline="") as file:
        return [(int(row["particles"]), 60 * float(row["minutes"]) / REPORT_STEPS) for row in csv.DictReader(file)]


def exponent(points):
    return np.polyfit(*np.log(np.array(points)).T, 1)[0]


def draw(ours, path):
    figure, axes = plt.subplots(figsize=(6, 4.4), layout="constrained")
    for points, marker, label in ((report_times(), "s", "the report, Quadro P5000"), (ours, "o", "Scree, one core")):
        particles, seconds = np.array(points).T
        axes.loglog(particles, seconds, marker, label=f"{label}: exponent {exponent(points):.3f}")
        axes.loglog(particles, seconds[0] * particles / particles[0], color="0.6", lw=1)
    axes.set(xlabel="spheres", ylabel="seconds per step")
    axes.legend()
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scree", default="scree")
    parser.add_argument("--sizes", type=lambda text: [int(float(word)) for word in text.split(",")],
                        default=[10_000, 100_000, 1_000_000])
    parser.add_argument("--steps", type=int, default=200)
    parser.add_argument("--picture", type=pathlib.Path)
    options = parser.parse_args()
    ours = []
    for particles in options.sizes:
        seconds, contacts = measured(options.scree, particles, options.steps)
        ours.append((particles, seconds))
        print(f"{particles:>9} spheres {seconds:.3g} s per step, {particles / seconds:.3g} particle-steps/s, {contacts:.3f} "
              f"contacts per sphere, {memory(options.scree, particles) / particles:.0f} bytes per sphere", flush=True)
    if len(ours) > 1:
        print(f"run time grows as the number to the power {exponent(ours):.3f}; the report's {exponent(report_times()):.3f}")
    if options.picture:
        draw(ours, options.picture)


if __name__ == "__main__":
    main()
