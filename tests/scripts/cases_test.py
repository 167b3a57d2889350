"""Cases that come with the program: all pass `scree check`, the examples run. usage: cases_test.py PROGRAM SOURCE"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest

import numpy as np

PROGRAM, SOURCE = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))
STEPS = 150


def scree(*arguments, directory=None):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, cwd=directory,
                          env={**os.environ, "OMP_WAIT_POLICY": "passive"})


def metres(length):
    number, _, unit = str(length).partition(" ")
    return float(number) * {"": 1, "m": 1, "mm": 1e-3}[unit]


def one_particle(domain, part, path):
    """A table with one particle, a part of the way from the lower to the upper corner of a domain."""
    place = [metres(low) + part * (metres(high) - metres(low)) for low, high in zip(domain["min"], domain["max"])]
    path.write_text("x,y,z\n" + ",".join(map(str, place)) + "\n")
    return path


def one_triangle(path):
    """A mesh that is in nobody's way."""
    corners = "".join(f"vertex {x} {y} -1\n" for x, y in ((0, 0), (1, 0), (0, 1)))
    path.write_text(f"solid a\nfacet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\nendsolid a\n")
    return path


def files_made_on_demand(case, directory):
    """Changes that put other files in the place of those that `scree bench` makes for a case."""
    content = tomllib.loads(case.read_text())
    changes = []
    for k, group in enumerate(content["particles"]):
        if "file" in group:
            part = (k + 1) / (len(content["particles"]) + 1)
            table = one_particle(content["domain"], part, directory / f"particles_{k}.csv")
            changes += ["--set", f'particles.{k}.file="{table}"']
    if "file" in content.get("walls", [{}])[0]:
        changes += ["--set", f'walls.0.file="{one_triangle(directory / "wall.stl")}"']
    return changes


class Cases(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)

    def assertPasses(self, result):
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_every_case_passes_the_check(self):
        cases = sorted([*SOURCE.glob("examples/*/case.toml"), *SOURCE.glob("verify/*/case.toml"),
                        *SOURCE.glob("verify/long/*/case.toml"),
                        *SOURCE.glob("bench/*.toml"), *SOURCE.glob("docs/studies/*/*.toml")])
        self.assertGreater(len(cases), 25)
        for case in cases:
            with self.subTest(case=case.relative_to(SOURCE).as_posix()):
                changes = files_made_on_demand(case, self.directory) if case.parent.name == "bench" else []
                self.assertPasses(scree("check", case, *changes))

    def test_every_example_runs(self):
        for example in sorted(SOURCE.glob("examples/*/case.toml")):
            with self.subTest(example=example.parent.name):
                self.assertTrue((example.parent / "README.md").exists())
                checked = scree("check", example)
                self.assertPasses(checked)
                if "\n[fluid]" in example.read_text() and "[[particles]]" not in example.read_text():
                    self.check_fluid_example(example)
                    continue
                step = float(re.search(r"time step +(\S+) s", checked.stdout).group(1))
                out = self.directory / example.parent.name
                self.assertPasses(scree("run", example, "--until", STEPS * step, "--threads", 2, "-o", out, "--quiet"))
                summary = json.loads((out / "summary.json").read_text())
                self.assertEqual(summary["status"], "finished")
                self.assertAlmostEqual(summary["steps"], STEPS, delta=2)
                series = np.atleast_1d(np.genfromtxt(out / "series.csv", delimiter=",", names=True))
                self.assertAlmostEqual(series["time"][-1], summary["time"])
                self.assertTrue(np.all(np.isfinite(series["kinetic_energy"])))
                self.assertTrue((out / "frames" / "frame_000000.h5").exists())

    def check_fluid_example(self, example):
        out = self.directory / example.parent.name
        end = tomllib.loads(example.read_text())["simulation"]["end"] / 400
        self.assertPasses(scree("run", example, "--until", end, "--threads", 2, "-o", out, "--quiet"))
        summary = json.loads((out / "summary.json").read_text())
        self.assertEqual(summary["status"], "finished")
        self.assertAlmostEqual(summary["time"], end)
        series = np.atleast_1d(np.genfromtxt(out / "series.csv", delimiter=",", names=True))
        self.assertTrue(np.all(np.isfinite(series["kinetic_energy"])))
        self.assertTrue((out / "fluid" / "fluid_000000.h5").exists())

    def test_the_architecture_tells_the_memory(self):
        text = (SOURCE / "ARCHITECTURE.md").read_text()

        def told(what):
            return [int(bytes) for bytes in re.findall(rf"^\| {what} \| (\d+)", text, re.MULTILINE)]

        (particle,), (pair,) = told("particle, in all"), told("candidate pair")
        (rolling,) = told("with rolling, twisting or hard collisions")
        shape, pair_of_shapes = told("and where some are no spheres")
        (coupled,), (turned,), (heat,) = (told(f"and where {what}") for what in (
            "a fluid is solved for", "it turns particles", "they have a temperature"))
        for example, per_particle, per_pair in (("02_bouncing_ball", particle, pair),
                                                ("03_settling_heap", particle, rolling),
                                                ("12_fifty_cylinders", particle + shape, rolling + pair_of_shapes),
                                                ("33_warm_bed", particle + coupled + heat, pair)):
            report = scree("check", SOURCE / "examples" / example / "case.toml").stdout
            self.assertIn(f"({per_particle} B per particle, {per_pair} B per pair", report)
        turning = scree("check", SOURCE / "examples" / "33_warm_bed" / "case.toml", "--set", "coupling.viscous_torque=on")
        self.assertIn(f"({particle + coupled + heat + turned} B per particle", turning.stdout)

    def test_the_first_steps_of_the_readme_work(self):
        """The case that README.md prints is a case, and every program call it prints exists."""
        text = (SOURCE / "README.md").read_text()
        cases = re.findall(r"^```toml\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        self.assertEqual(len(cases), 1)
        (self.directory / "first.toml").write_text(cases[0])
        self.assertPasses(scree("check", "first.toml", directory=self.directory))
        self.assertPasses(scree("run", "first.toml", directory=self.directory))
        self.assertTrue((self.directory / "runs" / "first" / "summary.json").exists())
        for command in set(re.findall(r"\bscree ([a-z]+)\b(?= |$|`)", text)) - {"is"}:
            self.assertPasses(scree(command, "--help"))


if __name__ == "__main__":
    unittest.main()
