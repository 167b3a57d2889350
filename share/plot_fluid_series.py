"""The panels of the series of a fluid."""

import numpy as np

from plot_style import COLOURS


def draw_columns(axes, series, names, unit):
    """The columns of these names that are numbers somewhere, with a line each; `names` gives their labels."""
    shown = [name for name in names if np.any(np.isfinite(series[name]))]
    for colour, name in zip(COLOURS, shown):
        axes.plot(series["t"], series[name], color=colour, label=names[name])
    axes.set_ylabel(f"[{unit}]")
    if shown:
        axes.legend(loc="best")


def draw_energy(axes, series):
    axes.set_title("Kinetic energy of the fluid")
    draw_columns(axes, series, {"kinetic_energy": "kinetic energy"}, "J")


def draw_speed(axes, series):
    axes.set_title("Largest speed")
    draw_columns(axes, series, {"largest_speed": "largest speed"}, "m/s")


def draw_solver(axes, series):
    axes.set_title("Iterations of a step")
    draw_columns(axes, series, {"pressure_iterations": "pressure", "viscous_iterations": "friction"}, "1")


def draw_errors(axes, series):
    axes.set_title("What a step misses")
    for colour, name, label in ((COLOURS[0], "divergence", "volume of a cell / cell"),
                                (COLOURS[3], "momentum_error", "momentum since the start [N s]"),
                                (COLOURS[1], "change", "change while passing a cell / speed")):
        values = np.abs(series[name])
        axes.plot(series["t"], np.where(values > 0, values, np.nan), color=colour, label=label)
    if any(np.any(np.isfinite(line.get_ydata())) for line in axes.lines):
        axes.set_yscale("log")
    axes.legend(loc="best")


def draw_forces(axes, series):
    axes.set_title("Force on patches")
    names = {name: name.replace("_force_", " ") for name in series
             if "_force_" in name and np.nanmax(np.abs(series[name])) > 0}
    largest = sorted(names, key=lambda name: -np.nanmax(np.abs(series[name])))[: len(COLOURS)]
    draw_columns(axes, series, {name: names[name] for name in names if name in largest}, "N")


def draw_probes(axes, series):
    axes.set_title("Velocity at probes")
    names = [name for name in series if name.endswith(("_u_x", "_u_y", "_u_z"))]
    largest = sorted(names, key=lambda name: -np.nanmax(np.abs(series[name])))[: len(COLOURS)]
    draw_columns(axes, series, {name: name.replace("_u_", " ") for name in names if name in largest}, "m/s")


def panels_of(series):
    """What there is to draw."""
    panels = [draw_energy, draw_speed, draw_solver, draw_errors]
    if any("_force_" in name for name in series):
        panels.append(draw_forces)
    if any(name.endswith("_u_x") for name in series):
        panels.append(draw_probes)
    return panels
