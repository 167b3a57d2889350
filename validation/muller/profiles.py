#!/usr/bin/python3
"""Profiles of Müller's bed from frames of particles, beside the measurements (docs/validation/muller.md).

usage: profiles.py [--from 5] [--influence] [--picture FILE.png] [--maps FILE.png] LABEL=RUN_DIRECTORY[,RUN_DIRECTORY...] ...

Prints a table in Markdown of the root mean square differences from the measured profiles for 3.5 mm < x < 40.5 mm. Of the
first run also, with --influence, what other bins give. Void fraction and velocity are those of the exact volume of the
seeds in bins of 2 mm along x, 2 mm along y and the middle 5 mm of the depth, over all frames from the given time [s] on.
Runs of one label, with other seeds, are averaged; then also what lies between them is printed, and whether two labels with several
runs agree.
"""

import argparse
import csv
import itertools
import pathlib

import h5py
import numpy as np

import bins

HERE = pathlib.Path(__file__).parent
RADIUS, WIDTH, DEPTH = 0.6e-3, 44e-3, 10e-3
LOW, HIGH = 3.5e-3, 40.5e-3  # where profiles are compared
QUANTITIES = (("void_fraction", 16.4), ("void_fraction", 31.2), ("velocity", 15), ("velocity", 25), ("velocity", 35))
PUBLISHED = (0.022, 0.100, 0.021, 0.024, 0.091)  # RMS of sediFoam (Syamlal-O'Brien), as the goal
NOISE = (0.017, 0.039, 0.022, 0.012, 0.006)  # of the measurements: their left against their right half
STUDENT = {1: 12.706, 2: 4.303, 3: 3.182, 4: 2.776, 5: 2.571, 6: 2.447}  # 97.5 % of t, by degrees of freedom
BINS = {"2 x 2 x 5 mm": (2e-3, 2e-3, 5e-3), "1 x 2 x 5 mm": (1e-3, 2e-3, 5e-3), "4 x 2 x 5 mm": (4e-3, 2e-3, 5e-3),
        "2 x 1 x 5 mm": (2e-3, 1e-3, 5e-3), "2 x 4 x 5 mm": (2e-3, 4e-3, 5e-3), "2 x 2 x 10 mm": (2e-3, 2e-3, 10e-3)}


def measured(quantity, height):
    with open(HERE / f"measured_{quantity}_{height}mm.csv", newline="") as file:
        return np.array([[float(x) for x in row] for row in list(csv.reader(file))[1:]]).T


def frames_of(run, folder, start):
    """The frames of a run from a time on: the open files, one after the other."""
    for path in sorted((pathlib.Path(run) / folder).glob("*.h5")):
        with h5py.File(path) as file:
            if file.attrs["time"] > start - 1e-9:
                yield file


def make_profile(height, size):
    across = np.linspace(0, WIDTH, round(WIDTH / size[0]) + 1)
    return bins.Profile(across, (height - size[1] / 2, height + size[1] / 2),
                        ((DEPTH - size[2]) / 2, (DEPTH + size[2]) / 2))


def collect(run, start, profiles):
    for file in frames_of(run, "frames", start):
        position, velocity = file["particles/position"][:], file["particles/velocity"][:, 1]
        for profile in profiles:
            profile.add(position, velocity, RADIUS)


def values(profile, quantity):
    return profile.void_fraction() if quantity == "void_fraction" else profile.velocity()


class Samples:
    """One profile from each of several runs."""

    def __init__(self, profiles, quantity):
        self.middles = profiles[0].middles
        self.all = np.array([values(p, quantity) for p in profiles])
        self.mean = self.all.mean(axis=0)

    def error_squared(self):
        """Of the mean, in each bin; of several runs."""
        return self.all.var(axis=0, ddof=1) / len(self.all)

    def interval(self):
        """Half the width of the 95 % interval of the mean; of several runs."""
        return STUDENT[len(self.all) - 1] * np.sqrt(self.error_squared())


def deviation(middles, found, quantity, height):
    x, truth = measured(quantity, height)
    inside = (x > LOW) & (x < HIGH)
    return np.sqrt(np.mean((np.interp(x[inside], middles, found) - truth[inside]) ** 2))


def samples_of(runs):
    """Of the profiles of several runs, in the order of the quantities."""
    return [Samples([profiles[n] for profiles in runs], quantity) for n, (quantity, _) in enumerate(QUANTITIES)]


def agreement(one, other):
    """In what part of the bins two means differ by no more than the 95 % interval of their difference."""
    freedom = len(one.all) + len(other.all) - 2
    allowed = STUDENT[freedom] * np.sqrt(one.error_squared() + other.error_squared())
    return np.mean(np.abs(one.mean - other.mean) <= allowed)


def row(label, numbers):
    print("|", label, "|", " | ".join(f"{n:.3f}" for n in numbers), "|")


def heading(of):
    print(f"| {of} | void fraction, 16.4 mm | 31.2 mm | velocity, 15 mm [m/s] | 25 mm | 35 mm |\n|" + "---|" * 6)


def deviations(samples):
    return [deviation(s.middles, s.mean, *q) for s, q in zip(samples, QUANTITIES)]


def table(found, influence):
    heading("root mean square from the measurements")
    for label, samples in found.items():
        row(label, deviations(samples))
        if len(samples[0].all) > 1:
            each = np.array([[deviation(s.middles, one, *q) for one in s.all] for s, q in zip(samples, QUANTITIES)])
            row(f"{label}, the best of its runs", each.min(axis=1))
            row(f"{label}, the worst", each.max(axis=1))
    row("a published code, the goal", PUBLISHED)
    row("noise of the measurements", NOISE)
    several = {label: samples for label, samples in found.items() if len(samples[0].all) > 1}
    if several:
        print()
        heading("half the 95 % interval, mean over the bins")
        for label, samples in several.items():
            row(label, [np.mean(s.interval()) for s in samples])
        for (one, first), (other, second) in itertools.combinations(several.items(), 2):
            row(f"part of the bins where {one} and {other} agree", [agreement(a, b) for a, b in zip(first, second)])
    if influence:
        print()
        heading("other bins, first run")
        for label, samples in influence.items():
            row(label, deviations(samples))


