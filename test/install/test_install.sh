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

# The program, where it was built.
if [ -e "$build_dir/examples/flip_free_maps" ]; then
  "$work/prefix/bin/flip_free_maps" --version
fi

# The options of the compiler lead to the headers, without CMake.
if command -v pkg-config > /dev/null; then
  pc_dir="$(dirname "$(find "$work/prefix" -name flip_free_maps.pc)")"
  cflags="$(PKG_CONFIG_PATH="$pc_dir" pkg-config --cflags flip_free_maps)"
  version="$(PKG_CONFIG_PATH="$pc_dir" pkg-config --modversion flip_free_maps)"
  printf '#include <CGAL/Flip_free_maps/version.h>\nCGAL_FLIP_FREE_MAPS_VERSION\n' | c++ $cflags -E -P -x c++ - | grep -qF "\"$version\""
fi

"$cmake" -S "$consumer_dir" -B "$work/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/prefix" "$@"
"$cmake" --build "$work/build"
"$work/build/consumer"
