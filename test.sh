#!/usr/bin/env bash
# test.sh: installs, builds with warnings fatal, runs the tests. Arguments go to ctest: ./test.sh -R surface
# -C ci adds other programs that open what Sinew writes, -C long everything. Without either what takes long is left out.
set -euo pipefail
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
source "$root/cmake/packages.sh"

packages=("${sinewTestPackages[@]}")
[[ " $* " == *" -C "* ]] && packages+=("${sinewPartsPackages[@]}")
sinewInstallPackages "${packages[@]}"
began=$SECONDS
sinewBuild "$root" ci
sinewSay "the build took $((SECONDS - began)) s"

# Why tests were left out, each reason once with its count, from what the skipped tests themselves printed.
leftOut() {
  local reasons
  reasons=$(sed -n '/: Skipped$/{n;p;d}; /^left out: /p' "$root/build/ci/Testing/Temporary/LastTest.log" 2>/dev/null |
    sed '/^$/d' | sort | uniq -c | sed -E 's/^ *([0-9]+) (left out: )?/  \1 x /')
  printf 'Left out:\n%s\n' "${reasons:-  nothing}"
}

# ctest's closing lines are held back until the reasons are printed, so that they end the output.
closing=$(mktemp)
trap 'rm -f "$closing"' EXIT
status=0
ctest --test-dir "$root/build/ci" --output-on-failure -j "$(nproc)" "$@" 2>&1 |
  awk -v closing="$closing" '/^[0-9]+% tests passed/ { held = 1 } held { print > closing; next } { print; fflush() }' ||
  status=$?
[[ -s $closing ]] && leftOut && printf '\n' && cat "$closing"
exit "$status"
