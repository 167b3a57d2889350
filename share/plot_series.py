"""The series of a run as a page of diagrams over time."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

import plot_fluid_series
from plot_style import COLOURS, STYLE, si_scale

ENERGIES = {
    "kinetic_energy": "kinetic",
    "rotational_energy": "rotational",
    "elastic_energy": "elastic",
    "cohesive_energy": "cohesive",
    "gravitational_energy": "body forces",
}
EXCHANGES = {
    "dissipated_normal": "lost: normal damping",
    "dissipated_sliding": "lost: sliding",
    "dissipated_rolling": "lost: rolling",
    "work_drag": "work of drag",
    "work_prescribed": "work of moving bodies",
    "work_walls": "work of walls",
}


def read_series(path):
    """Columns by name. None without rows."""
    with open(path) as file:
        names = file.readline().strip().split(",")
        lines = file.readlines()
    if not lines:
        return None
    rows = np.loadtxt(lines, delimiter=",", ndmin=2)
    return {name: rows[:, i] for i, name in enumerate(names)}


def moves(values):
    return np.any(np.isfinite(values)) and np.nanmax(np.abs(values)) > 0


def draw_lines(axes, series, names, unit):
    """Draws the columns that are not all zero, in a common unit with a fitting prefix."""
    shown = [name for name in names if name in series and moves(series[name])]
    factor, unit = si_scale(max((np.nanmax(np.abs(series[name])) for name in shown), default=0), unit)
    for colour, name in zip(COLOURS, shown):
        axes.plot(series["t"], factor * series[name], color=colour, label=names[name])
    axes.set_ylabel(f"[{unit}]")
    if shown:
        axes.legend(loc="best")


def draw_energies(axes, series):
    axes.set_title("Energy of the particles")
    draw_lines(axes, series, ENERGIES, "J")


def draw_exchanges(axes, series):
    axes.set_title("Energy exchanged since the start")
    draw_lines(axes, series, EXCHANGES, "J")


def draw_errors(axes, series):
    axes.set_title("Closure of the books")
    for colour, name, label, scale in (
        (COLOURS[0], "energy_error", "energy error / energy turnover", "energy_turnover"),
        (COLOURS[3], "momentum_error", "momentum error [N s]", None),
    ):
        if name not in series or not moves(series[name]) or (scale and scale not in series):
            continue
        # The progress line and ledger.energy_tolerance mean the same ratio.
        turnover = np.where(series[scale] > 0, series[scale], np.nan) if scale else 1.0
        error = np.abs(series[name]) / turnover
        axes.plot(series["t"], np.where(error > 0, error, np.nan), color=colour, label=label)
    if axes.lines:
        axes.set_yscale("log")
        axes.legend(loc="best")


def draw_pressure_drop(axes, series):
    axes.set_title("Pressure drop from inlets to outlets")
    draw_lines(axes, series, {"pressure_drop": "pressure drop"}, "Pa")


def draw_temperatures(axes, series):
    axes.set_title("Temperature of the particles")
    names = {f"particle_temperature_{what}": what for what in ("lowest", "mean", "highest")}
    draw_lines(axes, series, names, "K")


def draw_contacts(axes, series):
    axes.set_title("Contacts")
    pair(axes, series, ("contacts", "contacts", 1), ("max_overlap", "largest overlap / smaller radius [%]", 100))


def draw_speeds(axes, series):
    axes.set_title("Speeds")
    draw_lines(axes, series, {"max_speed": "largest", "mean_speed": "mean", "collision_speed": "of collisions"}, "m/s")


def draw_momentum(axes, series):
    axes.set_title("Momentum of the particles")
    draw_lines(axes, series, {f"momentum_{x}": x for x in "xyz"}, "N s")


def draw_passage(axes, series):
    axes.set_title("Mass that came and went since the start")
    outlets = {name: name[:-5].replace("outlet_", "left through ", 1) for name in ending(series, "_mass")
               if name.startswith("outlet_")}
    names = {"inserted_mass": "came in", "removed_mass": "left"}
    if len(outlets) > 1:
        names |= outlets
    draw_lines(axes, in_grams(series, names), names, "g")


def draw_planes(axes, series):
    axes.set_title("Mass flow through planes")
    names = {f"{plane}_rate": plane for plane in planes_of(series)}
    draw_lines(axes, in_grams(series, names), names, "g/s")


def draw_forces(axes, series):
    axes.set_title("Force on walls")
    draw_lengths(axes, series, "force", "N")


def draw_torques(axes, series):
    axes.set_title("Torque on walls")
    draw_lengths(axes, series, "torque", "N m")


def ending(series, end):
    return [name for name in series if name.endswith(end)]


def planes_of(series):
    """Names of the planes: no other columns count what passes against a normal."""
    return [name.removesuffix("_against") for name in ending(series, "_against")]


def in_grams(series, names):
    return {"t": series["t"]} | {name: 1000 * series[name] for name in names if name in series}


def draw_lengths(axes, series, what, unit):
    """The lengths of a vector of every wall; of the largest, where there are many walls."""
    walls = [name.removesuffix(f"_{what}_x") for name in ending(series, f"_{what}_x")]
    lengths = {wall: np.sqrt(sum(series[f"{wall}_{what}_{x}"] ** 2 for x in "xyz")) for wall in walls}
    shown = sorted(sorted(walls, key=lambda wall: -np.nanmax(lengths[wall]))[: len(COLOURS)], key=walls.index)
    draw_lines(axes, lengths | {"t": series["t"]}, {wall: wall for wall in shown}, unit)


def panels_of(series):
    """What there is to draw."""
    if "pressure_iterations" in series:
        return plot_fluid_series.panels_of(series)
    panels = [draw_energies, draw_exchanges, draw_errors, draw_contacts, draw_speeds]
    if "pressure_drop" in series and moves(series["pressure_drop"]):
        panels.insert(0, draw_pressure_drop)
    panels += [draw_agglomerates, draw_sizes, draw_structure] if "agglomerates" in series else [draw_momentum]
    if "particle_temperature_mean" in series:
        panels.insert(1, draw_temperatures)
    if "inserted_mass" in series:
        panels.append(draw_passage)
    if planes_of(series):
        panels.append(draw_planes)
    for end, panel in (("_force_x", draw_forces), ("_torque_x", draw_torques)):
        if any(moves(series[name[:-1] + x]) for name in ending(series, end) for x in "xyz"):
            panels.append(panel)
    return panels


def draw_agglomerates(axes, series):
    axes.set_title("Agglomeration")
    pair(axes, series, ("agglomerated_fraction", "particles in agglomerates [%]", 100), ("agglomerates", "agglomerates", 1))


def draw_sizes(axes, series):
    axes.set_title("Size of the agglomerates")
    names = {"largest_agglomerate": "largest", "mean_agglomerate_size": "mean"}
    for colour, name in zip(COLOURS, names):
        axes.plot(series["t"], series[name], color=colour, label=names[name])
    axes.set_yscale("log")
    axes.set_ylabel("particles")
    axes.legend(loc="best")


def draw_structure(axes, series):
    axes.set_title("Structure of the agglomerates")
    axes.plot(series["t"], series["coordination_number"], color=COLOURS[0], label="coordination number")
    dimension, error = series["fractal_dimension"], series["fractal_dimension_error"]
    if moves(dimension):
        axes.plot(series["t"], dimension, color=COLOURS[3], label="fractal dimension \u00b1 error")
        axes.fill_between(series["t"], dimension - error, dimension + error, color=COLOURS[3], alpha=0.2, lw=0)
    axes.legend(loc="best")


def pair(axes, series, left, right):
    """Two columns with an axis each: (name, label, factor)."""
    for side, colour, (name, label, factor) in ((axes, COLOURS[0], left), (axes.twinx(), COLOURS[3], right)):
        side.plot(series["t"], factor * series[name], color=colour)
        side.set_ylabel(label, color=colour)
        side.tick_params(axis="y", colors=colour)
        largest = factor * np.nanmax(series[name], initial=0)
        side.set_ylim(0, 1.08 * largest if largest > 0 else 1)
        side.yaxis.set_major_locator(MaxNLocator(6))
        if side is not axes:
            side.grid(False)
            side.spines["right"].set_visible(True)


def draw(series_path, picture_path):
    """Writes the page; returns its path, or None where the series has no rows."""
    series = read_series(series_path)
    if series is None:
        return None
    factor, unit = si_scale(series["time"].max(), "s")
    series["t"] = factor * series["time"]
    panels = panels_of(series)
    with plt.rc_context(STYLE):
        rows = (len(panels) + 1) // 2
        figure, places = plt.subplots(rows, 2, figsize=(12, 3.1 * rows), dpi=130, sharex=True, layout="constrained")
        for place, panel in zip(places.flat, panels):
            panel(place, series)
            place.set_xlim(series["t"].min(), series["t"].max() if len(series["t"]) > 1 else None)
        for place in places.flat[len(panels):]:
            place.set_visible(False)
        for place in places.flat[max(0, len(panels) - 2):len(panels)]:
            place.set_xlabel(f"time [{unit}]")
            place.tick_params(labelbottom=True)
        figure.savefig(picture_path)
        plt.close(figure)
    return picture_path
