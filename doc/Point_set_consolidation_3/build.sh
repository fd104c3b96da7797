#!/usr/bin/env bash
# Builds the manual: build.sh [FOLDER], build/doc otherwise; open FOLDER/html/index.html. Any warning of
# Doxygen is an error. Needs doxygen 1.9.4 or newer and, for the bibliography, bibtex (package texlive-base).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
output=${1:-$root/build/doc}
mkdir -p "$output"
DOC_OUTPUT=$(cd "$output" && pwd)
DOC_VERSION=$(sed -nE 's/.*define .*_VERSION_(MAJOR|MINOR|PATCH) ([0-9]+)$/\2/p' \
  "$root/include/CGAL/Point_set_consolidation_3/version.h" | paste -sd .)
export DOC_OUTPUT DOC_VERSION

for tool in doxygen bibtex; do
  if ! command -v "$tool" >/dev/null; then
    echo "build.sh: $tool is missing: apt-get install doxygen texlive-base" >&2
    exit 1
  fi
done
cd "$root"
for example in examples/Point_set_consolidation_3/*_example.cpp; do
  if ! grep -qx "\\\\example Point_set_consolidation_3/${example##*/}" \
    doc/Point_set_consolidation_3/examples.txt; then
    echo "build.sh: ${example##*/} is not in examples.txt" >&2
    exit 1
  fi
done
doxygen doc/Point_set_consolidation_3/Doxyfile
# What Doxygen does not report: formulas and cross references that came out as text.
if grep -rlE 'cgalCite|cgalParam|cgalFigure|cgalNamedParams' "$DOC_OUTPUT/html" --include='*.html' >&2; then
  echo "build.sh: a command of the manual was not understood in the pages above" >&2
  exit 1
fi
echo "$DOC_OUTPUT/html/index.html"
