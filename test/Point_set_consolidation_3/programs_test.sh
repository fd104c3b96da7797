#!/usr/bin/env bash
# Copyright (c) 2026  The Point_set_consolidation_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Bad files, options and outputs for every program: the documented exit status, one line on the
# standard error output that names the cause, and no file left behind. Argument: the folder of the programs.

set -u
programs=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
cd "$work" || exit 1
passed=0
failed=0

complain() {
  echo "FAILED: $*"
  failed=$((failed + 1))
}

# expect STATUS TEXT PROGRAM ARGUMENTS...: everything is written below $work/out, which must stay empty
# unless the status is 0.
expect() {
  local status=$1 text=$2 program=$3
  shift 3
  rm -rf out
  mkdir out
  timeout 60 "$programs/$program" "$@" >stdout.txt 2>stderr.txt </dev/null
  local got=$?
  local lines
  lines=$(wc -l <stderr.txt)
  local before=$failed
  [ "$got" -eq "$status" ] || complain "$program $*: status $got, not $status: $(head -c 300 stderr.txt)"
  if [ "$status" -ne 0 ]; then
    [ "$lines" -eq 1 ] || complain "$program $*: $lines lines on stderr: $(head -c 300 stderr.txt)"
    grep -qF -- "$text" stderr.txt || complain "$program $*: no '$text' in: $(head -c 300 stderr.txt)"
    [ -z "$(ls -A out)" ] || complain "$program $*: left behind $(ls -A out)"
  fi
  [ "$failed" -eq "$before" ] && passed=$((passed + 1))
}

# ---- inputs ---------------------------------------------------------------------------------

# An ellipsoid of 400 points, spread by the golden angle, with normals.
awk 'BEGIN { for(i = 0; i < 400; ++i) { z = 1 - (2 * i + 1) / 400; r = sqrt(1 - z * z); t = 2.39996323 * i;
  x = r * cos(t); y = r * sin(t); print 2 * x, y, z, x, y, z } }' >good.xyz
head -c 5000 /dev/urandom >garbage.bin
head -c 300 good.xyz >garbage_tail.xyz
printf '\001\002\377\376\000\000' >>garbage_tail.xyz
: >empty.ply
: >empty.xyz
mkdir folder.ply
echo "1 2" >two_columns.xyz
echo "1 2 three" >words.xyz
printf '1 2 3\nnan 0 0\n4 5 6\n' >nan.xyz
printf '1 2 3\ninf 0 0\n4 5 6\n' >inf.xyz
printf '0 0 0\n1 0 0\n0 1 0\n' >three.xyz
printf '0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n' >three_normals.xyz
echo "1 2 3" >one.xyz
for i in $(seq 50); do echo "1 2 3"; done >equal.xyz
header='property float x\nproperty float y\nproperty float z\nend_header\n'
printf 'ply\nformat ascii 1.0\nelement vertex 1000\n'"$header"'1 2 3\n' >lying.ply
printf 'ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n'"$header"'12345678' >lying_binary.ply
printf 'ply\nformat ascii 1.0\nelement vertex -5\n'"$header"'1 2 3\n' >negative.ply
printf 'ply\nformat ascii 1.0\nelement vertex 99999999999999999999999\n'"$header"'1 2 3\n' >too_many.ply
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n' >no_end.ply
printf 'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n' >only_x.ply
printf 'OFF\n1000 0 0\n1 2 3\n' >lying.off
printf 'OFF\n4294967295000 1 1\n1 2 3\n' >huge.off
printf 'LASF\000\000\000\000' >short.las
head -c 400 garbage.bin >garbage.las
for extension in ply off las; do cp garbage.bin garbage_1.$extension; done
{ printf 'ply\nformat binary_little_endian 1.0\nelement vertex 300\n'"$header"; head -c 3599 garbage.bin; } >truncated.ply
cp good.xyz good.ply
cp good.xyz good.abc
cp good.xyz good

# ---- every program: usage, unreadable input, unwritable output --------------------------------

bad_files="empty.ply empty.xyz folder.ply two_columns.xyz words.xyz garbage_tail.xyz nan.xyz inf.xyz lying.ply
lying_binary.ply truncated.ply negative.ply too_many.ply no_end.ply only_x.ply lying.off huge.off short.las garbage.las
garbage_1.ply garbage_1.off good.ply good.abc good missing.ply"

