#!/usr/bin/python3
"""A bed of rods beside one of spheres of the same volume and mass, in the same air.

usage: compare.py RODS SPHERES [PICTURE.png]

RODS and SPHERES are run directories of this example. Prints a table in Markdown and draws the pressure drop over the velocity,
the height of the bed over time, and how the rods lie.
"""

import csv
import pathlib
import sys
import tomllib

import h5py
import numpy as np

RODS, SPHERES = "rods", "spheres"
FLUIDISED = 0.5  # what moves in faster air than this is fluidised [m/s]
AT_REST = 0.06  # what lies in slower air than this is at rest [m/s]
BEGUN = 0.15  # until then the particles fall together [s]


class Run:
    """The rows of a run, with the velocity of the air and the pressure drop over the weight of the bed, and its stages."""

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)
        with open(self.directory / "series.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.column = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
        self.time = self.column["time"]
        case = tomllib.loads((self.directory / "case.toml").read_text())
        domain, gravity = case["domain"], case["gravity"]["acceleration"]
        area = (domain["max"][0] - domain["min"][0]) * (domain["max"][1] - domain["min"][1])
        self.box = [np.array(case["analysis"]["regions"][0][end]) for end in ("min", "max")]
        with h5py.File(self.frames()[0]) as frame:
            self.weight = -gravity[2] * frame["particles/mass"][:].sum() / area
        self.air = -self.column["in_flow"] / area
        self.drop = self.column["pressure_drop"] / self.weight
        begun = np.searchsorted(self.time, BEGUN)
        slower = np.flatnonzero((np.diff(self.air, append=0) < 0) & (self.time >= BEGUN))[0]
        slow = slower + np.flatnonzero(self.air[slower:] < FLUIDISED)[0]
        still = np.flatnonzero((self.air < AT_REST) & (self.time >= BEGUN))
        slowest = still[self.air[still] < self.air[still].min() + 1e-6][-1]
        self.stages = {"fluidised": slice(begun, slow), "at rest": slice(still[0], slowest + 1)}
        fastest_again = slowest + np.argmax(self.air[slowest:])
        self.falling, self.rising = slice(slower, still[0] + 1), slice(slowest, fastest_again + 1)

    def frames(self):
        return sorted((self.directory / "frames").glob("*.h5"))

    def minimum_fluidisation(self, branch):
        """Where the curve of the packed bed, a u + b u^2 through its lower part (Ergun 1952), meets the weight [m/s]; NaN if
        the air does not get that far."""
        u, drop = self.air[branch], self.drop[branch]
        if len(drop) == 0 or drop.max() < 0.9:
            return np.nan
        packed = (drop > 0.05) & (drop < 0.8) & (u < FLUIDISED)
        a, b = np.linalg.lstsq(np.column_stack([u[packed], u[packed] ** 2]), drop[packed], rcond=None)[0]
        return (-a + np.sqrt(a * a + 4 * b)) / (2 * b)

    def long_axes(self, stage):
        """Unit vectors along the rods in the region, of all frames of a stage."""
        begin, end = self.time[self.stages[stage]][[0, -1]]
        out = []
        for path in self.frames():
            with h5py.File(path) as frame:
                if not begin - 1e-9 <= frame.attrs["time"] <= end + 1e-9:
                    continue
                place, (w, x, y, z) = frame["particles/position"][:], frame["particles/orientation"][:].T
                inside = np.all((place >= self.box[0]) & (place < self.box[1]), axis=1)
                axes = np.column_stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])
                out.append(axes[inside])
        return np.concatenate(out)


def order(axes):
    """Mean squares of the cosines with x, y and z, and the largest eigenvalue of the mean of (3 u u - 1)/2."""
    mean = axes.T @ axes / len(axes)
    return [*np.diag(mean), np.linalg.eigvalsh(1.5 * mean - 0.5 * np.eye(3))[-1]]


def table(runs):
    print("| | " + " | ".join(runs) + " |\n|---|" + "---|" * len(runs))

    def line(label, text, value):
        numbers = [value(run) for run in runs.values()]
        print("|", label, "|", " | ".join("not run" if np.isnan(n) else format(n, text) for n in numbers), "|")

    line("weight over area [Pa]", ".1f", lambda run: run.weight)
    line("minimum fluidisation, air slower and slower [m/s]", ".3f", lambda run: run.minimum_fluidisation(run.falling))
    line("minimum fluidisation, air faster again [m/s]", ".3f", lambda run: run.minimum_fluidisation(run.rising))
    line("pressure drop over weight, fluidised: mean", ".3f", lambda run: run.drop[run.stages["fluidised"]].mean())
    line("its standard deviation", ".3f", lambda run: run.drop[run.stages["fluidised"]].std())
    for name in ("fluidised", "at rest"):
        line(f"height [mm], {name}", ".1f", lambda run: 1e3 * run.column["bed_level"][run.stages[name]].mean())
        line(f"void fraction of the middle, {name}", ".3f",
             lambda run: 1 - run.column["core_solid_fraction"][run.stages[name]].mean())
    print("\n| rods of the middle | cos^2 with x | with y | with z, the vertical | nematic order |\n|---|---|---|---|---|")
    for name in ("fluidised", "at rest"):
        print("|", name, "|", " | ".join(f"{number:.3f}" for number in order(runs[RODS].long_axes(name))), "|")


def draw(runs, picture):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    colours = {RODS: "#b5432a", SPHERES: "#2f6690"}
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(11.5, 3.8), layout="constrained")
    for name, run in runs.items():
        for branch, style, how in ((run.falling, "-", "slower and slower"), (run.rising, "--", "faster again")):
            if np.isnan(run.minimum_fluidisation(branch)):
                continue
            left.plot(run.air[branch], run.drop[branch], style, color=colours[name], lw=1.1,
                      label=f"{name}, air {how}")
        middle.plot(run.time, 1e3 * run.column["bed_level"], color=colours[name], lw=1.1, label=name)
    left.axhline(1, color="#888888", lw=0.8)
    left.set(xlabel="velocity of the air [m/s]", ylabel="pressure drop over weight", ylim=(0, 1.6))
    left.legend(fontsize=8)
    middle.set(xlabel="time [s]", ylabel="height of the bed [mm]", ylim=(0, None))
    air = middle.twinx()
    air.plot(runs[SPHERES].time, runs[SPHERES].air, color="#888888", lw=0.8)
    air.set(ylabel="velocity of the air [m/s]", ylim=(0, 1.6))
    bins = np.linspace(0, 1, 11)
    for name, colour in (("fluidised", colours[RODS]), ("at rest", "#333333")):
        upright = np.abs(runs[RODS].long_axes(name)[:, 2])
        right.stairs(np.histogram(upright, bins, density=True)[0], bins, color=colour, label=name)
    right.axhline(1, color="#888888", lw=0.8, label="all directions alike")
    right.set(xlabel="cosine of a rod's angle with the vertical", ylabel="density", ylim=(0, None))
    right.legend(fontsize=8)
    figure.savefig(picture, dpi=90)


def main():
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    runs = {RODS: Run(sys.argv[1]), SPHERES: Run(sys.argv[2])}
    table(runs)
    if len(sys.argv) == 4:
        draw(runs, sys.argv[3])


if __name__ == "__main__":
    main()
