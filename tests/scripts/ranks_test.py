"""Runs on several processes. usage: ranks_test.py PROGRAM MPIEXEC"""

import csv
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py
import numpy

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
MPIEXEC = sys.argv.pop(1)

# Ranks of one test share processors with those of others, and the tests may run as root in a container. What MPI's
# libraries never free is not for the sanitizer of this program to tell.
ENVIRONMENT = os.environ | {
    "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_mpi_yield_when_idle": "1", "OMP_WAIT_POLICY": "passive", "OMPI_MCA_hwloc_base_binding_policy": "none",
    "ASAN_OPTIONS": "detect_leaks=0"}

# A crowd that rushes through a box, and over its periodic faces: everybody changes the rank many times.
CROWD = """
[simulation]
end = 0.03
time_step = 2e-5
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.05, 0.05, 0.3]
periodic = [true, true, false]
[gravity]
type = "uniform"
acceleration = [1, 0.5, -9.81]
[contact]
rolling = "spring"
twisting = "spring"
[[materials]]
name = "glass"
density = 2000
stiffness = 500
restitution = 0.9
friction = 0.3
rolling_friction = 0.02
twisting_friction = 0.1
[[particles]]
name = "grains"
material = "glass"
diameter = { distribution = "uniform", min = "3 mm", max = "6 mm" }
insert = "random"
count = 500
velocity = { type = "random", deviation = 0.7 }
region_min = [0, 0, 0.008]
region_max = [0.05, 0.05, 0.06]
[[walls]]
name = "floor"
type = "plane"
material = "glass"
point = [0, 0, 0.001]
normal = [0, 0, 1]
[output]
series = "1 ms"
frames = "5 ms"
checkpoints = "10 ms"
contacts = true
[[analysis.planes]]
name = "middle"
point = [0, 0, 0.01]
normal = [0, 0, 1]
"""

SHAPES = """
[simulation]
end = 0.012
time_step = 2e-5
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.05, 0.05, 0.06]
periodic = [true, false, false]
[gravity]
type = "uniform"
acceleration = [1, 0, -9.81]
[[materials]]
name = "glass"
density = 2000
stiffness = 500
restitution = 0.8
friction = 0.3
[[particles]]
name = "boxes"
shape = "superellipsoid"
half_axes = [0.003, 0.002, 0.0015]
exponents = [0.4, 0.4]
orientation = { type = "random" }
material = "glass"
insert = "random"
count = 80
velocity = { type = "random", deviation = 0.7 }
[[particles]]
name = "balls"
diameter = "4 mm"
material = "glass"
insert = "random"
count = 80
velocity = { type = "random", deviation = 0.7 }
[[walls]]
name = "box"
type = "box"
material = "glass"
min = [-0.05, 0, 0]
max = [0.1, 0.05, 0.06]
[output]
series = "1 ms"
"""

# Two feeds rain on a bed, which leaves through a hole in the floor and by a drain; walls and cut planes go through all of
# it. What leaves touches what stays, also on other ranks.
FEEDS = """
[simulation]
end = 0.06
time_step = 2e-5
exchange_every = 25
max_overlap = 0.9
[domain]
min = [-0.0125, -0.0125, -0.01]
max = [0.0125, 0.0125, 0.04]
[gravity]
type = "uniform"
acceleration = [0.5, 0, -9.81]
[flow]
type = "uniform"
velocity = [0, 0, 0.5]
density = 1.2
viscosity = 1.8e-5
drag = "schiller_naumann"
[[materials]]
name = "glass"
density = 2500
stiffness = 300
restitution = 0.7
friction = 0.4
[[particles]]
name = "bed"
material = "glass"
insert = "random"
count = 120
region_min = [-0.01, -0.01, 0]
region_max = [0.01, 0.01, 0.018]
diameter = { distribution = "uniform", min = 2e-3, max = 4e-3 }
velocity = { type = "random", value = [0, 0, -0.5], deviation = 0.1 }
[[particles]]
name = "rain"
material = "glass"
insert = "rate"
mass_rate = 1e-2
region_min = [-0.009, -0.009, 0.022]
region_max = [0.009, 0.009, 0.03]
diameter = { distribution = "uniform", min = 1.5e-3, max = 3e-3 }
velocity = { type = "random", value = [0, 0, -0.8], deviation = 0.1 }
angular_velocity = [30, 0, 20]
max_delay = 1
[[particles]]
name = "pebbles"
material = "glass"
SHAPE
insert = "rate"
number_rate = 400
from = 0.004
region_min = [-0.008, -0.008, 0.025]
region_max = [0.008, 0.008, 0.025]
velocity = [0.1, 0, -1]
max_delay = 1
[[walls]]
name = "sides"
type = "box"
material = "glass"
min = [-0.01, -0.01, -0.1]
max = [0.01, 0.01, 0.1]
[[walls]]
name = "floor"
type = "rectangle"
material = "glass"
min = [-0.01, -0.01, 0]
max = [0.004, 0.01, 0]
[[outlets]]
name = "drain"
type = "region"
min = [-0.01, 0.004, 0]
max = [-0.006, 0.01, 0.004]
[[outlets]]
name = "below"
face = "z_min"
[[analysis.planes]]
name = "hole"
point = [0, 0, -0.002]
normal = [0, 0, -1]
[output]
series = "5 ms"
frames = "20 ms"
checkpoints = "20 ms"
"""
SPHERES_COME = FEEDS.replace("SHAPE", 'diameter = "3 mm"')
SHAPES_COME = FEEDS.replace("SHAPE", 'shape = "superellipsoid"\nhalf_axes = [1.5e-3, 1e-3, 0.8e-3]\nexponents = [0.5, 0.5]\n'
                            'orientation = { type = "random" }')

