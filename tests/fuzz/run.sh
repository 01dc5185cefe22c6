#!/usr/bin/env bash
# tests/fuzz/run.sh: runs each fuzzer of a build for some time. Usage: run.sh BUILD SECONDS|COUNTruns [TARGET...]
# With a count of runs they are the same each time, from the seeds alone.
# What it learns stays in BUILD/fuzz/TARGET; an input that breaks a promise goes into BUILD/fuzz/found, and the status is 1.
set -euo pipefail
build=$(cd -- "$1" && pwd)
case $2 in
  *runs) learned=$(mktemp -d) amount=(-runs="${2%runs}" -seed=1); trap 'rm -rf "$learned"' EXIT ;;
  *) learned=$build/fuzz amount=(-max_total_time="$2") ;;
esac
targets=("${@:3}")
((${#targets[@]})) || targets=(import rig set smooth export)
# Fills, a long quarantine and deep stacks took two fifths of the time. To read what was found, run it again without these.
export ASAN_OPTIONS="max_malloc_fill_size=0:quarantine_size_mb=16:malloc_context_size=8:${ASAN_OPTIONS:-}"
mkdir -p "$build/fuzz/found"
"$build/tests/fuzz/fuzz_seeds" "$build/fuzz/seeds"
status=0
for target in "${targets[@]}"; do
  mkdir -p "$learned/$target"
  # Sanitizers use three times the memory and many times the time: about 512 MB and 1 s without them.
  "$build/tests/fuzz/fuzz_$target" "${amount[@]}" -max_len=65536 -timeout=20 -rss_limit_mb=2048 -malloc_limit_mb=1024 \
    -print_final_stats=1 -verbosity=0 -artifact_prefix="$build/fuzz/found/$target-" \
    "$learned/$target" "$build/fuzz/seeds/$target" 2>&1 |
    grep -E 'stat::number_of_executed_units|stat::peak_rss_mb|ERROR|SUMMARY|broken promise|runtime error|^ +#[0-9] |Test unit written' |
    sed "s/^/fuzz $target: /" || ((PIPESTATUS[0] == 0)) || status=1
done
exit "$status"
