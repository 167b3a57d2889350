"""What compare.py of the example `bed_of_rods` finds in runs whose curves and orientations are known."""

import pathlib
import sys
import tempfile
import unittest

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "examples" / "32_bed_of_rods"))
import compare

CASE = """
[domain]
min = [0, 0, 0]
max = [0.01, 0.02, 0.1]
[gravity]
acceleration = [0, 0, -10]
[[analysis.regions]]
min = [0, 0, 0]
max = [0.01, 0.02, 0.05]
"""
FASTEST, MEETS = 0.7, 0.3  # velocities [m/s]: the largest, and that at which the packed bed takes the weight
WEIGHT = 100.0  # over the area [Pa]
TIMES = np.linspace(0, 2.5, 501)


def air(time):
    return np.interp(time, [0, 0.5, 1.5, 1.6, 2.5], [FASTEST, FASTEST, 0, 0, FASTEST])


def drop(u):
    """Packed as Ergun's equation has it, and no more than the weight."""
    return WEIGHT * np.minimum(1, (0.7 * u / MEETS + 0.3 * (u / MEETS) ** 2))


class Compare(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)
        (self.directory / "case.toml").write_text(CASE)
        rows = np.column_stack([TIMES, -2e-4 * air(TIMES), drop(air(TIMES))])
        np.savetxt(self.directory / "series.csv", rows, delimiter=",", header="time,in_flow,pressure_drop", comments="")
        (self.directory / "frames").mkdir()
        self.write_frame(0, 0.0, 0)
        self.write_frame(1, 0.4, np.pi / 3)
        self.write_frame(2, 1.55, np.pi / 2)

    def write_frame(self, number, time, angle):
        """Four rods, turned from the vertical by an angle about x; the last one is above the region."""
        with h5py.File(self.directory / "frames" / f"frame_{number:06}.h5", "w") as frame:
            frame.attrs["time"] = time
            frame["particles/mass"] = np.full(4, 0.25 * WEIGHT * 2e-4 / 10)
            frame["particles/position"] = np.array([[0.005, 0.01, z] for z in (0, 0.02, 0.04, 0.06)])
            angles = np.array([angle, angle, angle, 0])
            frame["particles/orientation"] = np.column_stack(
                [np.cos(angles / 2), np.sin(angles / 2), np.zeros(4), np.zeros(4)])

    def test_minimum_fluidisation_is_where_the_packed_curve_meets_the_weight(self):
        run = compare.Run(self.directory)
        self.assertAlmostEqual(run.weight, WEIGHT)
        for branch in (run.falling, run.rising):
            self.assertAlmostEqual(run.minimum_fluidisation(branch), MEETS)
        self.assertTrue(np.isnan(run.minimum_fluidisation(slice(0, 0))))

    def test_stages_are_those_of_the_air(self):
        run = compare.Run(self.directory)
        fluidised, at_rest = (run.time[run.stages[name]] for name in ("fluidised", "at rest"))
        self.assertAlmostEqual(fluidised[0], compare.BEGUN)
        self.assertAlmostEqual(fluidised[-1], 0.5 + (FASTEST - compare.FLUIDISED) / FASTEST, delta=0.006)
        self.assertAlmostEqual(at_rest[0], 1.5 - compare.AT_REST / FASTEST, delta=0.006)
        self.assertAlmostEqual(at_rest[-1], 1.6)

    def test_rods_of_the_region_and_the_stage_count(self):
        run = compare.Run(self.directory)
        c, s = np.cos(np.pi / 3), np.sin(np.pi / 3)
        np.testing.assert_allclose(run.long_axes("fluidised"), [[0, -s, c]] * 3, atol=1e-12)
        np.testing.assert_allclose(compare.order(run.long_axes("fluidised")), [0, s * s, c * c, 1], atol=1e-12)
        np.testing.assert_allclose(compare.order(run.long_axes("at rest")), [0, 1, 0, 1], atol=1e-12)

    def test_directions_alike_have_no_order(self):
        np.testing.assert_allclose(compare.order(np.eye(3)), [1 / 3, 1 / 3, 1 / 3, 0], atol=1e-12)


if __name__ == "__main__":
    unittest.main()
