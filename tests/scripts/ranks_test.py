"""Runs on several processes. usage: ranks_test.py PROGRAM MPIEXEC"""

import csv
import json
import os
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

import h5py
import numpy

from ranks_common import (CROWD, ENVIRONMENT, HARD_SHAPES, HARD_SPHERES, MPIEXEC, PROGRAM, SHAPES, SHAPES_COME, SPHERES_COME,
                          STIRRERS, TURNED, Ranks)

# A duct with a step, a body in it and a bed behind it, all of which the cuts between ranks go through.
FLUID = (pathlib.Path(__file__).parent / "ranks_fluid.toml").read_text()

class OnSeveralRanks(Ranks):
    def assert_shared(self, summary, ranks, most_messages):
        """A rank sends each partner one message per step at most, but for steps with new lists; nobody is busier than all."""
        sharing = summary["sharing"]
        self.assertGreater(sharing["messages"], 0.5)
        self.assertLess(sharing["messages"], most_messages * (ranks - 1))
        self.assertGreater(sharing["bytes"], 48 * sharing["messages"])
        self.assertGreaterEqual(sharing["imbalance"], 0)
        self.assertLess(sharing["imbalance"], ranks - 1)
        self.assertGreaterEqual(sharing["most_particles"], summary["particles"] / ranks)
        self.assertLessEqual(sharing["busy"] + sharing["waiting"], summary["wall_seconds"])

    def same_on_all(self, case, ranks, most_messages=3):
        alone = self.run_on(0, case, "alone")
        self.assertEqual(alone["sharing"], {})
        for n in ranks:
            shared = self.run_on(n, case, f"on{n}", threads=1 + n % 2)
            for key in ("state_hash", "steps", "particles", "contacts", "wall_contacts", "ledger"):
                self.assertEqual(shared[key], alone[key], (n, key))
            self.assertEqual(shared["ranks"], n)
            self.assert_shared(shared, n, most_messages)
            self.same_files("alone", f"on{n}")

    def test_spheres_have_the_same_bits_and_files_on_any_number(self):
        self.same_on_all(CROWD, (2, 3, 4))

    def test_bodies_that_move_as_prescribed_have_the_same_bits_and_files_on_any_number(self):
        self.same_on_all(CROWD + STIRRERS, (2, 3), most_messages=9)

    def test_shapes_have_the_same_bits_and_files_on_any_number(self):
        self.same_on_all(SHAPES, (2, 4))

    def test_contacts_by_vertices_have_the_same_bits_and_files_on_any_number(self):
        self.same_on_all(SHAPES + '[contact]\ndetection = "vertices"\nvertices = 12\n', (2, 3))

    def goes_on(self, case, until, on=(2, 3)):
        whole = self.run_on(0, case, "whole")
        self.run_on(on[0], case, "parts", "--until", str(until))
        parts = self.run_on(on[1], case, "parts", "--restart", "latest")
        self.assertEqual(parts["state_hash"], whole["state_hash"])
        self.same_files("whole", "parts")

    def test_spheres_that_a_flow_turns_have_the_same_bits_on_any_number(self):
        alone = self.run_on(0, TURNED, "alone")
        self.assertGreater(alone["contacts"], 300)
        for n in (2, 3):
            shared = self.run_on(n, TURNED, f"on{n}")
            self.assertEqual(shared["state_hash"], alone["state_hash"])
            self.assertEqual(shared["ledger"], alone["ledger"])

    def test_goes_on_with_another_number(self):
        self.goes_on(CROWD, 0.01)

    def test_who_comes_and_goes_is_the_same_on_any_number(self):
        self.same_on_all(SPHERES_COME, (2, 3, 4))
        last = list(csv.DictReader((self.work / "alone" / "series.csv").read_text().splitlines()))[-1]
        for column in ("outlet_drain_count", "outlet_below_count", "hole_count"):
            self.assertGreater(float(last[column]), 0, column)
        self.assertGreater(float(last["inserted_count"]), 50)

    def test_shapes_come_and_go_on_any_number(self):
        self.same_on_all(SHAPES_COME, (2, 4))

    def test_feeds_go_on_with_another_number(self):
        self.goes_on(SHAPES_COME, 0.02, on=(4, 3))

    def test_a_feed_that_is_late_stops_all_ranks(self):
        case = SPHERES_COME.replace("max_delay = 1", "max_delay = 1e-4").replace("mass_rate = 1e-2", "mass_rate = 1")
        alone, shared = self.scree(0, case, "alone"), self.scree(3, case, "shared")
        self.assertEqual((alone.returncode, shared.returncode), (3, 3))
        told = alone.stderr.splitlines()[0]
        self.assertIn("cannot keep its rate", told)
        self.assertEqual(shared.stderr.count(told), 1, shared.stderr)
        self.same_files("alone", "shared")

    def test_physics_gone_wrong_is_told_once_and_leaves_a_checkpoint(self):
        case = CROWD.replace("max_overlap = 0.9", "max_overlap = 0.2")
        alone, shared = self.scree(0, case, "alone"), self.scree(3, case, "shared")
        self.assertEqual(alone.returncode, 3)
        self.assertEqual(shared.returncode, 3)
        told = alone.stderr.splitlines()[0]
        self.assertIn("max_overlap", told)
        self.assertEqual(shared.stderr.count("exceeds simulation.max_overlap"), 1)
        self.assertIn(told, shared.stderr)
        self.same_files("alone", "shared")

    def test_bad_input_is_told_once(self):
        result = self.scree(3, CROWD.replace("restitution", "restitutoin"), "bad")
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr.count("did you mean"), 1, result.stderr)

    def test_one_that_is_killed_takes_the_others_with_it(self):
        for victim in (0, 2):
            shutil.rmtree(self.work / "out", ignore_errors=True)
            status, _ = self.while_it_runs(3, CROWD.replace("end = 0.03", "end = 100"),
                                           lambda pid: os.kill(pid[victim], signal.SIGKILL))
            self.assertNotEqual(status, 0)

    @unittest.skipIf(b"san_init" in pathlib.Path(PROGRAM).read_bytes(), "a sanitizer needs memory of its own")
    def test_one_that_finds_no_memory_takes_the_others_with_it(self):
        # Libraries give up in their own ways when they find none: rank 1 has some to spare for them, and too little for so
        # many particles.
        peak = []

        def look(pid):
            status = pathlib.Path(f"/proc/{pid[1]}/status").read_text()
            peak.append(int(next(line for line in status.splitlines() if line.startswith("VmPeak")).split()[1]))
            os.kill(pid[1], signal.SIGKILL)

        self.while_it_runs(2, CROWD.replace("end = 0.03", "end = 100"), look)
        case = CROWD.replace('insert = "random"\ncount = 500', 'insert = "lattice"\ncount = 2000000').replace(
            'diameter = { distribution = "uniform", min = "3 mm", max = "6 mm" }', 'diameter = "0.03 mm"').replace(
            "time_step = 2e-5", 'time_step = "auto"')
        (self.work / "case.toml").write_text(case)
        run = f'[ $OMPI_COMM_WORLD_RANK = 0 ] || ulimit -v {peak[0] + 65536}; exec "$0" run case.toml --quiet --threads 1 -o much'
        result = subprocess.run([MPIEXEC, "-n", "2", "sh", "-c", run, PROGRAM], capture_output=True, text=True,
                                cwd=self.work, env=ENVIRONMENT, timeout=120)
        self.assertNotEqual(result.returncode, 0)
        self.assertEqual(result.stderr.count("rank 1: out of memory"), 1, result.stderr)

    def test_one_that_finds_its_input_bad_takes_the_others_with_it(self):
        for rank, text in ((0, CROWD), (1, CROWD.replace("restitution", "restitutoin"))):
            (self.work / str(rank)).mkdir()
            (self.work / str(rank) / "case.toml").write_text(text)
        run = 'cd $OMPI_COMM_WORLD_RANK; exec "$0" run case.toml --quiet -o out'
        result = subprocess.run([MPIEXEC, "-n", "2", "sh", "-c", run, PROGRAM], capture_output=True, text=True,
                                cwd=self.work, env=ENVIRONMENT, timeout=120)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("rank 1: case.toml:"), 1, result.stderr)

    def test_a_binding_that_leaves_processors_idle_is_told(self):
        if len(os.sched_getaffinity(0)) < 2:
            self.skipTest("there is only one processor")
        (self.work / "case.toml").write_text(CROWD)
        told = {}
        for binding in ("core", "none"):
            command = [MPIEXEC, "-n", "1", "--bind-to", binding, PROGRAM, "run", "case.toml", "-o", binding, "--until", "1e-4"]
            told[binding] = subprocess.run(command, capture_output=True, text=True, cwd=self.work, timeout=300, env=ENVIRONMENT)
            self.assertEqual(told[binding].returncode, 0, told[binding].stderr)
        self.assertIn("--bind-to none", told["core"].stderr)
        self.assertNotIn("--bind-to none", told["none"].stderr)

    def test_hard_spheres_have_the_same_bits_and_files_on_any_number(self):
        self.same_on_all(HARD_SPHERES, (2, 3), most_messages=1000)
        with h5py.File(max((self.work / "alone" / "contacts").glob("*.h5"))) as last:
            of_the_ball = numpy.count_nonzero(last["contacts/first"][()] == 0)
        self.assertGreater(of_the_ball, 64)

    def test_hard_shapes_have_the_same_bits_and_files_on_any_number(self):
        self.same_on_all(HARD_SHAPES, (2, 4), most_messages=1000)

    def test_hard_shapes_go_on_with_another_number(self):
        self.goes_on(HARD_SHAPES, 0.005)

    def test_a_hard_body_that_is_too_fast_stops_all_ranks(self):
        case = HARD_SPHERES.replace("deviation = 0.2", "deviation = 4")
        alone, shared = self.scree(0, case, "alone"), self.scree(3, case, "shared")
        self.assertEqual((alone.returncode, shared.returncode), (3, 3), alone.stderr)
        told = alone.stderr.splitlines()[0]
        self.assertIn("of its radius", told)
        self.assertEqual(shared.stderr.count(told), 1, shared.stderr)
        self.same_files("alone", "shared")

    def test_collisions_one_after_the_other_have_the_same_bits_and_files_on_any_number(self):
        one_by_one = '[hard]\norder = "sequential"\n'
        for case in (HARD_SPHERES.replace("[hard]\n", one_by_one), HARD_SHAPES + one_by_one):
            self.same_on_all(case, (2, 3), most_messages=1000)
            shutil.rmtree(self.work)
            self.work.mkdir()


