#!/usr/bin/python3
"""Runs the study of README.md. What is finished is not run again; what was ended sooner, or interrupted, goes on.

usage: study.py RUNS [--scree PROGRAM] [--turnovers N] [--stokes A,B] [--stickiness A,B] [--seeds A,B] [-- OPTIONS of scree run]
"""

import argparse
import json
import pathlib
import subprocess
import sys

import cases

INTERRUPTED = 130  # exit code of `scree`


def numbers(text):
    return tuple(float(word) for word in text.split(","))


def arguments(argv):
    own, extra = (argv[:argv.index("--")], argv[argv.index("--") + 1:]) if "--" in argv else (argv, [])
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("runs", type=pathlib.Path, help="directory of the runs")
    parser.add_argument("--scree", default="scree", help="the program")
    parser.add_argument("--turnovers", type=float, default=5, help="when the runs end")
    parser.add_argument("--stokes", type=numbers, default=cases.STOKES)
    parser.add_argument("--stickiness", type=numbers, default=cases.STICKINESS)
    parser.add_argument("--seeds", type=numbers, default=cases.SEEDS)
    return parser.parse_args(own), extra


def reached(place):
    """The simulated time that a run has come to, None if it never ended."""
    try:
        return json.loads((place / "summary.json").read_text())["time"]
    except FileNotFoundError:
        return None


def run(options, extra, base, point):
    """Runs a point as far as is asked; the exit code of `scree run`."""
    place = cases.directory(options.runs, *point)
    end, time = options.turnovers * base.turnover, reached(place)
    if time is not None and time > end - 1e-9 * end:
        return 0
    go_on = ["--restart", place] if any((place / "checkpoints").glob("*.h5")) else ["--force"]
    print(f"Stokes {point[0]:g}, stickiness {point[1]:g}, seed {point[2]:g}", flush=True)
    return subprocess.run([options.scree, "run", base.path, "-o", place, "--threads", "1", "--quiet", *go_on,
                           *cases.settings(base, *point, options.turnovers), *extra]).returncode


def main():
    options, extra = arguments(sys.argv[1:])
    base = cases.Base()
    failed = 0
    for seed in options.seeds:  # after each seed there is a whole table
        for stokes in options.stokes:
            for stickiness in options.stickiness:
                code = run(options, extra, base, (stokes, stickiness, int(seed)))
                if code == INTERRUPTED:
                    return code
                failed += code != 0
    return failed


if __name__ == "__main__":
    sys.exit(main())
