"""The cases of the study: what a Stokes and a stickiness number make of case.toml."""

import math
import pathlib
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
MEAN_SPEED = 0.77994166  # of the Taylor-Green flow over its amplitude

STOKES = (0.01, 0.1, 1, 10)
STICKINESS = (0.25, 0.5, 1, 2, 4)
SEEDS = (1, 2, 3)


class Base:
    """The numbers of case.toml that the two groups are made of."""

    def __init__(self, path=HERE / "case.toml"):
        self.path = path
        case = tomllib.loads(path.read_text())
        flow, powder, grains = case["flow"], case["materials"][0], case["particles"][0]
        self.side = case["domain"]["max"][0]
        self.cell = math.pi / flow["wavenumber"]
        self.amplitude, self.wavenumber = flow["amplitude"], flow["wavenumber"]
        self.speed = MEAN_SPEED * flow["amplitude"]
        self.turnover = self.cell / self.speed
        self.diameter, self.gap = grains["diameter"], grains["effect_gap"]
        self.density, self.restitution = powder["density"], powder["restitution"]
        self.stiffness = powder["stiffness"]
        self.reduced_mass = self.density * math.pi / 6 * self.diameter**3 / 2

    def viscosity(self, stokes):
        """The viscosity of the fluid at which the relaxation time is this many turnovers."""
        return self.density * self.diameter**2 / (18 * stokes * self.turnover)

    def cohesion(self, stickiness):
        """The stiffness of cohesion at which an impact with the mean speed of the flow has this stickiness number."""
        part = (stickiness * self.restitution) ** 2
        return self.reduced_mass * self.speed**2 * part / (1 - part) / self.gap**2


def settings(base, stokes, stickiness, seed, turnovers):
    """What `scree run case.toml` needs to be told."""
    return ["--set", f"flow.viscosity={base.viscosity(stokes)!r}",
            "--set", f"materials.powder.cohesion_stiffness={base.cohesion(stickiness)!r}",
            "--set", f"simulation.seed={seed}",
            "--set", f"simulation.end={turnovers * base.turnover!r}"]


def directory(runs, stokes, stickiness, seed):
    return runs / f"stokes{stokes:g}_stickiness{stickiness:g}_seed{seed}"
