#!/usr/bin/env bash
# Installs what is missing (Debian), builds everything in Release mode and runs all tests.
# The last line reads "N passed, N failed"; the exit code is 0 only if nothing failed. Where something is missing that a test needs,
# such as an optional library, the lines before tell which tests were skipped for it, and their number.
#
# usage: test/run_tests.sh [CMAKE_OPTION...]
#   BUILD_DIR   where to build (default: build/tests in the repository)

set -euo pipefail

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
build_dir="${BUILD_DIR:-$root/build/tests}"
jobs="$(nproc)"

# What fails before the tests can run counts as one failure.
give_up()
{
  echo "$1" >&2
  echo "0 passed, 1 failed"
  exit 1
}

bash "$root/.ci/install_packages.sh" tests || give_up "The packages needed could not be installed."

# Compiling takes most of the time: optimization beyond the first level would take more than it saves. Assertions are on, in the compiled
# library as well. Ninja, unlike make, begins with the tests while the library is being compiled.
if command -v ninja > /dev/null; then
  export CMAKE_GENERATOR="${CMAKE_GENERATOR:-Ninja}"
fi
cmake -S "$root" -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
      -DFLIP_FREE_MAPS_BUILD_EXAMPLES=ON -DFLIP_FREE_MAPS_BUILD_TESTS=ON -DFLIP_FREE_MAPS_BUILD_PYTHON=ON "$@" || give_up "CMake failed."
cmake --build "$build_dir" -j "$jobs" || give_up "The build failed."

cd -- "$build_dir"
report="$PWD/ctest_report.xml"
rm -f -- "$report"
status=0
ctest -j "$jobs" --output-on-failure --output-junit "$report" || status=$?
[[ -s "$report" ]] || give_up "ctest wrote no report."

# A test that could not be run at all is a failed one; a test that was skipped on purpose is neither.
count()
{
  grep -c "<testcase .*status=\"$1\"" "$report" || true
}
all="$(grep -c '<testcase ' "$report" || true)"
passed="$(count run)"
skipped="$(grep -c '<skipped message="SKIP_' "$report" || true)"
disabled="$(count disabled)"
failed=$((all - passed - skipped - disabled))

if [[ "$all" -eq 0 ]]; then
  give_up "There are no tests."
fi
if [[ "$status" -ne 0 && "$failed" -eq 0 ]]; then
  failed=1
fi
if [[ $((skipped + disabled)) -ne 0 ]]; then
  awk '/<testcase /          { split($0, fields, "\""); name = fields[2]; is_skipped = 0 }
       /<skipped message="SKIP_/ { is_skipped = 1 }
       is_skipped && sub(/.*Skipped: /, "") { sub(/<.*/, ""); print "skipped " name ": " $0 }' "$report"
  echo "$((skipped + disabled)) skipped"
fi
echo "$passed passed, $failed failed"
[[ "$failed" -eq 0 ]]
