"""Runs on a simulated OpenCL device. usage: device_test.py PROGRAM OCLGRIND WHETHER_IT_SOLVES_FLOWS"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
OCLGRIND = sys.argv.pop(1)
SOLVES_FLOWS = sys.argv.pop(1) == "1"

# What Oclgrind's compiler makes of its best optimisation it cannot run itself. The simulator's own leaks are not for the
# sanitizer of this program to tell. MPI, which looks for devices itself, asks more than the simulator knows.
SIMULATOR = {"OCL_ICD_VENDORS": OCLGRIND, "OCLGRIND_DATA_RACES": "1", "OCLGRIND_UNIFORM_WRITES": "1",
             "OCLGRIND_CHECK_API": "1", "OCLGRIND_BUILD_OPTIONS": "-cl-opt-disable", "OMP_WAIT_POLICY": "passive",
             "ASAN_OPTIONS": "detect_leaks=0", "HWLOC_COMPONENTS": "-opencl"}

# So crowded that cells hold several, and so fast that lists are made again and again.
CROWD = """
[simulation]
end = "18 us"
time_step = "2 us"
skin = "0.02 mm"
[domain]
min = [0, 0, 0]
max = ["8 mm", "8 mm", "8 mm"]
periodic = [true, true, false]
[contact]
normal = "hertz"
tangential = "mindlin"
[[materials]]
name = "grain"
density = "2500 kg/m3"
young = "25 MPa"
poisson = 0.3
restitution = 0.8
friction = 0.5
[[particles]]
name = "bed"
material = "grain"
insert = "random"
count = 70
diameter = { distribution = "uniform", min = "0.8 mm", max = "2.4 mm" }
velocity = {type = "random", deviation = 2}
[[walls]]
name = "floor"
type = "plane"
material = "grain"
point = [0, 0, 0]
normal = [0, 0, 1]
"""

# A flow by formulas that turns and lifts what is in it: a kernel of its own finds this.
FLOW = """
[flow]
type = "expression"
expression = ["200 * y - x * t", "30 * x", "x + y"]
density = "300 kg/m3"
viscosity = "1 mPa s"
drag = "schiller_naumann"
magnus = true
added_mass = true
viscous_torque = "on"
"""

# A flow that is solved for on the processors.
FLUID = """
[fluid]
type = "incompressible"
density = "300 kg/m3"
viscosity = "1 mPa s"
cells = [2, 2, 2]
[coupling]
subcycles = 3
"""

# The simulator takes long for a search: a few bodies, so fast that they soon meet.
BODIES = CROWD.replace("\"18 us\"", "\"20 us\"\nmax_overlap = 0.9").replace("deviation = 2", "deviation = 4").replace("""count = 70
diameter = { distribution = "uniform", min = "0.8 mm", max = "2.4 mm" }
""", """count = 16
shape = "ellipsoid"
half_axes = ["1.3 mm", "1 mm", "0.7 mm"]
orientation = "random"
region_min = [0, 0, 0]
region_max = ["8 mm", "8 mm", "4 mm"]
""") + """
[[particles]]
name = "balls"
material = "grain"
insert = "random"
count = 8
diameter = "1 mm"
region_min = [0, 0, 0]
region_max = ["8 mm", "8 mm", "4 mm"]
velocity = {type = "random", deviation = 4}
[[walls]]
name = "disc"
type = "cone"
material = "grain"
start = ["4 mm", "4 mm", "3.1 mm"]
end = ["4 mm", "4 mm", "3.3 mm"]
start_radius = "1 mm"
end_radius = "0.5 mm"
"""


class Devices(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.work = pathlib.Path(directory.name)
        (self.work / "crowd.toml").write_text(CROWD)
        (self.work / "bodies.toml").write_text(BODIES)

    def scree(self, *arguments, **environment):
        return subprocess.run([PROGRAM, *arguments], cwd=self.work, env=os.environ | SIMULATOR | environment,
                              capture_output=True, text=True)

    def run_on(self, device, case, *more):
        result = self.scree("run", case, "-o", device.replace(":", "_"), "--device", device, "--quiet", "--force", *more)
        self.assertEqual(result.returncode, 0, result.stderr)
        # Whatever the simulator has to say it says there.
        self.assertEqual(result.stderr + result.stdout, "")
        return json.loads((self.work / device.replace(":", "_") / "summary.json").read_text())

    def expect_the_same(self, case, contacts=20):
        alone, device = self.run_on("cpu", case), self.run_on("opencl:0", case)
        self.assertGreater(alone["contacts"], contacts)
        for key in ("state_hash", "contacts", "wall_contacts", "ledger", "fluid_hash"):
            self.assertEqual(device.get(key), alone.get(key), key)
        self.assertIn("device", device["stages"])
        self.assertNotIn("device", alone["stages"])
        return alone

    def test_kernels_neither_race_nor_leave_their_buffers(self):
        self.expect_the_same("crowd.toml")

    def test_fields_neither_race_nor_leave_their_buffers(self):
        (self.work / "flow.toml").write_text(CROWD + FLOW)
        self.expect_the_same("flow.toml")

    def expect_the_same_contacts_in_mixed_precision(self, case):
        alone, device = (self.run_on("cpu", case), self.run_on("opencl:0", case, "--precision", "mixed"))
        for key in ("contacts", "wall_contacts"):
            self.assertEqual(device[key], alone[key], key)
        self.assertEqual((alone["device"], alone["precision"], device["precision"]), ("cpu", "double", "mixed"))
        self.assertIn("Oclgrind", device["device"])

    def test_kernels_in_mixed_precision_do_not_either(self):
        self.expect_the_same_contacts_in_mixed_precision("crowd.toml")

    def test_nor_do_those_of_shapes_in_mixed_precision(self):
        self.expect_the_same_contacts_in_mixed_precision("bodies.toml")

    def test_nor_do_those_of_shapes(self):
        self.assertGreater(self.expect_the_same("bodies.toml", 10)["wall_contacts"], 0)

    def test_nor_does_what_a_flow_does_to_shapes(self):
        (self.work / "flow.toml").write_text(BODIES + FLOW.replace("schiller_naumann", "holzer_sommerfeld"))
        self.expect_the_same("flow.toml", 10)

    @unittest.skipUnless(SOLVES_FLOWS, "this program solves for no flows")
    def test_nor_does_what_a_fluid_has_said_to_them(self):
        for case, drag in ((CROWD, "gidaspow_blend"), (BODIES, "holzer_sommerfeld")):
            (self.work / "fluid.toml").write_text(case + FLUID + f'drag = "{drag}"\nadded_mass = true\n')
            self.expect_the_same("fluid.toml", 10)

    def test_info_lists_devices_and_what_was_tried(self):
        self.assertIn("device opencl:0    Oclgrind", self.scree("info").stdout)
        none = self.scree("info", OCL_ICD_VENDORS=str(self.work)).stdout
        self.assertNotIn("opencl:0", none)
        self.assertIn("knows no platform", none)

    def test_without_devices_a_run_says_what_was_tried(self):
        result = self.scree("run", "crowd.toml", "--device", "opencl", OCL_ICD_VENDORS=str(self.work))
        self.assertEqual(result.returncode, 2)
        self.assertIn("libOpenCL.so.1: knows no platform", result.stderr)
        self.assertFalse((self.work / "runs").exists())


if __name__ == "__main__":
    unittest.main()
