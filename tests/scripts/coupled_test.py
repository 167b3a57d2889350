"""Particles in a fluid that is solved for: restarts, ranks, threads. usage: coupled_test.py PROGRAM MPIEXEC"""

import csv
import re
import shutil
import subprocess
import unittest

import h5py
import numpy

from ranks_common import ENVIRONMENT, PROGRAM, Ranks

# A small bed that is blown up, on cells of two kinds, with bodies of two shapes.
BED = """
[simulation]
end = 0.02
time_step = 2e-5
[domain]
min = [0, 0, 0]
max = [0.016, 0.032, 0.008]
periodic = [false, false, true]
[gravity]
type = "uniform"
acceleration = [0, -9.81, 0]
[contact]
normal = "linear"
tangential = "history"
[[materials]]
name = "seed"
density = 1000
stiffness = 20
restitution = 0.9
friction = 0.2
heat_capacity = 900
conductivity = 2
[heat]
type = "solved"
every = 3
[[particles]]
name = "balls"
temperature = 360
material = "seed"
diameter = 0.0012
insert = "random"
count = 300
region_min = [0, 0.001, 0]
region_max = [0.016, 0.012, 0.008]
[[particles]]
name = "rods"
temperature = 290
material = "seed"
shape = "ellipsoid"
half_axes = [0.0015, 0.0006, 0.0006]
insert = "random"
count = 60
region_min = [0, 0.013, 0]
region_max = [0.016, 0.024, 0.008]
[[walls]]
name = "box"
material = "seed"
type = "box"
min = [0, 0, -1]
max = [0.016, 0.032, 1]
temperature = 340
[fluid]
type = "incompressible"
density = 1.2
viscosity = 1.8e-5
cells = [6, 12, 4]
x = [{ to = 0.016, cells = 6, ratio = 2 }]
convection = "van_leer"
[fluid.heat]
type = "solved"
heat_capacity = 1000
conductivity = 0.025
temperature = "300"
[[fluid.patches]]
name = "in"
face = "y_min"
type = "inlet"
velocity = ["0", "0.9", "0"]
temperature = "310"
[[fluid.patches]]
name = "out"
face = "y_max"
type = "outlet"
[coupling]
subcycles = 9
[output]
series = 0.0025
frames = 0.005
checkpoints = 0.0102
"""

# Particles that go with a uniform flow, over cells of several widths and through the faces between processes.
UNIFORM = """
[simulation]
end = 0.002
time_step = 2e-5
[domain]
min = [0, 0, 0]
max = [0.02, 0.02, 0.02]
periodic = [true, true, true]
[contact]
normal = "linear"
[[materials]]
name = "grain"
density = 2500
stiffness = 300
restitution = 0.8
[[particles]]
name = "cloud"
material = "grain"
diameter = 0.002
insert = "random"
count = 150
velocity = [3, -2, 1]
[fluid]
type = "incompressible"
density = 10
viscosity = 1e-3
cells = [6, 4, 4]
x = [{ to = 0.02, cells = 6, ratio = 2 }]
velocity = ["3", "-2", "1"]
divergence_tolerance = 1e-12
[coupling]
drag = "none"
pressure_force = false
subcycles = 10
[output]
frames = 0.002
"""

FEED = """
[[particles]]
name = "rain"
temperature = 300
material = "seed"
shape = "ellipsoid"
half_axes = [0.001, 0.0005, 0.0005]
orientation = { type = "random" }
insert = "rate"
number_rate = 3000
region_min = [0.001, 0.024, 0.001]
region_max = [0.015, 0.028, 0.007]
velocity = [0, -0.5, 0]
max_delay = 1
"""


