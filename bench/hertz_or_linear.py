#!/usr/bin/python3
"""Linear against Hertz contact: accuracy and time. usage: hertz_or_linear.py PROGRAM [PICTURE.png]

PROGRAM is scree. Prints the tables of docs/hertz_or_linear.md and, if asked, draws them; half a minute and a quiet machine are
enough.
"""

import csv
import math
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
LAWS = {"linear": 'normal = "linear"\ntangential = "history"', "hertz": 'normal = "hertz"\ntangential = "mindlin"'}
EXPERIMENT = ((2.0275, 0.7938), (3.9282, 0.7450), (9.6304, 0.6728), (20.0845, 0.5964), (30.2218, 0.6883), (39.3031, 0.7719),
              (49.5459, 0.8469), (59.8416, 0.9019))  # angle of impact [deg], e_t: Kharaz, Gorham and Salman 2001

# Test 1 of Chung and Ooi 2011: glass spheres of 20 mm meet at 10 m/s each.
MASS = 2800 * 4 / 3 * math.pi * 0.01**3
HERTZ = 4 / 3 * (48e9 / (2 * (1 - 0.2**2))) * math.sqrt(0.005)  # force over overlap^1.5
DEEPEST = (5 / 4 * MASS / 2 * 20**2 / HERTZ) ** 0.4             # overlap at 20 m/s [m]
STIFFNESS = MASS / 2 * 20**2 / DEEPEST**2                       # of the linear spring with the same overlap there

HEAD_ON = """
[simulation]
end = {end}
time_step = {step}
max_overlap = 0.5
[domain]
min = [-0.05, -0.02, -0.02]
max = [0.05, 0.02, 0.02]
[contact]
{law}
[[materials]]
name = "glass"
density = 2800
{elastic}
[[particles]]
material = "glass"
diameter = 0.02
insert = "positions"
positions = [[{left}, 0, 0]]
velocity = [{speed}, 0, 0]
[[particles]]
material = "glass"
diameter = 0.02
insert = "positions"
positions = [[0.01, 0, 0]]
velocity = [-{speed}, 0, 0]
[output]
series = {step}
tracks = [0]
"""

BED = """
[simulation]
end = 0.2
time_step = 5e-6
max_overlap = 0.5
[domain]
min = [0, 0, -0.001]
max = [0.01, 0.01, 0.08]
periodic = [true, true, false]
[gravity]
type = "uniform"
acceleration = [0, 0, -9.81]
[contact]
{law}
[[materials]]
name = "bead"
density = 2500
{elastic}
restitution = 0.5
friction = 0.5
[[particles]]
material = "bead"
diameter = 0.001
insert = "random"
count = 2400
region_min = [0, 0, 0]
region_max = [0.01, 0.01, 0.06]
attempts = 100000
[[walls]]
name = "floor"
type = "plane"
material = "bead"
point = [0, 0, 0]
normal = [0, 0, 1]
[[analysis.regions]]
name = "core"
min = [0, 0, 0.004]
max = [0.01, 0.01, 0.015]
"""


def rows(path):
    with open(path, newline="") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


class Runner:
    """Runs cases, each in a directory of its own."""

    def __init__(self, program, space):
        self.program, self.space, self.count = program, pathlib.Path(space), 0

    def run(self, text_or_path, changes=()):
        """Directory of the results."""
        self.count += 1
        out = self.space / f"run{self.count}"
        case = text_or_path
        if not isinstance(case, pathlib.Path):
            case = self.space / f"case{self.count}.toml"
            case.write_text(text_or_path)
        arguments = [self.program, "run", case, "-o", out, "--threads", "1", "--quiet"]
        for change in changes:
            arguments += ["--set", change]
        subprocess.run([str(a) for a in arguments], check=True, stderr=subprocess.DEVNULL)
        return out


def head_on(runner, law, speed, step, phase=0.5):
    """Duration over the step, largest overlap [m] and speed afterwards over that before; first touch `phase` steps off a step."""
    elastic = f"stiffness = {STIFFNESS}" if law == "linear" else "young = 48e9\npoisson = 0.2"
    longest = 1.3 * 2.9433 * DEEPEST / 20 * (10 / speed) ** 0.2
    text = HEAD_ON.format(law=LAWS[law], elastic=elastic, speed=speed, step=step, end=longest + 8 * step,
                          left=-0.01 - 2 * speed * step * (2 + phase))
    out = runner.run(text)
    series, tracks = rows(out / "series.csv"), rows(out / "tracks.csv")
    in_touch = sum(row["max_overlap"] > 0 for row in series)
    return in_touch, 0.01 * max(row["max_overlap"] for row in series), -tracks[-1]["vx"] / speed


def impacts(runner):
    """How overlap and duration follow the speed."""
    print("| speed of each [m/s] | Hertz: overlap [um], closed | simulated | duration [us], closed | simulated "
          "| linear: overlap [um] | duration [us] |\n" + "|---" * 7 + "|")
    found = []
    for speed in (0.01, 0.1, 1, 10):
        overlap = DEEPEST * (speed / 10) ** 0.8
        duration = 2.9432751 * overlap / (2 * speed)
        step = duration / 2000
        hertz, linear = (head_on(runner, law, speed, step) for law in ("hertz", "linear"))
        found.append((speed, overlap, hertz[1], linear[1], duration, hertz[0] * step, linear[0] * step))
        print(f"| {speed:g} | {1e6 * overlap:.4g} | {1e6 * hertz[1]:.4g} | {1e6 * duration:.4g} | {1e6 * hertz[0] * step:.4g} "
              f"| {1e6 * linear[1]:.4g} | {1e6 * linear[0] * step:.4g} |")
    return found


