#!/usr/bin/python3
"""Turns a particle table into a data file that LAMMPS (atom_style sphere) and LIGGGHTS (atom_style granular) both read.

usage: csv_to_data.py TABLE.csv DENSITY XHI YHI ZHI OUT.data      the box starts at the origin
"""
import csv
import sys


def main(table, density, x_high, y_high, z_high, data):
    with open(table) as lines:
        rows = list(csv.DictReader(lines))
    with open(data, "w") as out:
        out.write(f"{table}\n\n{len(rows)} atoms\n1 atom types\n\n")
        for high, axis in ((x_high, "x"), (y_high, "y"), (z_high, "z")):
            out.write(f"0 {high} {axis}lo {axis}hi\n")
        out.write("\nAtoms\n\n")
        for number, row in enumerate(rows, 1):
            out.write(f"{number} 1 {row['diameter']} {density} {row['x']} {row['y']} {row['z']}\n")
        if "vx" in rows[0]:
            out.write("\nVelocities\n\n")
            for number, row in enumerate(rows, 1):
                out.write(f"{number} {row['vx']} {row['vy']} {row['vz']} 0 0 0\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
