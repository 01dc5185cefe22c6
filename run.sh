#!/usr/bin/env bash
# run.sh: from a bare Debian 12 to a running Sinew. Arguments go to the program: ./run.sh inspect FILE --json
# ./run.sh python [SCRIPT...] is Debian's Python with the module sinew, ./run.sh blender [RIG] Blender with the add-on.
set -euo pipefail
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
source "$root/cmake/packages.sh"

if [[ ${1:-} == python || ${1:-} == blender ]]; then
  wanted=()
  [[ $1 == blender ]] && ! command -v blender >/dev/null && wanted=(blender)
  sinewInstallPackages "${sinewRunPackages[@]}" "${sinewPythonPackages[@]}" "${wanted[@]}"
  build=$root/build/release
  # A build that was made before the packages were there is without the module.
  if grep -qsxF -- "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt" &&
    ! grep -qxF "SINEW_BUILD_PYTHON:BOOL=ON" "$build/CMakeCache.txt"; then
    cmake -S "$root" -B "$build" -D SINEW_BUILD_PYTHON=ON >&2 || sinewFail "cmake could not configure $build"
  fi
  sinewBuild "$root" release sinew_python -D SINEW_BUILD_TESTS=OFF -D SINEW_BUILD_PYTHON=ON
  export PYTHONPATH=$build/python${PYTHONPATH:+:$PYTHONPATH}
  [[ $1 == python ]] && exec /usr/bin/python3 "${@:2}"
  # Debian's Blender takes the first Python in PATH for its own, and the module is for Debian's.
  PATH=/usr/bin:$PATH exec blender --factory-startup --python "$root/blender/try.py" -- "${@:2}"
fi

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
