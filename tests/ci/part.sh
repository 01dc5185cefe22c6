#!/usr/bin/env bash
# tests/ci/part.sh: one part of what .ci/run adds to test.sh. Usage: part.sh clang|sanitizers SOURCE BUILD
set -euo pipefail
part=$1 source=$2 build=$3
options=(-D SINEW_BUILD_APP=OFF)
command -v ccache >/dev/null && options+=(-D CMAKE_CXX_COMPILER_LAUNCHER=ccache)

# Runs a step and says how long it took.
step() {
  local began=$SECONDS
  "${@:2}"
  echo "ci/$part: $1: $((SECONDS - began)) s"
}

# Warnings are errors here, too, and each file is compiled alone.
clang() {
  command -v clang++-14 >/dev/null || { echo "left out: ci/clang, clang++-14 is not installed"; exit 77; }
  step configure cmake -S "$source" --preset ci -B "$build/clang" "${options[@]}" -D CMAKE_CXX_COMPILER=clang++-14 \
    -D SINEW_BUILD_TESTS=OFF -D CMAKE_UNITY_BUILD=OFF
  step build cmake --build "$build/clang" --target sinew_core
}

# Indented, so that nobody takes these closing lines for those of the whole.
testUnderSanitizers() {
  ctest --test-dir "$build/asan" --output-on-failure -j "$(nproc)" \
    -E "$(grep -v '^#' "$source/tests/ci/sanitizers_without.txt" | paste -sd '|')" 2>&1 | sed 's/^/    /'
}

# All tests of core but those that would say nothing new: they run no code of core themselves, or take minutes here.
sanitizers() {
  step configure cmake -S "$source" --preset asan -B "$build/asan" "${options[@]}"
  step build cmake --build "$build/asan"
  step test testUnderSanitizers
}

"$part"
