#!/bin/sh
# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

# Builds the benchmarks and runs them all, one after the other, in a few minutes on generated meshes.
#
# usage: benchmark/run_benchmarks.sh [--out FOLDER] [--build FOLDER] [--seconds LIMIT] [MESH_FOLDER]
#
# Results go to build/benchmark_results; open methods.html there. With a folder of meshes the methods are compared on its files d1_*, d2_*,
# d3_*, d3p_* and special_* with at most FFM_LARGEST_MESH triangles (60000) instead of the generated ones; if the folder holds
# PP_FIGURES.tsv, its figures appear beside ours.

set -e
root=$(cd "$(dirname "$0")/.." && pwd)
build="$root/build/benchmark"
out="$root/build/benchmark_results"
seconds=60
meshes=
while [ $# -gt 0 ]; do
  case "$1" in
    --out) out=$2; shift 2 ;;
    --build) build=$2; shift 2 ;;
    --seconds) seconds=$2; shift 2 ;;
    -h|--help) sed -n '9,15s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) meshes=$1; shift ;;
  esac
done

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DFLIP_FREE_MAPS_BUILD_BENCHMARKS=ON \
  -DFLIP_FREE_MAPS_BUILD_EXAMPLES=OFF -DFLIP_FREE_MAPS_BUILD_TESTS=OFF > /dev/null
cmake --build "$build" --config Release
bin="$build/benchmark"
[ -d "$bin/Release" ] && bin="$bin/Release"
mkdir -p "$out"

failures=0
run() # NAME FILE COMMAND...
{
  name=$1
  file=$2
  shift 2
  [ -x "$1" ] || { echo "$name: not built"; return 0; }
  echo "$name ..."
  if "$@" > "$out/$file"; then
    echo "$name: $out/$file"
  else
    echo "$name: FAILED"
    failures=$((failures + 1))
  fi
}

run "kernels" kernels.json "$bin/performance_bench_kernels" --benchmark_format=json
run "interactive deformation" deform_interactive.csv "$bin/performance_deform_interactive"
run "splitting iterations" splitting_iterations.csv "$bin/performance_splitting_iterations"
run "bar experiments" bar_experiments.csv "$bin/quality_bar_experiments" 20 "$seconds"

set --
if [ -n "$meshes" ]; then
  for file in "$meshes"/d1_* "$meshes"/d2_* "$meshes"/d3_* "$meshes"/d3p_* "$meshes"/special_*; do
    case "$file" in
      *.off) faces=$(awk '!/^#/ && NF { for(i = 1; i <= NF; ++i) if($i != "OFF" && ++n == 2) { print $i; exit } }' "$file") ;;
      *.ply) faces=$(awk '/^element face/ { print $3; exit }' "$file") ;;
      *.obj) faces=$(grep -c '^f ' "$file") ;;
      *) continue ;;
    esac
    [ "$faces" -le "${FFM_LARGEST_MESH:-60000}" ] && set -- "$@" "$file"
  done
  [ $# -gt 0 ] || { echo "no meshes in $meshes"; exit 1; }
  run "area distortion" area_distortion.csv "$bin/quality_area_distortion" "$@"
  [ -f "$meshes/PP_FIGURES.tsv" ] && set -- --reference "$meshes/PP_FIGURES.tsv" "$@"
else
  run "area distortion" area_distortion.csv "$bin/quality_area_distortion"
fi
if [ -x "$bin/quality_run_methods" ]; then
  "$bin/quality_run_methods" --seconds "$seconds" --csv "$out/methods.csv" --html "$out/methods.html" "$@" || failures=$((failures + 1))
else
  echo "methods: not built"
fi
[ "$failures" -eq 0 ]
