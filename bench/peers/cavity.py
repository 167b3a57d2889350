"""The lid-driven cube in Scree and in OpenFOAM's icoFoam: cells per second of a step, and errors.

usage: cavity.py SCREE [CELLS [ROUNDS [no-reference]]]

Both take the same steps from rest to t = 0.5 (viscosity 0.01, lid at 1, Courant number 0.32), in second order in space and time, on one
core, in turns. Both leave about as much of the volume wrong in a step; the second table is against Scree on twice the cells.
Needs Debian's package openfoam.
"""
import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile

END = 0.5
HEAD = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
FILES = {
    "system/blockMeshDict": ("dictionary", """
vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));
blocks (hex (0 1 2 3 4 5 6 7) (N N N) simpleGrading (1 1 1));
boundary ( lid {{ type wall; faces ((3 7 6 2)); }}
  walls {{ type wall; faces ((0 4 7 3) (2 6 5 1) (1 5 4 0) (0 3 2 1) (4 5 6 7)); }} );"""),
    "system/controlDict": ("dictionary", """
application icoFoam; startFrom startTime; startTime 0; stopAt endTime; endTime END; deltaT DT;
writeControl runTime; writeInterval END; writeFormat ascii; writePrecision 12; timePrecision 8;"""),
    "system/fvSchemes": ("dictionary", """
ddtSchemes {{ default backward; }} gradSchemes {{ default Gauss linear; }}
divSchemes {{ default none; div(phi,U) Gauss linear; }} laplacianSchemes {{ default Gauss linear orthogonal; }}
interpolationSchemes {{ default linear; }} snGradSchemes {{ default orthogonal; }}"""),
    "system/fvSolution": ("dictionary", """
solvers {{
  p {{ solver GAMG; smoother GaussSeidel; tolerance 1e-6; relTol 0.05; }} pFinal {{ $p; relTol 0; }}
  U {{ solver smoothSolver; smoother symGaussSeidel; tolerance 1e-6; relTol 0; }} }}
PISO {{ nCorrectors 2; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0; }}"""),
    "constant/transportProperties": ("dictionary", "nu 0.01;"),
    "0/U": ("volVectorField", """
dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField {{ lid {{ type fixedValue; value uniform (1 0 0); }} walls {{ type noSlip; }} }}"""),
    "0/p": ("volScalarField", """
dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField {{ lid {{ type zeroGradient; }} walls {{ type zeroGradient; }} }}"""),
}
CASE = """
[simulation]
end = {end}
[domain]
min = [0, 0, 0]
max = [1, 1, 1]
[fluid]
type = "incompressible"
density = 1
viscosity = 0.01
cells = [{n}, {n}, {n}]
time_step = {dt}
divergence_tolerance = 3e-9
viscous_tolerance = 1e-6
[[fluid.patches]]
name = "lid"
face = "y_max"
velocity = ["1", "0", "0"]
[[fluid.lines]]
name = "middle"
from = [0.5, {low}, 0.5]
to = [0.5, {high}, 0.5]
points = 32
every = {end}
[output]
frames = 0
series = {end}
"""


def timed(command, **options):
    """Seconds of the processor that a command takes, and what it prints."""
    before = os.times()
    done = subprocess.run(command, check=True, capture_output=True, text=True, **options)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system, done.stdout


def icofoam(folder, n, steps):
    """Seconds of a step, error of the volume, and u_x along the middle line, at 32 places."""
    for name, (kind, text) in FILES.items():
        path = folder / name
        path.parent.mkdir(exist_ok=True, parents=True)
        text = text.format().replace("N N N", f"{n} {n} {n}").replace("END", str(END)).replace("DT", repr(END / steps))
        path.write_text(HEAD.format(kind, path.name) + text + "\n")
    environment = {"WM_PROJECT_DIR": "/usr/share/openfoam", "PATH": "/usr/bin:/bin", "FOAM_SIGFPE": "false"}
    subprocess.run(["blockMesh"], cwd=folder, env=environment, check=True, capture_output=True)
    seconds, log = timed(["icoFoam"], cwd=folder, env=environment)
    volume = [float(v) for v in re.findall(r"sum local = ([0-9.e+-]+)", log)]
    text = (folder / str(END) / "U").read_text()
    values = [tuple(map(float, v.split())) for v in re.findall(r"^\(([-0-9.e+ ]+)\)$", text, re.M)]
    cell = lambda i, j, k: values[i + n * (j + n * k)][0]
    half = (n // 2 - 1, n // 2)
    column = [sum(cell(i, j, k) for i in half for k in half) / 4 for j in range(n)]
    return seconds / steps, volume[-1], sample(column)


def sample(column):
    """Linear between the middles of cells, at 32 even places from 1/64 on."""
    n, out = len(column), []
    for m in range(32):
        at = (m + 0.5) / 32 * n - 0.5
        i = min(int(at), n - 2)
        out.append(column[i] + (at - i) * (column[i + 1] - column[i]))
    return out


def scree(program, folder, n, steps):
    (folder / "case.toml").write_text(CASE.format(n=n, dt=END / steps, end=END, low=1 / 64, high=63 / 64))
    seconds, _ = timed([program, "run", "case.toml", "-o", "out", "--threads", "1", "--quiet", "--force"], cwd=folder)
    last = list(csv.DictReader((folder / "out/lines/middle.csv").open()))[-32:]
    series = list(csv.DictReader((folder / "out/series.csv").open()))
    return seconds / steps, float(series[-1]["divergence"]), [float(r["u_x"]) for r in last]


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    n = int(sys.argv[2]) if len(sys.argv) > 2 else 64
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    steps = round(END * n / 0.32)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "scree").mkdir()
        print(f"{n}^3 cells, {steps} steps; seconds per step, millions of cells per second, error of volume in a step")
        for _ in range(rounds):
            for who, found in (("icoFoam", icofoam(folder / "ico", n, steps)),
                               ("scree", scree(program, folder / "scree", n, steps))):
                print(f"{who:10} {found[0]:8.4f} {n ** 3 / found[0] / 1e6:8.3f} {found[1]:10.2e}", flush=True)
                if who == "icoFoam":
                    ico = found
                else:
                    own = found
        if len(sys.argv) > 4:
            return
        fine = scree(program, folder / "scree", 2 * n, 2 * steps)
        print("largest error of u_x along the middle line against twice the cells")
        for who, found in (("icoFoam", ico), ("scree", own)):
            print(f"{who:10} {max(abs(a - b) for a, b in zip(found[2], fine[2])):10.2e}")


main()
