"""Kills a run at random moments and continues it from its newest checkpoint:
kill.py SCREE DIRECTORY KILLS [MPIEXEC RANKS].

After every kill all files must be readable by other people's readers and the newest checkpoint must load. The run that was
killed so often must end like one that nobody touched: the same state_hash, the same tables, the same frames. With several
ranks one of them is killed, and the others must go down with it; the run that nobody touches is one process.
"""

import csv
import glob
import json
import math
import os
import random
import shutil
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree as xml

import h5py
import numpy

CASE = """
[simulation]
end = 0.12
time_step = 2e-5
max_overlap = 0.9

[domain]
min = [0, 0, 0]
max = [0.03, 0.03, 0.03]

[gravity]
type = "uniform"
acceleration = [1, 0, -9.81]

[contact]
rolling = "spring"
twisting = "spring"

[[materials]]
name = "glass"
density = 2000
stiffness = 1000
restitution = 0.97
friction = 0.3
friction_sliding = 0.2
rolling_friction = 0.02
twisting_friction = 0.1

[[particles]]
material = "glass"
diameter = { distribution = "uniform", min = "3 mm", max = "5 mm" }
insert = "random"
count = 250
velocity = { type = "random", deviation = 1 }

[[walls]]
type = "box"
material = "glass"
min = [0, 0, 0]
max = [0.03, 0.03, 0.03]

[output]
series = 0.0005
frames = 0.002
checkpoints = 0.001
tracks = [0, 7]

[analysis]
agglomerates = true
"""


ENVIRONMENT = os.environ | {
    "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_MCA_hwloc_base_binding_policy": "none"}


def command(scree, case, directory, restart, launcher=()):
    words = [*launcher, scree, "run", case, "-o", directory, "--quiet", "--threads", "1" if launcher else "2"]
    return words + (["--restart", restart] if restart else ["--force"])


def run_to_the_end(scree, case, directory, restart=None, launcher=(), more=()):
    start = time.monotonic()
    subprocess.run(command(scree, case, directory, restart, launcher) + list(more), check=True, env=ENVIRONMENT)
    return time.monotonic() - start


def ranks_of(launcher_pid):
    return [int(pid) for pid in subprocess.run(["pgrep", "-P", str(launcher_pid)], capture_output=True,
                                               text=True).stdout.split()]


def alive(pid):
    """False for a process that is gone or has left nothing but its exit status."""
    try:
        with open(f"/proc/{pid}/stat") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


def wait_for_launcher(process, ranks):
    """Open MPI's mpirun may hang while it shuts itself down (4.1.4, in PMIx_server_finalize), when all ranks are gone."""
    try:
        process.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        left = [pid for pid in ranks if alive(pid)]
        assert not left, f"processes {left} go on without the one that was killed"
        print("mpirun hangs without any rank", flush=True)
        process.kill()
        process.communicate(timeout=60)


