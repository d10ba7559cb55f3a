#!/usr/bin/env bash
# The program over ranks of MPI: a bar is bent, and files that are missing are told of.
#
# usage: test_program_mpi.sh MPIRUN RANKS PROGRAM

set -euo pipefail
run=(bash "$(dirname "${BASH_SOURCE[0]}")/../distribution/run_over_mpi.sh" "$1" "$2" "$3")
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# A bar of cubes, and its ends as handles, of which the second is raised and turned.
awk -v cubes=8 -v width=2 -v mesh=bar.mesh -v handles=handles.txt 'BEGIN {
  print "MeshVersionFormatted 2\nDimension 3\nVertices\n" (cubes + 1) * (width + 1) * (width + 1) > mesh
  for(k = 0; k <= width; ++k) for(j = 0; j <= width; ++j) for(i = 0; i <= cubes; ++i) {
    print i, j, k, 0 > mesh
    if(i == 0) print n + 0, i, j, k > handles
    if(i == cubes) print n + 0, i - 1 - 0.5 * k, j, 0.9 * k + 2 " # moved" > handles
    ++n
  }
  print "Tetrahedra\n" 6 * cubes * width * width > mesh
  split("1 2 3 2 3 1 3 1 2 1 3 2 3 2 1 2 1 3", order, " ")
  for(k = 0; k < width; ++k) for(j = 0; j < width; ++j) for(i = 0; i < cubes; ++i) for(o = 0; o < 6; ++o) {
    p[1] = i; p[2] = j; p[3] = k
    for(s = 0; s <= 3; ++s) {
      if(s > 0) ++p[order[3 * o + s]]
      v[s] = 1 + (p[3] * (width + 1) + p[2]) * (cubes + 1) + p[1]
    }
    if(o < 3) print v[0], v[1], v[2], v[3], 1 > mesh; else print v[0], v[2], v[1], v[3], 1 > mesh
  }
  print "End" > mesh
}'

set +e
"${run[@]}" deform bar.mesh --handles handles.txt -o bent.mesh > output.txt 2>&1
code=$?
set -e
[[ "$code" -eq 77 ]] && { cat output.txt; exit 77; }
[[ "$code" -eq 0 ]] || { cat output.txt; echo "The bar was not bent: exit code $code."; exit 1; }
grep -q "flips *0" output.txt || { cat output.txt; echo "The report has no word of flips."; exit 1; }
[[ "$(wc -l < bent.mesh)" -eq "$(wc -l < bar.mesh)" ]] || { echo "The result has other lines than the mesh."; exit 1; }
# A handle is where it was to go.
grep -q "^7 0 2 0$" bent.mesh || { echo "A handle is not in its place."; exit 1; }

# From the result nothing remains to be done.
"${run[@]}" deform bar.mesh --handles handles.txt --start bent.mesh -o again.mesh > output.txt 2>&1
grep -q "start *given" output.txt || { cat output.txt; echo "The start was not taken."; exit 1; }

# A sheet of two hills, flat.
awk -v size=12 'BEGIN {
  print "OFF"
  print (size + 1) * (size + 1), 2 * size * size, 0
  for(j = 0; j <= size; ++j) for(i = 0; i <= size; ++i) print i, j, 2 * sin(i / 2) * cos(j / 3)
  for(j = 0; j < size; ++j) for(i = 0; i < size; ++i) {
    a = j * (size + 1) + i
    print 3, a, a + 1, a + size + 2
    print 3, a, a + size + 2, a + size + 1
  }
}' > sheet.off
"${run[@]}" parameterize sheet.off -o sheet.obj > output.txt 2>&1 || { cat output.txt; echo "The sheet was not flattened."; exit 1; }
[[ "$(grep -c '^vt ' sheet.obj)" -eq 169 && "$(grep -c '^f ' sheet.obj)" -eq 288 ]] || { echo "The OBJ file is not whole."; exit 1; }

for arguments in "parameterize bar.mesh -o x.mesh" "deform missing.mesh --handles handles.txt -o x.mesh" "deform bar.mesh --handles missing.txt -o x.mesh" \
                 "deform bar.mesh -o x.mesh" "deform bar.mesh --handles handles.txt -o no_folder/x.mesh"; do
  # shellcheck disable=SC2086
  if "${run[@]}" $arguments > output.txt 2>&1; then
    echo "Succeeded: $arguments"
    exit 1
  fi
  [[ ! -e x.mesh ]] || { echo "Wrote a file: $arguments"; exit 1; }
done
