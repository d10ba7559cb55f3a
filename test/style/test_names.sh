#!/usr/bin/env bash
# Names have the spelling of .clang-tidy. As a test it looks at rooms that compile fast, since clang-tidy takes minutes for all.
# Without clang-tidy 14 or later: exit code 77, skipped.
#
# usage: test_names.sh SOURCE_FOLDER [COMPILER_OPTION...]     rooms as in ROOMS, "energies elements" by default, "all" for all:
#        ROOMS=all test/style/test_names.sh . -isystem /usr/include/eigen3

set -euo pipefail
cd -- "$1"
shift

version="$(clang-tidy --version 2> /dev/null | sed -n 's/.*version \([0-9]*\)\..*/\1/p' | head -n 1)" || true
if [[ -z "$version" || "$version" -lt 14 ]]; then
  echo "Skipped: there is no clang-tidy 14 or later."
  exit 77
fi
rooms="${ROOMS:-energies elements}"
folder=CGAL/Flip_free_maps
if [[ "$rooms" == all ]]; then
  rooms="$(cd "include/$folder" && find . -mindepth 1 -maxdepth 1 -type d | sed 's|^\./||' | sort) ."
fi
source_file="$(mktemp --suffix=.cpp)"
trap 'rm -f -- "$source_file"' EXIT
for room in $rooms; do
  depth=()
  [[ "$room" == . ]] && depth=(-maxdepth 1)
  (cd include && find "$folder/$room" "${depth[@]}" -name '*.h' | sed 's|/\./|/|' | sort)
done | sed 's|.*|#include <&>|' > "$source_file"
[[ -s "$source_file" ]] || { echo "There are no headers in: $rooms."; exit 1; }
report="$(clang-tidy --quiet --config-file=.clang-tidy --header-filter="$folder/" "$source_file" -- -std=c++17 -I include "$@" 2>&1)" || {
  echo "$report" | grep -E 'error|warning:' | sort -u
  exit 1
}
