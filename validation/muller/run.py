#!/usr/bin/python3
"""The runs of the validation with Müller's bed (docs/validation/muller.md), one after the other.

usage: run.py PROGRAM DIRECTORY [NAME ...]

PROGRAM is scree. Each run goes to DIRECTORY/NAME; one that is there already goes on from its last checkpoint. Without a NAME
all are made, in the order of the list.
"""

import pathlib
import subprocess
import sys

CASE = pathlib.Path(__file__).parents[2] / "examples" / "31_muller_bed" / "case.toml"
# What profiles.py reads: places and velocities every 10 ms.
COMMON = ["output.frames=0.01", 'output.fields=["velocity"]', "output.precision=single", "output.checkpoints=1"]
# Longer by 1e-10 along one axis: what is a sphere to the last bit goes the way of spheres, whatever it is called, and then
# every bit of the run is theirs.
ROUND = ["particles.seeds.shape=superellipsoid", "particles.seeds.half_axes=[0.0006, 0.0006, 0.00060000000006]",
         "particles.seeds.exponents=[1, 1]"]
STIFF = ["materials.poppy.stiffness=800", "simulation.time_step=5e-6"]  # as many steps in a contact
BY_VERTICES = ["contact.detection=vertices", "contact.vertices=20"]

RUNS = {
    "spheres": [],
    "spheres_di_felice": ["coupling.drag=di_felice"],
    "spheres_syamlal_obrien": ["coupling.drag=syamlal_obrien"],
    "superellipsoids": ROUND,
    "spheres_seed2": ["simulation.seed=2"],
    "spheres_seed3": ["simulation.seed=3"],
    "superellipsoids_seed2": [*ROUND, "simulation.seed=2"],
    "superellipsoids_seed3": [*ROUND, "simulation.seed=3"],
    "spheres_stiff": STIFF,
    "superellipsoids_stiff": [*ROUND, *STIFF, "simulation.end=1"],
    "vertices": [*ROUND, *BY_VERTICES, "simulation.end=0.2"],
}


def main(program, directory, *names):
    for name in names or RUNS:
        place = pathlib.Path(directory) / name
        command = [program, "run", str(CASE), "-o", str(place), "--threads", "1"]
        if (place / "checkpoints").exists():
            command += ["--restart", "latest"]
        for change in COMMON + RUNS[name]:
            command += ["--set", change]
        subprocess.run(command, check=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
