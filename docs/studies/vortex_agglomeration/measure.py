#!/usr/bin/python3
"""The numbers of the study: a row per Stokes and stickiness number, from runs of study.py.

usage: measure.py RUNS TABLE.csv [TURNOVERS]

With TURNOVERS no run counts for longer than that.
"""

import csv
import json
import math
import pathlib
import re
import sys

import numpy as np
import numpy.lib.recfunctions as rfn

import cases

STUDENT = {2: 12.706, 3: 4.303, 4: 3.182, 5: 2.776, 6: 2.571}  # 95 %, by the number of seeds
MEANS = ("agglomerated_fraction", "mean_agglomerate_size", "largest_agglomerate", "agglomerates", "contacts_per_sphere",
         "fractal_dimension", "collision_speed", "max_overlap")
COLUMNS = ["stokes", "stickiness_number", "seeds", "turnovers", *(c for m in MEANS for c in (m, f"{m}_95")),
           "fraction_drift", "size_drift", "stationary"]
LAST = 1 / 3           # of the run is averaged
FRACTION_DRIFT = 0.02  # a run is stationary whose fraction in agglomerates changes by less than this in that time
SIZE_DRIFT = 0.1       # and whose mean agglomerate changes by less than this part of itself


def series(place):
    rows = np.genfromtxt(place / "series.csv", delimiter=",", names=True)
    return rfn.append_fields(rows, "contacts_per_sphere", 2 * rows["contacts"] / rows["particles"], usemask=False)


def finished(place):
    summary = place / "summary.json"
    return summary.exists() and json.loads(summary.read_text())["status"] == "finished"


def runs_of(directory, turnovers=math.inf):
    """All finished runs, by Stokes and stickiness number; those of different seeds as far as the shortest goes, and none
    longer than so many turnovers."""
    found = {}
    end = (turnovers + 1e-3) * cases.Base().turnover
    for place in sorted(directory.glob("stokes*_stickiness*_seed*")):
        stokes, stickiness, _ = map(float, re.findall(r"[a-z]([0-9.]+)", place.name))
        if finished(place):
            run = series(place)
            found.setdefault((stokes, stickiness), []).append(run[run["time"] <= end])
    for runs in found.values():
        shortest = min(len(run) for run in runs)
        runs[:] = [run[:shortest] for run in runs]
    return dict(sorted(found.items()))


def interval(values):
    """Mean over the seeds, and half of the interval in which it is with 95 %."""
    half = STUDENT[len(values)] * np.std(values, ddof=1) / np.sqrt(len(values)) if len(values) > 1 else np.nan
    return np.mean(values), half


def late(rows):
    return rows[rows["time"] > (1 - LAST) * rows["time"][-1]]


def drift(rows, column):
    """Change over the last part of a run, by a straight line through its rows."""
    end = late(rows)
    return np.polyfit(end["time"], end[column], 1)[0] * np.ptp(end["time"])


def row(point, runs, turnover):
    found = {"stokes": point[0], "stickiness_number": point[1], "seeds": len(runs),
             "turnovers": min(run["time"][-1] for run in runs) / turnover}
    for name in MEANS:
        found[name], found[f"{name}_95"] = interval([np.nanmean(late(run)[name]) for run in runs])
    found["fraction_drift"] = np.mean([drift(run, "agglomerated_fraction") for run in runs])
    found["size_drift"] = np.mean([drift(run, "mean_agglomerate_size") for run in runs]) / found["mean_agglomerate_size"]
    settled = abs(found["fraction_drift"]) < FRACTION_DRIFT and abs(found["size_drift"]) < SIZE_DRIFT
    return {**found, "stationary": "yes" if settled else "no"}


def table(directory, turnovers=math.inf):
    turnover = cases.Base().turnover
    return [row(point, runs, turnover) for point, runs in runs_of(directory, turnovers).items()]


def main():
    with open(sys.argv[2], "w", newline="") as file:
        out = csv.DictWriter(file, COLUMNS)
        out.writeheader()
        for line in table(pathlib.Path(sys.argv[1]), *map(float, sys.argv[3:])):
            out.writerow({k: v if isinstance(v, str) else f"{v:.4g}" for k, v in line.items()})


if __name__ == "__main__":
    main()
