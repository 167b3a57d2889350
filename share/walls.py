"""The walls of a frame as lines and faint faces around and between the particles. Needs numpy, h5py and matplotlib."""

import h5py
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from plot_style import INK

FOLD = np.cos(np.radians(25))


def read_walls(frame_path):
    """Points (n, 3), triangles (m, 3) and walls (m) of the last surface up to that frame; None if there is none."""
    known = {int(path.stem.split("_")[-1]): path for path in (frame_path.parent.parent / "walls").glob("walls_*.h5")}
    if not known:
        return None
    number = int(frame_path.stem.split("_")[-1])
    earlier = [n for n in known if n <= number]
    if not earlier:
        return None
    path = known[max(earlier)]
    with h5py.File(path, "r") as file:
        points = file["points"][:]
        topology = file.attrs.get("triangles_in", path.name)
    with h5py.File(path.with_name(topology), "r") as file:
        triangles, wall = file["triangles"][:], file["wall"][:]
    return (points, triangles, wall) if len(triangles) else None


def joined(points, triangles):
    """The same with equal corners (to 1e-6 of the size) made one, and without triangles that this flattens."""
    grid = np.round(points / (1e-6 * max(np.ptp(points, axis=0).max(), 1e-300))).astype(np.int64)
    _, first, same = np.unique(grid, axis=0, return_index=True, return_inverse=True)
    triangles = same.reshape(-1)[triangles]
    thin = (triangles == np.roll(triangles, 1, axis=1)).any(axis=1)
    return points[first], triangles[~thin], ~thin


def outline(points, triangles, wall, viewer):
    """Pairs of points: free edges, folds, and edges where the surface turns away from the viewer."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    towards = np.einsum("ij,ij->i", normal, viewer - (a + b + c) / 3)
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    owner = np.tile(np.arange(len(triangles)), 3)
    _, start, group = np.unique(np.column_stack([edges, wall[owner]]), axis=0, return_index=True, return_inverse=True)
    order = np.argsort(group.reshape(-1), kind="stable")
    count = np.bincount(group.reshape(-1))
    one, two = (owner[order[np.minimum(np.cumsum(count) - count + k, len(order) - 1)]] for k in (0, 1))
    cosine = np.einsum("ij,ij->i", normal[one], normal[two])
    # The two corners of an edge run one way in one triangle and the other way in its neighbour, if both look outwards;
    # surfaces are not all oriented, so a sharp turn counts either way round.
    turns_away = (towards[one] * towards[two] * np.sign(cosine) < 0) & (np.abs(cosine) < 0.99999)
    kept = (count != 2) | (np.abs(cosine) < FOLD) | turns_away
    return points[edges[start[kept]]]


def pieces(lines, longest):
    """The lines cut into pieces of at most that length, so that each is before or behind a particle as a whole."""
    parts = np.maximum(1, np.ceil(np.linalg.norm(lines[:, 1] - lines[:, 0], axis=1) / longest)).astype(int)
    which = np.repeat(np.arange(len(lines)), parts)
    step = np.arange(len(which)) - np.repeat(np.cumsum(parts) - parts, parts)
    ends = [lines[which, 0] + (lines[which, 1] - lines[which, 0]) * ((step + k) / parts[which])[:, None] for k in (0, 1)]
    return np.stack(ends, axis=1)


def draw_walls(axes, camera, depth, walls):
    """Lines before the particles are strong, those behind them hidden. `depth`: of the picture, row 0 at the top."""
    points, triangles, keep = joined(*walls[:2])
    wall = walls[2][keep]
    viewer = camera.centre + camera.axes[2] * camera.distance
    flat = camera.project(points)[0] / 2
    if len(triangles) <= 20_000:
        axes.add_collection(PolyCollection(flat[triangles], facecolor=INK, alpha=0.035, edgecolor="none",
                                           antialiased=False, zorder=1.5))
    lines = pieces(outline(points, triangles, wall, viewer), 0.01 * np.linalg.norm(np.ptp(points, axis=0)))
    place, far, _ = camera.project(lines.reshape(-1, 3))
    place, far = place.reshape(-1, 2, 2) / 2, far.reshape(-1, 2).mean(axis=1)
    middle = place.mean(axis=1).astype(int)
    inside = np.all((middle >= 0) & (middle < depth.shape[::-1]), axis=1)
    column, row = np.where(inside[:, None], middle, 0).T
    before = ~inside | (far < depth[depth.shape[0] - 1 - row, column])
    axes.add_collection(LineCollection(place, colors=INK, linewidths=0.8, alpha=0.55, zorder=1.6))
    axes.add_collection(LineCollection(place[before], colors=INK, linewidths=0.8, alpha=0.75, zorder=3))
