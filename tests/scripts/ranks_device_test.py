"""Runs on several processes, each with an OpenCL device: what one process on the processors gives. usage:
ranks_device_test.py PROGRAM MPIEXEC"""

import csv
import json
import os
import re
import unittest

# Processes share the processors that PoCL makes a device of: each of them is to take one.
os.environ["POCL_MAX_PTHREAD_COUNT"] = "1"

from ranks_common import CROWD, SHAPES_COME, SPHERES_COME, STIRRERS, TURNED, Ranks

# Everything swarms to one corner: blocks are cut anew, and everybody there changes the rank.
SWARM = """
[simulation]
end = 0.015
time_step = 1e-5
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.06, 0.06, 0.06]
periodic = [true, false, false]
[gravity]
type = "uniform"
acceleration = [400, -300, -300]
[[materials]]
name = "glass"
density = 2000
stiffness = 1000
restitution = 0.5
friction = 0.3
[[particles]]
name = "grains"
material = "glass"
diameter = { distribution = "uniform", min = "2 mm", max = "3 mm" }
insert = "random"
count = 400
velocity = { type = "random", deviation = 0.5 }
[[walls]]
name = "room"
type = "box"
material = "glass"
min = [-0.05, 0, 0]
max = [0.1, 0.06, 0.06]
[output]
series = "5 ms"
"""

# Bodies of several shapes are driven into a corner, inside and outside of a tube, which rods touch at both ends: blocks are cut
# anew, and many change the rank while they touch each other and walls.
BODIES = """
[simulation]
end = 0.01
time_step = 2e-5
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.05, 0.05, 0.06]
periodic = [true, false, false]
[gravity]
type = "uniform"
acceleration = [300, 250, -300]
[contact]
rolling = "spring"
twisting = "spring"
[[materials]]
name = "glass"
density = 2000
stiffness = 2000
restitution = 0.6
friction = 0.3
rolling_friction = 0.02
twisting_friction = 0.1
[[particles]]
name = "boxes"
shape = "superellipsoid"
half_axes = [0.003, 0.002, 0.0015]
exponents = [0.4, 0.4]
orientation = { type = "random" }
material = "glass"
insert = "random"
count = 60
velocity = { type = "random", deviation = 0.7 }
[[particles]]
name = "rods"
shape = "capsule"
half_axes = [0.0012, 0.0012, 0.005]
orientation = { type = "random" }
material = "glass"
insert = "random"
count = 40
velocity = { type = "random", deviation = 0.7 }
[[particles]]
name = "balls"
diameter = "4 mm"
material = "glass"
insert = "random"
count = 50
velocity = { type = "random", deviation = 0.7 }
[[walls]]
name = "box"
type = "box"
material = "glass"
min = [-0.05, 0, 0]
max = [0.1, 0.05, 0.06]
[[walls]]
name = "tube"
type = "cylinder"
material = "glass"
start = [0.03, 0.03, 0]
end = [0.03, 0.03, 0.06]
radius = 0.015
[output]
series = "2 ms"
frames = "5 ms"
checkpoints = "5 ms"
contacts = true
"""

# Balls that shoot into dust, so that one rank begins without any of them; there are no walls.
TWO_SIZES = """
[simulation]
end = 0.005
time_step = 1e-5
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.06, 0.02, 0.02]
periodic = [false, true, true]
[[materials]]
name = "glass"
density = 2000
stiffness = 800
restitution = 0.5
friction = 0.3
[[particles]]
name = "dust"
material = "glass"
diameter = "1.2 mm"
insert = "random"
count = 400
region_min = [0, 0, 0]
region_max = [0.042, 0.02, 0.02]
[[particles]]
name = "balls"
material = "glass"
diameter = "7 mm"
insert = "random"
count = 4
region_min = [0.044, 0, 0]
region_max = [0.06, 0.02, 0.02]
velocity = [-8, 0.1, 0]
[output]
series = "5 ms"
"""

# The crowd of the turned ones in a fluid that is solved for; and with rods.
SOLVED = TURNED.split("[flow]")[0].replace("end = 0.006", "end = 0.004") + """
[fluid]
type = "incompressible"
density = 10
viscosity = 0.1
cells = [6, 4, 4]
velocity = ["0.1", "0", "0"]
[coupling]
drag = "di_felice"
added_mass = true
saffman = true
viscous_torque = "on"
subcycles = 13
[output]
series = 0.002
frames = 0.002
"""
SOLVED_RODS = SOLVED.replace("di_felice", "holzer_sommerfeld") + """
[[particles]]
name = "rods"
material = "grain"
shape = "ellipsoid"
half_axes = [0.002, 0.0008, 0.0008]
orientation = { type = "random" }
insert = "random"
count = 40
velocity = { type = "random", deviation = 0.3 }
"""


# Cohesive spheres in a vortex without any wall, which come together while they cross the borders.
VORTEX = """
[simulation]
end = 0.012
time_step = 3e-6
[domain]
min = [0, 0, 0]
max = [0.003, 0.003, 0.003]
periodic = [true, true, true]
[flow]
type = "taylor_green"
amplitude = 0.14
wavenumber = 2094.3951023931953
density = 1.2
viscosity = 1.8e-5
drag = "stokes"
[contact]
cohesion = "linear"
[[materials]]
name = "powder"
density = 1000
stiffness = 0.5
restitution = 0.5
friction = 0.3
cohesion_stiffness = 0.02
[[particles]]
name = "grains"
material = "powder"
diameter = 1e-4
effect_gap = 1e-5
insert = "random"
count = 1200
velocity = { type = "fluid" }
[output]
series = 0.012
[analysis]
agglomerates = true
"""


