"""Files that several processes write at once and read again. usage: ranks_files_test.py PROGRAM MPIEXEC"""

import json
import resource
import shutil
import unittest

import h5py
import numpy

from ranks_common import CROWD, HARD_SPHERES, SHAPES, SPHERES_COME, Ranks

# Everything that a row of the series and a frame can say.
LOOKED_AT = """
tracks = [3, 499, 17]
fields = ["velocity", "force", "contacts", "unwrapped_position", "mass", "group"]
compression = "COMPRESSION"
[[analysis.regions]]
name = "low"
min = [0.01, 0.01, 0.002]
max = [0.04, 0.04, 0.02]
[[analysis.surfaces]]
name = "top"
min = [0, 0, 0]
max = [0.05, 0.05, 0.06]
cells = [3, 3, 12]
[[analysis.averages]]
name = "bulk"
min = [0, 0, 0]
max = [0.05, 0.05, 0.05]
cells = [4, 4, 4]
every = "2 ms"
"""

# More particles than a chunk of a file has rows, in a row of rows.
MANY = """
[simulation]
end = 1e-5
time_step = 1e-5
[domain]
min = [0, 0, 0]
max = [1.2, 0.3, 0.2]
[[materials]]
name = "glass"
density = 2500
stiffness = 1000
[[particles]]
material = "glass"
diameter = "4 mm"
insert = "lattice"
count = 70000
[output]
compression = "fast"
precision = "single"
"""


class FilesOfSeveralRanks(Ranks):
    def same_on(self, case, *ranks):
        self.run_on(0, case, "alone")
        for n in ranks:
            self.run_on(n, case, f"on{n}")
            self.same_files("alone", f"on{n}")

    def test_whatever_is_looked_at_is_the_same_on_any_number(self):
        case = CROWD.replace("contacts = true\n", "contacts = true\n" + LOOKED_AT.replace("COMPRESSION", "fast"))
        self.same_on(case, 2, 3)
        lines = (self.work / "alone" / "series.csv").read_text().splitlines()
        last = dict(zip(lines[0].split(","), lines[-1].split(",")))
        self.assertGreater(float(last["low_solid_fraction"]), 0.01)
        self.assertGreater(float(last["top_level"]), 0.001)
        self.assertEqual(len((self.work / "alone" / "tracks.csv").read_text().splitlines()), 1 + 3 * (len(lines) - 1))

    def test_agglomerates_walls_and_shapes_are_the_same_on_any_number(self):
        self.same_on(SHAPES + 'frames = "4 ms"\ncontacts = true\ncompression = "small"\n[analysis]\nagglomerates = true\n'
                     '[[analysis.regions]]\nname = "all"\n', 2, 4)
        series = numpy.genfromtxt(self.work / "alone" / "series.csv", delimiter=",", names=True)
        self.assertGreater(series["all_nematic_order"][-1], 0)
        self.assertAlmostEqual(sum(series[f"all_cos2_{axis}"][-1] for axis in "xyz"), 1)

    def test_what_hard_spheres_are_looked_at_for_is_the_same_on_any_number(self):
        self.same_on(HARD_SPHERES.replace("contacts = true\n", 'contacts = true\nfields = ["force", "contacts"]\ntracks = [0]\n'), 3)

    def test_chunks_are_shared_too(self):
        self.same_on(MANY, 3)
        with h5py.File(self.work / "on3" / "frames" / "frame_000001.h5") as file:
            ids = file["particles/id"]
            self.assertLess(ids.chunks[0], 70000)
            self.assertTrue(numpy.array_equal(ids[()], numpy.arange(70000)))

    def full_disk(self, victim):
        """Rank `victim` cannot write any more; what the run says, and its summary."""
        case = CROWD.replace("end = 0.03", "end = 100").replace('checkpoints = "10 ms"', 'checkpoints = "1 ms"')
        size = 100000  # less than a checkpoint

        def fill(pid):
            resource.prlimit(pid[victim], resource.RLIMIT_FSIZE, (size, size))

        status, said = self.while_it_runs(3, case, fill)
        self.assertEqual(status, 4, said)
        self.assertEqual(said.count("File too large"), 1, said)
        return said

    def test_a_disk_that_is_full_for_one_rank_stops_all_and_loses_nothing(self):
        for victim in (2, 0):
            shutil.rmtree(self.work / "out", ignore_errors=True)
            said = self.full_disk(victim)
            self.assertIn("--restart latest", said)
            self.assertEqual(list((self.work / "out").rglob("*.part")), [])
            checkpoint = max((self.work / "out" / "checkpoints").glob("*.h5"))
            with h5py.File(checkpoint) as file:
                time = file["values/time"][0]
            result = self.scree(2, CROWD.replace("end = 0.03", "end = 100"), "out", "--restart", "latest", "--until",
                                str(time + 1e-4))
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_a_checkpoint_of_another_case_is_refused_once(self):
        self.run_on(2, CROWD, "out", "--until", "1e-3")
        result = self.scree(3, CROWD.replace("friction = 0.3", "friction = 0.4"), "out", "--restart", "latest")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("the case is another one"), 1, result.stderr)

    def test_ranks_may_be_more_than_particles(self):
        few = SPHERES_COME.replace("count = 120", "count = 2").replace("end = 0.06", "end = 0.01")
        few = few.replace('"5 ms"', '"1 ms"').replace('"20 ms"', '"1 ms"')
        self.same_on(few, 6)
        whole = json.loads((self.work / "alone" / "summary.json").read_text())
        self.run_on(6, few, "parts", "--until", "0.005")
        self.assertEqual(self.run_on(5, few, "parts", "--restart", "latest")["state_hash"], whole["state_hash"])


if __name__ == "__main__":
    unittest.main()
