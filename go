#!/usr/bin/env bash
# From a fresh clone to a picture (./go demo) or to proof (./go test): installs what is missing, builds, runs.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")"

demo_name=fluidised_bed
demo_case=examples/30_$demo_name/case.toml
demo_directory=runs/$demo_name

usage() {
  cat <<TEXT
./go demo          installs what is missing, builds, runs $demo_case and draws its pictures
./go test          installs what is missing, builds and runs the tests, then the quick ones under sanitizers
./go test --all    the long tests and all other builds as well
./go help          this text

Debian packages that are missing (packages.txt) are installed as root or with sudo.
TEXT
}

say() { printf '\n== %s\n' "$*"; }
fail() { printf '%s\n' "$*" >&2; exit 1; }

# Runs a command silently into a log, which is shown if it fails.
quietly() {
  local log=build/log/$1.txt
  shift
  mkdir -p build/log
  "$@" >"$log" 2>&1 || { tail -n 40 "$log" >&2; fail "failed: $* (all of it: $log)"; }
}

# Names of the packages that are not installed; with "tests" also those that only the tests need.
missing_packages() {
  local wanted
  wanted=$(sed -e '/^#/d' -e "$([ "$1" = tests ] && echo '/^\[tests\]$/d' || echo '/^\[tests\]$/,$d')" packages.txt)
  # dpkg-query fails for names it does not know; what it does not list is missing.
  comm -23 <(sort <<<"$wanted") \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null | sed -n 's/^installed //p' | sort -u)
}

install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "This is no Debian system: taking it that the libraries of packages.txt are installed."
    return
  fi
  local missing root=()
  missing=$(missing_packages "$1")
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" != 0 ]; then
    # Without a terminal sudo cannot ask for a password.
    if command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
      root=(sudo)
    else
      fail "These packages are missing, and neither root nor sudo is there to install them:
  $(tr '\n' ' ' <<<"$missing")
Have them installed (apt-get install ...), then run ./go again."
    fi
  fi
  say "installing $(tr '\n' ' ' <<<"$missing")"
  quietly apt-update "${root[@]}" apt-get update
  quietly apt-install "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
}

# As many compilers as there are processors, and 1.5 GB of memory for each.
jobs() {
  local processors memory
  processors=$(nproc)
  memory=$(awk '/^MemAvailable/ { print int($2 / 1500000) }' /proc/meminfo)
  [ "$memory" -ge 1 ] || memory=1
  echo $((processors < memory ? processors : memory))
}

# build PRESET TARGET [CMAKE_OPTION...]
build() {
  local preset=$1 target=$2
  shift 2
  say "building $preset (build/$preset)"
  quietly "configure-$preset" cmake --preset "$preset" "$@"
  cmake --build --preset "$preset" --target "$target" -j "$(jobs)"
}

run_tests() {
  local preset=$1
  shift
  say "tests of $preset"
  ctest --preset "$preset" --no-tests=error -j "$(nproc)" "$@"
}

# test_build PRESET CTEST_OPTION...
test_build() {
  build "$1" all -DSCREE_TESTS=ON -DSCREE_WERROR=ON
  run_tests "$@"
}

demo() {
  install_packages program
  build release scree
  say "running $demo_case"
  build/release/scree run "$demo_case" -o "$demo_directory" --force
  say "drawing"
  build/release/scree plot "$demo_directory"
  cat <<TEXT

The pictures are   $demo_directory/particles.png (the bed at the end)
                   $demo_directory/series.png (the pressure drop of the bed first)
                   $demo_directory/fluid.png
The numbers are    $demo_directory/series.csv (what is in it: docs/files.md)
For ParaView       $demo_directory/fields.xdmf
The case is        $demo_case; to make it yours:  build/release/scree new $demo_name
TEXT
}

tests() {
  install_packages tests
  if [ "${1:-}" = --all ]; then
    test_build release
    test_build asan -L quick
    test_build audit -LE long
    test_build tsan -L quick
    test_build debug -L quick
    test_build no_mpi -L quick
  else
    test_build release -LE long
    test_build asan -L quick
  fi
  say "all tests passed"
}

case "${1:-help}" in
  demo) [ $# -eq 1 ] || fail "./go demo takes no options"; demo ;;
  test) [ $# -eq 1 ] || [ "$*" = "test --all" ] || fail "./go test takes no option but --all"; tests "${2:-}" ;;
  help | -h | --help) usage ;;
  *) usage >&2; exit 2 ;;
esac
