#!/usr/bin/python3
"""Writes ring.stl: a ring (torus) about the z axis, in millimetres, as a binary STL file."""

import math
import pathlib
import struct

AROUND, ACROSS, RADIUS, THICKNESS = 24, 10, 11.0, 3.0


def point(i, j):
    a, b = 2 * math.pi * i / AROUND, 2 * math.pi * j / ACROSS
    distance = RADIUS + THICKNESS * math.cos(b)
    return distance * math.cos(a), distance * math.sin(a), THICKNESS * math.sin(b)


triangles = []
for i in range(AROUND):
    for j in range(ACROSS):
        a, b, c, d = point(i, j), point(i + 1, j), point(i + 1, (j + 1) % ACROSS), point(i, (j + 1) % ACROSS)
        triangles += [(a, b, c), (a, c, d)]

data = b"a ring".ljust(80) + struct.pack("<I", len(triangles))
for corners in triangles:
    data += struct.pack("<12fH", 0, 0, 0, *(x for corner in corners for x in corner), 0)
(pathlib.Path(__file__).parent / "ring.stl").write_bytes(data)
