#!/usr/bin/env bash
# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

# The program for the command line, on good and bad files of every kind: exit codes, reports, pictures and traces.
# Usage: test_program.sh PROGRAM DATA_DIRECTORY, where the directory need not exist.

set -u
program=$1
data=${2:-}
directory=$(mktemp -d) || exit 1
trap 'rm -rf "$directory"' EXIT
cd "$directory" || exit 1
failures=0
checks=0

fail()
{
  echo "FAILED: $*" >&2
  failures=$((failures + 1))
}

check()
{
  checks=$((checks + 1))
  "${@:2}" || fail "$1"
}

# expect CODE ARGUMENTS...: runs the program; every error has a line that begins with the program's name.
expect()
{
  local code=$1
  shift
  "$program" "$@" > out.txt 2> err.txt
  local got=$?
  checks=$((checks + 1))
  if [ $got -ne "$code" ]; then
    fail "exit code $got instead of $code: $* ($(head -n 1 err.txt))"
  elif [ "$code" -gt 2 ] && [ "$1" = parameterize ]; then
    grep -q '^flip_free_maps: ' err.txt || fail "no message: $*"
  fi
}

# value FILE KEY: a number or a string of a report.
value()
{
  sed -n "s/^ *\"$2\": *\"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}\$/\1/p" "$1" | head -n 1
}

# close A B TOLERANCE
close()
{
  awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; if(d < 0) d = -d; exit !(a != "" && b != "" && d <= t) }'
}

less()
{
  awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && b != "" && a + 0 < b + 0) }'
}

# ---------------------------------------------------------------------------------------------------------------------
# Meshes

# grid FORMAT COLUMNS ROWS: a hilly sheet on standard output.
grid()
{
  awk -v format="$1" -v n="$2" -v m="$3" '
    function coordinates(i, j,  x, y) {
      x = i / n; y = j / n
      return sprintf("%.9g %.9g %.9g", x, y, 0.4 * exp(-30 * ((x - 0.4)^2 + (y - 0.4)^2)) + 0.05 * sin(9 * x) * cos(8 * y))
    }
    function triangle(a, b, c) {
      if(format == "obj") print "f", a + 1, b + 1, c + 1
      else if(format == "stl") {
        print "facet normal 0 0 0\nouter loop\nvertex " p[a] "\nvertex " p[b] "\nvertex " p[c] "\nendloop\nendfacet"
      } else print 3, a, b, c
    }
    BEGIN {
      for(j = 0; j <= m; ++j)
        for(i = 0; i <= n; ++i)
          p[j * (n + 1) + i] = coordinates(i, j)
      vertices = (n + 1) * (m + 1)
      if(format == "off") print "OFF\n" vertices, 2 * n * m, 0
      if(format == "stl") print "solid sheet"
      if(format == "ply") {
        print "ply\nformat ascii 1.0\nelement vertex " vertices "\nproperty double x\nproperty double y\nproperty double z"
        print "element face " 2 * n * m "\nproperty list uchar int vertex_indices\nend_header"
      }
      if(format != "stl")
        for(v = 0; v < vertices; ++v)
          print (format == "obj" ? "v " : "") p[v]
      for(j = 0; j < m; ++j)
        for(i = 0; i < n; ++i) {
          a = j * (n + 1) + i; b = a + 1; c = b + n + 1; d = c - 1
          triangle(a, b, c)
          triangle(a, c, d)
        }
      if(format == "stl") print "endsolid sheet"
    }'
}

for format in off obj ply stl; do
  grid $format 12 10 > sheet.$format
done

