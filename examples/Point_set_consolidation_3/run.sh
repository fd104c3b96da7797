#!/usr/bin/env bash
# Consolidates scans with large missing parts: from points to completed points to a mesh, with a
# picture of before and after.
#
#   run.sh                      scans of models from CGAL's data
#   run.sh FILE [OPTION...]     your own scan; the options are those of consolidate_point_set
#
# Installs what is missing and builds the programs first. The variable BUILD_DIR says where (build/
# otherwise); results are written to its folder results/.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${BUILD_DIR:-$root/build}
# shellcheck source=../../cmake/run_functions.sh
. "$root/cmake/run_functions.sh"

if [ $# -gt 0 ] && [ ! -r "$1" ]; then
  echo "run.sh: $1 cannot be read" >&2
  exit 2
fi

install_packages
data=$build/data
if [ $# -eq 0 ] && ! unpack_data "$data"; then
  echo "run.sh: CGAL's data (package libcgal-demo) is not there; give your own scan: run.sh FILE" >&2
  exit 1
fi
configure "$root" "$build"
jobs=$(number_of_jobs)
say "building the programs with $jobs jobs"
cmake --build "$build" -j "$jobs" \
  --target consolidate_point_set virtual_scan judge_mesh

bin=$build/bin
results=$build/results
mkdir -p "$results"

# number FILE EXPRESSION: what the expression captures in a JSON file, or "-".
number() {
  local value
  value=$(tr -d ' \n' <"$1" | sed -nE "s/.*$2.*/\\1/p")
  echo "${value:--}"
}

table=()
# consolidate NAME SCAN TRUTH [OPTION...]: TRUTH is a mesh, or empty if nobody knows it.
consolidate() {
  local name=$1 scan=$2 truth=$3 out=$results/$1 error=- begin end json
  shift 3
  say "$name: $scan"
  json=$out.json
  begin=$(date +%s.%N)
  "$bin/consolidate_point_set" "$scan" -o "$out.points.ply" --mesh "$out.mesh.ply" \
    --json "$json" --picture "$out.png" "$@"
  end=$(date +%s.%N)
  if [ -n "$truth" ]; then
    "$bin/judge" "$truth" "$out.mesh.ply" --json "$out.judge.json" >/dev/null
    error=$(number "$out.judge.json" '"truth_to_result":\{[^}]*"mean":([-+.e0-9]+)')
    error=$(LC_ALL=C awk -v e="$error" 'BEGIN { printf "%.2f %%", e }')
  fi
  table+=("$(LC_ALL=C awk -v name="$name" -v points="$(number "$json" '"points":([0-9]+)')" \
    -v completed="$(number "$json" '"completed_points":([0-9]+)')" \
    -v seconds="$(LC_ALL=C awk -v a="$begin" -v b="$end" 'BEGIN { print b - a }')" -v error="$error" \
    'BEGIN { printf "%-24s %8s %10s %8.1f %8s", name, points, completed, seconds, error }')")
}

if [ $# -gt 0 ]; then
  file=$1
  shift
  name=$(basename "$file")
  consolidate "${name%.*}" "$file" "" "$@"
else
  scan_mesh() { # NAME MESH VIEWS POINTS
    "$bin/virtual_scan" "$data/meshes/$2" -o "$results/$1.scan.ply" --views "$3" --points "$4" \
      --noise 0.2 --seed 1
    consolidate "$1" "$results/$1.scan.ply" "$data/meshes/$2"
  }
  scan_mesh armadillo_1_view armadillo.off 1 20000
  scan_mesh elephant_2_views refined_elephant.off 2 20000
  consolidate hippo "$data/points_3/hippo1.ply" ""
fi

echo
printf '%-24s %8s %10s %8s %8s\n' scan points completed seconds error
printf '%s\n' "${table[@]}"
echo
echo "error: mean distance from the true surface to the mesh, in percent of its diagonal"
echo "results in $results: *.png before and after, *.points.ply, *.mesh.ply, *.json"
