#!/usr/bin/python3
"""Turns the dump of settle.lmp into the particle table that Scree inserts: x, y, z, diameter in metres.

usage: dump_to_csv.py SETTLED.dump DENSE.csv
"""
import sys


def main(dump, table):
    with open(dump) as lines:
        for line in lines:
            if line.startswith("ITEM: ATOMS"):
                break
        rows = [line.split() for line in lines]
    with open(table, "w") as out:
        out.write("x,y,z,diameter\n")
        for _, x, y, z, radius in rows:
            out.write(f"{float(x)!r},{float(y)!r},{float(z)!r},{2 * float(radius)!r}\n")
    print(f"{table}: {len(rows)} particles, top at z = {max(float(row[3]) + float(row[4]) for row in rows):.6f} m")


if __name__ == "__main__":
    main(*sys.argv[1:])
