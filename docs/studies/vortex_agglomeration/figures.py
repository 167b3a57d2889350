#!/usr/bin/python3
"""Draws the figures of README.md from runs of study.py. usage: figures.py RUNS [--scree PROGRAM] [--only NAME,NAME]"""

import argparse
import io
import pathlib
import subprocess
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import matplotlib.ticker  # noqa: E402
import numpy as np  # noqa: E402
import PIL.Image  # noqa: E402

import cases  # noqa: E402
import measure  # noqa: E402
import speeds  # noqa: E402

EDGE = {"arrowstyle": "-|>", "color": "tab:green", "lw": 2, "shrinkA": 0, "shrinkB": 0}
DEGREES = plt.get_cmap("viridis")
COMMON = 5  # turnovers that all runs have


def shade(value, values):
    return DEGREES(0.9 * sorted(values).index(value) / max(1, len(values) - 1))


def field(base, axes):
    """The plane x = 0, which the fluid does not cross: y to the right, z upwards, in cell widths."""
    side = np.linspace(-1, 1, 201)
    y, z = np.meshgrid(side, side)
    place = np.stack([np.zeros(y.size), y.ravel() * base.cell, z.ravel() * base.cell], axis=1)
    velocity, _ = speeds.flow(place, base)
    v, w = (velocity[:, k].reshape(y.shape) / base.amplitude for k in (1, 2))
    vorticity = -3 * np.sin(np.pi * y) * np.sin(np.pi * z)
    colours = axes.contourf(y, z, vorticity, 24, cmap="RdBu_r", alpha=0.6)
    axes.streamplot(y, z, v, w, color="0.25", density=1.3, linewidth=0.6, arrowsize=0.7)
    axes.set(xlabel="y / cell width", ylabel="z / cell width", xlim=(-1, 1), ylim=(-1, 1), aspect="equal")
    return colours


def draw_field(options, base):
    figure, axes = plt.subplots(figsize=(5.6, 4.6), layout="constrained")
    colours = field(base, axes)
    for k in (-1, 0, 1):  # each half of an edge runs from the saddle that it leaves to the one that it enters
        for low in (-1, 0):
            axes.annotate("", (k, low + (k + low + 1) % 2), (k, low + (k + low) % 2), arrowprops=EDGE)
            axes.annotate("", (low + (k + low) % 2, k), (low + (k + low + 1) % 2, k), arrowprops=EDGE)
    axes.plot([-0.5, -0.5, 0.5, 0.5], [-0.5, 0.5, -0.5, 0.5], "k+", ms=9)
    figure.colorbar(colours, label="vorticity across the plane / (A a)", ticks=[-3, -2, -1, 0, 1, 2, 3])
    return figure


def tracks(options, base, stokes):
    """The paths of paths.toml: an array of times and places for each sphere."""
    with tempfile.TemporaryDirectory() as place:
        subprocess.run([options.scree, "run", cases.HERE / "paths.toml", "-o", place, "--threads", "1", "--quiet", "--set",
                        f"flow.viscosity={base.viscosity(stokes)!r}"], check=True)
        rows = np.genfromtxt(pathlib.Path(place) / "tracks.csv", delimiter=",", names=True)
    return [rows[rows["id"] == k] for k in np.unique(rows["id"])]


def draw_paths(options, base):
    figure, all_axes = plt.subplots(1, 3, figsize=(10.5, 3.9), layout="constrained", sharey=True)
    for axes, stokes in zip(all_axes, (0.1, 1, 10)):
        field(base, axes)
        for colour, rows in zip(("k", "tab:orange", "tab:green"), tracks(options, base, stokes)):
            y, z = (rows[c] / base.cell for c in "yz")
            jumps = np.flatnonzero(np.hypot(np.diff(y), np.diff(z)) > 1) + 1  # to the other side of the periodic plane
            axes.plot(np.insert(y, jumps, np.nan), np.insert(z, jumps, np.nan), color=colour, lw=1.6)
            axes.plot(y[0], z[0], "o", color=colour, ms=5)
        axes.set_title(f"Stokes number {stokes:g}")
        axes.label_outer()
    return figure


def count_logarithmically(axes):
    """A logarithmic axis of numbers that are read, not powers."""
    axes.set_yscale("log")
    axes.yaxis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def draw_agglomerates(options, base):
    rows = measure.table(options.runs, COMMON)
    stokes = sorted({row["stokes"] for row in rows})
    figure, all_axes = plt.subplots(1, 3, figsize=(11, 3.8), layout="constrained")
    for axes, name, label in zip(all_axes, ("agglomerated_fraction", "mean_agglomerate_size", "largest_agglomerate"),
                                 ("part of the spheres in agglomerates", "spheres per agglomerate", "spheres in the largest")):
        for value in stokes:
            mine = [row for row in rows if row["stokes"] == value and row["stickiness_number"] > 0]
            axes.errorbar([r["stickiness_number"] for r in mine], [r[name] for r in mine],
                          np.nan_to_num([r[f"{name}_95"] for r in mine]),
                          color=shade(value, stokes), marker="o", ms=4, capsize=3, label=f"Stokes {value:g}")
            for free in (row for row in rows if row["stokes"] == value and row["stickiness_number"] == 0):
                axes.plot(0.18, free[name], marker="<", color=shade(value, stokes))
        axes.axvline(1, color="0.6", lw=1, ls="--")
        axes.set(xscale="log", xlabel="stickiness number (triangles: no cohesion)", ylabel=label)
        axes.set_xticks([0.25, 0.5, 1, 2, 4], ["0.25", "0.5", "1", "2", "4"])
        axes.minorticks_off()
        if name != "agglomerated_fraction":
            count_logarithmically(axes)
    all_axes[0].set_ylim(0, 1)
    all_axes[0].legend(fontsize=8)
    return figure


