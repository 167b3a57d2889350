#!/bin/bash
# Times the peers on a benchmark scene and prints millions of particle-steps per second.
#   run.sh dense|dilute [ROUNDS] [PACKINGS]
# ROUNDS (default 3) repeats everything, interleaved, since identical runs vary; PACKINGS is the folder with dense.csv and
# dilute.csv (default: bench/packings). A peer that is not installed is left out.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
scene=${1:?usage: run.sh dense|dilute [ROUNDS] [PACKINGS]}
rounds=${2:-3}
packings=${3:-$here/../packings}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Steps of a run, for 10 to 20 s; skins as tuned for each peer (README.md).
case $scene in
dense) dense=1 box="0.08 0.08 0.16" steps=600 skin_lammps=1e-4 skin_liggghts=1e-4 ;;
dilute) dense=0 box="0.2031 0.2031 0.2031" steps=3000 skin_lammps=4e-4 skin_liggghts=4e-4 ;;
*) echo "unknown scene '$scene'; use dense or dilute" >&2 && exit 2 ;;
esac
# shellcheck disable=SC2086  # the box is three words
/usr/bin/python3 "$here/csv_to_data.py" "$packings/$scene.csv" 2500 $box "$work/scene.data"
particles=$(awk '/ atoms/ {print $1; exit}' "$work/scene.data")

# rate NAME PROCESSES COMMAND...: runs a peer and prints its rate, from the time it gives for its last run.
rate() {
  local name=$1 processes=$2
  shift 2
  command -v "$1" >/dev/null || return 0
  if ! OMP_NUM_THREADS=1 mpirun --allow-run-as-root --oversubscribe --bind-to none -n "$processes" "$@" -log none \
    -var dense "$dense" -var data "$work/scene.data" -var steps $((steps * processes)) >"$work/log" 2>&1; then
    tail -n 20 "$work/log" >&2
    exit 1
  fi
  awk -v name="$name" -v processes="$processes" -v steps=$((steps * processes)) -v particles="$particles" '
    /^Loop time of/ {seconds = $4}
    /Neighbor list builds/ {builds = $NF}
    END {printf "%-16s %9d %9.2f %9.1f %9d\n", name, processes, particles * steps / seconds / 1e6, seconds, builds}
  ' "$work/log"
}

printf '%-16s %9s %9s %9s %9s\n' "$scene" processes Mps/s seconds rebuilds
for ((round = 1; round <= rounds; ++round)); do
  for processes in 1 2; do
    rate lammps-history "$processes" lmp -in "$here/scene.lmp" -var law history -var skin "$skin_lammps"
    rate lammps-granular "$processes" lmp -in "$here/scene.lmp" -var law granular -var skin "$skin_lammps"
    rate liggghts "$processes" liggghts -in "$here/scene.liggghts" -var skin "$skin_liggghts"
  done
done
