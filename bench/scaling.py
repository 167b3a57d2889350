#!/usr/bin/python3
"""How a run shares itself among processes of one thread. usage: scaling.py PROGRAM PACKINGS PROCESSES... [--cases NAMES...] [--until TIME]

PROGRAM is scree, PACKINGS the directory with dense.csv (`scree bench dense` makes it), PROCESSES as in "1 2 4 8". Prints one
line per run in Markdown: the dense bed of 100 000 spheres shared by all (strong), one such bed per process side by side (weak),
the 2000 falling ellipsoids of the thesis' table 4-5 shared by all (ellipsoids), and 2000 of them per process in a box that is as many
times as long (weak-ellipsoids). The time of a step is that of its stages at the root, waiting included,
output left out; efficiency is the time of the first line over processes times this one (weak: over this one). Where processes
outnumber the processors times say nothing, and "oversubscribed" stands in place of it.
"""

import argparse
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
STAGES = ("neighbours", "fields", "contacts and motion")
WIDTH = 0.08  # of the dense bed [m]
CORES = len(os.sched_getaffinity(0))


def tiled(table, times, place):
    """The particles of a table, repeated along x."""
    with open(table) as source, open(place, "w") as target:
        rows = list(csv.reader(source))
        lines = csv.writer(target)
        lines.writerow(rows[0])
        for k in range(times):
            for row in rows[1:]:
                lines.writerow([repr(float(row[0]) + k * WIDTH)] + row[1:])
    return place


def command(program, processes):
    if processes == 1:
        return [program]
    return (["mpirun", "-n", str(processes)] + (["--allow-run-as-root"] if os.geteuid() == 0 else [])
            + (["--oversubscribe", "--bind-to", "none"] if processes > CORES else ["--bind-to", "core"]) + [program])


def run(program, processes, case, settings, until, directory):
    arguments = command(program, processes) + ["run", str(HERE / case), "-o", directory, "--threads", "1", "--quiet", "--until", until]
    for setting in settings + ["output.series=1000"]:  # rows take time, and copies that steps then need not ask for
        arguments += ["--set", setting]
    subprocess.run(arguments, check=True, env=dict(os.environ, OMP_WAIT_POLICY="passive"))
    return json.loads((pathlib.Path(directory) / "summary.json").read_text())


def strong(packings, _processes, _directory):
    return "dense.toml", [f"particles.bed.file={packings}/dense.csv"], "2 ms"


def weak(packings, processes, directory):
    table = tiled(f"{packings}/dense.csv", processes, f"{directory}/tiled.csv")
    return "dense.toml", [f"particles.bed.file={table}", f'domain.max=[{processes * WIDTH}, {WIDTH}, 0.16]'], "2 ms"


def ellipsoids(_packings, _processes, _directory):
    return "thesis_ellipsoids.toml", [], "0.3 s"


def weak_ellipsoids(_packings, processes, _directory):
    length = 0.04 * processes
    return "thesis_ellipsoids.toml", [f"domain.max=[{length + 1e-3}, 0.041, 0.052]", f"particles.bed.count={2000 * processes}",
                                      f"particles.bed.region_max=[{length}, 0.04, 0.05]",
                                      f"walls.box.max=[{length}, 0.04, 0.051]"], "0.3 s"


CASES = {"strong": strong, "weak": weak, "ellipsoids": ellipsoids, "weak-ellipsoids": weak_ellipsoids}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("packings", type=os.path.abspath)
    parser.add_argument("processes", type=int, nargs="+")
    parser.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES))
    parser.add_argument("--until", help='end all runs at another time, as in "50 ms"')
    arguments = parser.parse_args()
    print("| case | processes | particles | steps | ms per step | efficiency | messages | bytes | imbalance | waiting | state |")
    print("|" + "---|" * 11)
    for name in arguments.cases:
        make = CASES[name]
        first = None
        for count in arguments.processes:
            with tempfile.TemporaryDirectory() as directory:
                case, settings, until = make(arguments.packings, count, directory)
                s = run(arguments.program, count, case, settings, arguments.until or until, f"{directory}/run")
            step = 1e3 * sum(s["stages"].get(stage, 0) for stage in STAGES) / s["steps"]
            first = first or (step, count)
            efficiency = first[0] / step * (1 if name.startswith("weak") else first[1] / count)
            shared = s["sharing"]
            cells = [name, count, s["particles"], s["steps"], f"{step:.3f}",
                     f"{efficiency:.3f}" if count <= CORES else "oversubscribed"]
            if shared:
                waiting = shared["waiting"] / (shared["busy"] + shared["waiting"])
                cells += [f"{shared['messages']:.2f}", f"{shared['bytes']:.0f}", f"{shared['imbalance']:.3f}", f"{waiting:.3f}"]
            else:
                cells += [""] * 4
            print("|", " | ".join(map(str, cells)), f"| {s['state_hash'][:8]} |", flush=True)


if __name__ == "__main__":
    main()
