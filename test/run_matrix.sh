#!/usr/bin/env bash
# Builds with other compilers, standards, libraries and sanitizers, and prints a table with a row for each: what failed, the warnings and
# the seconds. The exit code is 0 only if no row failed and none has warnings. Not a part of the tests: a row takes several minutes.
#
# Each row compiles all headers together, the program, and some tests, which it runs.
#
# usage: test/run_matrix.sh [--headers] [ROW...]      all rows if none is named; --list prints their names
#   --headers   compile nothing but the headers, which takes a fraction of the time
#   BUILD_DIR   where to build (default: build/matrix in the repository)
#   JOBS        how many jobs at a time (default: as many as there are cores)

set -uo pipefail

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
build_dir="${BUILD_DIR:-$root/build/matrix}"
jobs="${JOBS:-$(nproc)}"
clang="$(command -v clang++-14 || command -v clang++ || true)"

cgal_6=libcgal-dev_6.0.1-1_amd64.deb
cgal_6_address="http://deb.debian.org/debian/pool/main/c/cgal/$cgal_6"

rows=(g++ clang libc++ c++20 c++23 header-only no-libraries sanitizers threads cgal-6)
if [[ "${1:-}" == --list ]]; then
  printf '%s\n' "${rows[@]}"
  exit 0
fi
headers_only=
if [[ "${1:-}" == --headers ]]; then
  headers_only=yes
  shift
fi
[[ $# -eq 0 ]] || rows=("$@")

# Debian 13's package, unpacked beside. Prints the folder of its CMake files.
unpacked_cgal_6()
{
  local folder="$build_dir/cgal-6"
  if [[ ! -d "$folder/usr" ]]; then
    mkdir -p "$folder" || return 1
    curl -fsS -o "$folder/$cgal_6" "$cgal_6_address" && dpkg-deb -x "$folder/$cgal_6" "$folder" || return 1
  fi
  dirname -- "$(find "$folder/usr" -name CGALConfig.cmake | head -n 1)"
}

# What a row is: options of CMake, targets beside headers and program, and the tests that are run.
describe()
{
  options=()
  targets=(test_headers_alone test_headers_together flip_free_maps IO_tests core_tests report_tests)
  tests='^(IO|core|report)/'
  unity=ON
  missing=
  case "$1" in
    g++) options=(-DCMAKE_CXX_COMPILER=g++) ;;
    clang)
      [[ -n "$clang" ]] || missing="there is no clang"
      options=(-DCMAKE_CXX_COMPILER="$clang" "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow") ;;
    libc++)
      # The libraries of the system speak libstdc++, whose strings are others: Boost and CGAL are headers, the others C.
      { [[ -n "$clang" ]] && echo '#include <vector>' | "$clang" -stdlib=libc++ -fsyntax-only -x c++ - 2> /dev/null; } ||
        missing="there is no clang with libc++ (Debian: libc++-14-dev libc++abi-14-dev)"
      options=(-DCMAKE_CXX_COMPILER="$clang" -DCMAKE_CXX_FLAGS=-stdlib=libc++) ;;
    c++20) options=(-DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_STANDARD=20) ;;
    c++23) options=(-DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_STANDARD=23) ;;
    header-only)
      # Each header alone, with nothing compiled before it.
      options=(-DCMAKE_CXX_COMPILER=g++ -DFLIP_FREE_MAPS_BUILD_CORE=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON)
      targets=(test_headers_alone test_headers_together flip_free_maps IO_tests report_tests)
      tests='^(IO|report)/' ;;
    no-libraries)
      options=(-DCMAKE_CXX_COMPILER=g++)
      for library in CHOLMOD TBB CAIRO ZLIB TETGEN; do
        options+=("-DFLIP_FREE_MAPS_WITH_$library=OFF")
      done ;;
    sanitizers) options=(-DCMAKE_CXX_COMPILER=g++ "-DCMAKE_CXX_FLAGS=-fsanitize=address,undefined -fno-sanitize-recover=all") ;;
    threads)
      options=(-DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS=-fsanitize=thread)
      unity=OFF
      targets=(minimizer_test_minimizer_threads doors_test_deadline)
      tests='^(minimizer/test_minimizer_threads|doors/test_deadline)$' ;;
    cgal-6)
      local folder
      if folder="$(unpacked_cgal_6)"; then
        options=(-DCMAKE_CXX_COMPILER=g++ -DCGAL_DIR="$folder" -DCMAKE_CXX_FLAGS=-DCGAL_NO_DEPRECATED_CODE)
      else
        missing="$cgal_6_address is not to be had"
      fi ;;
    *) missing="there is no such row" ;;
  esac
}

if command -v ninja > /dev/null; then
  export CMAKE_GENERATOR="${CMAKE_GENERATOR:-Ninja}"
fi
mkdir -p "$build_dir"
status=0
format="%-14s %-8s %-8s %-8s %-20s %9s %8s  %s\n"
printf "$format" row headers program others tests warnings seconds note
for row in "${rows[@]}"; do
  describe "$row"
  if [[ -n "$missing" ]]; then
    printf "$format" "$row" - - - - - - "not run: $missing"
    status=1
    continue
  fi
  folder="$build_dir/$row"
  log="$build_dir/$row.log"
  SECONDS=0
  declare -A result=([headers]=- [program]=- [others]=-)
  passed=-
  note=
  # Nothing but the tests runs, and these have options of their own.
  if cmake -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DFLIP_FREE_MAPS_UNITY_BUILD=$unity \
           "${options[@]}" > "$log" 2>&1; then
    [[ -z "$headers_only" ]] || targets=(test_headers_alone test_headers_together)
    for target in "${targets[@]}"; do
      case "$target" in
        test_headers_*) column=headers ;;
        flip_free_maps) column=program ;;
        *) column=others ;;
      esac
      if ! cmake --build "$folder" -j "$jobs" --target "$target" >> "$log" 2>&1; then
        result[$column]=FAILED
      elif [[ "${result[$column]}" == - ]]; then
        result[$column]=built
      fi
    done
    if [[ -z "$headers_only" ]]; then
      ctest --test-dir "$folder" -R "$tests" -j "$jobs" > "$folder/ctest.log" 2>&1
      cat "$folder/ctest.log" >> "$log"
      run="$(grep -cE 'Test +#[0-9]+: ' "$folder/ctest.log")"
      passed="$(grep -cE 'Test +#[0-9]+: .* Passed' "$folder/ctest.log")"
      skipped="$(grep -cE 'Test +#[0-9]+: .*\*\*\*Skipped' "$folder/ctest.log")"
      [[ $((passed + skipped)) -eq "$run" && "$passed" -gt 0 ]] || status=1
      passed="$passed of $((run - skipped)) passed"
    fi
  else
    note="CMake failed; "
    status=1
  fi
  warnings="$(grep -cE '(^|: )warning:' "$log")"
  [[ "${result[*]}" != *FAILED* && "$warnings" -eq 0 ]] || status=1
  printf "$format" "$row" "${result[headers]}" "${result[program]}" "${result[others]}" "$passed" "$warnings" "$SECONDS" "$note$log"
done
exit "$status"
