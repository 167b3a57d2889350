"""`scree bench` refuses what it does not know, and writes and draws its figures. usage: bench_test.py PROGRAM SHARE"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import matplotlib

matplotlib.use("Agg")
import matplotlib.image  # noqa: E402
import numpy as np  # noqa: E402

PROGRAM, SHARE = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))


class Bench(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)

    def bench(self, *arguments):
        return subprocess.run([PROGRAM, "bench", *map(str, arguments)], capture_output=True, text=True,
                              env={**os.environ, "OMP_WAIT_POLICY": "passive"})

    def assertRefused(self, arguments, *words):
        result = self.bench(*arguments)
        self.assertEqual(result.returncode, 2, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)

    def assertPainted(self, picture):
        pixels = matplotlib.image.imread(picture)[..., :3]
        self.assertGreater(np.mean(pixels.min(axis=2) < 0.98), 0.01)
        self.assertGreater(np.mean(np.ptp(pixels, axis=2) > 0.15), 0.001)

    def test_what_cannot_be_done_is_refused_before_measuring(self):
        self.assertRefused(["liner"], "no benchmark 'liner'", "did you mean 'linear'?")
        self.assertRefused(["xyzzy"], "take dense, dilute, drum, silo, mix, ellipsoids, cylinders, boxes, exponents,")
        self.assertRefused(["dense", "--plot", self.directory / "a.png"], "name it too")
        self.assertRefused(["linear", "--plot", self.directory / "a.pdf"], "ends in .png")
        self.assertRefused(["linear", "--json", self.directory / "none" / "a.json"], "there is no directory")
        self.assertRefused(["linear", "--particles", 20000], "needs two sizes")

    def test_the_tables_of_the_thesis_are_printed(self):
        script = SHARE.parent / "bench" / "thesis.py"
        result = subprocess.run([script, PROGRAM, "1e-3"], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = [[entry.strip() for entry in line.split("|")[1:-1]] for line in result.stdout.splitlines()]
        self.assertEqual({len(row) for row in rows}, {12})
        self.assertEqual([row[1] for row in rows[3:]],
                         ["400 vertices", "certified", "400 vertices", "900 vertices", "1600 vertices"])
        # Core-microseconds of the thesis: its time, which it divided by its eight processors, times them.
        self.assertEqual([row[11] for row in rows[4:]], ["292", "838", "1634", "2949"])

    def test_the_smallest_sizes_give_figures_and_a_picture(self):
        picture = self.directory / "linear.png"
        result = self.bench("linear", "--particles", 30000, "--rounds", 1, "--threads", 1, "--plot", picture)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        (figures,) = json.loads((self.directory / "linear.json").read_text())["figures"]
        self.assertEqual([p["particles"] for p in figures["points"]], [10000, 30000])
        (n0, t0), (n1, t1) = ((p["particles"], p["seconds_per_step"]) for p in figures["points"])
        self.assertAlmostEqual(figures["exponent"], np.log(t1 / t0) / np.log(n1 / n0), places=12)
        for p in figures["points"]:
            self.assertGreater(p["contacts_per_particle"], 0)
        # Equal solid fraction and equal vortices: the two sizes see as many contacts.
        self.assertAlmostEqual(*(p["contacts_per_particle"] for p in figures["points"]), delta=0.01)
        self.assertIn(f"power {figures['exponent']:.3f}", result.stdout)
        self.assertPainted(picture)

    def test_figures_without_the_benchmark_are_not_drawn(self):
        figures = self.directory / "dense.json"
        figures.write_text(json.dumps({"figures": [{"scene": "dense"}]}))
        picture = self.directory / "none.png"
        result = subprocess.run([sys.executable, "-B", SHARE / "bench_plot.py", figures, picture], capture_output=True,
                                text=True)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("no figures of the benchmark 'linear'", result.stderr)
        self.assertFalse(picture.exists())


if __name__ == "__main__":
    unittest.main()
