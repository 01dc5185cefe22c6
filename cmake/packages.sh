# cmake/packages.sh: the Debian 12 packages Sinew needs, and how they get there. Sourced by run.sh and test.sh.
# shellcheck shell=bash

# To configure, build and start the program.
sinewRunPackages=(
  g++ cmake ninja-build pkg-config
  libglm-dev nlohmann-json3-dev libtinygltf-dev libstb-dev libhwy-dev libtbb-dev libeigen3-dev libdraco-dev libmeshoptimizer-dev libwebp-dev  # core
  libglfw3-dev libimgui-dev libepoxy-dev libegl-dev libopengl-dev libgl-dev libfreetype-dev libfribidi-dev libspng-dev libcli11-dev  # app
  libgl1-mesa-dri  # OpenGL 4.5 in software where there is no graphics card
  fonts-inter fonts-dejavu-core  # the editor's letters
)

# To build and use the Python module as well.
# shellcheck disable=SC2034  # run.sh python reads it
sinewPythonPackages=(python3-dev pybind11-dev python3-numpy)

# To build and run the tests as well: their libraries; Python for the scripts, a display without a screen, simulated input, screenshots, the source
# format; what a farm runs; what makes and checks a Debian package, and the shells whose completion is tried.
# shellcheck disable=SC2034  # test.sh reads it
sinewTestPackages=("${sinewRunPackages[@]}" libgtest-dev libbenchmark-dev python3 xvfb xauth xdotool imagemagick
  clang-format-14 lld
  "${sinewPythonPackages[@]}" mypy  # the Python module, and its types
  fonts-noto-cjk  # Chinese, Japanese and Korean names in the window
  parallel slurm-wlm  # jobs shared out
  git dpkg-dev binutils lintian desktop-file-utils appstream shared-mime-info man-db util-linux fish zsh)

# For .ci/run and the long run besides: other programs that open what Sinew writes. Node's own packages come from npm while tests run.
# shellcheck disable=SC2034  # test.sh reads it
sinewPartsPackages=(blender chromium mono-mcs mono-runtime clang-14 libclang-rt-14-dev)
command -v npm >/dev/null || sinewPartsPackages+=(nodejs npm)  # Node from elsewhere brings its own npm.

# Progress goes to stderr, so that a verb's result has stdout for itself.
sinewSay() { printf 'sinew: %s\n' "$*" >&2; }

# Stops with one line on stderr.
sinewFail() { sinewSay "$*"; exit 1; }

# Prints those of the named packages that are not installed. Needs no network.
sinewMissingPackages() {
  local installed
  # dpkg-query fails when it does not know one of the names; that is an answer, not an error.
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null || true)
  local package
  for package in "$@"; do
    grep -qxF -- "$package installed" <<<"$installed" || printf '%s\n' "$package"
  done
}

# Installs what is missing of the named packages; touches the network only then.
sinewInstallPackages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    sinewFail "this script installs its packages with apt-get and this system has none; install the equivalents of: $*"
  fi
  local missing
  mapfile -t missing < <(sinewMissingPackages "$@")
  ((${#missing[@]} == 0)) && return 0
  local asRoot=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || sinewFail "not root and no sudo: as root, run: apt-get install ${missing[*]}"
    asRoot=(sudo)
  fi
  sinewSay "installing ${missing[*]}"
  local apt=("${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=120 -q)
  "${apt[@]}" update >&2 || sinewSay "apt-get update failed; trying with the package lists that are there"
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >&2 ||
    sinewFail "apt-get could not install: ${missing[*]}"
}

# sinewBuild ROOT PRESET [TARGET [OPTION...]]: configures once, with the options, then builds what changed; a build with
# nothing to do takes a second.
sinewBuild() {
  local root=$1 preset=$2 target=${3:-all}
  local options=("${@:4}") build=$root/build/$preset launcher=()
  command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  # A build made before the project was moved names the old directory everywhere.
  if [[ -f $build/CMakeCache.txt ]] && ! grep -qxF -- "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
    sinewSay "$build was configured for another directory: making it again"
    rm -rf -- "$build"
  fi
  if [[ ! -f $build/build.ninja ]]; then
    sinewSay "configuring $build"
    cmake -S "$root" --preset "$preset" "${launcher[@]}" "${options[@]}" >&2 || sinewFail "cmake could not configure $build"
    sinewSay "building $build; the first time takes minutes"
  fi
  cmake --build "$build" --target "$target" >&2 || sinewFail "the build in $build failed; see its messages above"
}
