#!/usr/bin/env bash
# Line coverage of include/ by the tests: builds the preset coverage, runs the tests and prints, for each header,
# the share of lines that were run, and the lines that were not. Arguments: names of tests (all otherwise).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/coverage
tests=("$@")
cmake --preset coverage -S "$root" >/dev/null
find "$build" -name '*.gcda' -delete
if [ ${#tests[@]} -eq 0 ]; then
  cmake --build "$build"
  ctest --test-dir "$build" --output-on-failure || true
else
  cmake --build "$build" --target "${tests[@]}"
  pattern=$(IFS='|'; echo "${tests[*]}")
  ctest --test-dir "$build" --output-on-failure -R "^($pattern)$" || true
fi
cd "$build"
find . -name '*.gcda' -print0 | xargs -0 gcov --json-format --stdout >coverage.json
python3 "$root/cmake/coverage.py" "$root/include" coverage.json
