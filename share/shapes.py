"""Bodies as a picture sees them: where a line of sight meets the surface, and which way that faces."""

import numpy as np

LOOKS = 30
CLOSE = 1e-3  # of a gauge


def rotations(quaternions):
    """Matrices from the axes of the bodies to those of space."""
    w, x, y, z = quaternions.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), -1, 0)


def gauge(points, powers):
    """Gauges of points over the half axes, and their gradients; `powers`: 2/e1 and 2/e2 of each."""
    outer, inner = powers.T
    size = np.maximum(np.abs(points), 1e-9)
    x, y, z = size.T
    flat = (x**inner + y**inner) ** (1 / inner)
    value = (flat**outer + z**outer) ** (1 / outer)
    around = (flat / value) ** (outer - 1)
    slope = np.array([around * (x / flat) ** (inner - 1), around * (y / flat) ** (inner - 1), (z / value) ** (outer - 1)])
    return value, slope.T * np.sign(points)


def heights_of_ellipsoids(base, way):
    """The largest h at which base + h way lies on the unit sphere; nan where there is none."""
    square, half = np.einsum("na,na->n", way, way), np.einsum("na,na->n", base, way)
    part = half**2 - square * (np.einsum("na,na->n", base, base) - 1)
    return (np.sqrt(np.where(part >= 0, part, np.nan)) - half) / square


class Surface:
    """The surface of a shape over its half axes, from a file shape_N.obj of a run: points and normals in directions of equal
    steps of both angles, of which an eighth is looked at: the others are its mirror images."""

    def __init__(self, path):
        rows = [line.split() for line in path.read_text().splitlines()]
        points = np.array([row[1:] for row in rows if row[0] == "v"], dtype=float)
        normals = np.array([row[1:] for row in rows if row[0] == "vn"], dtype=float)
        heights = points[:, 2] / np.linalg.norm(points, axis=1)
        columns = int(np.sum(np.isclose(heights, heights[1], atol=1e-6)))
        self.rings, self.spokes = (len(points) - 2) // columns + 1, columns  # steps from pole to pole, and around
        ring = np.arange(self.rings // 2 + 1)[:, None]
        place = np.where(ring == 0, 0, 1 + (ring - 1) * columns + np.arange(columns // 4 + 1))
        self.lattice = np.concatenate([np.linalg.norm(points[place], axis=2)[..., None], normals[place]], axis=2)

    def gauge(self, points):
        """As `gauge` above: between the points of the lattice."""
        size = np.maximum(np.abs(points), 1e-9)
        length = np.linalg.norm(size, axis=1)
        i = np.arccos(np.minimum(size[:, 2] / length, 1)) / np.pi * self.rings
        j = np.arctan2(size[:, 1], size[:, 0]) / (2 * np.pi) * self.spokes
        low_i, low_j = (np.minimum(x.astype(int), n // k - 1) for x, n, k in ((i, self.rings, 2), (j, self.spokes, 4)))
        p, q = (i - low_i)[:, None], (j - low_j)[:, None]
        at = lambda a, b: self.lattice[low_i + a, low_j + b]
        found = (1 - p) * ((1 - q) * at(0, 0) + q * at(0, 1)) + p * ((1 - q) * at(1, 0) + q * at(1, 1))
        value, normal = length / found[:, 0], found[:, 1:]
        slope = normal * (value / np.sum(normal * size, axis=1))[:, None]
        return value, slope * np.sign(points)


class Shapes:
    """The bodies of a frame. `surfaces`: those that are no superellipsoids, by number; `surface`: the number of each body, -1 of
    superellipsoids."""

    def __init__(self, orientation, half_axes, exponents, surface=None, surfaces=None):
        self.turn = rotations(orientation)
        self.half_axes = half_axes
        self.powers = 2 / exponents
        self.surface = np.full(len(half_axes), -1) if surface is None else surface
        self.surfaces = surfaces or {}
        ways = np.array([[i, j, k] for i in range(7) for j in range(7) for k in range(7) if i + j + k], dtype=float)
        self.radius = np.zeros(len(half_axes))  # of the sphere around each body, a little too large
        for way in ways:
            on_surface = way * half_axes / self.gauge(np.arange(len(half_axes)), np.tile(way, (len(half_axes), 1)))[0][:, None]
            self.radius = np.maximum(self.radius, 1.03 * np.linalg.norm(on_surface, axis=1))
        self.ellipsoid = np.all(exponents == 1, axis=1) & (self.surface < 0)
        round_ones = (np.ptp(half_axes, axis=1) == 0) & self.ellipsoid
        self.radius[round_ones] = half_axes[round_ones, 0]

    def gauge(self, which, points):
        """Gauges of points over the half axes of some bodies, and their gradients."""
        value, slope = gauge(points, self.powers[which])
        for number, surface in self.surfaces.items():
            own = self.surface[which] == number
            value[own], slope[own] = surface.gauge(points[own])
        return value, slope

    def scaled_axes(self, which, view):
        """The axes of the view in the frame of each body, over its half axes and times its radius: [bodies, 3, 3]."""
        own = (view @ self.turn) * (self.radius[:, None] / self.half_axes)[:, None, :]
        return own[which]

    def heights(self, which, x, y, view):
        """How far towards the viewer the lines of sight at x and y (over the radius, to the right and up from the centre)
        meet the surface first, over the radius; nan where they miss it. Of ellipsoids by a square root, else by Newton's method
        for a convex function, from outside."""
        axes = self.scaled_axes(which, view)
        base = x[:, None] * axes[:, 0] + y[:, None] * axes[:, 1]
        height, easy = np.full(len(which), 1.0), self.ellipsoid[which]
        height[easy] = heights_of_ellipsoids(base[easy], axes[easy, 2])
        going = np.nonzero(~easy)[0]
        for _ in range(LOOKS):
            value, gradient = self.gauge(which[going], base[going] + height[going, None] * axes[going, 2])
            slope = np.sum(gradient * axes[going, 2], axis=1)
            missed = (slope <= 1e-6) & (value > 1 + CLOSE)
            height[going[missed]] = np.nan
            goes_on = ~missed & (value > 1 + CLOSE)
            going, value, slope = going[goes_on], value[goes_on], slope[goes_on]
            if len(going) == 0:
                break
            height[going] -= (value - 1) / slope
        height[going] = np.nan
        return np.where(np.abs(height) <= 1, height, np.nan)

    def normals(self, which, x, y, height, view):
        """Unit normals in the axes of the view."""
        axes = self.scaled_axes(which, view)
        places = x[:, None] * axes[:, 0] + y[:, None] * axes[:, 1] + height[:, None] * axes[:, 2]
        normal = np.einsum("nb,nvb->nv", self.gauge(which, places)[1], axes)
        return (normal / np.linalg.norm(normal, axis=1)[:, None]).astype(np.float32)
