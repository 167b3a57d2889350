#!/usr/bin/python3
"""Writes drum.data and drum.stl for drum.liggghts: 1930 spheres on a jittered lattice, and a drum of 120 facets."""

import math

import numpy

RADIUS, LENGTH, DIAMETER, DENSITY, COUNT = 0.069, 0.0595, 5.95e-3, 1768, 1930

random = numpy.random.default_rng(1)
spacing = 1.08 * DIAMETER
along = int(LENGTH / spacing)
across = numpy.arange(-RADIUS, RADIUS, spacing)
places = [
    ((i + 0.5) * LENGTH / along - LENGTH / 2, y, z)
    for z in across
    for y in across
    if math.hypot(y, z) < RADIUS - 0.6 * DIAMETER
    for i in range(along)
][:COUNT]
places = numpy.array(places) + random.uniform(-0.035 * DIAMETER, 0.035 * DIAMETER, (COUNT, 3))
with open("drum.data", "w") as out:
    out.write(f"drum\n\n{COUNT} atoms\n1 atom types\n\n{-LENGTH / 2} {LENGTH / 2} xlo xhi\n")
    out.write("-0.071 0.071 ylo yhi\n-0.071 0.071 zlo zhi\n\nAtoms\n\n")
    for number, (x, y, z) in enumerate(places, 1):
        out.write(f"{number} 1 {DIAMETER} {DENSITY} {x:.9g} {y:.9g} {z:.9g}\n")

rim = [(RADIUS * math.cos(a), RADIUS * math.sin(a)) for a in numpy.linspace(0, 2 * math.pi, 121)]
with open("drum.stl", "w") as out:
    out.write("solid drum\n")
    for low, high in zip(rim, rim[1:]):
        a, b, c, d = ((x, *p) for x in (-LENGTH / 2, LENGTH / 2) for p in (low, high))
        for corners in ((a, b, c), (b, d, c)):
            lines = "".join("   vertex %.9g %.9g %.9g\n" % corner for corner in corners)
            out.write(f" facet normal 0 0 0\n  outer loop\n{lines}  endloop\n endfacet\n")
    out.write("endsolid drum\n")