printf 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n' > quads.off
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n' > closed.off
printf 'OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n3 0 1 2\n3 3 4 5\n' > components.off
printf 'OFF\n3 1 0\n0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n' > nan.off
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n' > truncated.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' > index.off
printf '' > empty.off
printf 'OFF\n0 0 0\n' > no_vertices.off
printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' > no_faces.off
printf 'This is a letter, not a mesh.\n' > letter.off
printf 'OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n' > edge.off
printf 'OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n' > vertex.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n' > twice.off
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 2 3\n' > orientation.off
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0.5 0.5 0\n3 0 1 2\n3 2 1 3\n' > zero_area.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0.5\n3 0 1 2\n' > one.off
# A quiet NaN has the bytes 00 00 c0 7f.
{
  printf 'ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n'
  printf 'element face 1\nproperty list uchar int vertex_indices\nend_header\n'
  printf '\0\0\0\0\0\0\0\0\0\0\0\0' # 0 0 0
  printf '\0\0\200\077\0\0\0\0\0\0\0\0' # 1 0 0
  printf '\0\0\300\177\0\0\200\077\0\0\0\0' # NaN 1 0
  printf '\003\0\0\0\0\001\0\0\0\002\0\0\0'
} > nan.ply
# A square frame, a strip that closes after half a turn, a torus less one face, and a long thin tube.
awk 'BEGIN {
  print "OFF\n8 8 0\n0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n2 1 0\n2 2 0\n1 2 0"
  for(i = 0; i < 4; ++i) { j = (i + 1) % 4; print 3, i, j, 4 + j; print 3, i, 4 + j, 4 + i }
}' > frame.off
awk 'BEGIN {
  n = 8; print "OFF\n" 2 * n, 2 * n, 0
  for(i = 0; i < n; ++i) {
    t = 2 * 3.14159265358979 * i / n
    for(s = -1; s <= 1; s += 2)
      print (2 + 0.5 * s * cos(t / 2)) * cos(t), (2 + 0.5 * s * cos(t / 2)) * sin(t), 0.5 * s * sin(t / 2)
  }
  for(i = 0; i < n; ++i) {
    a = 2 * i; b = a + 1; c = i + 1 < n ? a + 2 : 1; d = i + 1 < n ? a + 3 : 0
    print 3, a, c, b; print 3, b, c, d
  }
}' > moebius.off
awk 'BEGIN {
  n = 5; print "OFF\n" n * n, 2 * n * n - 1, 0
  for(i = 0; i < n; ++i)
    for(j = 0; j < n; ++j) {
      u = 2 * 3.14159265358979 * i / n; v = 2 * 3.14159265358979 * j / n
      print (2 + cos(v)) * cos(u), (2 + cos(v)) * sin(u), sin(v)
    }
  for(i = 0; i < n; ++i)
    for(j = 0; j < n; ++j) {
      k = (i + 1) % n; l = (j + 1) % n
      print 3, n * i + j, n * k + j, n * k + l
      if(i + 1 < n || j + 1 < n) print 3, n * i + j, n * k + l, n * i + l
    }
}' > handle.off
awk 'BEGIN {
  n = 600; print "OFF\n" 3 * n + 1, 6 * (n - 1) + 3, 0
  for(j = 0; j < n; ++j)
    for(i = 0; i < 3; ++i)
      print cos(2.0943951 * i), sin(2.0943951 * i), 0.7 * j
  print 0, 0, 0.7 * n
  for(j = 0; j < n; ++j)
    for(i = 0; i < 3; ++i) {
      a = 3 * j + i; b = 3 * j + (i + 1) % 3
      if(j + 1 < n) { print 3, a, b, b + 3; print 3, a, b + 3, a + 3 } else print 3, a, b, 3 * n
    }
}' > tube.off

# ---------------------------------------------------------------------------------------------------------------------
# The command line

expect 0 --help
check "the exit codes are documented" grep -q '11 start_not_flip_free' out.txt
expect 0 --version
check "version" grep -q '[0-9]\.[0-9]\.[0-9]' out.txt
expect 0 parameterize --help
expect 2
expect 2 parameterize
expect 2 flatten sheet.off
expect 2 parameterize sheet.off --no-such-option
expect 2 parameterize sheet.off --preconditioner best
expect 2 parameterize sheet.off --linear-solver best
expect 2 parameterize sheet.off --border triangle
expect 2 parameterize sheet.off --threads 0
expect 2 parameterize sheet.off --threads many
expect 2 parameterize sheet.off --tolerance -1
expect 2 parameterize sheet.off --max-iterations -1
expect 2 parameterize sheet.off --time-limit 0
expect 2 measure