def draw(found, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, all_axes = plt.subplots(2, 3, figsize=(11, 6.4), constrained_layout=True)
    places = dict(zip(QUANTITIES, (all_axes[0, 0], all_axes[0, 1], all_axes[1, 0], all_axes[1, 1], all_axes[1, 2])))
    for n, (quantity, height) in enumerate(QUANTITIES):
        axes = places[quantity, height]
        axes.set_title(f"{quantity.replace('_', ' ')} at {height} mm")
        axes.set_xlabel("x [mm]")
        axes.set_ylabel("void fraction" if quantity == "void_fraction" else "velocity of the seeds [m/s]")
        x, truth = measured(quantity, height)
        axes.plot(1e3 * x, truth, "ko", markersize=3.5, label="measured (Müller et al.)")
        for label, samples in found.items():
            sample = samples[n]
            line = axes.plot(1e3 * sample.middles, sample.mean, label=label)[0]
            if len(sample.all) > 1:
                low, high = sample.mean - sample.interval(), sample.mean + sample.interval()
                axes.fill_between(1e3 * sample.middles, low, high, color=line.get_color(), alpha=0.15, linewidth=0)
        axes.grid(True, color="#e3e6ea")
    all_axes[0, 2].axis("off")
    handles, labels = all_axes[0, 0].get_legend_handles_labels()
    all_axes[0, 2].legend(handles, labels, loc="center", frameon=False)
    figure.savefig(path, dpi=110)


def fluid_map(run, start):
    """Mean velocity of the air along y between the plates, and the faces of its cells."""
    total, frames, faces = 0, 0, None
    for file in frames_of(run, "fluid", start):
        faces = [file[f"faces/{a}"][:] for a in "xyz"]
        cells = [len(f) - 1 for f in faces]
        total = total + file["fields/velocity"][:, 1].reshape(cells[2], cells[1], cells[0]).mean(axis=0)
        frames += 1
    return total / frames, faces


def particle_maps(run, start, tallest, every):
    edges = np.arange(0, tallest + 1e-9, 2e-3)
    rows = [make_profile(0.5 * (a + b), (2e-3, b - a, 5e-3)) for a, b in zip(edges[:-1], edges[1:])]
    for number, file in enumerate(frames_of(run, "frames", start)):
        if number % every:
            continue
        position, velocity = file["particles/position"][:], file["particles/velocity"][:, 1]
        for profile in rows:
            profile.add(position, velocity, RADIUS)
    solids = np.array([1 - p.void_fraction() for p in rows])
    speed = np.where(solids > 1e-3, np.array([p.velocity() for p in rows]), np.nan)
    return rows[0].edges, edges, 1 - solids, speed


def draw_maps(label, run, start, path, tallest=0.08, every=5):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    air, faces = fluid_map(run, start)
    x, y, void, speed = particle_maps(run, start, tallest, every)
    figure, all_axes = plt.subplots(1, 3, figsize=(10, 5.6), constrained_layout=True)
    maps = ((faces[0], faces[1], air, "velocity of the air [m/s]", "viridis"),
            (x, y, speed, "velocity of the seeds [m/s]", "RdBu_r"), (x, y, void, "void fraction", "viridis"))
    for axes, (across, up, field, title, colours) in zip(all_axes, maps):
        largest = np.nanmax(np.abs(speed)) if colours == "RdBu_r" else None
        drawn = axes.pcolormesh(1e3 * across, 1e3 * up, field, cmap=colours, vmin=-largest if largest else None, vmax=largest)
        axes.set_ylim(0, 1e3 * tallest)
        axes.set_aspect("equal")
        axes.set_title(title, fontsize=10)
        axes.set_xlabel("x [mm]")
        figure.colorbar(drawn, ax=axes, shrink=0.8)
    all_axes[0].set_ylabel("y [mm]")
    figure.suptitle(f"{label}: means over the last 5 s, middle of the depth")
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--from", dest="start", type=float, default=5.0)
    parser.add_argument("--influence", action="store_true")
    parser.add_argument("--picture")
    parser.add_argument("--maps")
    parser.add_argument("runs", nargs="+", metavar="LABEL=RUN_DIRECTORY[,RUN_DIRECTORY...]")
    options = parser.parse_args()
    runs = {label: places.split(",") for label, places in (entry.split("=", 1) for entry in options.runs)}
    found = {}
    for label, places in runs.items():
        profiles = [[make_profile(1e-3 * height, BINS["2 x 2 x 5 mm"]) for _, height in QUANTITIES] for _ in places]
        for place, of_run in zip(places, profiles):
            collect(place, options.start, of_run)
            print(f"{label}: {of_run[0].frames} frames of {place}", flush=True)
        found[label] = samples_of(profiles)
    label, first = next(iter(runs.items()))
    influence = {}
    if options.influence:
        profiles = {name: [make_profile(1e-3 * height, size) for _, height in QUANTITIES] for name, size in BINS.items()}
        collect(first[0], options.start, [p for of_size in profiles.values() for p in of_size])
        influence = {name: samples_of([of_size]) for name, of_size in profiles.items()}
    table(found, influence)
    if options.picture:
        draw(found, options.picture)
    if options.maps:
        draw_maps(label if len(first) == 1 else f"{label}, the first of them", first[0], options.start, options.maps)


if __name__ == "__main__":
    main()
