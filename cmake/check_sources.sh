#!/usr/bin/env bash
# check_sources.sh [--tidy] [--cgal FOLDER] [FILES...]
#
# Compiles every source file, without code, by clang++ with all warnings and CGAL_NO_DEPRECATED_CODE; --cgal
# takes the headers of another version of CGAL, from the folder that holds CGAL/. --tidy runs clang-tidy instead, with
# the configuration of this folder. The last line counts the files that have findings.
set -uo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cgal=()
tidy=
while [ $# -gt 0 ]; do
  case $1 in
    --tidy) tidy=yes ;;
    --cgal) cgal=(-isystem "$2"); shift ;;
    *) break ;;
  esac
  shift
done
cd "$root" || exit 1
files=("$@")
headers=
if [ ${#files[@]} -eq 0 ]; then
  # All headers at once, the public ones first, then what instantiates them.
  headers=$(mktemp --suffix=.cpp)
  trap 'rm -f "$headers"' EXIT
  (cd include && find CGAL -name '*.h' | sort | sed 's/.*/#include <&>/') >"$headers"
  files=("$headers" src/*/*.cpp examples/*/support/*.cpp examples/*/*.cpp test/*/every_function/*.cpp test/*/*.cpp
    test/*/fuzz/fuzz_*.cpp benchmark/*/*.cpp)
fi
flags=(-std=c++17 -Wall -Wextra -Wpedantic -DCGAL_NO_DEPRECATED_CODE -DCGAL_EIGEN3_ENABLED -DCGAL_LINKED_WITH_TBB
  -DCGAL_POINT_SET_CONSOLIDATION_3_COMPILED_CORE=16 -DCGAL_POINT_SET_CONSOLIDATION_3_CORE_HAS_TBB
  '-DCGAL_DATA_DIR="data"' "${cgal[@]}" -isystem /usr/include/eigen3 -Iinclude
  -Iexamples/Point_set_consolidation_3/support -Ibenchmark/Point_set_consolidation_3)

failed=0
for file in "${files[@]}"; do
  case $file in */draw_*) continue ;; esac # needs CGAL's part for Qt
  if [ -n "$tidy" ]; then
    findings=$(clang-tidy --quiet --config-file="$root/.clang-tidy" "$file" -- "${flags[@]}" 2>/dev/null)
  else
    findings=$(clang++ -fsyntax-only "${flags[@]}" "$file" 2>&1)
  fi
  if [ -n "$findings" ]; then
    failed=$((failed + 1))
    printf '%s\n' "$findings"
  fi
done
echo "$((${#files[@]} - failed)) passed, $failed failed"
[ "$failed" -eq 0 ]
