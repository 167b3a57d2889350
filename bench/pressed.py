#!/usr/bin/python3
"""The packed beds of `scree bench`, pressed together until vertices find their contacts. usage: pressed.py PROGRAM DIRECTORY

PROGRAM is scree. Makes DIRECTORY/NAME.csv of ellipsoids, cylinders and boxes: the beds of the bench, settled with certified
contacts under 200 times the gravity of the earth, which presses them with some 20 kPa in the middle of their height. What is
there is left as it is. Then measures them by 20 x 20 vertices, under that weight, on one thread.
"""

import csv
import pathlib
import subprocess
import sys

import h5py

HERE = pathlib.Path(__file__).parent
EXPONENTS = {"ellipsoids": "[1, 1]", "cylinders": "[0.25, 1]", "boxes": "[0.25, 0.25]"}
SPACING = {"ellipsoids": "linear", "cylinders": "mixed", "boxes": "mixed"}
HEAVY = ["gravity.acceleration=[0, 0, -1962]", "simulation.max_overlap=2", "simulation.time_step=2e-6"]
# A drag takes the motion out, and lets the bed give way slowly.
SETTLING = ["simulation.end=0.03", "flow.type=still", "flow.drag=stokes", "flow.viscosity=5", "flow.density=1", "output.frames=0.03"]


def settings(changes):
    return [word for change in changes for word in ("--set", change)]


def press(program, name, loose, table):
    run = table.with_name(f"press_{name}")
    changes = [*HEAVY, *SETTLING, f"particles.bed.exponents={EXPONENTS[name]}", f'particles.bed.file="{loose}"']
    subprocess.run([program, "run", HERE / "packed.toml", "-o", run, "--force", "--threads", "1", *settings(changes)], check=True)
    with h5py.File(sorted((run / "frames").glob("*.h5"))[-1]) as file:
        particles = {key: file[f"particles/{key}"][:] for key in ("position", "velocity", "diameter", "orientation")}
    with open(table, "w", newline="") as out:
        writer = csv.writer(out)
        writer.writerow("x y z vx vy vz diameter qw qx qy qz".split())
        for x, v, d, q in zip(*particles.values()):
            writer.writerow([repr(float(number)) for number in (*x, *v, d, *q)])


def main(program, directory):
    directory = pathlib.Path(directory).resolve()
    loose = directory / "loose"
    if not all((loose / f"{name}.csv").exists() for name in EXPONENTS):
        subprocess.run([program, "bench", *EXPONENTS, "--threads", "1", "--rounds", "1", "--packings", loose], check=True)
    for name in EXPONENTS:
        if not (directory / f"{name}.csv").exists():
            press(program, name, loose / f"{name}.csv", directory / f"{name}.csv")
        vertices = ["contact.detection=vertices", "contact.vertices=20", f"contact.spacing={SPACING[name]}"]
        subprocess.run([program, "bench", name, "--threads", "1", "--rounds", "5", "--packings", directory,
                        *settings([*HEAVY, *vertices])], check=True)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
