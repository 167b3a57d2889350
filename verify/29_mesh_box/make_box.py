#!/usr/bin/python3
"""Writes box.obj: a cube of 1/8 m whose faces are cut into triangles of several sizes, and open.obj without its lid."""

import itertools
import pathlib

EDGES = [0, 0.03125, 0.0625, 0.125]  # exact in binary, so that the mesh is the box to the last bit

points, triangles = [], []
for axis, level in itertools.product(range(3), (0, 0.125)):
    for (a0, a1), (b0, b1) in itertools.product(zip(EDGES, EDGES[1:]), repeat=2):
        corners = [(a0, b0), (a1, b0), (a1, b1), (a0, b1)]
        turned = []
        for pair in corners:
            point = list(pair)
            point.insert(axis, level)
            if point not in points:
                points.append(point)
            turned.append(points.index(point) + 1)
        a, b, c, d = turned
        triangles += [(a, b, c), (a, c, d)] if a0 + b0 < 0.07 else [(a, b, d), (b, c, d)]

for name, faces in (("box.obj", triangles), ("open.obj", triangles[:-18])):
    lines = [f"v {x} {y} {z}" for x, y, z in points] + [f"f {a} {b} {c}" for a, b, c in faces]
    (pathlib.Path(__file__).parent / name).write_text("\n".join(lines) + "\n")
