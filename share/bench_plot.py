#!/usr/bin/python3
"""Draws the run time over the number of particles, beside the line through the smallest size.

bench_plot.py FIGURES PICTURE: reads what `scree bench linear --json FIGURES` wrote and writes a PNG.
"""

import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from plot_style import COLOURS, INK, STYLE  # noqa: E402


def label(figures):
    threads = figures["threads"]
    return f"{threads} thread{'s' if threads > 1 else ''}: N to the power {figures['exponent']:.3f}"


def draw_line(axes, figures, colour):
    """Medians with the span of the rounds, and a line of slope 1 through the smallest size."""
    points = figures["points"]
    count, time, fastest, slowest = (np.array([p[name] for p in points], dtype=float) for name in
                                     ("particles", "seconds_per_step", "fastest_round", "slowest_round"))
    axes.plot(count, time[0] * count / count[0], color=colour, lw=1.0, alpha=0.6, zorder=2)
    axes.errorbar(count, time, yerr=[time - fastest, slowest - time], fmt="o", color=colour, ms=5, capsize=3, zorder=3,
                  label=label(figures))


def draw(figures, picture):
    """Writes the picture of the figures with the name "linear"."""
    linear = [f for f in figures if f["scene"] == "linear"]
    if not linear:
        sys.exit("bench_plot.py: there are no figures of the benchmark 'linear'; make them with: scree bench linear --json FILE")
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(6.4, 4.8), dpi=130, layout="constrained")
        for colour, one in zip((COLOURS[0], COLOURS[3], COLOURS[2]), linear):
            draw_line(axes, one, colour)
        axes.plot([], [], color=INK, lw=1.0, alpha=0.6, label="in proportion to the smallest")
        axes.set(xscale="log", yscale="log", xlabel="particles N", ylabel="run time of a step [s]")
        axes.set_title("Run time over the number of particles")
        axes.legend(loc="upper left")
        figure.savefig(picture)
        plt.close(figure)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    draw(json.loads(pathlib.Path(sys.argv[1]).read_text())["figures"], sys.argv[2])