def run_and_kill(scree, case, directory, restart, delay, launcher=(), which=0):
    """True if the run was killed, False if it ended before."""
    process = subprocess.Popen(command(scree, case, directory, restart, launcher), stderr=subprocess.PIPE, env=ENVIRONMENT)
    try:
        _, text = process.communicate(timeout=delay)
    except subprocess.TimeoutExpired:
        ranks = ranks_of(process.pid) if launcher else []
        try:
            os.kill(ranks[which % len(ranks)] if ranks else process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass  # it has just ended
        wait_for_launcher(process, ranks)
        if launcher and process.returncode == 0:
            # The rank had just ended, like all the others: what is killed while it runs mpirun tells by its exit status.
            with open(f"{directory}/summary.json") as file:
                assert json.load(file)["status"] == "finished", "the other ranks go on without the one that was killed"
            return False
        return True
    assert process.returncode == 0, f"the run ended with {process.returncode}: {text.decode()}"
    return False


def load(group):
    """Reads every dataset of a file to the last byte."""
    group.visititems(lambda name, item: item[()] if isinstance(item, h5py.Dataset) else None)


def read_everything(directory):
    """Reads all files that a kill has left with other people's readers."""
    for path in glob.glob(f"{directory}/frames/*.h5") + glob.glob(f"{directory}/checkpoints/*.h5"):
        with h5py.File(path) as file:
            load(file)
    if os.path.exists(f"{directory}/fields.xdmf"):
        for grid in xml.parse(f"{directory}/fields.xdmf").getroot().iter("DataItem"):
            assert os.path.exists(os.path.join(directory, grid.text.split(":")[0])), f"no frame {grid.text}"
    for name in glob.glob(f"{directory}/*.csv"):
        with open(name, newline="") as file:
            header, *rows = csv.reader(file)
        # Only the very last line may be torn.
        for row in rows[:-1]:
            assert len(list(map(float, row))) == len(header), f"{name}: {row}"


def newest(directory):
    found = sorted(glob.glob(f"{directory}/checkpoints/*.h5"))
    return found[-1] if found else None


def same_arrays(one, other):
    with h5py.File(one) as a, h5py.File(other) as b:
        names = []
        a.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
        return all(numpy.array_equal(a[name][()], b[name][()]) for name in names)


def column(path, name):
    with open(path, newline="") as file:
        return [float(row[name]) for row in csv.DictReader(file)]


def compare(directory, truth):
    for run in (directory, truth):
        with open(f"{run}/summary.json") as file:
            assert json.load(file)["status"] == "finished"
    assert all(map(math.isfinite, column(f"{truth}/series.csv", "collision_speed")[1:])), "too quiet a case"
    hashes = [json.load(open(f"{run}/summary.json"))["state_hash"] for run in (directory, truth)]
    assert hashes[0] == hashes[1], "another final state"
    for name in ("series.csv", "tracks.csv", "agglomerates.csv", "fields.xdmf"):
        with open(f"{directory}/{name}") as a, open(f"{truth}/{name}") as b:
            assert a.read() == b.read(), f"{name} differs"
    frames = [sorted(os.listdir(f"{run}/frames")) for run in (directory, truth)]
    assert frames[0] == frames[1], f"frames {frames[0]} instead of {frames[1]}"
    for name in frames[0]:
        assert same_arrays(f"{directory}/frames/{name}", f"{truth}/frames/{name}"), f"{name} differs"


def main(scree, directory, kills, launcher=()):
    shutil.rmtree(directory, ignore_errors=True)
    os.makedirs(directory)
    case = f"{directory}/kill.toml"
    with open(case, "w") as file:
        # Ranks wait for each other where tests share processors.
        file.write(CASE.replace("end = 0.12", "end = 0.03") if launcher else CASE)
    truth, victim = f"{directory}/truth", f"{directory}/victim"
    duration = run_to_the_end(scree, case, truth)
    begin = 0
    if launcher:
        begin = run_to_the_end(scree, case, victim, launcher=launcher, more=["--until", "1e-4"])
        duration = run_to_the_end(scree, case, victim, launcher=launcher, more=["--force"]) - begin
        shutil.rmtree(victim)
    moments = random.Random(1)
    done, resumed = 0, 0
    while done < kills:
        restart = newest(victim)
        # Short delays too: a kill may come while the files of the run are being made or cut.
        delay = moments.uniform(0.5 * begin, 1.2 * begin + 2.5 * duration / kills)
        if not run_and_kill(scree, case, victim, restart, delay, launcher, done):
            shutil.rmtree(victim)  # it came to its end: once more from the start
            continue
        done += 1
        resumed += restart is not None
        read_everything(victim)
    run_to_the_end(scree, case, victim, newest(victim), launcher)
    compare(victim, truth)
    assert resumed > kills / 3, f"only {resumed} of {kills} kills hit a continued run"
    print(f"{kills} kills, {resumed} of them of a continued run; the end is the same")
    shutil.rmtree(directory)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]), [sys.argv[4], "-n", sys.argv[5]] if len(sys.argv) > 4 else [])
