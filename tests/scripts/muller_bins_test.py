"""Volumes of spheres in boxes (validation/muller/bins.py) against cut balls, sums over parts and counted points."""

import itertools
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "validation" / "muller"))
import bins

BALL = 4 * np.pi / 3


class VolumeInBox(unittest.TestCase):
    def test_planes_through_the_centre_halve_the_ball(self):
        for low in itertools.product((-2.0, 0.0), repeat=3):
            part = 0.5 ** sum(side == 0 for side in low)
            self.assertAlmostEqual(bins.volume_in_box(np.zeros(3), 1.0, low, np.full(3, 2.0))[0], part * BALL, places=12)

    def test_a_cap_is_that_of_archimedes(self):
        for axis, height in itertools.product(range(3), (0.1, 0.7, 1.0, 1.6)):
            low = np.full(3, -2.0)
            low[axis] = 1 - height
            found = bins.volume_in_box(np.zeros(3), 1.0, low, np.full(3, 2.0))[0]
            self.assertAlmostEqual(found, np.pi * height**2 * (3 - height) / 3, places=12)

    def test_parts_add_up_to_the_whole(self):
        source = np.random.default_rng(5)
        total = np.zeros(200)
        centre, cuts = source.uniform(-0.5, 0.5, (200, 3)), np.array([-3.0, -0.9, -0.2, 0.1, 1.1, 3.0])
        for cell in itertools.product(range(5), repeat=3):
            part = bins.volume_in_box(centre, 0.8, cuts[list(cell)], cuts[[c + 1 for c in cell]])
            self.assertGreater(part.min(), -1e-7)
            total += part
        np.testing.assert_allclose(total, BALL * 0.8**3, rtol=1e-12)

    def test_counted_points(self):
        source = np.random.default_rng(6)
        side = (np.arange(100) + 0.5) / 50 - 1
        points = np.stack(np.meshgrid(side, side, side), axis=-1).reshape(-1, 3)
        points = points[np.sum(points**2, axis=1) < 1]
        low = source.uniform(-1.2, 0.6, (40, 3))
        high = low + source.uniform(0.1, 2.0, (40, 3))
        found = bins.volume_in_box(np.zeros((40, 3)), 1.0, low, high)
        counted = [np.sum(np.all((points > a) & (points < b), axis=1)) / 50**3 for a, b in zip(low, high)]
        np.testing.assert_allclose(found, counted, atol=0.02)


class Profiles(unittest.TestCase):
    def test_a_profile_holds_all_volume_and_its_mean_velocity(self):
        source = np.random.default_rng(7)
        place, speed = source.uniform((0.1, 0.1, 0.1), (0.9, 0.9, 0.9), (50, 3)), source.normal(size=50)
        profile = bins.Profile(np.linspace(0, 1, 11), (0.0, 1.0), (0.0, 1.0))
        profile.add(place, speed, 0.05)
        self.assertAlmostEqual(np.sum(0.1 * (1 - profile.void_fraction())), 50 * BALL * 0.05**3, places=12)
        carried = np.sum(profile.solids * profile.velocity())
        self.assertAlmostEqual(carried, np.sum(speed) * BALL * 0.05**3, places=12)


if __name__ == "__main__":
    unittest.main()
