"""What the tests of runs on several processes share: cases, and how to run and compare them. The words of the command line are
PROGRAM and MPIEXEC."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
MPIEXEC = sys.argv.pop(1)

# Ranks of one test share processors with those of others, and the tests may run as root in a container. What MPI's
# libraries never free is not for the sanitizer of this program to tell.
ENVIRONMENT = os.environ | {
    "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_mpi_yield_when_idle": "1", "OMP_WAIT_POLICY": "passive", "OMPI_MCA_hwloc_base_binding_policy": "none",
    "ASAN_OPTIONS": "detect_leaks=0"}

# A crowd that rushes through a box, and over its periodic faces: everybody changes the rank many times, also while touching the
# partition or crossing the planes, which lie in the blocks of several ranks.
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
[[walls]]
name = "partition"
type = "rectangle"
material = "glass"
min = [0.02, 0.01, 0.002]
max = [0.02, 0.04, 0.07]
[output]
series = "1 ms"
frames = "5 ms"
checkpoints = "10 ms"
contacts = true
[[analysis.planes]]
name = "middle"
point = [0, 0, 0.01]
normal = [0, 0, 1]
[[analysis.planes]]
name = "high"
point = [0, 0, 0.022]
normal = [0, 0, 1]
[[analysis.planes]]
name = "upright"
point = [0.03, 0, 0]
normal = [1, 0, 0]
"""

# Bodies that cross many blocks of the crowd as formulas say, faster than all others.
STIRRERS = """
[[particles]]
name = "pins"
material = "glass"
diameter = "6 mm"
insert = "positions"
positions = [[0.025, 0.025, 0.066], [0.01, 0.04, 0.066]]
motion = "prescribed"
motion_velocity = ["4*cos(150*t)", "40*x", "-1"]
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


# A crowd that spins and collides in a viscous stream.
TURNED = """
[simulation]
end = 0.006
time_step = 2e-5
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.02, 0.02, 0.02]
periodic = [true, true, true]
[contact]
tangential = "history"
[[materials]]
name = "grain"
density = 2500
stiffness = 300
restitution = 0.8
friction = 0.3
[[particles]]
material = "grain"
diameter = 0.002
insert = "random"
count = 150
velocity = { type = "random", deviation = 0.3 }
[flow]
type = "uniform"
velocity = [0.1, 0, 0]
density = 10
viscosity = 0.1
drag = "schiller_naumann"
viscous_torque = "on"
[output]
frames = 0.006
"""


def children_of(pid):
    found = subprocess.run(["pgrep", "-P", str(pid)], capture_output=True, text=True).stdout.split()
    return [int(child) for child in found] + [c for child in found for c in children_of(child)]


def variable(pid, name):
    entries = pathlib.Path(f"/proc/{pid}/environ").read_bytes().split(b"\0")
    return next((e.split(b"=", 1)[1].decode() for e in entries if e.startswith(name.encode() + b"=")), None)


class Ranks(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.work = pathlib.Path(temporary.name)

    def scree(self, ranks, case, output, *words, threads=1):
        (self.work / "case.toml").write_text(case)
        command = [PROGRAM, "run", "case.toml", "-o", output, "--quiet", "--threads", str(threads), *words]
        launcher = [MPIEXEC, "-n", str(ranks)] if ranks > 0 else []
        return subprocess.run(launcher + command, capture_output=True, text=True, cwd=self.work, env=ENVIRONMENT, timeout=2400)

    def run_on(self, ranks, case, output, *words, threads=1):
        result = self.scree(ranks, case, output, *words, threads=threads)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads((self.work / output / "summary.json").read_text())

    def same_files(self, one, other):
        names = sorted(p.relative_to(self.work / one) for p in (self.work / one).rglob("*") if p.is_file())
        self.assertEqual(names, sorted(p.relative_to(self.work / other) for p in (self.work / other).rglob("*")
                                       if p.is_file()))
        for name in names:
            if name.suffix in (".csv", ".xdmf"):
                self.assertEqual((self.work / one / name).read_text(), (self.work / other / name).read_text(), name)
            if name.suffix == ".h5":  # to the last byte
                self.assertTrue((self.work / one / name).read_bytes() == (self.work / other / name).read_bytes(), name)

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
