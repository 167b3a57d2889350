#!/usr/bin/python3
"""Draws each case of the verification book over its reference.

verify_plot.py DIRECTORY: reads DIRECTORY/NN_name/figure.json, written by `scree verify --plot`, and writes figure.png
beside it. docs/verification.md has the format.
"""

import json
import sys
from pathlib import Path
from textwrap import fill

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402

COLOURS = ["#0b6e99", "#d1495b", "#e8a33d", "#4f8a5b", "#7a5195", "#8c6d46", "#5c6b73"]
REFERENCE = {"color": "black", "linewidth": 1.0, "zorder": 3}


def as_numbers(values):
    return [float("nan") if value is None else value for value in values]


def same_reference(curves):
    """True when all curves have one and the same reference, which is then drawn once."""
    return all(c["reference"] == curves[0]["reference"] and c["x"] == curves[0]["x"] for c in curves)


def draw_curve(axes, curve, colour, points):
    x, y = as_numbers(curve["x"]), as_numbers(curve["y"])
    if points or len(x) <= 60:
        axes.plot(x, y, "o", color=colour, markersize=5, markerfacecolor="none", markeredgewidth=1.3, zorder=4,
                  label=curve["label"] or "computed")
    else:
        axes.plot(x, y, color=colour, linewidth=3.2, alpha=0.55, zorder=2, label=curve["label"] or "computed",
                  solid_capstyle="round")


def widen(axes):
    """Shows what stays the same but for rounding as a line, not as noise."""
    low, high = axes.get_ylim()
    middle = 0.5 * (low + high)
    if high - low < 1e-6 * abs(middle):
        axes.set_ylim(0.9 * middle, 1.1 * middle) if middle > 0 else axes.set_ylim(1.1 * middle, 0.9 * middle)


def draw_plot(axes, plot):
    curves = plot["curves"]
    for index, curve in enumerate(curves):
        draw_curve(axes, curve, COLOURS[index % len(COLOURS)], plot["points"])
    once = curves and same_reference(curves)
    for index, curve in enumerate(curves[:1] if once else curves):
        if curve["reference"]:
            axes.plot(as_numbers(curve["x"]), as_numbers(curve["reference"]), **REFERENCE,
                      label="reference" if index == 0 else None)
    if plot["logarithmic"]:
        axes.set_xscale("log")
        axes.set_yscale("log")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axis.set_minor_formatter(NullFormatter())
    else:
        widen(axes)
    axes.set_title(plot["title"], fontsize=10)
    axes.set_xlabel(plot["x_label"])
    axes.set_ylabel(plot["y_label"])
    axes.grid(color="#dddddd", linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    if len(curves) <= 7:
        axes.legend(fontsize=7.5, frameon=False)


def draw_case(source, target):
    case = json.loads(source.read_text())
    plots = case["plots"]
    if not plots:
        return False
    columns = min(len(plots), 3 if len(plots) in (3, 5, 6, 9) else 2)
    rows = -(-len(plots) // columns)
    height = 3.7 * rows + 1.1
    figure, grid = plt.subplots(rows, columns, figsize=(5.2 * columns, height), squeeze=False)
    for axes, plot in zip(grid.flat, plots):
        draw_plot(axes, plot)
    for axes in list(grid.flat)[len(plots):]:
        axes.axis("off")
    figure.suptitle(fill(case["title"], 40 * columns), fontsize=12, fontweight="bold", y=1 - 0.1 / height, va="top")
    figure.text(0.5, 0.1 / height, fill(case["source"], 60 * columns), ha="center", va="bottom", fontsize=7.5,
                color="#555555")
    figure.tight_layout(rect=(0, 0.4 / height, 1, 1 - 0.45 / height))
    figure.savefig(target, dpi=110)
    plt.close(figure)
    return True


def main(directory):
    sources = sorted(Path(directory).glob("*/figure.json"))
    if not sources:
        sys.exit(f"{directory}: no figure.json here; make them with: scree verify --plot -o {directory}")
    drawn = sum(draw_case(source, source.with_suffix(".png")) for source in sources)
    print(f"{drawn} figures in {directory}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