# ---------------------------------------------------------------------------------------------------------------------
# Good files

expect 0 parameterize sheet.off -o off.obj --json off.json --tolerance 1e-8
for key in status converged vertices faces iterations factorizations linear_solves energy energy_initial flips min_singular_value \
           max_singular_value load start assemble analyze factorize solve line_search certify total factorization_units \
           peak_memory_mb linear_solver preconditioner message; do
  check "the report has $key" grep -q "\"$key\": " off.json
done
check "seconds hold the phases" grep -q '"seconds": {' off.json
check "start names a start" grep -q '"start": "tutte' off.json
check "status" test "$(value off.json status)" = success
check "converged" test "$(value off.json converged)" = true
check "vertices" test "$(value off.json vertices)" = 143
check "faces" test "$(value off.json faces)" = 240
check "flips" test "$(value off.json flips)" = 0
check "energy falls" less "$(value off.json energy)" "$(value off.json energy_initial)"
check "energy exceeds an isometry's" less 1 "$(value off.json energy)"
check "singular values" less 0 "$(value off.json min_singular_value)"
check "memory" less 1 "$(value off.json peak_memory_mb)"
check "texture coordinates of all vertices" test "$(grep -c '^vt ' off.obj)" = 143
check "faces with texture" test "$(grep -c '^f [0-9]*/[0-9]* [0-9]*/[0-9]* [0-9]*/[0-9]*' off.obj)" = 240
energy=$(value off.json energy)

expect 0 measure off.obj --json measured.json
check "measured energy" close "$(value measured.json energy)" "$energy" 1e-9
check "measured flips" test "$(value measured.json flips)" = 0
check "measured faces" test "$(value measured.json faces)" = 240
check "measured singular value" close "$(value measured.json max_singular_value)" "$(value off.json max_singular_value)" 1e-9

for format in obj ply stl; do
  expect 0 parameterize sheet.$format -o $format.obj --json $format.json --tolerance 1e-8 --quiet
  check "quiet ($format)" test ! -s out.txt
  # STL readers keep single precision.
  check "energy of the $format file" close "$(value $format.json energy)" "$energy" "$([ $format = stl ] && echo 1e-5 || echo 1e-8)"
  check "vertices of the $format file" test "$(value $format.json vertices)" = 143
  expect 0 measure $format.obj
done

# The files name their material file, hence the folders.
mkdir one two
expect 0 parameterize sheet.off -o one/off.obj --tolerance 1e-8
check "runs are repeatable" cmp -s off.obj one/off.obj
grid off 60 50 > large.off
expect 0 parameterize large.off -o one/large.obj --threads 1
expect 0 parameterize large.off -o two/large.obj --threads 2
check "threads do not matter" cmp -s one/large.obj two/large.obj
expect 0 parameterize large.off -o one/slim.obj --threads 1 --preconditioner slim --linear-solver eigen
expect 0 parameterize large.off -o two/slim.obj --threads 2 --preconditioner slim --linear-solver eigen
check "nor do they with other methods" cmp -s one/slim.obj two/slim.obj

for preconditioner in default laplacian killing slim cm newton; do
  expect 0 parameterize sheet.off -o p.obj --json p.json --preconditioner $preconditioner --tolerance 1e-6 --max-iterations 20000
  check "$preconditioner converges" test "$(value p.json converged)" = true
  check "$preconditioner finds the same energy" close "$(value p.json energy)" "$energy" 1e-6
  expect 0 measure p.obj
