#!/usr/bin/env bash
# run.sh: from a bare Debian 12 to a running Sinew. Arguments go to the program: ./run.sh inspect FILE --json
set -euo pipefail
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
source "$root/cmake/packages.sh"

sinewInstallPackages "${sinewRunPackages[@]}"
# Whoever only runs the program needs no test library; `cmake --preset release` adds the tests to the same build.
sinewBuild "$root" release sinew -D SINEW_BUILD_TESTS=OFF
program=$root/build/release/app/sinew

# Nothing asked for and no screen to open a window on: show the playback as pictures.
if (($# == 0)) && [[ -z ${DISPLAY:-} && -z ${WAYLAND_DISPLAY:-} ]]; then
  mkdir -p "$root/out"
  sinewSay "no display (DISPLAY and WAYLAND_DISPLAY are empty): rendering 24 frames of the walk into $root/out"
  exec "$program" render "$root/assets/humanoid.rig.json" --clip Walk --fps 22 --frames 0:23 -o "$root/out/walk_%04d.png"
fi
exec "$program" "$@"
