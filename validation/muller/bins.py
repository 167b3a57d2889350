"""The exact volume of spheres in boxes, and what follows for void fraction and velocity. Needs numpy only."""

import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(6)


def antiderivative(h, radius):
    """Of sqrt(radius^2 - h^2), |h| <= radius."""
    inside = np.sqrt(np.maximum(radius**2 - h**2, 0.0))
    return 0.5 * (h * inside + radius**2 * np.arctan2(h, inside))


def quadrant(a, b, radius):
    """Area of the disc around the origin with y < a and z < b."""
    a, b = np.clip(a, -radius, radius), np.clip(b, -radius, radius)
    half = np.sqrt(np.maximum(radius**2 - b**2, 0.0))  # |y| where the line z = b leaves the disc

    def below(y):
        """Integral from -radius to y of the length that z < b has of the chord at y."""
        whole, part = antiderivative(y, radius) - antiderivative(-radius, radius), np.clip(y, -half, half)
        # Beside the line's ends a chord is there wholly (b > 0) or not at all.
        middle = b * (part + half) + antiderivative(part, radius) - antiderivative(-half, radius)
        ends = 2 * (whole - antiderivative(part, radius) + antiderivative(-half, radius))
        return middle + np.where(b > 0, ends, 0.0)

    return below(a)


def rectangle(y0, y1, z0, z1, radius):
    """Area of the disc around the origin in a rectangle."""
    return (quadrant(y1, z1, radius) - quadrant(y0, z1, radius) - quadrant(y1, z0, radius) + quadrant(y0, z0, radius))


def volume_in_box(centre, radius, low, high):
    """Volume of each sphere (centres in rows) in a box from `low` to `high`, which may be rows as well.

    The area of the sections is exact; over x it is integrated between the places where its formula changes. The error
    is below 1e-5 of a sphere.
    """
    centre = np.atleast_2d(centre)
    radius = np.broadcast_to(np.asarray(radius, float), len(centre))
    low = np.broadcast_to(low, centre.shape) - centre
    high = np.broadcast_to(high, centre.shape) - centre
    y0, y1, z0, z1 = low[:, 1], high[:, 1], low[:, 2], high[:, 2]
    # Sections of radius r sin(angle): x = -r cos(angle) leaves no root at the poles.
    start = np.arccos(-np.clip(low[:, 0] / radius, -1, 1))
    end = np.arccos(-np.clip(high[:, 0] / radius, -1, 1))
    reach = [np.abs(y0), np.abs(y1), np.abs(z0), np.abs(z1)]
    reach += [np.hypot(y, z) for y in (y0, y1) for z in (z0, z1)]
    turn = np.arcsin(np.clip(np.array(reach) / radius, 0, 1))
    knots = np.sort(np.concatenate([turn, np.pi - turn, [start, end]]), axis=0)
    knots = np.clip(knots, start, end)
    volume = np.zeros(len(centre))
    for below, above in zip(knots[:-1], knots[1:]):
        some = np.flatnonzero(above > below + 1e-12)
        middle, half, r = 0.5 * (above + below)[some], 0.5 * (above - below)[some], radius[some]
        sides = [side[some] for side in (y0, y1, z0, z1)]
        for node, weight in zip(NODES, WEIGHTS):
            section = r * np.sin(middle + half * node)
            volume[some] += weight * half * section * rectangle(*sides, section)
    return volume


class Profile:
    """Void fraction and mean velocity in bins along x between two heights and two depths; frames are added up."""

    def __init__(self, edges, heights, depths):
        self.edges, self.heights, self.depths = np.asarray(edges), heights, depths
        self.box = np.diff(self.edges) * (heights[1] - heights[0]) * (depths[1] - depths[0])
        self.solids, self.flow = np.zeros(len(self.box)), np.zeros(len(self.box))
        self.frames = 0

    def add(self, position, velocity, radius):
        """One frame: places of the centres, velocities of the centres along y, radius of all."""
        self.frames += 1
        near = np.abs(position[:, 1] - np.mean(self.heights)) < 0.5 * np.ptp(self.heights) + radius
        near &= np.abs(position[:, 2] - np.mean(self.depths)) < 0.5 * np.ptp(self.depths) + radius
        place, speed = position[near].astype(float), velocity[near].astype(float)
        first = np.searchsorted(self.edges, place[:, 0] - radius, side="right") - 1
        last = np.searchsorted(self.edges, place[:, 0] + radius, side="left") - 1
        for offset in range(int((last - first).max(initial=-1)) + 1):
            bins = first + offset
            there = (bins <= last) & (bins >= 0) & (bins < len(self.box))
            b, centre = bins[there], place[there]
            low = np.column_stack([self.edges[b], np.full(len(b), self.heights[0]), np.full(len(b), self.depths[0])])
            high = np.column_stack([self.edges[b + 1], np.full(len(b), self.heights[1]), np.full(len(b), self.depths[1])])
            volume = volume_in_box(centre, radius, low, high)
            np.add.at(self.solids, b, volume)
            np.add.at(self.flow, b, volume * speed[there])

    @property
    def middles(self):
        return 0.5 * (self.edges[1:] + self.edges[:-1])

    def void_fraction(self):
        return 1 - self.solids / (self.frames * self.box)

    def velocity(self):
        """Weighted by volume, over all frames together."""
        return self.flow / np.maximum(self.solids, np.finfo(float).tiny)