done
for solver in default eigen; do
  expect 0 parameterize sheet.off --json s.json --linear-solver $solver
  check "$solver finds the same energy" close "$(value s.json energy)" "$energy" 1e-6
done
check "eigen is used" grep -q '"linear_solver": "eigen' s.json
if "$program" parameterize --help | grep -q 'eigen,cholmod\|cholmod'; then
  expect 0 parameterize sheet.off --json s.json --linear-solver cholmod
  check "cholmod finds the same energy" close "$(value s.json energy)" "$energy" 1e-6
  check "cholmod is used" grep -q '"linear_solver": "cholmod' s.json
fi
for border in circle square; do
  for weights in uniform mean-value cotangent; do
    expect 0 parameterize sheet.off --json b.json --border $border --weights $weights
    check "$border, $weights: same energy" close "$(value b.json energy)" "$energy" 1e-6
    check "$border, $weights: start" grep -q "\"start\": \"tutte .*${weights%-*}" b.json
  done
done
for criterion in characteristic gradient energy; do
  expect 0 parameterize sheet.off --json c.json --criterion $criterion
  check "$criterion converges" test "$(value c.json converged)" = true
  check "$criterion: energy" close "$(value c.json energy)" "$energy" 1e-4
done

expect 0 parameterize sheet.off --json l.json --max-iterations 2 --trace trace.csv --criterion gradient --tolerance 0 --preconditioner slim
check "limit" test "$(value l.json status)" = iteration_limit
check "a limit is no convergence" test "$(value l.json converged)" = false
check "the trace has a row for the start and each iteration" test "$(wc -l < trace.csv)" = 4
expect 0 parameterize sheet.off --json l.json --trace trace.csv
check "the trace has a header" grep -q '^iteration,seconds,energy,gradient_norm,step,flips$' trace.csv
check "rows of the trace" test "$(wc -l < trace.csv)" = $(($(value l.json iterations) + 2))
check "iterations are counted, energies fall, nothing flips" awk -F, '
  NR == 1 { next }
  NF != 6 || $1 != NR - 2 || $6 != 0 || (NR > 2 && $3 > energy) { wrong = 1 }
  { energy = $3 }
  END { exit wrong }' trace.csv
check "the trace ends at the energy of the report" close "$(tail -n 1 trace.csv | cut -d, -f3)" "$(value l.json energy)" 1e-14

expect 0 parameterize sheet.off -o unit.obj --unit-square
check "coordinates in the unit square" awk '
  $1 == "vt" { for(k = 2; k <= 3; ++k) { if($k < 0 || $k > 1) wrong = 1; if($k > most) most = $k; if($k < least) least = $k } }
  END { exit wrong || most != 1 || least != 0 }' unit.obj
expect 0 measure unit.obj --json unit.json
check "a similarity" close "$(value unit.json energy_of_similarity)" "$energy" 1e-5
expect 0 parameterize sheet.off --svg sheet.svg
check "picture" grep -q '<svg' sheet.svg
expect 0 parameterize one.off --json one.json
check "one triangle is mapped isometrically" close "$(value one.json energy)" 1 1e-8

# A flipped map is an error.
awk '$1 == "vt" { print "vt", -$2, $3; next } { print }' off.obj > mirrored.obj
expect 11 measure mirrored.obj --json mirrored.json
check "all flipped" test "$(value mirrored.json flips)" = 240
awk '$1 == "f" && !done { print "f", $3, $2, $4; done = 1; next } { print }' off.obj > one_flipped.obj
expect 11 measure one_flipped.obj --json one_flipped.json
check "one flipped" test "$(value one_flipped.json flips)" = 1
expect 17 measure sheet.obj
expect 17 measure no_such_file.obj

# ---------------------------------------------------------------------------------------------------------------------
# Bad files: code, status and the file