def draw_courses(options, base):
    runs = measure.runs_of(options.runs)
    stokes = sorted({point[0] for point in runs})
    stickiness = sorted({point[1] for point in runs})
    figure, all_axes = plt.subplots(2, len(stokes), figsize=(3 * len(stokes), 5.6), layout="constrained", sharey="row",
                                    squeeze=False)
    for (value, sticky), seeds in runs.items():
        column = stokes.index(value)
        time = seeds[0]["time"] / base.turnover
        for axes, name in zip(all_axes[:, column], ("agglomerated_fraction", "mean_agglomerate_size")):
            courses = np.array([run[name] for run in seeds])
            axes.plot(time, courses.mean(axis=0), color=shade(sticky, stickiness), lw=1.2, label=f"{sticky:g}")
            axes.fill_between(time, courses.min(axis=0), courses.max(axis=0), color=shade(sticky, stickiness), alpha=0.3, lw=0)
    for axes, value in zip(all_axes[0], stokes):
        axes.set(title=f"Stokes number {value:g}", ylim=(0, 1))
    for axes in all_axes[1]:
        axes.set(xlabel="time / turnovers")
        count_logarithmically(axes)
    all_axes[0, 0].set_ylabel("part of the spheres in agglomerates")
    all_axes[1, 0].set_ylabel("spheres per agglomerate")
    all_axes[0, 0].legend(title="stickiness", fontsize=7, title_fontsize=8, loc="lower right", ncols=2)
    return figure


def free_frames(options, stokes):
    """Frames of the runs without cohesion, one a turnover as far as all have come, the first third of each left out."""
    found = []
    for place in sorted(options.runs.glob(f"stokes{stokes:g}_stickiness0_seed*")):
        frames = sorted((place / "frames").glob("*.h5"))[:COMMON + 1]
        found += frames[len(frames) // 3:]
    return found


def draw_speeds(options, base):
    figure, axes = plt.subplots(figsize=(6.2, 4.2), layout="constrained")
    for value in options.stokes:
        found = speeds.impacts(free_frames(options, value), base)
        axes.plot(found / base.speed, np.cumsum(found) / np.sum(found), color=shade(value, options.stokes),
                  label=f"Stokes {value:g}")
    for sticky in cases.STICKINESS:
        limit = sticking_speed(options, base, sticky) / base.speed
        axes.axvline(limit, color="0.5", lw=1, ls="--")
        axes.text(limit, 1.01, f"{sticky:g}", ha="center", fontsize=8)
    axes.set(xscale="log", xlim=(0.01, 15), ylim=(0, 1), xlabel="speed of impact / mean speed of the flow",
             ylabel="part of the impacts that is slower")
    axes.set_title("dashed: the speed below which a pair sticks, for a stickiness number of", fontsize=9, pad=16)
    axes.legend(fontsize=8)
    return figure


def sticking_speed(options, base, stickiness):
    """The speed below which two spheres stick, as `scree check` says it."""
    told = subprocess.run([options.scree, "check", base.path, *cases.settings(base, 1, stickiness, 1, 10)], check=True,
                          capture_output=True, text=True).stdout
    return float(told.split("they stick below")[1].split()[0])


def draw_places(options, base):
    """Where the spheres are at the end without cohesion: a slab half a cell thick about x = 0, and one about z = 0."""
    figure, all_axes = plt.subplots(2, len(options.stokes), figsize=(3 * len(options.stokes), 6), layout="constrained",
                                    squeeze=False)
    for column, value in enumerate(options.stokes):
        position, _ = speeds.frame(free_frames(options, value)[-1])
        for axes, across, (right, up) in zip(all_axes[:, column], (0, 2), ((1, 2), (0, 1))):
            place = position / base.cell
            offset = np.abs(place[:, across] - np.round(place[:, across]))
            shown = place[offset < 0.25]
            axes.plot(shown[:, right], shown[:, up], ",", color="k", alpha=0.6)
            axes.set(xlabel=f"{'xyz'[right]} / cell width", ylabel=f"{'xyz'[up]} / cell width", aspect="equal",
                     xlim=(0, 4), ylim=(0, 4))
        all_axes[0, column].set_title(f"Stokes number {value:g}")
    return figure


DRAWN = {"field": draw_field, "paths": draw_paths, "agglomerates": draw_agglomerates, "courses": draw_courses,
         "speeds": draw_speeds, "places": draw_places}


def save(figure, path):
    """Few colours make small files."""
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=100)
    PIL.Image.open(drawn).convert("RGB").quantize(64).save(path, optimize=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", type=pathlib.Path)
    parser.add_argument("--scree", default="scree")
    parser.add_argument("--only", default=",".join(DRAWN))
    parser.add_argument("--stokes", type=lambda text: tuple(map(float, text.split(","))), default=cases.STOKES)
    parser.add_argument("--pictures", type=pathlib.Path, default=cases.HERE)
    options = parser.parse_args()
    base = cases.Base()
    for name in options.only.split(","):
        save(DRAWN[name](options, base), options.pictures / f"{name}.png")


if __name__ == "__main__":
    main()
