"""Draws the last frame of a fluid: speed, or temperature, and streamlines in the middle plane across its thinnest axis."""

import h5py
import matplotlib.pyplot as plt
import numpy as np

MOST_WIDE = 6  # longer flows are stretched across


def read_slice(path):
    """Faces of both axes of the plane, velocity along them, what is coloured, names of the axes and the time. Bodies are
    masked."""
    with h5py.File(path) as file:
        faces = [file["faces"][axis][:] for axis in "xyz"]
        shape = tuple(len(f) - 1 for f in reversed(faces))
        velocity = file["fields/velocity"][:].reshape(*shape, 3)
        fluid = file["fields/fluid"][:].reshape(shape) > 0
        heat = file["fields/temperature"][:].reshape(shape) if "fields/temperature" in file else None
        time = float(file.attrs["time"])
    cells = [len(f) - 1 for f in faces]
    lengths = [f[-1] - f[0] for f in faces]
    across = min(range(3), key=lambda a: (cells[a], lengths[a], -a))
    first, second = (a for a in range(3) if a != across)
    place = cells[across] // 2
    plane = np.take(velocity, place, axis=2 - across)
    here = np.take(fluid, place, axis=2 - across)
    colour = np.linalg.norm(plane, axis=-1) if heat is None else np.take(heat, place, axis=2 - across)
    colour = np.ma.masked_where(~here, colour)
    label = "speed [m/s]" if heat is None else "temperature [K]"
    along = [np.where(here, plane[..., a], np.nan) for a in (first, second)]
    return faces[first], faces[second], along, (colour, label), "xyz"[first] + "xyz"[second], time


def even(faces, values_first, values_second, count, least):
    """Values in the middles of cells, on an even grid, which streamplot needs."""
    from_faces = [0.5 * (f[1:] + f[:-1]) for f in faces]
    shares = np.array([f[-1] - f[0] for f in faces])
    sizes = np.maximum(least, (count * shares / shares.max()).astype(int))
    places = [np.linspace(m[0], m[-1], n) for m, n in zip(from_faces, sizes)]
    columns = np.array([np.interp(places[0], from_faces[0], row) for row in values_first])
    first = np.array([np.interp(places[1], from_faces[1], column) for column in columns.T]).T
    columns = np.array([np.interp(places[0], from_faces[0], row) for row in values_second])
    second = np.array([np.interp(places[1], from_faces[1], column) for column in columns.T]).T
    return places, first, second


def draw(path, picture):
    """Writes the picture of a frame; returns its path."""
    x, y, along, (colour, label), names, time = read_slice(path)
    true_wide = (x[-1] - x[0]) / (y[-1] - y[0])
    wide = min(true_wide, MOST_WIDE)
    width = min(10.0, max(4.0, 7.0 * wide))
    figure, axes = plt.subplots(figsize=(width + 1.2, width / wide + 0.8), constrained_layout=True)
    mesh = axes.pcolormesh(x, y, colour, cmap="viridis" if "speed" in label else "inferno", shading="flat")
    figure.colorbar(mesh, ax=axes, label=label, shrink=0.85)
    if min(colour.shape) > 1 and any(np.nanmax(np.abs(part)) > 0 for part in along):
        (px, py), u, v = even((x, y), *along, count=200, least=40)
        density = 1.6 * np.minimum(1, [wide, 1 / wide])[::-1] ** 0.5
        axes.streamplot(px, py, u, v, color="white", linewidth=0.7, density=density, arrowsize=0.8)
    stretched = "" if wide == true_wide else f", {names[1]} stretched {true_wide / wide:.2g} times"
    axes.set(xlabel=f"{names[0]} [m]", ylabel=f"{names[1]} [m]", title=f"t = {time:.4g} s{stretched}",
             aspect=true_wide / wide, xlim=(x[0], x[-1]), ylim=(y[0], y[-1]))
    axes.set_facecolor("0.6")
    figure.savefig(picture, dpi=110)
    plt.close(figure)
    return picture
