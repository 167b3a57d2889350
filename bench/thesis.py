#!/usr/bin/python3
"""Tables 4-5 to 4-7 of the thesis (Srinivasan 2019) on one core, its figures beside them. usage: thesis.py PROGRAM [UNTIL]

PROGRAM is scree. UNTIL [s] ends the runs before 2.6 s. Prints a table in Markdown: the time that the processor spent, contacts
between particles and with walls that acted, counted in every step, and core-microseconds per instance.
"""

import json
import pathlib
import resource
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent

# Case, changes, what the thesis used: processors, wall time [s], instances between particles and with walls.
RUNS = (
    ("ellipsoids", "certified", [], None),
    ("ellipsoids", "400 vertices", ["contact.detection=vertices", "contact.vertices=20"], (1, 213323, None, None)),
    ("spheres", "certified", [], (8, 2592, 60685720, 10224988)),
    ("spheres", "400 vertices", ["contact.detection=vertices", "contact.vertices=20"], (8, 7645, 62415940, 10567446)),
    ("spheres", "900 vertices", ["contact.detection=vertices", "contact.vertices=30"], (8, 18972, 80681123, 12208878)),
    ("spheres", "1600 vertices", ["contact.detection=vertices", "contact.vertices=40"], (8, 37098, 86898067, 13750284)),
)


def processor_seconds():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def run(program, case, changes, until, directory):
    """Processor time [s], steps, contacts of particles and with walls."""
    before = processor_seconds()
    arguments = [program, "run", HERE / f"thesis_{case}.toml", "-o", directory, "--threads", "1", "--quiet"]
    arguments += ["--until", until] if until else []
    for change in changes:
        arguments += ["--set", change]
    subprocess.run([str(a) for a in arguments], check=True)
    seconds = processor_seconds() - before
    summary = json.loads((pathlib.Path(directory) / "summary.json").read_text())
    walls = summary["wall_contacts"]
    return seconds, summary["steps"], summary["contacts"] - walls, walls


def per_instance(processors, seconds, pairs, walls):
    """Core-microseconds per instance as the thesis counts them."""
    microseconds = 1e6 * processors * seconds / (pairs + walls) if pairs else 0
    return f"{microseconds:.{2 if microseconds < 10 else 0}f}" if pairs else ""


def main(program, until=""):
    print("| case | contacts | core s | steps | pairs, each once | pairs as the thesis counts | with walls | core-us per instance | "
          "thesis: core s | pairs | with walls | core-us per instance |")
    print("|" + "---|" * 12)
    for case, contacts, changes, thesis in RUNS:
        with tempfile.TemporaryDirectory() as directory:
            seconds, steps, pairs, walls = run(program, case, changes, until, f"{directory}/run")
        # A pair in contact counts for both partners in the thesis, whose own table divides by the processors once more.
        row = [case, contacts, f"{seconds:.1f}", steps, pairs, 2 * pairs, walls, per_instance(1, seconds, 2 * pairs, walls)]
        if thesis:
            processors, wall_seconds, its_pairs, its_walls = thesis
            row += [processors * wall_seconds, its_pairs or "", its_walls or "",
                    per_instance(processors, wall_seconds, its_pairs, its_walls)]
        else:
            row += [""] * 4
        print("|", " | ".join(str(entry) for entry in row), "|", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
