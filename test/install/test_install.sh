#!/usr/bin/env bash
# Installs the package into a temporary prefix, then configures, builds and runs a small project that finds it there.
#
# usage: test_install.sh CMAKE BUILD_DIR CONSUMER_DIR [CMAKE_OPTION...]

set -euo pipefail

cmake="$1"
build_dir="$2"
consumer_dir="$3"
shift 3

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

"$cmake" --install "$build_dir" --prefix "$work/prefix"

# Paths of the machine that built the package must not get into what is installed.
if grep -rqF -- "$build_dir" "$work/prefix"; then
  echo "The installed files mention the build directory:" >&2
  grep -rlF -- "$build_dir" "$work/prefix" >&2
  exit 1
fi

"$cmake" -S "$consumer_dir" -B "$work/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/prefix" "$@"
"$cmake" --build "$work/build"
"$work/build/consumer"
