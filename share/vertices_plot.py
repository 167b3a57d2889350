#!/usr/bin/python3
"""Draws what contacts by vertices miss and get wrong over the number of vertices, beside certified contacts.

vertices_plot.py TABLES PICTURE: reads the tables that the program scree_vertices prints (docs/vertices.md holds them too)
and writes PICTURE (PNG).
"""

import re
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FixedLocator, NullFormatter, NullLocator  # noqa: E402

COLOURS = ["#0b6e99", "#d1495b", "#e8a33d", "#4f8a5b"]
SPACING = "mixed"


def read_tables(text):
    """Rows of the tables by (depth [%] or "energy", shape, vertices on a side or None for certified)."""
    rows, table = {}, None
    for line in text.splitlines():
        heading = re.match(r"Overlap ([0-9.]+) % of the least half axis", line)
        if heading:
            table = heading.group(1)
        elif line.startswith("| shape | vertices | passed through"):
            table = "energy"
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        side = re.match(rf"(\d+) x \d+ {SPACING}", cells[1]) if len(cells) > 4 else None
        if table and len(cells) > 4 and (side or cells[1] == "certified"):
            rows[table, cells[0], int(side.group(1)) if side else None] = cells[2:]
    return rows


def numbers(cell):
    return [float(x) for x in re.findall(r"[0-9.]+(?:e[-+]?\d+)?", cell)]


PANELS = [  # title, label, table, number of a row, logarithmic
    ("Contacts missed, overlap 0.5 %", "missed [%]", "0.5", lambda row: numbers(row[0])[0], False),
    ("Contacts missed, overlap 2 %", "missed [%]", "2", lambda row: numbers(row[0])[0], False),
    ("Depth, overlap 2 %: from 5 to 95 % of the pairs", "span of depth / true depth", "2",
     lambda row: numbers(row[1])[2] - numbers(row[1])[0], False),
    ("Normal, overlap 2 %: median", "off by [degrees]", "2", lambda row: numbers(row[2])[0], False),
    ("Energy of an elastic collision: median", "change / energy of motion", "energy",
     lambda row: numbers(row[1])[0], True),
    ("Cost, overlap 2 %", "time per pair [us]", "2", lambda row: numbers(row[3])[0], True),
]


def draw_panel(axes, rows, panel):
    title, label, table, number, logarithmic = panel
    shapes = list(dict.fromkeys(shape for key, shape, _ in rows if key == table))
    for shape, colour in zip(shapes, COLOURS):
        sides = sorted(side for key, name, side in rows if (key, name) == (table, shape) and side)
        axes.plot([side * side for side in sides], [number(rows[table, shape, side]) for side in sides], "o-",
                  color=colour, markersize=4, label=shape)
        axes.axhline(number(rows[table, shape, None]), color=colour, linestyle=":", linewidth=1.6)
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(FixedLocator([400, 1600, 6400]))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.set_xticklabels(["400", "1600", "6400"])
    if logarithmic:
        axes.set_yscale("log")
        axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_title(title, fontsize=10)
    axes.set_xlabel("vertices of a body")
    axes.set_ylabel(label)
    axes.grid(color="#dddddd", linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)


def main(tables, picture):
    rows = read_tables(Path(tables).read_text())
    if not rows:
        sys.exit(f"{tables}: no tables of scree_vertices here")
    figure, grid = plt.subplots(2, 3, figsize=(13, 7.4))
    for axes, panel in zip(grid.flat, PANELS):
        draw_panel(axes, rows, panel)
    grid[0, 0].legend(fontsize=8, frameon=False)
    figure.suptitle(f"Contacts by vertices ({SPACING}; lines) beside certified ones (dotted)", fontsize=12,
                    fontweight="bold")
    figure.tight_layout()
    figure.savefig(picture, dpi=90)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
