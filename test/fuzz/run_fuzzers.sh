#!/usr/bin/env bash
# Builds the fuzz targets with clang and runs each for a while, beginning with small files that are made here. Prints a table; the exit
# code is 0 only if no target found a fault: a crash, undefined behaviour, more than 1 GB of memory, or an input that takes 10 seconds.
# The inputs of faults stay in the folder artifacts, the others in the folder corpus, with which the next run begins.
#
# usage: test/fuzz/run_fuzzers.sh [SECONDS_PER_TARGET [TARGET...]]
#   BUILD_DIR   where to build (default: build/fuzz in the repository)
#   CXX         clang's compiler (default: clang++-14, or clang++)
#   JOBS        how many jobs build (default: as many as there are cores)

set -euo pipefail

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)"
build_dir="${BUILD_DIR:-$root/build/fuzz}"
seconds="${1:-60}"
targets=("${@:2}")
compiler="${CXX:-$(command -v clang++-14 || command -v clang++ || true)}"
[[ -n "$compiler" ]] || { echo "There is no clang: install it, or name it in CXX." >&2; exit 2; }

if command -v ninja > /dev/null; then
  export CMAKE_GENERATOR="${CMAKE_GENERATOR:-Ninja}"
fi
mkdir -p "$build_dir"/{artifacts,corpus}
cmake -S "$root" -B "$build_dir" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O1 -g1" \
      -DFLIP_FREE_MAPS_BUILD_FUZZERS=ON -DFLIP_FREE_MAPS_EXAMPLES=flip_free_maps > "$build_dir/cmake.log" 2>&1 ||
  { cat "$build_dir/cmake.log" >&2; exit 2; }
built=(fuzzers)
[[ ${#targets[@]} -eq 0 ]] || built=(make_fuzz_corpus "${targets[@]/#/fuzz_}")
cmake --build "$build_dir" -j "${JOBS:-$(nproc)}" --target "${built[@]}"

bin="$build_dir/test/fuzz"
if [[ ${#targets[@]} -eq 0 ]]; then
  for program in "$bin"/fuzz_*; do
    targets+=("$(basename -- "${program#"$bin"/fuzz_}")")
  done
fi
"$bin/make_fuzz_corpus" "$build_dir/corpus"

# Readers read files: where there is memory for them, no disk is worn out.
work="$(mktemp -d -p "$([[ -w /dev/shm ]] && echo /dev/shm || echo "${TMPDIR:-/tmp}")")"
trap 'rm -rf -- "$work"' EXIT

status=0
row="%-14s %10s %8s %9s  %s\n"
printf "$row" target runs edges features result
for target in "${targets[@]}"; do
  log="$build_dir/$target.log"
  result="no fault"
  (cd -- "$work" && TMPDIR="$work" "$bin/fuzz_$target" -max_total_time="$seconds" -max_len=16384 -rss_limit_mb=1024 -timeout=10 \
     -print_final_stats=1 -close_fd_mask=1 -artifact_prefix="$build_dir/artifacts/$target-" "$build_dir/corpus/$target") > "$log" 2>&1 || result="FAULT"
  if [[ "$result" != "no fault" ]]; then
    status=1
    reason="$(grep -m 1 -oE 'runtime error: .*|ERROR: [A-Za-z]*Sanitizer: .*|ERROR: libFuzzer: .*|^wrong: .*' "$log" || true)"
    result="FAULT: ${reason:-exit code} ($log)"
  fi
  last="$(grep -E '^#[0-9]+.* cov: ' "$log" | tail -n 1 || true)"
  printf "$row" "$target" "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1)" \
         "$(sed -n 's/.* cov: \([0-9]*\).*/\1/p' <<< "$last")" "$(sed -n 's/.* ft: \([0-9]*\).*/\1/p' <<< "$last")" "$result"
done
exit "$status"