for program in consolidate_point_set extract_skeleton segment_point_set reconstruct_surface; do
  [ -x "$programs/$program" ] || { complain "$program is missing"; continue; }
  expect 0 "" $program --help
  grep -q "^Usage: $program" stdout.txt || complain "$program --help: no usage"
  expect 0 "" $program --version
  output=out/result.ply

  expect 1 "INPUT" $program
  expect 1 "--nonsense" $program good.xyz -o $output --nonsense
  expect 1 "output" $program good.xyz -o
  expect 1 "output" $program good.xyz --output
  expect 1 "surplus.xyz" $program good.xyz surplus.xyz -o $output
  expect 1 "--method" $program good.xyz -o $output --method nonsense
  expect 1 "--threads" $program good.xyz -o $output --threads -1
  expect 1 "--threads" $program good.xyz -o $output --threads two
  expect 1 "--threads" $program good.xyz -o $output --threads 1e30
  expect 1 "--threads" $program good.xyz -o $output --threads ""

  for file in $bad_files; do
    expect 2 "$file" $program $file -o $output
  done
  expect 2 "no_folder" $program good.xyz -o no_folder/result.ply
  expect 2 "result.abc" $program good.xyz -o out/result.abc
  # Before the work, not after it.
  expect 2 "picture.jpg" $program good.xyz -o $output --picture out/picture.jpg
  expect 2 "no_folder" $program good.xyz -o $output --picture no_folder/picture.png
  expect 2 "no_folder" $program good.xyz -o $output --json no_folder/report.json
  expect 2 "two outputs" $program good.xyz -o $output --json out/../$output
done
expect 2 "two outputs" consolidate_point_set good.xyz --mesh out/result.ply --completed out/result.ply
for option in --inner --deep-points; do
  expect 2 "inner.xyz" consolidate_point_set good.xyz -o out/result.ply $option out/inner.xyz
done
expect 1 "--panel" make_picture out/picture.png
expect 1 "--panel" make_picture out/picture.png --panel title
expect 2 "picture.abc" make_picture out/picture.abc --panel points=good.xyz
for file in $bad_files; do
  expect 2 "$file" make_picture out/picture.png --panel points=$file
done

# ---- options out of their range ---------------------------------------------------------------

for option in "--omega 0" "--omega 171" "--omega nan" "--sigma-p -1" "--sigma-q 0" "--mu -1" "--mu-hat -0.1" \
              "--epsilon 0" "--prior nonsense" "--data-term nonsense" "--particles 0" "--particles -4" \
              "--select-percentage 0" "--select-percentage 101" "--wlop-iterations 0" "--radius 0" \
              "--completed-spacing -1" "--scanner 1" "--upsample -3" "--mesh-distance 0"; do
  # shellcheck disable=SC2086
  expect 1 "${option%% *}" consolidate_point_set good.xyz -o out/result.ply $option
done
expect 2 "radius is far too large" consolidate_point_set good.xyz -o out/result.ply --radius 1e6
for option in "--samples 0" "--neighbors 1" "--weights nonsense" "--contraction-factor 0.5" "--threshold 0" \
              "--iterations 0" "--sampling-radius 2" "--sampling-radius nan"; do
  # shellcheck disable=SC2086
  expect 1 "${option%% *}" extract_skeleton good.xyz -o out/result.ply $option
done
for option in "--penalty 0" "--radius -1" "--prominence -1" "--segments -1"; do
  # shellcheck disable=SC2086
  expect 1 "${option%% *}" segment_point_set good.xyz -o out/result.ply $option
done
for option in "--resolution 1" "--surface-weight 0" "--outside-factor 0.5"; do
  # shellcheck disable=SC2086
  expect 1 "${option%% *}" reconstruct_surface good.xyz -o out/result.ply --method skeleton-driven $option
done

# ---- input that no method can use ---------------------------------------------------------------

for file in one.xyz three.xyz three_normals.xyz equal.xyz; do
  expect 2 "$file" consolidate_point_set $file -o out/result.ply
  for method in l1-medial meso; do
    expect 2 "$file" extract_skeleton $file -o out/result.ply --method $method
  done
  for method in poisson feature-enhanced; do
    expect 2 "$file" reconstruct_surface $file -o out/result.off --method $method
  done
  # These have a result: the points, a skeleton of one vertex, one segment.
  expect 0 "" consolidate_point_set $file -o out/result.ply --method iterative
  status=2
  [ $file = equal.xyz ] && status=0
  expect $status "$file" extract_skeleton $file -o out/result.ply
  expect $status "$file" segment_point_set $file -o out/result.ply