HARD = """
[simulation]
end = END
time_step = 1e-4
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.05, 0.05, 0.1]
periodic = [true, false, false]
[gravity]
type = "uniform"
acceleration = [3, 0, -9.81]
[contact]
collision = "hard"
[[materials]]
name = "wood"
density = 700
restitution = 0.6
friction = 0.5
[[walls]]
name = "room"
type = "box"
material = "wood"
min = [-0.05, 0.001, 0.001]
max = [0.1, 0.049, 0.2]
[output]
series = "5 ms"
frames = "5 ms"
checkpoints = "5 ms"
contacts = true
"""
# A crowd that falls on a ball in its middle, past a plate that shakes: the ball touches more than 64 others at once.
HARD_SPHERES = HARD.replace("END", "0.012").replace("[true, false, false]", "[false, false, false]").replace(
    'type = "uniform"\nacceleration = [3, 0, -9.81]',
    'type = "expression"\nexpression = ["2e4 * (0.025 - x)", "2e4 * (0.025 - y)", "2e4 * (0.025 - z)"]') + """
[hard]
sweeps = 5
[[walls]]
name = "shaker"
type = "plate"
material = "wood"
corner = [0.01, 0.01, 0.012]
edge_a = [0.03, 0, 0]
edge_b = [0, 0.03, 0]
motion = { type = "oscillation", amplitude = [0, 0, 0.002], frequency = 30 }
[[particles]]
name = "ball"
material = "wood"
diameter = "14 mm"
insert = "positions"
positions = [[0.025, 0.025, 0.025]]
[[particles]]
name = "grains"
material = "wood"
diameter = { distribution = "uniform", min = "2 mm", max = "2.5 mm" }
insert = "random"
count = 500
attempts = 20000
velocity = { type = "random", deviation = 0.2 }
region_min = [0.01, 0.01, 0.016]
region_max = [0.04, 0.04, 0.045]
"""
# Boxes that lie on each other with feet, and others that fall on them.
HARD_SHAPES = HARD.replace("END", "0.012").replace("acceleration = [3,", "acceleration = [0.5,") + """
[[particles]]
name = "stacks"
material = "wood"
shape = "superellipsoid"
half_axes = [0.005, 0.004, 0.003]
exponents = [0.1, 0.1]
insert = "positions"
positions = [POSITIONS]
[[particles]]
name = "stones"
material = "wood"
shape = "ellipsoid"
half_axes = [0.003, 0.002, 0.0015]
orientation = { type = "random" }
insert = "random"
count = 60
velocity = [0, 0, -0.5]
region_min = [0, 0.002, 0.03]
region_max = [0.05, 0.048, 0.06]
""".replace("POSITIONS", ", ".join(f"[{0.006 + 0.0125 * i}, {0.008 + 0.011 * j}, {0.00401 + 0.00602 * k}]"
                                   for i in range(4) for j in range(4) for k in range(3)))


# A duct with a step, a body in it and a bed behind it, all of which the cuts between ranks go through.
FLUID = (pathlib.Path(__file__).parent / "ranks_fluid.toml").read_text()


