"""The particles of one frame as a picture, coloured by agglomerate where there are any, else by speed."""

import pathlib
import sys

import h5py
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LinearSegmentedColormap, LogNorm, Normalize, to_rgb
from matplotlib.patches import Patch

import shapes
import spheres
import walls
from plot_style import COLOURS, INK, si_scale

DPI = 150
SINGLE = np.array([0.80, 0.82, 0.85])


def read_frame(path):
    with h5py.File(path, "r") as file:
        frame = {name: file["particles"][name][:] for name in file["particles"]}
        for name in ("time", "domain_min", "domain_max"):
            frame[name] = np.array(file.attrs[name], dtype=float)
    return frame


def colour_by_agglomerate(frame):
    """Colours by the size of the agglomerate, a little lighter or darker from one agglomerate to the next."""
    size = frame["agglomerate_size"]
    largest = max(3, size.max())
    norm = LogNorm(2, largest)
    colour_map = LinearSegmentedColormap.from_list("sizes", plt.get_cmap("plasma")(np.linspace(0.02, 0.86, 256)))
    colours = colour_map(norm(np.maximum(size, 2)))[:, :3]
    turn = np.modf(frame["agglomerate"] * 0.6180339887498949)[0]
    colours = np.clip(colours * (0.84 + 0.20 * turn)[:, None] + 0.06, 0, 1)
    colours[frame["agglomerate"] < 0] = SINGLE
    return colours, ScalarMappable(norm, colour_map), "particles in the agglomerate"


def colour_by_speed(frame):
    speed = np.linalg.norm(frame["velocity"], axis=1)
    factor, unit = si_scale(speed.max(), "m/s")
    # A few fast particles must not take the colours from all others.
    top = np.quantile(speed, 0.995) if speed.max() > 0 else 1.0
    norm = Normalize(0, factor * (top if top > 0 else speed.max()))
    colour_map = LinearSegmentedColormap.from_list("speeds", plt.get_cmap("viridis")(np.linspace(0.12, 1, 256)))
    return colour_map(norm(factor * speed))[:, :3], ScalarMappable(norm, colour_map), f"speed [{unit}]"


def colour_by_group(frame):
    """One colour per group of particles; no scale belongs to it."""
    return np.array([to_rgb(COLOURS[group % len(COLOURS)]) for group in frame["group"]]), None, ""


def frame_box(frame, surface):
    """The box to look at, and whether it is the domain: a few particles in a large domain are looked at alone, or with
    the walls in it."""
    radius = 0.5 * frame["diameter"][:, None]
    low, high = (frame["position"] - radius).min(axis=0), (frame["position"] + radius).max(axis=0)
    domain = frame["domain_min"], frame["domain_max"]
    if surface is not None:
        points = np.clip(surface[0], *domain)
        low, high = np.minimum(low, points.min(axis=0)), np.maximum(high, points.max(axis=0))
    if np.max(domain[1] - domain[0]) <= 2.5 * np.max(high - low):
        return *domain, True
    return low, high, False


def view_angles(low, high):
    """Azimuth and elevation: from the side and a little above, or almost along the axis of a thin layer."""
    size = high - low
    thin = int(np.argmin(size))
    if size[thin] > 0.15 * np.median(size):
        return -60.0, 22.0
    return [(-8.0, 10.0), (-82.0, 10.0), (-82.0, 72.0)][thin]


def draw_edges(axes, camera, low, high, front):
    """The edges of the box behind the particles, or those that meet in the corner next to the viewer."""
    nearest = camera.axes[2] > 0
    for axis in range(3):
        for k in range(4):
            other = [a for a in range(3) if a != axis]
            upper = np.zeros(3, dtype=bool)
            upper[other] = [k & 1, k >> 1]
            if np.all(upper[other] == nearest[other]) != front:
                continue
            ends = np.where([upper, upper], high, low)
            ends[:, axis] = low[axis], high[axis]
            x, y = camera.project(ends)[0].T / 2
            axes.plot(x, y, color=INK, lw=0.9, alpha=0.35 if front else 0.55, zorder=3 if front else 1)


def describe(frame, low, high):
    time, count = float(frame["time"]), len(frame["position"])
    factor, unit = si_scale(time, "s")
    text = f"t = {time * factor:.4g} {unit}    {count:,} particle{'s' if count != 1 else ''}".replace(",", "\u2009")
    if "agglomerate" in frame:
        text += f"    {100 * np.mean(frame['agglomerate'] >= 0):.0f} % in agglomerates"
    factor, unit = si_scale(np.max(high - low), "m")
    return text, " \u00d7 ".join(f"{x * factor:.3g}" for x in high - low) + f" {unit}"


