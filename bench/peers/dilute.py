#!/usr/bin/python3
"""Makes the dilute scene: 1e5 equal spheres at 5 % solid in a periodic cube, moving at random.

Spheres sit on the nodes of a cubic lattice of 47 x 47 x 47 cells, each shifted at random as far as it can go without
touching a neighbour; 3823 cells stay empty. Velocities are normal, 0.1 m/s in each direction, with mean zero.

usage: dilute.py DILUTE.csv
"""
import sys

import numpy as np

COUNT, DIAMETER, EDGE, SPEED, CELLS = 100_000, 0.002, 0.2031, 0.1, 47


def main(table):
    random = np.random.Generator(np.random.PCG64(1))
    cells = np.sort(random.permutation(CELLS**3)[:COUNT])
    nodes = np.stack(np.unravel_index(cells, (CELLS,) * 3), axis=1) + 0.5
    spacing = EDGE / CELLS
    positions = nodes * spacing + random.uniform(-0.5, 0.5, (COUNT, 3)) * (spacing - DIAMETER)
    velocities = random.normal(0, SPEED, (COUNT, 3))
    velocities -= velocities.mean(axis=0)
    with open(table, "w") as out:
        out.write("x,y,z,vx,vy,vz,diameter\n")
        for row in np.hstack([positions, velocities]).tolist():
            out.write(",".join(map(repr, row)) + f",{DIAMETER}\n")
    print(f"{table}: {COUNT} particles, solid fraction {COUNT * np.pi / 6 * (DIAMETER / EDGE) ** 3:.4f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
