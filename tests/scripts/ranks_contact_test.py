"""A contact that lies on a cut plane, so that its bodies have different ranks, by vertices: the thesis' figures B-2 and B-3. There
one body has vertices in the other that has none in it, and only one of two processes saw it. usage: ranks_contact_test.py PROGRAM MPIEXEC
"""

import unittest

import h5py
import numpy

from ranks_common import Ranks

SIDE = 12
# Loads of equal bodies put the planes through the watcher, which is where the two meet but far aside: with two ranks one
# plane, with three also one through the centre of the right one, so that they meet in the block of the third.
MEETING = f"""
[simulation]
end = 0.0015
time_step = 1e-5
max_overlap = 0.95
[domain]
min = [0, 0, 0]
max = [0.06, 0.04, 0.03]
[contact]
detection = "vertices"
vertices = {SIDE}
spacing = "linear"
[[materials]]
name = "rubber"
density = 1000
stiffness = 150
restitution = 0.9
friction = 0.4
[[particles]]
name = "left"
material = "rubber"
shape = "ellipsoid"
half_axes = [0.003, 0.0022, 0.0026]
orientation = {{ type = "given", axis = [3, 5, 1], angle = 1.3 }}
insert = "positions"
positions = [[0.0267, 0.0148, 0.015]]
velocity = [0.35, 0.02, 0]
angular_velocity = [0, 20, 30]
[[particles]]
name = "right"
material = "rubber"
shape = "ellipsoid"
half_axes = [0.0021, 0.0014, 0.0016]
orientation = {{ type = "given", axis = [1, -4, 2], angle = 0.9 }}
insert = "positions"
positions = [[0.0313, 0.0155, 0.0153]]
velocity = [-0.35, -0.02, 0.03]
angular_velocity = [40, 0, -20]
[[particles]]
name = "watcher"
material = "rubber"
shape = "ellipsoid"
half_axes = [0.002, 0.002, 0.001]
insert = "positions"
positions = [[0.0297, 0.035, 0.015]]
[output]
series = "1 ms"
frames = "40 us"
contacts = true
fields = ["velocity", "force", "orientation", "half_axes"]
"""


def vertices(half_axes):
    """Of an ellipsoid, in its frame: equal steps of both angles."""
    steps = SIDE - 1
    latitude = numpy.pi / 2 * (2 * numpy.arange(1, steps) - steps)[:, None] / steps
    longitude = numpy.pi * (2 * numpy.arange(steps) - steps)[None, :] / steps
    rings = numpy.stack([numpy.cos(latitude) * numpy.cos(longitude), numpy.cos(latitude) * numpy.sin(longitude),
                         numpy.sin(latitude) + 0 * longitude], axis=-1).reshape(-1, 3)
    return half_axes * numpy.vstack([[0, 0, -1], rings, [0, 0, 1]])


def rotation(quaternion):
    w, x, y, z = quaternion
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def vertices_within(frame, of, other):
    """How many vertices of a body lie in another one."""
    turn = [rotation(frame["orientation"][k]) for k in (of, other)]
    places = frame["position"][of] + vertices(frame["half_axes"][of]) @ turn[0].T
    seen = (places - frame["position"][other]) @ turn[1] / frame["half_axes"][other]
    return numpy.count_nonzero((seen**2).sum(axis=1) < 1)


class ContactOfTwoRanks(Ranks):
    def frames(self, output):
        for path in sorted((self.work / output / "frames").glob("*.h5")):
            with h5py.File(path) as file:
                yield {name: values[()] for name, values in file["particles"].items()}

    def look_at(self, output):
        """How often both, one and none of the two had vertices in the other; forces are equal and opposite to the last bit."""
        found = {"both": 0, "left alone": 0, "right alone": 0, "none": 0}
        for frame in self.frames(output):
            left, right = vertices_within(frame, 0, 1) > 0, vertices_within(frame, 1, 0) > 0
            found["both" if left and right else "left alone" if left else "right alone" if right else "none"] += 1
            self.assertEqual(frame["force"][0].tolist(), (-frame["force"][1]).tolist())
            self.assertEqual(frame["force"][2].tolist(), [0, 0, 0])
            # With vertices of one alone there is no contact (docs/vertices.md), on both ranks.
            self.assertEqual(numpy.abs(frame["force"][0]).max() > 0, left and right)
        return found

    def test_both_bodies_get_equal_and_opposite_forces_however_many_see_it(self):
        alone = self.run_on(0, MEETING, "alone")
        found = self.look_at("alone")
        self.assertGreater(found["both"], 15, found)
        self.assertGreater(found["left alone"] + found["right alone"], 2, found)
        for ranks in (2, 3):
            shared = self.run_on(ranks, MEETING, f"on{ranks}")
            self.assertEqual(shared["state_hash"], alone["state_hash"])
            self.assertGreater(shared["sharing"]["messages"], 0.2)  # between the two: the watcher is far from all
            self.assertEqual(self.look_at(f"on{ranks}"), found)
            self.same_files("alone", f"on{ranks}")


if __name__ == "__main__":
    unittest.main()
