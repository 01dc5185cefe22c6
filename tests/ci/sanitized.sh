#!/usr/bin/env bash
# tests/ci/sanitized.sh: builds core under sanitizers, linked with the tests as they are, and runs them.
# Usage: sanitized.sh SOURCE BUILD
set -euo pipefail
source=$1 build=$2
began=$SECONDS
cmake --build "$build" --target sanitized_tests
echo "ci/sanitized: build: $((SECONDS - began)) s"
began=$SECONDS
"$source/tests/ci/run_tests.sh" "$build/tests/ci" sanitized
echo "ci/sanitized: test: $((SECONDS - began)) s"
