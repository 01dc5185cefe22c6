#!/usr/bin/env bash
# tests/ci/sanitizers.sh: core and its tests by a second compiler, under sanitizers; then the fuzzers for a moment each.
# Usage: sanitizers.sh SOURCE BUILD
set -euo pipefail
source=$1 build=$2
command -v clang++-14 >/dev/null || { echo "left out: ci/sanitizers, clang++-14 is not installed"; exit 77; }
# Below -O2 clang inlines nothing of the standard library and GLM, and the tests take several times as long.
options=(-D SINEW_BUILD_APP=OFF -D CMAKE_CXX_COMPILER=clang++-14 -D CMAKE_C_COMPILER=clang-14 -D SINEW_WARNINGS_FATAL=ON
  -D SINEW_SANITIZE=address,undefined,fuzzer-no-link
  -D "CMAKE_CXX_FLAGS_RELWITHDEBINFO=-O2 -g1")
command -v ccache >/dev/null && options+=(-D CMAKE_CXX_COMPILER_LAUNCHER=ccache)

# Runs a step and says how long it took.
step() {
  local began=$SECONDS
  "${@:2}"
  echo "ci/sanitizers: $1: $((SECONDS - began)) s"
}

step configure cmake -S "$source" --preset asan -B "$build" "${options[@]}"
step build cmake --build "$build"
step test "$source/tests/ci/run_tests.sh" "$build/tests" tests
step found "$source/tests/ci/run_tests.sh" "$build/tests/fuzz" tests
step fuzz "$source/tests/fuzz/run.sh" "$build" "${SINEW_FUZZ:-2000runs}"
