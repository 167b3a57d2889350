"""Speeds at which spheres meet, and where they are, from frames of runs without cohesion."""

import h5py
import numpy as np

import cases


def frame(path):
    with h5py.File(path) as file:
        return file["particles/position"][:], file["particles/velocity"][:]


def close_pairs(position, side, reach):
    """Pairs nearer than `reach` in a periodic cube: each once, and the vector from the first to the second."""
    cells = int(side // reach)
    cell = np.minimum((position * (cells / side)).astype(int), cells - 1)
    number = (cell[:, 0] * cells + cell[:, 1]) * cells + cell[:, 2]
    order = np.argsort(number, kind="stable")
    first, second = [], []
    for shift in np.ndindex(3, 3, 3):
        other = (cell + np.array(shift) - 1) % cells
        wanted = (other[:, 0] * cells + other[:, 1]) * cells + other[:, 2]
        low, high = (np.searchsorted(number[order], wanted, end) for end in ("left", "right"))
        mine = np.repeat(np.arange(len(position)), high - low)
        place = np.arange(len(mine)) - np.repeat(np.cumsum(high - low) - (high - low), high - low) + np.repeat(low, high - low)
        first.append(mine)
        second.append(order[place])
    i, j = np.concatenate(first), np.concatenate(second)
    i, j = i[i < j], j[i < j]
    apart = position[j] - position[i]
    apart -= side * np.round(apart / side)
    near = np.linalg.norm(apart, axis=1) < reach
    return i[near], j[near], apart[near]


def impacts(paths, base):
    """Speeds of approach of pairs that are about to touch, and how often each counts: as often as it brings pairs together."""
    speeds = []
    for path in paths:
        position, velocity = frame(path)
        i, j, apart = close_pairs(position, base.side, base.diameter + base.gap)
        distance = np.linalg.norm(apart, axis=1)
        approach = -np.sum((velocity[j] - velocity[i]) * apart, axis=1) / distance
        speeds.append(approach[(approach > 0) & (distance > base.diameter)])
    return np.sort(np.concatenate(speeds))


def collision_rate(speeds, frames, count, base):
    """Impacts per sphere and turnover: pairs in the shell of thickness `gap` over the time that they take to cross it."""
    return 2 * np.sum(speeds) / base.gap / frames / count * base.turnover


def part_slower(speeds, limit):
    """The part of the impacts that are slower than `limit`."""
    return np.sum(speeds[speeds < limit]) / np.sum(speeds)


def flow(position, base):
    """Velocity of the fluid and the square of its vorticity (Taylor-Green, 2 A along z)."""
    x, y, z = (base.wavenumber * position).T
    a = base.amplitude
    sx, sy, sz, cx, cy, cz = np.sin(x), np.sin(y), np.sin(z), np.cos(x), np.cos(y), np.cos(z)
    velocity = a * np.stack([-sx * cy * cz, -cx * sy * cz, 2 * cx * cy * sz], axis=1)
    return velocity, (3 * a * base.wavenumber) ** 2 * ((cx * sy * sz) ** 2 + (sx * cy * sz) ** 2)