done
expect 1 "--samples" extract_skeleton good.xyz -o out/result.ply --method l1-medial --samples 9
expect 2 "missing.ply" reconstruct_surface good.xyz -o out/result.ply --method skeleton-driven --skeleton missing.ply
expect 2 "garbage_1.ply" reconstruct_surface good.xyz -o out/result.ply --method skeleton-driven \
  --skeleton garbage_1.ply

# ---- outputs that cannot be written -------------------------------------------------------------

expect 0 "" segment_point_set good.xyz -o out/result.ply --quiet
[ -s stderr.txt ] && complain "--quiet is not quiet"
expect 0 "" extract_skeleton good.xyz -o out/result.ply
for method in "deep-points --particles 60" iterative anisotropic-wlop; do
  # shellcheck disable=SC2086
  expect 0 "" consolidate_point_set good.xyz -o out/result.ply --method $method --json out/report.json
  grep -q '"iterations"' out/report.json || complain "--method $method: no stages in the report"
done

# Eight points far from the ellipsoid are left out, unless they are to be kept.
{ cat good.xyz; for i in 1 2 3 4 5 6 7 8; do echo "$((i % 3 + 2)) $((i * i % 7 - 3)) $((i - 4)) 0 0 1"; done; } >outliers.xyz
for option in "" --keep-outliers; do
  # shellcheck disable=SC2086
  expect 0 "" consolidate_point_set outliers.xyz --particles 60 --completed out/result.ply --json out/report.json $option
  left_out=$([ -z "$option" ] && echo 8 || echo 0)
  grep -q "\"outliers\": $left_out\\b" out/report.json || complain "$option: not $left_out outliers"
  completed=$(sed -n 's/.*"completed_points": \([0-9]*\).*/\1/p' out/report.json)
  vertices=$(sed -n 's/^element vertex \([0-9]*\)/\1/p' out/result.ply 2>/dev/null | head -1)
  [ "$vertices" -eq $((408 - left_out + completed)) ] || complain "$option: $vertices completed points"
done
if [ -c /dev/full ]; then
  # The extension says the format: a link to the full disk.
  ln -s /dev/full full.ply
  ln -s /dev/full full.json
  expect 2 "full.ply" segment_point_set good.xyz -o full.ply
  expect 2 "full.ply" extract_skeleton good.xyz -o full.ply
  expect 2 "full.ply" consolidate_point_set good.xyz -o full.ply --particles 60
  # The result itself was written before.
  expect 2 "full.json" segment_point_set good.xyz -o kept_result.ply --json full.json
  ln -s /dev/full full.off
  ln -s /dev/full full.png
  expect 2 "full.off" reconstruct_surface good.xyz -o full.off
  expect 2 "full.png" make_picture full.png --panel points=good.xyz
  for option in "--completed full.ply" "--inner full.ply" "--deep-points full.ply" "--mesh full.off" \
                "--picture full.png"; do
    # shellcheck disable=SC2086
    expect 2 "${option#* }" consolidate_point_set good.xyz --particles 60 $option
  done
fi
# A disk that is full after a kilobyte: what was begun is taken away.
expect_full() {
  if (
    ulimit -f 1
    trap '' XFSZ
    failed=0
    expect 2 "$@"
    [ "$failed" -eq 0 ]
  ); then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
  fi
}
expect_full "result.ply" segment_point_set good.xyz -o out/result.ply
awk 'BEGIN { for(i = 0; i < 200; ++i) print "add", i, 0.125, -0.375 }' >many.edits
expect_full "result.polylines.txt" extract_skeleton good.xyz -o out/result.polylines.txt --edits many.edits
expect_full "result.xyz" consolidate_point_set good.xyz -o out/result.xyz --particles 60
mkdir is_folder.ply
expect 2 "is_folder.ply" segment_point_set good.xyz -o is_folder.ply
if [ "$(id -u)" -ne 0 ]; then
  mkdir locked
  chmod a-w locked
  expect 2 "locked" segment_point_set good.xyz -o locked/result.ply
fi
# What was there before a failure is still there.
echo before >kept.ply
expect 2 "nan.xyz" segment_point_set nan.xyz -o kept.ply
[ "$(cat kept.ply)" = before ] || complain "an output that could not be written again was lost"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
