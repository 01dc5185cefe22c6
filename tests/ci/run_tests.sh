#!/usr/bin/env bash
# tests/ci/run_tests.sh: tests of core under sanitizers, but for those of sanitized_without.txt and long_tests.txt. A process takes half of a
# suite: one for each test, as ctest has it, would begin two thousand times.
# Usage: run_tests.sh DIRECTORY SUFFIX: the programs DIRECTORY/SUITE_SUFFIX
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
directory=$1 suffix=$2 shards=2
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT

# One half of one suite; what it said is shown where it failed.
runShard() {
  local program=$1 suite=$2 shard=$3 filter=$4 log=$5 began=$SECONDS status=0
  GTEST_TOTAL_SHARDS=$shards GTEST_SHARD_INDEX=$shard timeout 900 "$program" --gtest_brief=1 --gtest_filter="$filter" \
    >"$log" 2>&1 || status=$?
  echo "$suite, part $((shard + 1)) of $shards: $((SECONDS - began)) s"
  ((status == 0)) && return
  tail -n 100 "$log"
  echo "$suite: failed ($status)"
  return 1
}
export -f runShard
export shards

for program in "$directory"/*_"$suffix"; do
  suite=$(basename -- "${program%_"$suffix"}")
  filter=$({ cat "$here/sanitized_without.txt" "$here/../long_tests.txt" | grep "^$suite/" || true; } | cut -d/ -f2- | paste -sd :)
  for ((shard = 0; shard < shards; ++shard)); do
    printf '%s\0' "$program" "$suite" "$shard" "${filter:+-}${filter:-*}" "$logs/$suite.$shard"
  done
done | xargs -0 -n 5 -P "$(nproc)" bash -c 'runShard "$@"' _
