#!/bin/sh
# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

# Builds the benchmarks and runs them all, one after the other, in a few minutes on generated meshes.
#
# usage: benchmark/run_benchmarks.sh [--out FOLDER] [--build FOLDER] [--seconds LIMIT] [--reference FILE] [MESH_OR_FOLDER...]
#
# Results go to build/benchmark_results; open parameterize.html (the default method: time, memory, work, threads) and methods.html
# (all methods compared) there. Meshes, disks with or without holes, are given as files, or as folders, of which all OFF, OBJ and PLY
# files with at most FFM_LARGEST_MESH triangles (60000) are taken, instead of generated ones; figures of another program for the same
# meshes, a TSV file, appear beside ours in methods.html. FFM_LADDER (25000,100000,400000), FFM_THREADS (1,2) and FFM_REPEAT (3) are
# the numbers of triangles, threads and equal runs of parameterize.html.

set -e
root=$(cd "$(dirname "$0")/.." && pwd)
build="$root/build/benchmark"
out="$root/build/benchmark_results"
seconds=60
reference=
left=$#
while [ "$left" -gt 0 ]; do
  case "$1" in
    --out) out=$2; shift 2; left=$((left - 2)) ;;
    --build) build=$2; shift 2; left=$((left - 2)) ;;
    --reference) reference=$2; shift 2; left=$((left - 2)) ;;
    --seconds) seconds=$2; shift 2; left=$((left - 2)) ;;
    -h|--help) sed -n '9,18s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) set -- "$@" "$1"; shift; left=$((left - 1)) ;;
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
run "methods on a solid" volume_methods_results.csv "$bin/performance_volume_methods" --output "$out"

# Folders give way to their files.
left=$#
while [ "$left" -gt 0 ]; do
  mesh=$1
  shift
  left=$((left - 1))
  if [ ! -d "$mesh" ]; then
    set -- "$@" "$mesh"
    continue
  fi
  before=$#
  for file in "$mesh"/*.off "$mesh"/*.obj "$mesh"/*.ply; do
    [ -f "$file" ] || continue
    case "$file" in
      *.off) faces=$(awk '!/^#/ && NF { for(i = 1; i <= NF; ++i) if($i != "OFF" && ++n == 2) { print $i; exit } }' "$file") ;;
      *.ply) faces=$(awk '/^element face/ { print $3; exit }' "$file") ;;
      *.obj) faces=$(grep -c '^f ' "$file") ;;
      *) continue ;;
    esac
    [ "$faces" -le "${FFM_LARGEST_MESH:-60000}" ] && set -- "$@" "$file"
  done
  [ $# -gt "$before" ] || { echo "no meshes in $mesh"; exit 1; }
done

# BLAS has one thread, so that it does not compete with the other threads for processors.
if [ -x "$bin/performance_parameterize_report" ]; then
  OPENBLAS_NUM_THREADS=1 "$bin/performance_parameterize_report" --output "$out" --threads "${FFM_THREADS:-1,2}" \
    --repeat "${FFM_REPEAT:-3}" --ladder "${FFM_LADDER:-25000,100000,400000}" "$@" || failures=$((failures + 1))
else
  echo "default method: not built"
fi
run "area distortion" area_distortion.csv "$bin/quality_area_distortion" "$@"
if [ -x "$bin/quality_run_methods" ]; then
  "$bin/quality_run_methods" --seconds "$seconds" --csv "$out/methods.csv" "$@" || failures=$((failures + 1))
else
  echo "methods: not built"
fi
if command -v python3 > /dev/null; then
  python3 "$root/benchmark/report.py" "$out" ${reference:+--reference "$reference"} || failures=$((failures + 1))
else
  echo "pages of HTML: not made, since there is no python3; benchmark/report.py $out makes them where there is"
fi
[ "$failures" -eq 0 ]