def content(file):
    """Everything in an HDF5 file, but for when and from what case it was written."""
    found = {}
    with h5py.File(file) as f:
        f.visititems(lambda name, item: found.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
        found.update({"@" + key: value for key, value in f.attrs.items()})
    return {key: numpy.asarray(value).tobytes() for key, value in found.items() if key != "@case"}


class Ranks(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.work = pathlib.Path(temporary.name)

    def scree(self, ranks, case, output, *words, threads=1):
        (self.work / "case.toml").write_text(case)
        command = [PROGRAM, "run", "case.toml", "-o", output, "--quiet", "--threads", str(threads), *words]
        launcher = [MPIEXEC, "-n", str(ranks)] if ranks > 0 else []
        return subprocess.run(launcher + command, capture_output=True, text=True, cwd=self.work, env=ENVIRONMENT, timeout=300)


class OnSeveralRanks(Ranks):
    def run_on(self, ranks, case, output, *words, threads=1):
        result = self.scree(ranks, case, output, *words, threads=threads)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads((self.work / output / "summary.json").read_text())

    def same_files(self, one, other):
        names = sorted(p.relative_to(self.work / one) for p in (self.work / one).rglob("*") if p.is_file())
        self.assertEqual(names, sorted(p.relative_to(self.work / other) for p in (self.work / other).rglob("*")
                                       if p.is_file()))
        for name in names:
            if name.suffix == ".csv":
                self.assertEqual((self.work / one / name).read_text(), (self.work / other / name).read_text(), name)
            if name.suffix == ".h5":
                self.assertEqual(content(self.work / one / name), content(self.work / other / name), name)

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

    def test_shapes_have_the_same_bits_and_files_on_any_number(self):
        self.same_on_all(SHAPES, (2, 4))

    def goes_on(self, case, until, on=(2, 3)):
        whole = self.run_on(0, case, "whole")
        self.run_on(on[0], case, "parts", "--until", str(until))
        parts = self.run_on(on[1], case, "parts", "--restart", "latest")
        self.assertEqual(parts["state_hash"], whole["state_hash"])
        self.same_files("whole", "parts")

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

    def while_it_runs(self, ranks, case, do):
        """Does something to the processes of a run by their ranks; how the run ends, and what it says."""
        (self.work / "case.toml").write_text(case)
        command = [MPIEXEC, "-n", str(ranks), PROGRAM, "run", "case.toml", "-o", "out", "--quiet", "--threads", "1"]
        run = subprocess.Popen(command, cwd=self.work, env=ENVIRONMENT, stderr=subprocess.PIPE, text=True)
        try:
            while not list(self.work.glob("out/checkpoints/*.h5")):
                self.assertIsNone(run.poll())
                time.sleep(0.01)
            processes = {variable(pid, "OMPI_COMM_WORLD_RANK"): pid for pid in children_of(run.pid)}
            do({int(rank): pid for rank, pid in processes.items() if rank})
            _, said = run.communicate(timeout=60)
            return run.returncode, said
        finally:
            run.kill()
            run.wait()

    def test_one_that_is_killed_takes_the_others_with_it(self):
        for victim in (0, 2):
            shutil.rmtree(self.work / "out", ignore_errors=True)
            status, _ = self.while_it_runs(3, CROWD.replace("end = 0.03", "end = 100"),
                                           lambda pid: os.kill(pid[victim], signal.SIGKILL))
            self.assertNotEqual(status, 0)

    @unittest.skipIf(b"san_init" in pathlib.Path(PROGRAM).read_bytes(), "a sanitizer needs memory of its own")
    def test_one_that_finds_no_memory_takes_the_others_with_it(self):
        # A rain that needs more and more of it.
        case = SPHERES_COME.replace("end = 0.06", "end = 100").replace('checkpoints = "20 ms"', 'checkpoints = "1 ms"')

        def take_memory(pid):
            size = int(pathlib.Path(f"/proc/{pid[1]}/statm").read_text().split()[0]) * resource.getpagesize()
            resource.prlimit(pid[1], resource.RLIMIT_AS, (size, size))

        status, said = self.while_it_runs(2, case, take_memory)
        # MPI itself may not find the memory to hand the exit code on.
        self.assertNotEqual(status, 0, said)
        self.assertEqual(said.count("rank 1: out of memory"), 1, said)

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

    def test_what_is_not_there_yet_is_refused_by_name(self):
        result = self.scree(2, HARD_SHAPES + "[hard]\norder = \"sequential\"\n", "sequential")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("E191"), 1, result.stderr)


def children_of(pid):
    found = subprocess.run(["pgrep", "-P", str(pid)], capture_output=True, text=True).stdout.split()
    return [int(child) for child in found] + [c for child in found for c in children_of(child)]


def variable(pid, name):
    entries = pathlib.Path(f"/proc/{pid}/environ").read_bytes().split(b"\0")
    return next((e.split(b"=", 1)[1].decode() for e in entries if e.startswith(name.encode() + b"=")), None)


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