class OnDevices(Ranks):
    def same_on_devices(self, case, ranks):
        alone = self.run_on(0, case, "alone")
        self.assertGreater(alone["contacts"], 500)
        for n in ranks:
            shared = self.run_on(n, case, f"on{n}", "--device", "opencl")
            for key in ("state_hash", "steps", "particles", "contacts", "wall_contacts", "ledger"):
                self.assertEqual(shared[key], alone[key], (n, key))
            self.assertEqual(shared["ranks"], n)
            self.assertIn("device", shared["stages"])
            self.same_files("alone", f"on{n}")
        return alone

    def test_a_crowd_through_periodic_faces_walls_and_cuts(self):
        self.same_on_devices(CROWD, [2, 3])

    def test_a_swarm_for_which_blocks_are_cut_anew(self):
        self.same_on_devices(SWARM, [4])
        shared = json.loads((self.work / "on4/summary.json").read_text())
        self.assertLess(shared["sharing"]["most_particles"], 1.3 * shared["particles"] / 4)

    def test_a_vortex_without_walls(self):
        self.same_on_devices(VORTEX, [2])

    def test_particles_that_come_and_go(self):
        self.same_on_devices(SPHERES_COME, [2])

    def test_bodies_of_any_shape_in_a_swarm_that_goes_on_on_another_number_of_devices(self):
        alone = self.same_on_devices(BODIES, [2])
        self.run_on(2, BODIES, "parts", "--device", "opencl", "--until", "0.005")
        gone_on = self.run_on(3, BODIES, "parts", "--device", "opencl", "--restart", "latest")
        for key in ("state_hash", "contacts", "wall_contacts", "ledger"):
            self.assertEqual(gone_on[key], alone[key], key)

    def test_bodies_of_any_shape_that_come_and_go(self):
        self.same_on_devices(SHAPES_COME.replace("end = 0.06", "end = 0.006"), [2])

    def test_bodies_that_no_other_rank_has_the_size_of(self):
        self.same_on_devices(TWO_SIZES, [2])

    def same_in_a_fluid(self, case):
        # The fluid's bits are those of as many processes.
        host = self.run_on(2, case, "host")
        self.assertGreater(host["contacts"], 300)
        device = self.run_on(2, case, "device", "--device", "opencl")
        for key in ("state_hash", "fluid_hash", "steps", "contacts"):
            self.assertEqual(device[key], host[key], key)
        for frame in (self.work / "host").glob("f*/*.h5"):
            there = self.work / "device" / frame.relative_to(self.work / "host")
            self.assertEqual(there.read_bytes(), frame.read_bytes(), frame.name)
        # Rounding in the books of the exchange is that of sums over the particles of each rank, which may have other blocks.
        rows = [[{name: value for name, value in row.items() if name != "coupling_error"}
                 for row in csv.DictReader((self.work / name / "series.csv").read_text().splitlines())]
                for name in ("host", "device")]
        self.assertEqual(*rows)
        self.assertLess(device["ledger"]["coupling_error"], 1e-18)

    def test_spheres_in_a_fluid_that_is_solved_for(self):
        self.same_in_a_fluid(SOLVED)

    def test_bodies_of_any_shape_in_a_fluid_that_is_solved_for(self):
        self.same_in_a_fluid(SOLVED_RODS)

    def test_torques_of_a_stream_turn_copies_too(self):
        self.same_on_devices(TURNED, [2])

    def test_a_stream_that_is_no_number_on_one_device_stops_all(self):
        # In the middle of a block, of which the other rank has no copies.
        lost = TURNED.replace('type = "uniform"\nvelocity = [0.1, 0, 0]',
                              'type = "expression"\nexpression = ["sqrt(t < 0.00305 ? x : abs(z - 0.015) - 0.0005)", "0", "0"]')
        # Between two rows of the series, so that the device finds it and not who looks.
        lost += "series = 0.002\n"
        said = [self.scree(n, lost, f"lost{n}", *words).stderr for n, words in ((0, []), (2, ["--device", "opencl"]))]
        self.assertIn("no finite number", said[0])
        self.assertEqual(*[re.search(r"t = .*no finite number[^\n]*", text)[0] for text in said])
        ended = [json.loads((self.work / f"lost{n}/summary.json").read_text()) for n in (0, 2)]
        for key in ("steps", "state_hash"):
            self.assertEqual(ended[1][key], ended[0][key], key)

    def test_a_restart_on_another_number_of_devices(self):
        case = CROWD + STIRRERS
        alone = self.run_on(0, case, "alone")
        self.assertGreater(abs(alone["ledger"]["work_prescribed"]), 0)
        self.run_on(2, case, "parts", "--device", "opencl", "--until", "0.02")
        gone_on = self.run_on(3, case, "parts", "--device", "opencl", "--restart", "latest")
        self.assertEqual(gone_on["state_hash"], alone["state_hash"])
        self.assertEqual(gone_on["ledger"], alone["ledger"])

    def fails_alike(self, case):
        said = [self.scree(n, case, f"fails{n}", *words).stderr
                for n, words in ((0, []), (2, ["--device", "opencl"]))]
        self.assertIn("overlap", said[0])
        self.assertEqual(*[re.search(r"t = .*overlap[^\n]*", text)[0] for text in said])

    def test_what_goes_wrong_stops_all_in_the_same_step(self):
        self.fails_alike(CROWD.replace("max_overlap = 0.9", "max_overlap = 0.02"))

    def test_bodies_of_any_shape_that_go_wrong_stop_all_in_the_same_step(self):
        self.fails_alike(BODIES.replace("max_overlap = 0.9", "max_overlap = 0.25"))


if __name__ == "__main__":
    unittest.main()