def steps(runner):
    """Error of the speed after an elastic impact by the steps that it takes; the worst of eight phases of the first touch."""
    print("\n| steps per contact | error of the speed after, Hertz | linear |\n|---|---|---|")
    found = []
    for count in (12.5, 25, 50, 100, 200):
        errors = []
        for law, duration in (("hertz", 2.9432751 * DEEPEST / 20), ("linear", math.pi * DEEPEST / 20)):
            errors.append(max(abs(head_on(runner, law, 10, duration / count, k / 8)[2] - 1) for k in range(8)))
        found.append((count, *errors))
        print(f"| {count:g} | {errors[0]:.2g} | {errors[1]:.2g} |")
    return found


def oblique(runner):
    """Tangential restitution of a sphere that hits a plane obliquely, beside the experiment."""
    print("\n| angle [deg] | measured | Hertz, mindlin | Hertz, mindlin_stretch | linear |\n|---|---|---|---|---|")
    cases = (("06_oblique_impact", []), ("06_oblique_impact", ["contact.tangential=mindlin_stretch"]), ("14_dem05_oblique_linear", []))
    found = []
    for angle, measured in EXPERIMENT:
        vx, vz = 3.9 * math.sin(math.radians(angle)), -3.9 * math.cos(math.radians(angle))
        row = [angle, measured]
        for name, changes in cases:
            out = runner.run(ROOT / "verify" / name / "case.toml", [
                f"particles.sphere.velocity.value=[{vx!r}, 0, {vz!r}]",
                f"particles.sphere.positions=[[0, 0, {0.0025 - 2.5 * 4e-8 * vz!r}]]", *changes])
            row.append(rows(out / "tracks.csv")[-1]["vx"] / vx)
        found.append(row)
        print("| " + " | ".join(f"{value:.3f}" for value in row) + " |")
    errors = [math.sqrt(sum((row[k] - row[1]) ** 2 for row in found) / len(found)) for k in (2, 3, 4)]
    print("| root mean square | | " + " | ".join(f"{error:.3f}" for error in errors) + " |")
    return found


def bed(runner):
    """Processor time of a bed that falls and comes to rest; both laws have the same step and overlap at 0.5 m/s."""
    print("\n| law | processor time of two runs [s] | contacts | us per step and contact | overlap at rest, largest over the diameter "
          "| solid fraction |\n" + "|---" * 6 + "|")
    mass, deepest, speed = 2500 * math.pi / 6 * 1e-9, 2e-5, 0.5
    stiffness = mass / 2 * speed**2 / deepest**2
    young = 1.25 * mass / 2 * speed**2 / deepest**2.5 / (4 / 3 * math.sqrt(2.5e-4)) * 2 * (1 - 0.3**2)
    elastic = {"linear": f"stiffness = {stiffness}", "hertz": f"young = {young}\npoisson = 0.3"}
    seconds, outs = {law: [] for law in LAWS}, {}
    for _ in range(2):
        for law in LAWS:
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            outs[law] = runner.run(BED.format(law=LAWS[law], elastic=elastic[law]))
            seconds[law].append(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
    for law, out in outs.items():
        contacts = int(re.search(r'"contacts": (\d+)', (out / "summary.json").read_text()).group(1))
        last = rows(out / "series.csv")[-1]
        times = ", ".join(f"{s:.2f}" for s in seconds[law])
        print(f"| {law} | {times} | {contacts} | {1e6 * min(seconds[law]) / contacts:.3f} | {last['max_overlap'] / 2:.4f} "
              f"| {last['core_solid_fraction']:.4f} |")


def draw(speeds, accuracy, angles, picture):
    sys.path.insert(0, str(ROOT / "share"))
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from plot_style import COLOURS, INK, STYLE

    plt.rcParams.update(STYLE)
    figure, axes = plt.subplots(1, 3, figsize=(13, 4), constrained_layout=True)
    speed, _, hertz, linear, closed, hertz_time, linear_time = zip(*speeds)
    axes[0].loglog(speed, closed, color=INK, lw=1, label="Hertz, closed form")
    axes[0].loglog(speed, hertz_time, "o", color=COLOURS[0], label="Hertz")
    axes[0].loglog(speed, linear_time, "s--", color=COLOURS[1], label="linear, same overlap at 10 m/s")
    axes[0].set(title="How long an impact lasts", xlabel="speed of each sphere [m/s]", ylabel="duration [s]")
    count, hertz, linear = zip(*accuracy)
    axes[1].loglog(count, hertz, "o-", color=COLOURS[0], label="Hertz")
    axes[1].loglog(count, linear, "s--", color=COLOURS[1], label="linear")
    axes[1].set(title="Error of the speed after an elastic impact", xlabel="steps per contact", ylabel="relative error")
    angle, measured, mindlin, stretch, linear = zip(*angles)
    axes[2].plot(angle, measured, "o", color=INK, label="measured, Kharaz et al. 2001")
    axes[2].plot(angle, mindlin, color=COLOURS[0], label="Hertz, mindlin")
    axes[2].plot(angle, stretch, ":", color=COLOURS[0], label="Hertz, mindlin_stretch")
    axes[2].plot(angle, linear, "--", color=COLOURS[1], label="linear")
    axes[2].set(title="Oblique impact", xlabel="angle to the normal [deg]", ylabel="tangential restitution")
    for a in axes:
        a.legend()
    figure.savefig(picture, dpi=110)


def main(program, picture=""):
    with tempfile.TemporaryDirectory() as space:
        runner = Runner(program, space)
        speeds, accuracy, angles = impacts(runner), steps(runner), oblique(runner)
        bed(runner)
    if picture:
        draw(speeds, accuracy, angles, picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
