#!/bin/bash
# Times Scree and its peers on a benchmark scene, in turns, and prints millions of particle-steps per second.
#   run.sh dense|dilute|drum|silo|mix [ROUNDS] [PACKINGS]
# ROUNDS (default 3) repeats everything, interleaved, since identical runs vary; PACKINGS is the folder with the tables and
# meshes (default: bench/packings). A program that is not installed is left out; SCREE names that of Scree.
# STEPS sets the steps of a run of a peer on one process, for a quick trial.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
scene=${1:?usage: run.sh dense|dilute|drum|silo|mix [ROUNDS] [PACKINGS]}
rounds=${2:-3}
packings=${3:-$here/../packings}
scree=${SCREE:-$here/../../build/release/scree}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Steps of a run, for 10 to 20 s; skins as tuned for each peer (README.md).
boundary="f f f" gravity=1 step=5e-6 steps=600 skin_lammps=1e-4 skin_liggghts=1e-4 walls=/dev/null lammps=0
case $scene in
dense) box="0.08 0.08 0.16" boundary="p p f" walls=$here/floor.liggghts lammps=1 ;;
dilute) box="0.2031 0.2031 0.2031" boundary="p p p" gravity=0 steps=3000 skin_lammps=4e-4 skin_liggghts=4e-4 lammps=1 ;;
drum) box="0.184 0.124 0.124" skin_liggghts=4e-4 walls=$here/drum.liggghts ;;
silo) box="0.064 0.064 0.432" walls=$here/silo.liggghts ;;
mix) box="0.0704 0.0704 0.0704" boundary="p p p" gravity=0 step=2.5e-6 skin_liggghts=4e-4 ;;
*) echo "unknown scene '$scene'; use dense, dilute, drum, silo or mix" >&2 && exit 2 ;;
esac
steps=${STEPS:-$steps}
# shellcheck disable=SC2086  # the box is three words
/usr/bin/python3 "$here/csv_to_data.py" "$packings/$scene.csv" 2500 $box "$work/scene.data"
particles=$(awk '/ atoms/ {print $1; exit}' "$work/scene.data")

# peer NAME PROCESSES COMMAND...: runs a peer and prints its rate, from the time it gives for its last run.
peer() {
  local name=$1 processes=$2
  shift 2
  command -v "$1" >/dev/null || return 0
  if ! OMP_NUM_THREADS=1 mpirun --allow-run-as-root --oversubscribe --bind-to none -n "$processes" "$@" -log none \
    -var data "$work/scene.data" -var steps $((steps * processes)) >"$work/log" 2>&1; then
    tail -n 20 "$work/log" >&2
    exit 1
  fi
  awk -v name="$name" -v processes="$processes" -v steps=$((steps * processes)) -v particles="$particles" '
    /^Loop time of/ {seconds = $4}
    /Neighbor list builds/ {builds = $NF}
    END {printf "%-16s %9d %9.2f %9.1f %9d\n", name, processes, particles * steps / seconds / 1e6, seconds, builds}
  ' "$work/log"
}

# scree_rate THREADS: one round of `scree bench`.
scree_rate() {
  [ -x "$scree" ] || return 0
  "$scree" bench "$scene" --threads "$1" --rounds 3 --packings "$packings" --json "$work/scree.json" >/dev/null
  /usr/bin/python3 - "$work/scree.json" <<'PYTHON'
import json
import sys

(figures,) = json.load(open(sys.argv[1]))["figures"]
print(f"{'scree':16} {figures['threads']:9} {figures['particle_steps_per_second'] / 1e6:9.2f}")
PYTHON
}

printf '%-16s %9s %9s %9s %9s\n' "$scene" processes Mps/s seconds rebuilds
for ((round = 1; round <= rounds; ++round)); do
  for processes in 1 2; do
    scree_rate "$processes"
    if ((lammps)); then
      for law in history granular; do
        peer "lammps-$law" "$processes" lmp -in "$here/scene.lmp" -var law $law -var skin "$skin_lammps" -var dense "$gravity"
      done
    fi
    peer liggghts "$processes" liggghts -in "$here/scene.liggghts" -var skin "$skin_liggghts" -var step "$step" \
      -var boundary "$boundary" -var gravity "$gravity" -var walls "$walls" -var mesh "$packings/$scene.stl"
  done
done