class Coupled(Ranks):
    def run_case(self, name, *options, ranks=0, threads=1):
        return self.run_on(ranks, BED, name, *options, threads=threads)

    def fraction(self, name, frame):
        with h5py.File(self.work / name / "fluid" / f"fluid_{frame:06}.h5") as file:
            return file["fields/void_fraction"][:]

    def test_threads_restart_and_ranks(self):
        whole = self.run_case("whole")
        self.assertEqual(whole["status"], "finished")
        self.assertLess(whole["ledger"]["coupling_error"], 1e-12 * 9.81 * 3e-4 * 0.02)
        threads = self.run_case("threads", threads=2)
        self.assertEqual((threads["state_hash"], threads["fluid_hash"]), (whole["state_hash"], whole["fluid_hash"]))

        # In the middle of a step of the fluid.
        self.run_case("pieces", "--until", "0.0102", threads=2)
        pieces = self.run_case("pieces", "--restart", "latest")
        self.assertEqual((pieces["state_hash"], pieces["fluid_hash"]), (whole["state_hash"], whole["fluid_hash"]))
        self.assertEqual((self.work / "pieces" / "series.csv").read_text().splitlines()[-1].split(",")[:20],
                         (self.work / "whole" / "series.csv").read_text().splitlines()[-1].split(",")[:20])

        for ranks in (2, 3):
            name = f"on{ranks}"
            shared = self.run_case(name, ranks=ranks)
            self.assertEqual(shared["status"], "finished")
            # The same void fraction to the last bit, as long as the particles are the same.
            numpy.testing.assert_array_equal(self.fraction(name, 0), self.fraction("whole", 0))
            numpy.testing.assert_allclose(self.fraction(name, 1), self.fraction("whole", 1), atol=1e-6)
            self.assertLess(shared["ledger"]["coupling_error"], 1e-12 * 9.81 * 3e-4 * 0.02)

    def test_check_tells_the_room_for_it(self):
        self.run_on(0, BED, "run", "--set", "simulation.end=0.002", "--set", "output.frames=0.001")
        case = self.work / "run" / "case.toml"
        report = subprocess.run([PROGRAM, "check", str(case)], capture_output=True, text=True, env=ENVIRONMENT).stdout
        told = float(re.search(r"disk +up to ([0-9.]+) kB", report).group(1)) * 1000
        taken = sum(p.stat().st_size for p in (self.work / "run").rglob("*") if p.is_file())
        self.assertLess(taken, told)
        self.assertGreater(taken, 0.3 * told)

    def test_a_restart_keeps_the_steps_of_the_fluid(self):
        # Where nothing moves yet, they are a hundredth of the run.
        still = BED.replace("subcycles = 9", "").replace('"0.9"', '"0"')
        self.run_on(0, still, "kept", "--until", "0.001", "--set", "simulation.end=0.008")
        self.run_on(0, still, "kept", "--restart", "latest", "--until", "0.0016", "--set", "simulation.end=0.02",
                    "--set", "output.series=0.0004")
        with open(self.work / "kept" / "series.csv") as file:
            steps = [float(row["fluid_time_step"]) for row in csv.DictReader(file)]
        self.assertEqual(steps[-1], 4 * 2e-5)

    def test_a_restart_on_two_processes(self):
        short = ("--set", "simulation.end=0.006")
        case = BED.replace("0.0102", "0.0031")
        whole = self.run_on(2, case, "whole", *short)
        self.run_on(2, case, "pieces", "--until", "0.0031", *short)
        pieces = self.run_on(2, case, "pieces", "--restart", "latest", *short)
        self.assertEqual((pieces["state_hash"], pieces["fluid_hash"]), (whole["state_hash"], whole["fluid_hash"]))
        # What one process has begun, two go on with.
        self.run_on(0, case, "one", "--until", "0.0031", *short)
        more = self.run_on(2, case, "one", "--restart", "latest", *short)
        self.assertEqual(more["status"], "finished")
        self.assertLess(more["ledger"]["coupling_error"], 1e-12 * 9.81 * 3e-4 * 0.006)

    def test_a_restart_keeps_what_a_liquid_owes(self):
        # It makes way for the particles with a lag.
        case = BED.replace("0.0102", "0.0031").replace("density = 1.2", "density = 1500").replace("1.8e-5", "1e-3")
        case = case.replace('"0.9"', '"0.03"')
        short = ("--set", "simulation.end=0.006")
        whole = self.run_on(0, case, "whole", *short)
        self.assertLess(whole["ledger"]["coupling_error"], 1e-12 * 9.81 * 3e-4 * 0.006)
        self.run_on(0, case, "pieces", "--until", "0.0031", *short)
        with h5py.File(next((self.work / "pieces" / "checkpoints").glob("*.h5"))) as file:
            owed = []
            file.visititems(lambda name, data: owed.append(abs(data[:]).max()) if "coupling_owed_y" in name else None)
        self.assertGreater(owed[0], 1e-13)  # a ten-thousandth of a ball
        shutil.copytree(self.work / "pieces", self.work / "on2")
        pieces = self.run_on(0, case, "pieces", "--restart", "latest", *short)
        self.assertEqual((pieces["state_hash"], pieces["fluid_hash"]), (whole["state_hash"], whole["fluid_hash"]))
        shared = self.run_on(2, case, "on2", "--restart", "latest", *short)
        with open(self.work / "whole" / "series.csv") as file:
            self.assertGreater(float(list(csv.DictReader(file))[-1]["fluid_lag"]), 0.1)
        # The piece that was stopped has ended with a frame.
        numpy.testing.assert_allclose(self.fraction("on2", 2), self.fraction("whole", 1), atol=1e-9)
        self.assertLess(shared["ledger"]["coupling_error"], 1e-12 * 9.81 * 3e-4 * 0.006)

    def test_particles_that_come_in_between_are_not_turned_by_a_fluid_that_they_have_not_met(self):
        case = BED.replace("subcycles = 9\n", "subcycles = 9\ndrag = 'holzer_sommerfeld'\n") + FEED
        ends = self.run_on(0, case, "fed", "--set", "simulation.end=0.006")
        self.assertEqual(ends["status"], "finished")
        with open(self.work / "fed" / "series.csv") as file:
            rows = list(csv.DictReader(file))
        self.assertGreater(float(rows[-1]["particles"]), float(rows[0]["particles"]) + 5)
        for row in rows:
            for name in ("rotational_energy", "angular_momentum_x", "work_drag", "energy_error", "fluid_momentum_y"):
                self.assertTrue(numpy.isfinite(float(row[name])), name)

    def test_all_forces(self):
        forces = ("drag = 'holzer_sommerfeld'\nsaffman = true\nmagnus = true\nadded_mass = true\nviscous_stress = true\n"
                  "pitching_torque = 'on'\nviscous_torque = 'on'\n")
        case = BED.replace("subcycles = 9\n", "subcycles = 9\n" + forces).replace("0.0102", "0.0031")
        short = ("--set", "simulation.end=0.006")
        whole = self.run_on(0, case, "whole", *short)
        self.assertEqual(whole["status"], "finished")
        self.assertLess(whole["ledger"]["coupling_error"], 1e-12 * 9.81 * 3e-4 * 0.006)
        self.run_on(0, case, "pieces", "--until", "0.0031", *short, threads=2)
        pieces = self.run_on(0, case, "pieces", "--restart", "latest", *short, threads=2)
        self.assertEqual((pieces["state_hash"], pieces["fluid_hash"]), (whole["state_hash"], whole["fluid_hash"]))
        shared = self.run_on(2, case, "on2", *short)
        self.assertEqual(shared["status"], "finished")
        numpy.testing.assert_allclose(self.fraction("on2", 1), self.fraction("whole", 1), atol=1e-6)
        self.assertLess(shared["ledger"]["coupling_error"], 1e-12 * 9.81 * 3e-4 * 0.006)

    def test_copies_on_other_processes_turn_as_their_originals_do(self):
        # Else contacts across the border of two processes are not equal and opposite.
        case = UNIFORM.replace("velocity = [3, -2, 1]", 'velocity = { type = "random", deviation = 0.3 }')
        case = case.replace("restitution = 0.8", "restitution = 0.8\nfriction = 0.3").replace("1e-3", "0.1")
        case = case.replace('"linear"', '"linear"\ntangential = "history"').replace("end = 0.002", "end = 0.01\nmax_overlap = 0.9")
        case = case.replace('drag = "none"', 'drag = "di_felice"\nviscous_torque = "on"')
        shared = self.run_on(2, case, "on2")
        self.assertGreater(shared["contacts"], 1000)
        self.assertLess(abs(shared["ledger"]["momentum_error"]), 1e-18)

    def test_a_uniform_flow_stays_uniform_on_any_number_of_processes(self):
        for ranks in (1, 2, 3):
            name = f"on{ranks}"
            self.assertEqual(self.run_on(ranks, UNIFORM, name)["status"], "finished")
            with h5py.File(self.work / name / "fluid" / "fluid_000001.h5") as file:
                numpy.testing.assert_allclose(file["fields/velocity"][:].reshape(-1, 3), [[3, -2, 1]] * 96, atol=1e-10)
            numpy.testing.assert_array_equal(self.fraction(name, 1), self.fraction("on1", 1))
        self.assertGreater(numpy.ptp(self.fraction("on1", 1)), 0.02)


if __name__ == "__main__":
    unittest.main()
