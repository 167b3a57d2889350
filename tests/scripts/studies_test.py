"""The scripts of docs/studies/ on runs of no length. usage: studies_test.py PROGRAM STUDIES"""

import csv
import itertools
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

PROGRAM, STUDIES = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))
VORTEX, REPORT = STUDIES / "vortex_agglomeration", STUDIES / "opencl_report"
sys.path.insert(0, str(VORTEX))
import cases  # noqa: E402
import measure  # noqa: E402
import speeds  # noqa: E402

FEW = ("--", "--set", "particles.grains.count=3000", "--set", "output.series=2e-5")


def call(*command):
    result = subprocess.run([*map(str, command)], capture_output=True, text=True,
                            env={**os.environ, "OMP_WAIT_POLICY": "passive"})
    if result.returncode != 0:
        raise AssertionError(result.stdout + result.stderr)
    return result.stdout


class InTemporary(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)


class VortexAgglomeration(InTemporary):
    def study(self, turnovers, *options):
        return call(VORTEX / "study.py", self.directory, "--scree", PROGRAM, "--stokes", 1, "--stickiness", "0,1", "--seeds",
                    "1,2", "--turnovers", turnovers, *FEW, *options)

    def test_the_numbers_are_those_that_were_asked_for(self):
        base = cases.Base()
        for stokes, stickiness in itertools.product(cases.STOKES, cases.STICKINESS):
            told = call(PROGRAM, "check", VORTEX / "case.toml", *cases.settings(base, stokes, stickiness, 1, 10))
            self.assertAlmostEqual(float(re.search(r"Stokes number +(\S+)", told)[1]), stokes)
            self.assertAlmostEqual(float(re.search(r"stickiness number +(\S+)", told)[1]), stickiness, places=3)
        told = call(PROGRAM, "check", VORTEX / "case.toml")
        self.assertRegex(told, r"Stokes number +1 ")
        self.assertRegex(told, r"stickiness number +1 ")

    def test_runs_are_measured_drawn_and_go_on(self):
        self.assertEqual(self.study(0.05, "--set", "output.frames=2e-4").count("seed"), 4)
        self.assertEqual(self.study(0.05), "")
        self.assertEqual(self.study(0.2).count("seed"), 4)
        table = self.directory / "table.csv"
        call(VORTEX / "measure.py", self.directory, table)
        with open(table, newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["stickiness_number"] for row in rows], ["0", "1"])
        for row in rows:
            self.assertEqual(row["seeds"], "2")
            self.assertAlmostEqual(float(row["turnovers"]), 0.2, delta=0.002)
            self.assertGreater(float(row["agglomerated_fraction_95"]), 0)
        call(VORTEX / "figures.py", self.directory, "--scree", PROGRAM, "--stokes", 1, "--pictures", self.directory)
        for name in ("field", "paths", "agglomerates", "courses", "speeds", "places"):
            self.assertGreater((self.directory / f"{name}.png").stat().st_size, 2000)

    def test_only_runs_that_came_to_their_end_are_measured(self):
        for seed, status in ((1, "finished"), (2, "failed"), (3, "interrupted")):
            place = cases.directory(self.directory, 1, 0.25, seed)
            place.mkdir()
            (place / "summary.json").write_text(json.dumps({"status": status}))
            (place / "series.csv").write_text("time,contacts,particles\n0,0,2\n1,1,2\n")
        self.assertEqual([(point, len(runs)) for point, runs in measure.runs_of(self.directory).items()], [((1, 0.25), 1)])

    def test_the_flow_is_that_of_the_program(self):
        call(PROGRAM, "run", VORTEX / "case.toml", "-o", self.directory, "--quiet", "--until", 1e-5, "--force")
        position, velocity = speeds.frame(self.directory / "frames" / "frame_000000.h5")
        np.testing.assert_allclose(velocity, speeds.flow(position, cases.Base())[0], atol=1e-12)

    def test_the_interval_is_that_of_students_distribution(self):
        mean, half = measure.interval([1.0, 2.0, 4.0])
        self.assertAlmostEqual(mean, 7 / 3)
        self.assertAlmostEqual(half, 4.303 * np.sqrt(7 / 9), places=3)  # the variance of the three is 7/3

    def test_close_pairs_are_those_of_all_pairs(self):
        source = np.random.default_rng(3)
        position, side, reach = source.uniform(0, 1, (300, 3)), 1.0, 0.11
        i, j, apart = speeds.close_pairs(position, side, reach)
        every = position[None, :] - position[:, None]
        every -= np.round(every)
        first, second = np.nonzero(np.triu(np.linalg.norm(every, axis=2) < reach, 1))
        self.assertGreater(len(first), 100)
        self.assertEqual(sorted(zip(i, j)), sorted(zip(first, second)))
        np.testing.assert_allclose(apart, every[i, j], atol=1e-15)


class OpenclReport(InTemporary):
    def test_sizes_are_timed_and_drawn(self):
        picture = self.directory / "sizes.png"
        told = call(REPORT / "sizes.py", "--scree", PROGRAM, "--sizes", "1e4,3e4", "--steps", 20, "--picture", picture)
        self.assertRegex(told, r"10000 spheres .* particle-steps/s")
        self.assertRegex(told, r"the report's 0\.99")
        self.assertGreater(picture.stat().st_size, 5000)

    def test_the_case_is_the_one_that_the_report_timed(self):
        told = call(PROGRAM, "check", REPORT / "case.toml")
        self.assertRegex(told, r"time step +0\.0005 s")
        self.assertRegex(told, r"steps of the run +10 000")


if __name__ == "__main__":
    unittest.main()