class FluidOnSeveralRanks(Ranks):
    def fields(self, output):
        with h5py.File(sorted((self.work / output / "fluid").glob("*.h5"))[-1]) as file:
            return {name: file["fields"][name][:]
                    for name in ("velocity", "pressure", "temperature", "dye", "eddy_viscosity")}

    def hash(self, output):
        return json.loads((self.work / output / "summary.json").read_text())["fluid_hash"]

    def run_fluid(self, ranks, output, *words):
        result = self.scree(ranks, FLUID, output, *words)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_the_flow_does_not_depend_on_the_ranks(self):
        self.run_fluid(1, "one")
        one = self.fields("one")
        for ranks in (2, 4):
            self.run_fluid(ranks, f"on{ranks}")
            for name, values in self.fields(f"on{ranks}").items():
                self.assertLess(numpy.abs(values - one[name]).max(), 1e-10 * numpy.abs(one[name]).max(), name)

    def test_a_flow_goes_on_with_the_same_bits(self):
        self.run_fluid(2, "whole")
        self.run_fluid(2, "pieces", "--until", "0.1")
        self.run_fluid(2, "pieces", "--restart", "latest")
        self.assertEqual(self.hash("pieces"), self.hash("whole"))
        self.run_fluid(2, "other", "--until", "0.1")
        self.run_fluid(1, "other", "--restart", "latest")  # on another number of ranks: the same but for rounding
        whole = self.fields("whole")
        for name, values in self.fields("other").items():
            self.assertLess(numpy.abs(values - whole[name]).max(), 1e-10 * numpy.abs(whole[name]).max(), name)

    def test_too_many_ranks_are_refused(self):
        thin = FLUID.replace("cells = [16, 8, 4]", "cells = [4, 2, 1]").split("[[fluid.blocks]]")[0]
        result = self.scree(4, thin, "thin")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("processes are too many", result.stderr)


if __name__ == "__main__":
    unittest.main()
