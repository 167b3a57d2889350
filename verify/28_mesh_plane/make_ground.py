#!/usr/bin/python3
"""Writes ground.obj (a flat square of random triangles) and bumpy.obj (the same, its inner corners up to 1 um off)."""

import pathlib
import random

CELLS, WIDTH = 14, 0.4
draw = random.Random(28)


def corner(i, j):
    """A corner of the grid; those that are not on the rim are shifted by up to 0.35 of a cell."""
    shift = [draw.uniform(-0.35, 0.35) if 0 < k < CELLS else 0.0 for k in (i, j)]
    return [WIDTH / CELLS * (k + s) for k, s in zip((i, j), shift)]


def faces(i, j):
    """The two triangles of a cell, cut along one diagonal or the other."""
    a, b = i * (CELLS + 1) + j + 1, (i + 1) * (CELLS + 1) + j + 1
    return [(a, b, b + 1), (a, b + 1, a + 1)] if draw.random() < 0.5 else [(a, b, a + 1), (b, b + 1, a + 1)]


def write(name, points, heights, triangles):
    lines = [f"v {x:.6f} {y:.6f} {z:.8f}" for (x, y), z in zip(points, heights)]
    lines += [f"f {a} {b} {c}" for a, b, c in triangles]
    (pathlib.Path(__file__).parent / name).write_text("\n".join(lines) + "\n")


points = [corner(i, j) for i in range(CELLS + 1) for j in range(CELLS + 1)]
triangles = [face for i in range(CELLS) for j in range(CELLS) for face in faces(i, j)]
write("ground.obj", points, [0.0] * len(points), triangles)
write("bumpy.obj", points, [draw.uniform(-1e-6, 1e-6) for _ in points], triangles)