while read -r code status file; do
  rm -f bad.json bad.obj
  expect "$code" parameterize "$file" -o bad.obj --json bad.json
  check "$file has the status $status" test "$(value bad.json status)" = "$status"
  check "$file has a message" grep -q '"message": "..........' bad.json
  check "$file gives no map" test ! -e bad.obj
done << 'END'
3 empty_mesh no_vertices.off
3 empty_mesh no_faces.off
4 not_triangular quads.off
5 no_border closed.off
6 several_components components.off
7 not_a_disk frame.off
7 not_a_disk handle.off
8 non_manifold edge.off
8 non_manifold vertex.off
8 non_manifold twice.off
8 non_manifold orientation.off
8 non_manifold moebius.off
9 degenerate_rest_element zero_area.off
10 non_finite_input nan.ply
17 file_error nan.off
17 file_error truncated.off
17 file_error index.off
17 file_error empty.off
17 file_error letter.off
17 file_error no_such_file.off
END
expect 9 parameterize zero_area.off
check "the face is named by its number in the file" grep -q 'face number 1' err.txt

# A long thin tube may be beyond every start; if not, its map is as good as any.
rm -f tube.obj
"$program" parameterize tube.off -o tube.obj --json tube.json --max-iterations 10 > out.txt 2> err.txt
case $? in
  0) expect 0 measure tube.obj ;;
  11) check "a tube without a start gives no map" test ! -e tube.obj
      check "starts that were tried" grep -q 'uniform.*mean_value.*cotangent' tube.json ;;
  *) fail "the tube ends with $(value tube.json status)" ;;
esac

# Files that cannot be written.
expect 17 parameterize sheet.off -o missing/sheet.obj --json bad.json
check "the report says so" test "$(value bad.json status)" = file_error
expect 17 parameterize sheet.off --json missing/sheet.json
expect 17 parameterize sheet.off --svg missing/sheet.svg
expect 17 parameterize sheet.off --trace missing/trace.csv
expect 17 measure off.obj --json missing/measured.json
if [ -c /dev/full ]; then
  expect 17 parameterize sheet.off -o /dev/full
  expect 17 parameterize sheet.off --json /dev/full
  expect 17 parameterize sheet.off --trace /dev/full
fi

# ---------------------------------------------------------------------------------------------------------------------
# The collection of faulty and borderline files

if [ -n "$data" ] && [ -e "$data/bad_annulus.off" ]; then
  while read -r code file; do
    rm -f bad.obj
    expect "$code" parameterize "$data/$file" -o bad.obj
    if [ "$code" = 0 ]; then
      expect 0 measure bad.obj
    else
      check "$file gives no map" test ! -e bad.obj
    fi
  done << 'END'
7 bad_annulus.off
0 bad_cgal_issue_4290.off
5 bad_closed_cube.off
5 bad_closed_tetrahedron.off
9 bad_collinear_triangle.off
8 bad_degenerate_indices.off
6 bad_duplicated_vertices.off
17 bad_empty.off
0 bad_far_from_origin.off
3 bad_header_only.off
0 bad_huge_coordinates.off
8 bad_inconsistent_orientation.off
17 bad_index_out_of_range.off
17 bad_inf.off
0 bad_isolated_vertex.off
4 bad_mixed_polygons.off
8 bad_moebius.off
17 bad_nan.off
10 bad_nan.ply
0 bad_near_degenerate.off
17 bad_negative_index.off
3 bad_no_faces.off
8 bad_nonmanifold_edge.off
8 bad_nonmanifold_vertex.off
17 bad_not_a_mesh.off
8 bad_one_flipped_face.off
4 bad_quads.off
8 bad_repeated_face.off
0 bad_single_triangle.off
0 bad_tiny_coordinates.off
17 bad_truncated.off
6 bad_two_components.off
0 bad_two_triangles.off
17 bad_wrong_count.off
9 bad_zero_area_triangle.off
END
else
  echo "skipped: no meshes in '$data'"
fi

echo "$checks checks, $failures failed"
[ "$failures" -eq 0 ]
