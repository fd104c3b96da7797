#!/usr/bin/env bash
# Installs what is missing, builds all but the studies of speed and accuracy, and runs all tests.
# Arguments go to cmake; the variable BUILD_DIR says where to build (build/ otherwise). The last line
# counts the tests.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${BUILD_DIR:-$root/build}
# shellcheck source=../../cmake/run_functions.sh
. "$root/cmake/run_functions.sh"

finish() { # PASSED FAILED
  echo "$1 passed, $2 failed"
  [ "$2" -eq 0 ]
  exit
}

install_packages
data=()
if unpack_data "$build/data"; then
  data=("-DCGAL_DATA_DIR=$build/data")
else
  say "CGAL's data is not there: the examples are compiled but not run"
fi
configure "$root" "$build" -DPoint_set_consolidation_3_BUILD_BENCHMARK=OFF "${data[@]}" "$@" ||
  finish 0 1

jobs=$(number_of_jobs)
say "building with $jobs jobs"
build_failures=0
# All that compiles is tested, also if something does not.
keep_going=(-k)
if grep -q '^CMAKE_GENERATOR:INTERNAL=Ninja' "$build/CMakeCache.txt"; then
  keep_going=(-k 0)
fi
cmake --build "$build" -j "$jobs" -- "${keep_going[@]}" || build_failures=1

say "testing"
log=$build/test.log
(cd "$build" && ctest --output-on-failure -j "$jobs") 2>&1 | tee "$log" || true
summary=$(grep -E '^[0-9]+% tests passed, [0-9]+ tests? failed out of [0-9]+' "$log" || true)
if [ -z "$summary" ]; then
  say "no test was run"
  finish 0 1
fi
failed=$(sed -E 's/.*, ([0-9]+) tests? failed.*/\1/' <<<"$summary")
total=$(sed -E 's/.*out of ([0-9]+).*/\1/' <<<"$summary")
[ "$build_failures" -eq 0 ] || say "the build failed, which counts as a failed test"
finish $((total - failed)) $((failed + build_failures))
