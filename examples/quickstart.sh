#!/usr/bin/env bash
# From nothing to a first map: installs what is missing (Debian), builds the program, and flattens the head of a lion.
#
# usage: examples/quickstart.sh
#   BUILD_DIR    where to build (default: build/quickstart in the repository)
#   OUTPUT_DIR   where to write the result (default: quickstart_output in the repository)

set -euo pipefail

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
build_dir="${BUILD_DIR:-$root/build/quickstart}"
output_dir="${OUTPUT_DIR:-$root/quickstart_output}"

bash "$root/.ci/install_packages.sh" quickstart

# Ninja, unlike make, begins with the program while the library is being compiled.
if command -v ninja > /dev/null; then
  export CMAKE_GENERATOR="${CMAKE_GENERATOR:-Ninja}"
fi
cmake -S "$root" -B "$build_dir" -DCMAKE_BUILD_TYPE=Release \
      -DFLIP_FREE_MAPS_BUILD_EXAMPLES=ON -DFLIP_FREE_MAPS_BUILD_TESTS=OFF
cmake --build "$build_dir" -j "$(nproc)" --target flip_free_maps

mkdir -p -- "$output_dir"
output_dir="$(CDPATH='' cd -- "$output_dir" && pwd)"

# The meshes of CGAL come with Debian's libcgal-demo, unless the system drops /usr/share/doc.
archive=/usr/share/doc/libcgal-demo/data.tar.gz
input="$output_dir/lion-head.off"
if ! { [[ -r "$archive" ]] && tar -xzOf "$archive" data/meshes/lion-head.off > "$input"; }; then
  rm -f -- "$input"
  input="$output_dir/generated_surface.off"
  echo "No meshes in $archive: a generated surface is flattened instead."
  cmake --build "$build_dir" --target generate_surface
  "$build_dir/examples/generate_surface" "$input"
fi
name="$(basename -- "$input" .off)"
result="$output_dir/$name"

"$build_dir/examples/flip_free_maps" parameterize "$input" -o "$result.obj" \
    --png "$result.png" --svg "$result.svg" --json "$result.json"

# The value of a key of the JSON report: its text without quotes, or its number with six digits.
value()
{
  local text
  text="$(tr -d '\n' < "$result.json" | grep -oE "\"$1\" *: *(\"[^\"]*\"|[^,}]*)" | head -n 1)" || true
  text="$(sed 's/^[^:]*: *//; s/"//g; s/ *$//' <<< "$text")"
  if [[ "$text" =~ ^-?[0-9.]+(e[-+]?[0-9]+)?$ ]]; then
    LC_ALL=C printf '%.6g\n' "$text"
  else
    echo "${text:-unknown}"
  fi
}

echo
echo "Status:   $(value status), $(value flips) flipped triangles"
echo "Energy:   $(value energy_initial) at the start, $(value energy) in the end (symmetric Dirichlet, an isometry has 1)"
echo "Time:     $(value total) s, $(value iterations) iterations"
echo
echo "Files in $output_dir:"
echo "  $name.off            the surface that was flattened"
echo "  $name.obj            the same with texture coordinates: open it in MeshLab or Blender"
echo "  $name.png, $name.svg the layout, coloured by distortion: open them in any viewer or browser"
echo "  $name.json           the report in numbers"
