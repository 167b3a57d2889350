"""The exact volume of spheres in boxes, and what follows for void fraction and velocity. Needs numpy only."""

import itertools

import numpy as np

def arc_cosine(x):
    """Of a number that rounding may have put beside [-1, 1]."""
    return np.arccos(np.clip(x, -1.0, 1.0))


def cap(a):
    """Volume of the unit ball where x > a."""
    a = np.clip(a, -1.0, 1.0)
    return np.pi / 3 * (1 - a) ** 2 * (2 + a)


# What planes at right angles cut from a ball is a third of its curved surface less a third of each flat face times the
# distance of its plane (divergence theorem). The curved surface follows from Gauss and Bonnet: 2 pi less, for each arc, its
# angle times the distance of its plane, less the outer angle of each vertex.


def inner_angle(a, b, rest_a, rest_b):
    """Between the arcs of the planes x = a and y = b, whose circles have the radii rest_a and rest_b."""
    return arc_cosine(a * b / (rest_a * rest_b))


def wedge(a, b):
    """Volume of the unit ball where x > a and y > b, both at least 0."""
    volume = np.zeros(len(a))
    cut = a**2 + b**2 < 1
    a, b = a[cut], b[cut]
    rest_a, rest_b = np.sqrt(1 - a**2), np.sqrt(1 - b**2)
    half_a, half_b = arc_cosine(b / rest_a), arc_cosine(a / rest_b)  # of the arcs' angles
    end = np.sqrt(1 - a**2 - b**2)  # half the length of the edge
    curved = 2 * (inner_angle(a, b, rest_a, rest_b) - a * half_a - b * half_b)
    flat_a, flat_b = rest_a**2 * half_a - b * end, rest_b**2 * half_b - a * end
    volume[cut] = (curved - a * flat_a - b * flat_b) / 3
    return volume


def corner(a, b, c):
    """Volume of the unit ball where x > a, y > b and z > c, all at least 0."""
    volume = np.zeros(len(a))
    cut = a**2 + b**2 + c**2 < 1
    planes = [plane[cut] for plane in (a, b, c)]
    rests = [np.sqrt(1 - plane**2) for plane in planes]
    total = -np.pi
    for axis in range(3):
        (p, q, r), rest = (planes[axis], planes[axis - 2], planes[axis - 1]), rests[axis]
        arc = arc_cosine(q / rest) - np.arcsin(np.clip(r / rest, -1.0, 1.0))
        to_q, to_r = np.sqrt(1 - p**2 - q**2) - r, np.sqrt(1 - p**2 - r**2) - q  # lengths of the face's edges
        flat = 0.5 * (rest**2 * arc - q * to_q - r * to_r)
        total = total + inner_angle(p, q, rest, rests[axis - 2]) - p * arc - p * flat
    volume[cut] = total / 3
    return volume


def beyond(a, b, c):
    """Volume of the unit ball where x > a, y > b and z > c, of any signs."""
    sizes = [np.abs(plane) for plane in (a, b, c)]
    whole = [cap(size) for size in sizes]
    edges = {(i, j): wedge(sizes[i], sizes[j]) for i, j in ((0, 1), (0, 2), (1, 2))}
    # What lies beyond -a and on one side of others is what is on that side less what lies beyond a, mirrored.
    minus = [plane < 0 for plane in (a, b, c)]

    def signed_wedge(i, j):
        value = edges[i, j]
        value = np.where(minus[i], whole[j] - value, value)
        of_j = np.where(minus[i], 4 * np.pi / 3 - whole[i], whole[i])
        return np.where(minus[j], of_j - value, value)

    value = corner(*sizes)
    value = np.where(minus[0], edges[1, 2] - value, value)
    value = np.where(minus[1], np.where(minus[0], whole[2] - edges[0, 2], edges[0, 2]) - value, value)
    return np.where(minus[2], signed_wedge(0, 1) - value, value)


def volume_in_box(centre, radius, low, high):
    """Volume of each sphere (centres in rows) in a box from `low` to `high`, which may be rows as well; exact to 1e-7 of it."""
    centre = np.atleast_2d(centre)
    radius = np.broadcast_to(np.asarray(radius, float), len(centre))
    sides = [((np.broadcast_to(side, centre.shape) - centre) / radius[:, None]).T for side in (low, high)]
    volume = np.zeros(len(centre))
    for x, y, z in itertools.product((0, 1), repeat=3):
        volume += (-1) ** (x + y + z) * beyond(sides[x][0], sides[y][1], sides[z][2])
    return volume * radius**3


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
