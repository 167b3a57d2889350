"""Tests of share/plot.py and share/spheres.py. usage: plot_test.py SHARE_DIRECTORY"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import matplotlib
import matplotlib.image
import numpy as np

SHARE = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(SHARE))

matplotlib.use("Agg")
import plot_particles  # noqa: E402
import plot_series  # noqa: E402
import shapes  # noqa: E402
import spheres  # noqa: E402
import walls  # noqa: E402


def write_frame(path, position, diameter, velocity, agglomerate=None):
    path.parent.mkdir(parents=True, exist_ok=True)
    with h5py.File(path, "w") as file:
        file.attrs["time"] = 0.25
        file.attrs["domain_min"] = [0.0, 0.0, 0.0]
        file.attrs["domain_max"] = [1.0, 1.0, 1.0]
        particles = file.create_group("particles")
        particles["position"], particles["diameter"], particles["velocity"] = position, diameter, velocity
        if agglomerate is not None:
            particles["agglomerate"] = agglomerate
            particles["agglomerate_size"] = [max(1, np.sum(agglomerate == a) * (a >= 0)) for a in agglomerate]


def write_series(path, names):
    time = np.linspace(0, 2, 30)
    columns = [time if name == "time" else 1 + np.sin(time) for name in names]
    np.savetxt(path, np.transpose(columns), delimiter=",", header=",".join(names), comments="")


def plot(directory):
    return subprocess.run([sys.executable, "-B", SHARE / "plot.py", directory], capture_output=True, text=True)


class Pictures(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)

    def painted(self, name):
        """Fractions of the picture that are not white, and that have a colour."""
        picture = matplotlib.image.imread(self.directory / name)[..., :3]
        return np.mean(picture.min(axis=2) < 0.98), np.mean(np.ptp(picture, axis=2) > 0.15)

    def test_a_frame_without_the_fields_of_the_picture_is_left_out_with_a_word(self):
        write_frame(self.directory / "frames" / "frame_000000.h5", [[0.5, 0.5, 0.5]], [0.1], [[0, 0, 0]])
        with h5py.File(self.directory / "frames" / "frame_000000.h5", "a") as file:
            del file["particles/diameter"]
        result = plot(self.directory)
        self.assertIn("does not hold diameter (output.fields)", result.stderr)
        self.assertFalse((self.directory / "particles.png").exists())

    def drawn(self, *particles):
        frame = self.directory / "frame.h5"
        write_frame(frame, *particles)
        return matplotlib.image.imread(plot_particles.draw(frame, self.directory, pixels=500)[0])[..., :3]

    def test_agglomerates_are_drawn_in_colour(self):
        position = np.random.default_rng(1).random((300, 3))
        frame = self.directory / "frames" / "frame_000003.h5"
        write_frame(frame, position, np.full(300, 0.08), 0 * position, np.repeat(np.arange(100), 3))
        agglomerates = ["agglomerates", "agglomerated_fraction", "largest_agglomerate", "mean_agglomerate_size",
                        "fractal_dimension", "fractal_dimension_error", "coordination_number"]
        write_series(self.directory / "series.csv", ["time", "kinetic_energy", "energy_error", "energy_turnover", "contacts",
                                                     "max_overlap", "max_speed", *agglomerates])
        result = plot(self.directory)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        self.assertEqual(result.stdout.split(), [str(self.directory / n) for n in ("series.png", "particles.png")])
        ink, colour = self.painted("particles.png")
        self.assertGreater(ink, 0.2)
        self.assertGreater(colour, 0.1)
        ink, colour = self.painted("series.png")
        self.assertGreater(ink, 0.02)
        self.assertGreater(colour, 0.005)

    def test_series_show_what_passes_and_what_walls_bear(self):
        usual = ["time", "energy_error", "energy_turnover", "contacts", "max_overlap"]
        more = ["inserted_mass", "removed_mass", "outlet_out_mass", "mouth_count", "mouth_against", "mouth_mass", "mouth_rate",
                *(f"floor_{what}_{x}" for what in ("force", "torque") for x in "xyz")]
        titles = {}
        for names in (usual, usual + more):
            write_series(self.directory / "series.csv", names)
            series = plot_series.read_series(self.directory / "series.csv")
            titles[len(names)] = [panel.__name__ for panel in plot_series.panels_of(series)]
            self.assertIsNotNone(plot_series.draw(self.directory / "series.csv", self.directory / "series.png"))
        few, all_of_them = titles.values()
        self.assertEqual(all_of_them, few + ["draw_passage", "draw_planes", "draw_forces", "draw_torques"])

    def test_a_pressure_drop_and_temperatures_have_panels_where_there_are_any(self):
        names = ["time", "contacts", "max_overlap", "pressure_drop",
                 *(f"particle_temperature_{what}" for what in ("lowest", "mean", "highest"))]
        write_series(self.directory / "series.csv", names)
        series = plot_series.read_series(self.directory / "series.csv")
        titles = lambda: [panel.__name__ for panel in plot_series.panels_of(series)]
        self.assertEqual(titles()[:2], ["draw_pressure_drop", "draw_temperatures"])
        self.assertIsNotNone(plot_series.draw(self.directory / "series.csv", self.directory / "series.png"))
        series["pressure_drop"][:] = 0
        self.assertNotIn("draw_pressure_drop", titles())
        del series["particle_temperature_mean"]
        self.assertNotIn("draw_temperatures", titles())

    def test_groups_have_a_picture_of_their_own(self):
        frame = self.directory / "frame.h5"
        write_frame(frame, [[0.3, 0.5, 0.5], [0.7, 0.5, 0.5]], [0.4, 0.4], [[0, 0, 0], [0, 0, 0]])
        with h5py.File(frame, "a") as file:
            file["particles/group"] = np.array([0, 1])
        paths = plot_particles.draw(frame, self.directory, pixels=500)
        self.assertEqual(paths, [self.directory / "particles.png", self.directory / "groups.png"])
        by_speed, by_group = (matplotlib.image.imread(p)[..., :3] for p in paths)
        red = lambda picture: np.mean(picture[..., 0] > picture[..., 2] + 0.2)
        self.assertGreater(red(by_group), red(by_speed) + 0.005)

    def test_speed_is_the_colour(self):
        position = np.array([[0.3, 0.5, 0.5], [0.7, 0.5, 0.5]])
        slow = self.drawn(position, [0.4, 0.4], 0 * position)
        fast = self.drawn(position, [0.4, 0.4], [[0, 0, 0], [3, 4, 0]])

        def yellow(picture):
            return np.mean((picture[..., 0] > 0.6) & (picture[..., 2] < 0.4))

        self.assertGreater(yellow(fast), yellow(slow) + 0.005)

    def test_walls_are_drawn_where_they_are_and_hidden_behind_particles(self):
        frame = self.directory / "frames" / "frame_000002.h5"
        write_frame(frame, [[0.5, 0.5, 0.5]], [0.3], [[0, 0, 0]])
        square = np.array([[0.1, 0.1, 0.9], [0.9, 0.1, 0.9], [0.9, 0.9, 0.9], [0.1, 0.9, 0.9]])
        folder = self.directory / "walls"
        folder.mkdir()
        for number, height in ((0, 0.2), (2, 0.9), (3, 0.4)):
            with h5py.File(folder / f"walls_{number:06}.h5", "w") as file:
                file["points"] = square * [1, 1, 0] + [0, 0, height]
                if number > 0:  # has only moved
                    file.attrs["triangles_in"] = "walls_000000.h5"
                    continue
                file["triangles"], file["wall"] = [[0, 1, 2], [0, 2, 3]], [0, 0]
        points, triangles, wall = walls.read_walls(frame)
        self.assertEqual(set(points[:, 2]), {0.9})
        lines = walls.outline(points, triangles, wall, np.array([0.0, 0, 5]))
        self.assertEqual(len(lines), 4)  # not the diagonal
        self.assertEqual(plot_particles.draw(frame, self.directory, pixels=500), [self.directory / "particles.png"])

    def test_a_directory_that_is_no_run_is_refused(self):
        result = plot(self.directory)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("is it a run directory?", result.stderr)

    def test_nothing_is_drawn_of_nothing(self):
        frame, table = self.directory / "frame.h5", self.directory / "series.csv"
        write_frame(frame, np.zeros((0, 3)), np.zeros(0), np.zeros((0, 3)))
        self.assertEqual(plot_particles.draw(frame, self.directory), [])
        table.write_text("time,contacts,max_overlap\n")
        self.assertIsNone(plot_series.draw(table, self.directory / "none.png"))
        self.assertFalse((self.directory / "none.png").exists())

    def test_thin_layers_and_lone_particles_can_be_drawn(self):
        layer = np.random.default_rng(5).random((50, 3)) * [1, 0.05, 1]
        for particles in ((layer, np.full(50, 0.05), layer), ([[0.5, 0.5, 0.5]], [1e-3], [[0, 0, 0]])):
            picture = self.drawn(*particles)
            self.assertGreater(np.mean(picture.min(axis=2) < 0.9), 0.05)


class Spheres(unittest.TestCase):
    def test_nearest_sphere_is_that_of_brute_force(self):
        random = np.random.default_rng(2)
        count, width, height = 200, 90, 70
        flat = random.uniform(-10, 100, (count, 2))
        depth, radius = random.uniform(0, 30, count), random.uniform(0.9, 25, count)
        owner, buffer = spheres.nearest_spheres(flat, depth, radius, radius, width, height, budget=50_000)
        x, y = np.arange(width) + 0.5, np.arange(height) + 0.5
        square = (x[None, :, None] - flat[:, 0]) ** 2 + (y[:, None, None] - flat[:, 1]) ** 2
        surface = np.where(square < radius**2, depth - np.sqrt(np.maximum(radius**2 - square, 0)), np.inf)
        nearest = surface.min(axis=2)
        self.assertGreater(np.mean(np.isfinite(nearest)), 0.5)
        # Float rounding may move the rim of a sphere by a pixel; nothing else may differ.
        different = ~np.isclose(buffer, nearest, atol=1e-3)
        self.assertLess(different.mean(), 1e-3)
        same = ~different & (owner >= 0)
        self.assertGreater(np.mean(owner[same] == surface.argmin(axis=2)[same]), 0.999)

    def test_camera_sees_what_it_projects(self):
        random = np.random.default_rng(3)
        low, high = np.array([-1.0, 2.0, 5.0]), np.array([3.0, 3.0, 9.0])
        camera = spheres.Camera(low, high, -50.0, 25.0, pixels=400)
        points = low + (high - low) * random.random((100, 3))
        flat, depth, magnification = camera.project(points)
        np.testing.assert_allclose(camera.positions(flat[:, 0], flat[:, 1], depth), points, atol=1e-12)
        self.assertTrue(np.all((flat > 0) & (flat < [camera.width, camera.height])))
        # Nearer to the viewer is larger.
        self.assertTrue(np.all(np.diff(magnification[np.argsort(depth)]) <= 0))

    def test_a_sphere_shadows_what_lies_behind_it(self):
        map_of_light = spheres.ShadowMap(np.array([[0.0, 0.0, 2.0]]), np.array([0.5]), np.array([0.0, 0.0, 1.0]), 400)
        below = np.array([[0.0, 0.0, 0.0], [0.4, 0.0, 0.0], [0.0, 0.0, 3.0], [0.2, 0.1, 1.2]])
        np.testing.assert_array_equal(map_of_light.shade(below, 0.01, 1, 5), [1, 1, 0, 1])

class Shapes(unittest.TestCase):
    def test_lines_of_sight_meet_the_surface_first_where_a_fine_search_says(self):
        random = np.random.default_rng(4)
        count = 300
        turn = random.normal(size=(count, 4))
        turn /= np.linalg.norm(turn, axis=1)[:, None]
        half_axes, exponents = random.uniform(0.5, 2, (count, 3)), random.uniform(0.2, 1.6, (count, 2))
        bodies = shapes.Shapes(turn, half_axes, exponents)
        x, y = random.uniform(-0.8, 0.8, (2, count))
        view = spheres.view_axes(40.0, 20.0)
        found = bodies.heights(np.arange(count), x, y, view)
        line = np.linspace(1, -1, 4001)
        expected = np.full(count, np.nan)
        for k in range(count):
            seen = np.stack([np.full_like(line, x[k]), np.full_like(line, y[k]), line], axis=1) * bodies.radius[k]
            own = seen @ view @ shapes.rotations(turn[k : k + 1])[0] / half_axes[k]
            e1, e2 = exponents[k]
            flat = (np.abs(own[:, 0]) ** (2 / e2) + np.abs(own[:, 1]) ** (2 / e2)) ** (e2 / e1)
            inside = np.nonzero(flat + np.abs(own[:, 2]) ** (2 / e1) < 1)[0]
            if len(inside):
                expected[k] = line[inside[0]]
        self.assertGreater(np.mean(np.isnan(expected)), 0.1)
        self.assertGreater(np.mean(~np.isnan(expected)), 0.3)
        self.assertLess(np.mean(np.isnan(found) != np.isnan(expected)), 0.01)  # some graze
        both = ~np.isnan(found + expected)
        self.assertLess(np.quantile(np.abs(found - expected)[both], 0.98), 5e-3)

    def test_a_shape_from_a_file_looks_as_its_formula_says(self):
        rings, spokes = 32, 64
        polar, around = np.meshgrid(np.pi * np.arange(1, rings) / rings, 2 * np.pi * np.arange(spokes) / spokes, indexing="ij")
        flat = np.sin(polar)
        ways = np.stack([flat * np.cos(around), flat * np.sin(around), np.cos(polar)], axis=-1).reshape(-1, 3)
        ways = np.concatenate([[[0, 0, 1]], ways, [[0, 0, -1]]])
        value, slope = shapes.gauge(ways, np.tile([4.0, 2.0], (len(ways), 1)))
        points, normals = ways / value[:, None], slope / np.linalg.norm(slope, axis=1)[:, None]
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory) / "shape_1.obj"
            path.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in points) + "".join(f"vn {x} {y} {z}\n" for x, y, z in normals))
            surface = shapes.Surface(path)
        self.assertEqual((surface.rings, surface.spokes), (rings, spokes))
        places = np.random.default_rng(5).normal(size=(2000, 3))
        expected, gradient = shapes.gauge(places, np.tile([4.0, 2.0], (len(places), 1)))
        found, found_gradient = surface.gauge(places)
        np.testing.assert_allclose(found, expected, rtol=3e-3)
        self.assertLess(np.max(np.linalg.norm(found_gradient - gradient, axis=1)), 0.05)
        turn, axes = np.array([[1.0, 0, 0, 0]] * 2), np.array([[2.0, 1.0, 0.5]] * 2)
        bodies = shapes.Shapes(turn, axes, np.array([[0.5, 1.0], [1.0, 1.0]]), np.array([-1, 1]), {1: surface})
        self.assertAlmostEqual(bodies.radius[0], bodies.radius[1], delta=0.01)

    def test_normals_of_an_ellipsoid(self):
        bodies = shapes.Shapes(np.array([[1.0, 0, 0, 0]]), np.array([[2.0, 1.0, 0.5]]), np.ones((1, 2)))
        place = np.array([0.6, 0.64, 0.48]) * [2.0, 1.0, 0.5] / bodies.radius[0]
        found = bodies.normals(np.array([0]), place[:1], place[1:2], place[2:], np.eye(3))[0]
        expected = np.array([0.6, 0.64, 0.48]) / [2.0, 1.0, 0.5]
        np.testing.assert_allclose(found, expected / np.linalg.norm(expected), atol=1e-6)


if __name__ == "__main__":
    unittest.main()