def shapes_of(frame, run):
    """The bodies of a frame in which some are no spheres and all is there that says how they look, else None. `run`: directory of
    the run, which holds the surfaces of shapes that are no superellipsoids."""
    names = ("orientation", "half_axes", "exponents")
    if not all(name in frame for name in names):
        return None
    number = frame.get("shape_file", np.full(len(frame["id"]), -1))
    files = {n: run / f"shape_{n}.obj" for n in np.unique(number[number >= 0])}
    surfaces = {n: shapes.Surface(path) for n, path in files.items() if path.is_file()}
    return shapes.Shapes(*(frame[name].astype(float) for name in names), number, surfaces)


def draw(frame_path, directory, pixels=2400):
    """Writes particles.png, and groups.png where there are several groups; returns their paths, none where the frame has no
    particles or lacks a field that the pictures need. `pixels` are halved for them."""
    frame = read_frame(frame_path)
    if len(frame["position"]) == 0:
        return []
    with_agglomerates = "agglomerate" in frame and "agglomerate_size" in frame
    missing = [name for name in ["diameter"] + (not with_agglomerates) * ["velocity"] if name not in frame]
    if missing:
        print(f"plot.py: '{frame_path}' does not hold {' and '.join(missing)} (output.fields): no picture of the particles",
              file=sys.stderr)
        return []
    names = {"particles.png": colour_by_agglomerate if with_agglomerates else colour_by_speed}
    if len(np.unique(frame.get("group", [0]))) > 1:
        names["groups.png"] = colour_by_group
    colourings = [colour(frame) for colour in names.values()]
    surface = walls.read_walls(pathlib.Path(frame_path))
    low, high, is_domain = frame_box(frame, surface)
    camera = spheres.Camera(low, high, *view_angles(low, high), pixels)
    bodies = shapes_of(frame, pathlib.Path(frame_path).parent.parent)
    radius = 0.5 * frame["diameter"] if bodies is None else bodies.radius
    images, depth = spheres.shade(
        camera, frame["position"], radius, [c[0] for c in colourings], floor=(low, high) if is_domain else None, shapes=bodies
    )
    paths = [directory / name for name in names]
    for path, image, (_, scale, label) in zip(paths, images, colourings):
        figure = make_figure(image, depth, camera, surface, (low, high) if is_domain else None, describe(frame, low, high))
        if scale is not None:
            add_scale(figure, image, scale, label, with_agglomerates and np.any(frame["agglomerate"] < 0))
        figure.savefig(path)
        plt.close(figure)
    return paths


def size_of(image):
    """Inches of the image, and of the figure with room beside it."""
    inches = np.array(image.shape[1::-1]) / DPI
    return inches, max(inches[0] + 1.25, 5.0), inches[1] + 0.5


def make_figure(image, depth, camera, surface, domain, texts):
    inches, width, height = size_of(image)
    figure = plt.figure(figsize=(width, height), dpi=DPI)
    axes = figure.add_axes([0, 0, inches[0] / width, inches[1] / height])
    axes.imshow(image, extent=(0, image.shape[1], 0, image.shape[0]), zorder=2)
    if surface is not None:
        walls.draw_walls(axes, camera, depth, surface)
    elif domain is not None:
        draw_edges(axes, camera, *domain, front=False)
        draw_edges(axes, camera, *domain, front=True)
    axes.set(xlim=(0, image.shape[1]), ylim=(0, image.shape[0]))
    axes.axis("off")
    title, size = texts
    figure.text(0.3 / width, 1 - 0.3 / height, title, fontsize=13, color=INK, va="center")
    figure.text(0.3 / width, 0.2 / height, size, fontsize=9.5, color=INK, alpha=0.75)
    return figure


def add_scale(figure, image, scale, label, with_singles):
    """The bar of colours, and what the colour of single particles is."""
    inches, width, height = size_of(image)
    bar_axes = figure.add_axes([(inches[0] + 0.3) / width, 0.25, 0.16 / width, 0.5])
    bar = figure.colorbar(scale, cax=bar_axes)
    bar.outline.set_visible(False)
    bar.set_label(label, color=INK)
    bar_axes.tick_params(colors=INK, which="both", length=3)
    if with_singles:
        patch = Patch(facecolor=SINGLE * 0.92, label="single")
        place = ((inches[0] + 0.2) / width, 0.18)
        figure.legend(handles=[patch], loc=place, frameon=False, labelcolor=INK, handlelength=1, handleheight=1)
