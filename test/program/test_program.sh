#!/usr/bin/env bash
# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

# The program for the command line, on good and bad files of every kind: exit codes, reports, pictures and traces.
# Usage: test_program.sh PROGRAM

. "$(dirname -- "$0")/checks.sh"

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
sed 's/^element vertex/elephant vertex/' sheet.ply > elephant.ply
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

awk 'BEGIN {
  n = 40; m = 12; print "OFF\n" (n + 1) * (m + 1), 2 * n * m, 0
  for(j = 0; j <= m; ++j)
    for(i = 0; i <= n; ++i)
      printf "%.17g %.17g %.17g\n", cos(5 * i / n), sin(5 * i / n), 1.5 * j / m
  for(j = 0; j < m; ++j)
    for(i = 0; i < n; ++i) {
      a = j * (n + 1) + i; b = a + 1; c = b + n + 1; d = c - 1
      print 3, a, b, c; print 3, a, c, d
    }
}' > cylinder.off
# Bars in the plane and in space, the ends of which are handles, and the right ends move.
awk 'BEGIN {
  n = 16; m = 4; print "OFF\n" (n + 1) * (m + 1), 2 * n * m, 0
  for(j = 0; j <= m; ++j)
    for(i = 0; i <= n; ++i)
      print 4 * i / n, j / m, 0.25
  for(j = 0; j < m; ++j)
    for(i = 0; i < n; ++i) {
      a = j * (n + 1) + i; b = a + 1; c = b + n + 1; d = c - 1
      print 3, a, b, c; print 3, a, c, d
    }
  for(j = 0; j <= m; ++j) {
    print j * (n + 1), 0, j / m > "index_2.txt"
    print j * (n + 1) + n, 3 - j / m, 1.5 > "index_2.txt"
    print 0.01, j / m, "->", 0, j / m > "place_2.txt"
    print 4, j / m + 0.02, "->", 3 - j / m, 1.5, "# upwards" > "place_2.txt"
  }
}' > bar.off
awk '$1 == 3 && NF == 4 { print 3, $2, $4, $3; next } { print }' bar.off > clockwise.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' > triangle.off
printf '0 1 1\n1 1 0\n2 0 1\n' > turned_over.txt
awk 'BEGIN {
  n = 6; m = 2; step[1] = 1; step[2] = n + 1; step[3] = (n + 1) * (m + 1)
  print "MeshVersionFormatted 2\nDimension 3\nVertices\n" (n + 1) * (m + 1) * (m + 1)
  for(k = 0; k <= m; ++k)
    for(j = 0; j <= m; ++j)
      for(i = 0; i <= n; ++i)
        print i / 2, j / 2, k / 2, 0
  print "Tetrahedra\n" 6 * n * m * m
  for(k = 0; k < m; ++k)
    for(j = 0; j < m; ++j)
      for(i = 0; i < n; ++i) {
        a = k * step[3] + j * step[2] + i + 1; b = a + step[1] + step[2] + step[3]
        for(p = 1; p <= 3; ++p) {
          q = p % 3 + 1
          print a, a + step[p], a + step[p] + step[q], b, 0
          print a, a + step[p] + step[q], a + step[q], b, 0
        }
      }
  print "End"
  for(k = 0; k <= m; ++k)
    for(j = 0; j <= m; ++j) {
      a = k * step[3] + j * step[2]
      print a, 0, j / 2, k / 2 > "index_3.txt"
      print a + n, 3, 1 - k / 2, j / 2 > "index_3.txt"
      print 0.02, j / 2, k / 2, "->", 0, j / 2, k / 2 > "place_3.txt"
      print 3, j / 2, k / 2 + 0.01, "->", 3, 1 - k / 2, j / 2, "# a quarter of a turn" > "place_3.txt"
    }
}' > bar.mesh
head -n 20 bar.mesh > broken.mesh

# ---------------------------------------------------------------------------------------------------------------------
# The command line

expect 0 --help
tr -s ' \n' ' ' < out.txt > help.txt
check "exit codes are documented" grep -q "; 2 wrong command line; 3 empty_mesh; 4 not_triangular; 5 no_border; 6 several_components; \
7 not_a_disk; 8 non_manifold; 9 degenerate_rest_element; 10 non_finite_input; 11 start_not_flip_free; 12 unreachable_constraints; \
13 linear_solver_failed; 14 line_search_failed; 15 result_not_representable; 16 invalid_option; 17 file_error; 18 out_of_memory; \
19 not_planar; 20 flips_remain; 21 not_bijective; 22 interrupted" help.txt
check "exit codes of signals are documented" grep -q "130, 143 ended by Ctrl-C or SIGTERM" help.txt
expect 0 --version
check "version" grep -q '[0-9]\.[0-9]\.[0-9]' out.txt
expect 0 parameterize --help
expect 2
expect 2 parameterize
expect 2 flatten sheet.off
expect 2 parameterize sheet.off --no-such-option
expect 2 parameterize sheet.off --preconditioner best
expect 2 parameterize sheet.off --linear-solver best
expect 2 parameterize sheet.off --border heptagon
expect 2 parameterize sheet.off --method best
expect 2 parameterize sheet.off --reference best
expect 2 parameterize sheet.off --acceleration best
expect 2 parameterize sheet.off --energy best
expect 2 parameterize sheet.off --fixed
expect 2 parameterize sheet.off --threads 0
expect 2 parameterize sheet.off --threads many
expect 2 parameterize sheet.off --tolerance -1
expect 2 parameterize sheet.off --max-iterations -1
expect 2 parameterize sheet.off --time-limit 0
for option in --tolerance --time-limit --energy-parameter --memory-budget; do
  expect 2 parameterize sheet.off $option nan
done
expect 2 unwrap sheet.off --max-distortion nan
expect 2 unwrap sheet.off --margin -nan
expect 2 deform bar.off --handles index_2.txt --tikhonov nan
expect 2 measure
expect 0 deform --help
expect 2 deform
expect 2 deform bar.off
expect 2 deform bar.off --handles index_2.txt --soft-weight 0
expect 2 deform bar.off --handles index_2.txt --method best

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

for preconditioner in default laplacian killing slim cm projected-newton; do
  expect 0 parameterize sheet.off -o p.obj --json p.json --preconditioner $preconditioner --tolerance 1e-6 --max-iterations 20000
  check "$preconditioner converges" test "$(value p.json converged)" = true
  check "$preconditioner finds the same energy" close "$(value p.json energy)" "$energy" 1e-6
  expect 0 measure p.obj
done
# Other programs are told in lines of JSON how far it is.
# progress_of FILE: the phases in their order; fails if there is a line that is none, or the share decreases.
progress_of()
{
  awk '!/^[{]"phase":"[a-z_]+","share":[0-9.e+-]+,.*[}]$/ { exit 1 }
    { split($0, words, /[":,]+/); share = words[5]; if(share < last || share > 1) exit 1; last = share
      if(words[3] != phase) { phase = words[3]; phases = phases phase " " } } END { printf "%s", phases }' "$1"
}
expect 0 parameterize sheet.off -o told.obj --progress json --quiet
check "progress of parameterize" test "$(progress_of err.txt)" = "minimize end "
check "iterations and energies are told" grep -q '"iteration":0,"energy":[0-9][.0-9]*,"flips":0,' err.txt
check "the end is told" grep -q '^{"phase":"end","share":1,"status":"success","message":"..*"}$' err.txt
check "nothing but that is printed" test ! -s out.txt
expect 0 unwrap sheet.off -o told.obj --progress json
check "progress of unwrap" test "$(progress_of err.txt)" = "cut flatten pack end "
check "charts and faces are told" grep -q '"charts_done":[1-9][0-9]*,"charts":[1-9][0-9]*,"faces_done":240,"faces":240,' err.txt
expect 17 unwrap no_such_file.off -o told.obj --progress json
check "failures are told" grep -q '^{"phase":"end","share":1,"status":"file_error","message":"..*"}$' err.txt
expect 2 parameterize sheet.off --progress xml
for preconditioner in default killing slim cm projected-newton newton; do
  expect 0 parameterize sheet.off --json p.json --preconditioner $preconditioner --acceleration inexact-newton --tolerance 1e-8
  check "$preconditioner, inexact-newton: converges" test "$(value p.json converged)" = true
  check "$preconditioner, inexact-newton: same energy" close "$(value p.json energy)" "$energy" 1e-6
  check "$preconditioner, inexact-newton: keeps factorizations" less "$(value p.json factorizations)" "$(value p.json iterations)"
done
for method in default pp pp+ cm slim akvf akvf+ p-cm p-slim p-akvf aqp sobolev newton projected-newton; do
  expect 0 parameterize sheet.off -o m.obj --json m.json --method $method --tolerance 1e-6 --max-iterations 20000
  check "method $method converges" test "$(value m.json status)" = success
  check "method $method finds the same energy" close "$(value m.json energy)" "$energy" 1e-6
  expect 0 measure m.obj
done
for acceleration in none nesterov lbfgs inexact-newton; do
  for reference in fixed progressive; do
    expect 0 parameterize sheet.off --json m.json --acceleration $acceleration --reference $reference --tolerance 1e-6
    check "$acceleration is used" test "$(value m.json acceleration)" = ${acceleration/-/_}
    check "$reference is used" test "$(value m.json reference)" = $reference
    check "$acceleration, $reference: same energy" close "$(value m.json energy)" "$energy" 1e-6
  done
done
# Methods that need a decomposition of the energy take the energies that have one, and say of the others that they do not.
expect 0 parameterize sheet.off --json m.json --method newton --energy hencky --tolerance 1e-6
hencky=$(value m.json energy)
for method in cm p-cm; do
  expect 0 parameterize sheet.off --json m.json --method $method --energy hencky --tolerance 1e-6
  check "$method finds the same energy of Hencky" close "$(value m.json energy)" "$hencky" 1e-6
  for other in conformal amips; do
    expect 2 parameterize sheet.off --method $method --energy $other
    check "$method has no energy $other, and the reason is given" grep -q "^flip_free_maps: .*$other" err.txt
  done
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
if "$program" parameterize --help | grep -q 'petsc-mumps'; then
  for solver in petsc-gamg petsc-mumps; do
    expect 0 parameterize sheet.off --json s.json --linear-solver $solver
    check "$solver finds the same energy" close "$(value s.json energy)" "$energy" 1e-6
  done
  check "mumps is used" grep -q '"linear_solver": "mumps' s.json
else
  expect 2 parameterize sheet.off --linear-solver petsc-gamg
  check "the option that is missing is named" grep -q "FLIP_FREE_MAPS_WITH_PETSC" err.txt
fi
for border in circle square triangle octagon; do
  for weights in uniform mean-value cotangent; do
    expect 0 parameterize sheet.off --json b.json --border $border --weights $weights
    check "$border, $weights: same energy" close "$(value b.json energy)" "$energy" 1e-6
    check "$border, $weights: start" grep -q "\"start\": \"tutte .*${weights%-*}" b.json
    check "$border, $weights: a start of its own" less "$energy" "$(value b.json energy_initial)"
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
check "the trace has a header" grep -q '^iteration,seconds,energy,gradient_norm,step,flips,factorizations$' trace.csv
check "rows of the trace" test "$(wc -l < trace.csv)" = $(($(value l.json iterations) + 2))
check "iterations are counted, energies fall, nothing flips" awk -F, '
  NR == 1 { next }
  NF != 7 || $1 != NR - 2 || $6 != 0 || (NR > 2 && ($3 > energy || $7 < factorizations)) { wrong = 1 }
  { energy = $3; factorizations = $7 }
  END { exit wrong }' trace.csv
check "the trace ends at the factorizations of the report" test "$(tail -n 1 trace.csv | cut -d, -f7)" = "$(value l.json factorizations)"
check "the trace ends at the energy of the report" close "$(tail -n 1 trace.csv | cut -d, -f3)" "$(value l.json energy)" 1e-14

expect 0 parameterize sheet.off -o unit.obj --unit-square
check "coordinates in the unit square" awk '
  $1 == "vt" { for(k = 2; k <= 3; ++k) { if($k < 0 || $k > 1) wrong = 1; if($k > most) most = $k; if($k < least) least = $k } }
  END { exit wrong || most != 1 || least != 0 }' unit.obj
expect 0 measure unit.obj --json unit.json

# Texture coordinates mirrored as a whole, and one vertex thrown across the map: flips to repair.
awk '$1 == "vt" { n++; if (n == 20) { print "vt", -$2 - 1, $3 - 1; next } } { print }' off.obj > thrown.obj
expect 11 measure thrown.obj
expect 0 repair thrown.obj -o repaired.obj --json repaired.json
check "repaired without flips" test "$(value repaired.json flips)" = 0
check "repaired to the same energy" close "$(value repaired.json energy)" "$energy" 1e-5
expect 0 measure repaired.obj
expect 17 repair missing.obj -o repaired.obj
# Pinned vertices stay where they are. image_of FILE VERTEX: the vertex counts from 1.
image_of()
{
  awk -v v="$2" '
    $1 == "vt" { t[++n] = $2 " " $3 }
    $1 == "f" { for(k = 2; k <= NF; ++k) { split($k, i, "/"); if(i[1] == v) found = i[2] } }
    END { print t[found] }' "$1"
}
awk '$1 == "vt" { n++; if (n == 20) { print "vt", $2 - 1, $3 - 1; next } } { print }' off.obj > pulled.obj
printf '0\n5\n' > pinned.txt
expect 0 repair pulled.obj --pinned pinned.txt -o pinned.obj
expect 0 measure pinned.obj
for vertex in 1 6; do
  check "a pinned vertex stays" test "$(image_of pinned.obj $vertex)" = "$(image_of pulled.obj $vertex)"
done

# The splitting scheme: to the same energies as the default method, from a Tutte embedding and from a map with flips.
# As published it stops earlier.
expect 0 parameterize sheet.off --method splitting --json split.json
check "splitting comes near the same energy" close "$(value split.json energy)" "$energy" 1e-2
expect 0 parameterize sheet.off --method splitting+ -o split.obj --json split.json --tolerance 1e-7 --trace split.csv
check "splitting finds the same energy" close "$(value split.json energy)" "$energy" 1e-5
check "splitting is named" test "$(value split.json preconditioner)" = admm_splitting
check "splitting's energy is named" test "$(value split.json energy_name)" = "$(value off.json energy_name)"
check "splitting has a trace" grep -q '^1,' split.csv
expect 0 measure split.obj
expect 0 parameterize sheet.off --energy symmetric-gradient --json gradient.json --tolerance 1e-7
expect 0 parameterize sheet.off --energy symmetric-gradient --method splitting+ --start thrown.obj --polish --json split.json
check "splitting from flips finds the same energy" close "$(value split.json energy)" "$(value gradient.json energy)" 1e-4
check "splitting from flips" test "$(value split.json flips)" = 0
expect 2 parameterize sheet.off --method splitting --energy hencky
expect 2 parameterize sheet.off --method splitting --preconditioner slim
check "a similarity" close "$(value unit.json energy_of_similarity)" "$energy" 1e-5
expect 0 parameterize sheet.off --svg sheet.svg
check "picture" grep -q '<svg' sheet.svg
expect 0 parameterize one.off --json one.json
check "one triangle is mapped isometrically" close "$(value one.json energy)" 1 1e-8

# Surfaces that can be flattened without distortion are.
expect 0 parameterize cylinder.off -o cylinder.obj --json cylinder.json
check "a cylinder's patch: isometric" close "$(value cylinder.json energy)" 1 1e-8
check "a cylinder's patch: at once" test "$(value cylinder.json iterations)" -le 6
expect 0 measure cylinder.obj

# Starts and constraints.
expect 0 parameterize sheet.off --start off.obj --json given.json
check "a given start" test "$(value given.json iterations)" = 0
check "a given start is not computed" grep -q '"start": "given"' given.json
check "a given start's energy" close "$(value given.json energy)" "$energy" 1e-9
awk '$1 == "vt" { print "vt", -$2, $3; next } { print }' off.obj > mirrored.obj
expect 11 parameterize sheet.off --start mirrored.obj
expect 17 parameterize sheet.off --start one.off
expect 17 parameterize sheet.off --start no_such_file.obj
awk '$1 == "f" && !done { done = 1; next } { print }' off.obj > one_less.obj
expect 17 parameterize sheet.off --start one_less.obj

# place FILE VERTEX: its texture coordinates, in files that have one pair per vertex.
place()
{
  awk -v v="$2" '
    $1 == "vt" { uv[++n] = $2 " " $3 }
    $1 == "f" { for(k = 2; k <= 4; ++k) { split($k, i, "/"); if(i[1] == v + 1) { print uv[i[2]]; exit } } }' "$1"
}
printf '# corners\n0\n\n142 # the last one\n' > fixed.txt
expect 0 parameterize sheet.off --start off.obj --preconditioner projected-newton --energy hencky --fixed fixed.txt -o fixed.obj \
  --json fixed.json
check "the map changes" less 0 "$(value fixed.json iterations)"
check "fixed vertices stay" test "$(place fixed.obj 0) $(place fixed.obj 142)" = "$(place off.obj 0) $(place off.obj 142)"
check "others do not" test "$(place fixed.obj 70)" != "$(place off.obj 70)"
expect 0 parameterize sheet.off --fix-border --border square --json border.json -o border.obj
check "a fixed border costs distortion" less "$energy" "$(value border.json energy)"
expect 0 parameterize sheet.off --border square --max-iterations 0 -o start.obj
for v in 0 7 12 77 142; do
  check "vertex $v of the border stays" test "$(place border.obj $v)" = "$(place start.obj $v)"
done
check "an inner vertex does not" test "$(place border.obj 70)" != "$(place start.obj 70)"
printf '0 -3 2 1e5\n' > soft.txt
expect 0 parameterize sheet.off --soft soft.txt -o soft.obj --json soft.json
check "a soft position pulls" awk -v p="$(place soft.obj 0)" 'BEGIN { split(p, x); exit !((x[1] + 3)^2 + (x[2] - 2)^2 < 1e-6) }'
check "one soft position costs no distortion" close "$(value soft.json energy)" "$energy" 1e-6
for line in 'x' '143' '-1' '1.5' '0 1'; do
  echo "$line" > bad.txt
  expect 17 parameterize sheet.off --fixed bad.txt
done
for line in '0 1 2' '0 0 0 x' '143 0 0 1' '0 nan 0 1'; do
  echo "$line" > bad.txt
  expect 17 parameterize sheet.off --soft bad.txt
done
echo '0 0 0 -1' > bad.txt
expect 16 parameterize sheet.off --soft bad.txt
expect 17 parameterize sheet.off --soft no_such_file.txt

# A flipped map is an error.
expect 11 measure mirrored.obj --json mirrored.json
check "all flipped" test "$(value mirrored.json flips)" = 240
awk '$1 == "f" && !done { print "f", $3, $2, $4; done = 1; next } { print }' off.obj > one_flipped.obj
expect 11 measure one_flipped.obj --json one_flipped.json
check "one flipped" test "$(value one_flipped.json flips)" = 1
expect 17 measure sheet.obj
expect 17 measure no_such_file.obj

# ---------------------------------------------------------------------------------------------------------------------
# Atlases

for file in closed.off components.off frame.off handle.off cylinder.off sheet.off sheet.stl one.off; do
  atlas $file
done
atlas components.off
check "a chart for each component" test "$(total atlas.json number_of_charts)" = 2
atlas sheet.off --max-distortion inf
check "a disk needs no seam" test "$(total atlas.json seam_edges)" = 0
check "a disk's energy" close "$(total atlas.json energy)" "$energy" 1e-6
atlas handle.off --max-distortion inf
check "a handle needs seams" less 0 "$(total atlas.json seam_edges)"
charts=$(total atlas.json number_of_charts)
atlas handle.off --max-distortion 1.01
check "less distortion takes more charts" less "$charts" "$(total atlas.json number_of_charts)"
check "no chart is distorted more" awk '
  /"charts"/ { inside = 1 }
  inside && /"energy"/ { ++n; gsub(/[^0-9.e-]/, "", $2); if($2 > 1.01) wrong = 1 }
  END { exit wrong || !n }' atlas.json
# A unit of length does not matter, though areas in it be 0 or infinite.
atlas components.off
mean=$(total atlas.json energy)
for unit in e-200 e200; do
  awk -v unit=$unit 'NF == 3 && n++ > 0 { print $1 unit, $2 unit, $3 unit; next } { print }' components.off > unit.off
  expect 0 unwrap unit.off --json atlas.json
  check "mean energy at 1$unit" close "$(total atlas.json energy)" "$mean" 1e-9
done
wanted=1 atlas handle.off --margin 0.1 --no-rotation --time-limit 0.000001
check "a limit is valid" test "$(total atlas.json status)" = time_limit
atlas sheet.off --svg atlas.svg
check "picture of an atlas" grep -q '<svg' atlas.svg
expect 0 unwrap sheet.off --max-distortion inf --no-pack --json atlas.json -o atlas.obj
check "units of the surface" test "$(total atlas.json scale)" = 1.0
expect 0 measure atlas.obj --json measured.json
check "lengths are kept" close "$(value measured.json energy)" "$energy" 1e-6
printf '# a seam\n0 1\n\n1 2\n' > seams.txt
atlas closed.off --seams seams.txt
for line in 'x' '0' '0 99' '-1 0' '0 1 2' '0 142'; do
  echo "$line" > bad.txt
  expect 17 unwrap sheet.off --seams bad.txt
done
expect 17 unwrap sheet.off --seams no_such_file.txt
expect 16 unwrap sheet.off --margin 0
expect 16 unwrap sheet.off --max-distortion 1
expect 17 unwrap sheet.off -o missing/atlas.obj

# What is no manifold mesh of triangles is refused on request, and repaired on request.
while read -r code file; do
  rm -f atlas.obj
  expect "$code" unwrap $file --strict -o atlas.obj
  check "$file gives no atlas" test ! -e atlas.obj
  atlas $file --repair
  check "$file: repairs are reported" grep -q '"repairs": "repaired' atlas.json
done << 'END'
4 quads.off
8 edge.off
8 vertex.off
8 orientation.off
8 moebius.off
END
# Points are joined by their places, by both commands.
printf 'OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 3 4 5\n' > unwelded.off
atlas unwelded.off
check "unwelded triangles: one chart" test "$(total atlas.json number_of_charts)" = 1
atlas zero_area.off --repair
# A face without area needs no repair.
expect 0 unwrap zero_area.off -o atlas.obj --json atlas.json
check "faces without area are counted" less 0 "$(total atlas.json faces_without_area)"
expect 2 unwrap sheet.off --strict --repair
atlas sheet.off --strict
atlas sheet.off --repair
check "nothing to repair" grep -q '"repairs": "nothing' atlas.json
expect 3 unwrap nan.ply --repair
expect 17 unwrap truncated.off --repair
expect 17 unwrap no_such_file.off

# Polygons that two sides of a sheet share, that meet in two edges, that cross themselves; an edge that is flipped.
printf 'OFF\n6 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n4 0 1 2 3\n4 1 4 5 2\n4 3 2 1 0\n4 2 5 4 1\n' > two_sided.off
printf 'OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 1\n0 1 0\n4 0 1 2 3\n4 3 2 1 0\n3 0 1 3\n' > two_edges.off
printf 'OFF\n6 2 0\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n2 0 0\n2 1 0\n4 0 1 2 3\n3 2 4 5\n' > crossing.off
printf 'OFF\n5 3 0\n0 0 0\n1 0 0\n0.5 1 0\n0.5 0 0\n0.5 -1 0\n3 0 3 1\n3 0 1 2\n3 0 4 3\n' > cap.off
# Points that are collinear in decimals only: inside, and at the border.
printf 'OFF\n5 4 0\n0 0 0\n0.3 0.6 0.9\n0.1 0.2 0.3\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 3\n3 2 1 3\n3 1 0 4\n' > decimals.off
printf 'OFF\n4 3 0\n0 0 0\n0.3 0.6 0.9\n0.1 0.2 0.3\n1 0 0\n3 0 1 2\n3 0 2 3\n3 2 1 3\n' > decimals_border.off
for file in two_sided two_edges crossing cap decimals decimals_border; do
  atlas $file.off --repair
done
atlas two_sided.off --repair
check "both sides are kept" test "$(value measured.json faces)" = 8
atlas cap.off --repair
check "what happens to faces without area is told" grep -q '1 faces without area' atlas.json

# ---------------------------------------------------------------------------------------------------------------------
# Files that come back

# untextured FILE: its lines but those of texture coordinates, and without texture indices.
untextured()
{
  sed -E '/^vt /d; /^f /s#([0-9]+)/[0-9]*(/([0-9]+))?#\1/\3#g; s#/([[:space:]]|$)#\1#g' "$1"
}

# A roof of two quads, with all that modelling programs write.
printf '%s\r\n' '# by hand' 'mtllib roof.mtl' 'o roof' 'v 0 0 0 1 0 0' 'v 1 0 0 1 0 0' 'v 1 1 0.5 0 1 0' 'v 0 1 0.5 0 1 0' 'v 0 2 0 0 0 1' \
  'v 1 2 0 0 0 1' 'vn 0 -1 2' 'vn 0 1 2' 'vt 7 7' 'g south' 'usemtl red' 's 1' 'f 1/1/1 2/1/1 3/1/1 4/1/1' 'g north' 'usemtl blue' \
  'f 4//2 3//2 6//2 5//2' 'l 1 2' > roof.obj
echo 'newmtl red' > roof.mtl
for command in unwrap 'unwrap --checker'; do
  expect 0 $command roof.obj -o roof_out.obj
  expect 0 measure roof_out.obj --json measured.json
  check "$command: polygons are measured as such" test "$(value measured.json faces)" = 2
done
check "the checkerboard is used when it is asked for" grep -q 'usemtl checkerboard' roof_out.obj
rm -f roof_out*
expect 0 unwrap roof.obj -o roof_out.obj
untextured roof.obj > before.txt
untextured roof_out.obj > after.txt
check "lines are kept" cmp -s before.txt after.txt
check "the old texture coordinates are gone" test "$(grep -c '^vt 7 7' roof_out.obj)" = 0
check "new ones are there" test "$(grep -c '^vt ' roof_out.obj)" -ge 6
check "materials of the file stay" test ! -e roof_out_checker.mtl
check "other files are left alone" test "$(cat roof.mtl)" = 'newmtl red'
cp roof.obj same.obj
expect 0 unwrap same.obj -o same.obj
check "the output may be the input" cmp -s same.obj roof_out.obj
expect 0 unwrap same.obj -o same.obj
check "once more changes nothing" cmp -s same.obj roof_out.obj
expect 0 parameterize sheet.obj -o sheet_out.obj
grep -v '^mtllib\|^usemtl' sheet_out.obj > plain.obj
untextured plain.obj > after.txt
check "parameterize keeps lines" cmp -s sheet.obj after.txt
check "a file without materials gets a checkerboard" grep -q 'newmtl checkerboard' sheet_out_checker.mtl
check "which has a picture" test -s sheet_out_checker.png

# PLY stays PLY; all formats become OBJ or PLY; other extensions are refused before anything is done.
expect 0 unwrap sheet.ply -o sheet_out.ply
check "PLY gains texture coordinates" grep -q '^property list uchar double texcoord' sheet_out.ply
check "PLY keeps the rest" awk '
  NR == FNR { line[NR] = $0; next }
  /texcoord$/ { shift = 1; next }
  index($0, line[FNR - shift]) != 1 { wrong = 1 }
  END { exit wrong || !shift }' sheet.ply sheet_out.ply
expect 0 measure sheet_out.ply
for format in off stl obj; do
  expect 0 unwrap sheet.$format -o from_$format.ply
  expect 0 measure from_$format.ply
done
expect 0 unwrap sheet.ply -o from_ply.obj
expect 0 measure from_ply.obj
for name in out.off out.stl out.txt out; do
  for command in unwrap parameterize; do
    expect 2 $command sheet.off -o $name
    check "$command says what is written instead of $name" grep -q '\.obj, \.ply, \.glb and \.gltf' err.txt
  done
done
expect 17 deform bar.off --handles index_2.txt -o bar_out.glb
expect 17 deform bar.mesh --handles index_3.txt -o bar_out.obj
expect 2 unwrap sheet.off -o out.ply --checker
check "nothing was written" test -z "$(ls out* bar_out* 2> /dev/null | grep -v '^out.txt$')"

# Outputs that would destroy an input or each other are refused, and nothing happens.
cp sheet.obj precious.obj
printf '0 1\n' > seam.txt
ln -s precious.obj alias.obj
for arguments in 'unwrap precious.obj --json precious.obj' 'unwrap precious.obj -o a.obj --png alias.obj' \
  'unwrap precious.obj --seams seam.txt -o a.obj --json seam.txt' 'unwrap precious.obj -o a.obj --json ./a.obj' \
  'unwrap precious.obj -o a.obj --png a_checker.png' 'parameterize precious.obj --trace precious.obj' \
  'parameterize precious.obj --start off.obj -o off.obj' 'measure precious.obj --json precious.obj' \
  'repair precious.obj --json precious.obj' 'pack precious.obj --json precious.obj' \
  'deform bar.off --handles index_2.txt -o index_2.txt' 'deform bar.off --handles index_2.txt --json bar.off'; do
  expect 2 $arguments
  check "$arguments: the reason" grep -q 'same file\|would replace' err.txt
done
check "the input is still there" cmp -s precious.obj sheet.obj
check "seams are still there" test "$(cat seam.txt)" = '0 1'
check "nothing was written" test ! -e a.obj
# What fails in the middle leaves what was there.
{ echo 'usemtl red'; cat sheet.obj; } > kept.obj
cp kept.obj kept_before.obj
(ulimit -f 1; "$program" unwrap kept.obj -o kept.obj > out.txt 2> err.txt) 2> /dev/null
check "an output that cannot be completed leaves the input" cmp -s kept.obj kept_before.obj
rm -f kept.obj.*.tmp
expect 0 unwrap sheet.off -o a.obj --json a.json --png a.png --png3d surface.png
check "the surface is drawn" test -s surface.png
expect 0 measure a.obj --png3d measured.png
check "the same picture of what was written" cmp -s surface.png measured.png
expect 2 measure a.obj --png3d a.obj
check "no temporary files are left" test -z "$(ls -a | grep '\.tmp$')"

# Numbers of vertices are those of the file, through any repair, and a byte order mark does not matter.
awk 'BEGIN {
  n = 4; print "OFF\n" (n + 1) * (n + 1) + 1, 2 * n * n, 0
  print "0 0 0" # twice, so that a repair numbers all others anew
  for(j = 0; j <= n; ++j) for(i = 0; i <= n; ++i) print i / n, j / n, 0
  for(j = 0; j < n; ++j) for(i = 0; i < n; ++i) {
    a = j * (n + 1) + i + 1; b = a + 1; c = b + n + 1; d = c - 1
    print 3, (a == 1 ? 0 : a), b, c; print 3, a, c, d
  }
}' > doubled.off
printf '\357\273\277# at x = 1/2\n3 8\n8 13\n13 18\n18 23\n' > middle.txt
for repair in '' --repair; do
  expect 0 unwrap doubled.off $repair --seams middle.txt --max-distortion inf -o atlas.obj --json atlas.json
  check "the seam is at x = 1/2 ($repair)" awk '
    $1 == "v" { x[++v] = $2 }
    $1 == "f" { for(k = 2; k <= 4; ++k) { split($k, i, "/"); if(x[i[1]] == 0.5) middle[i[1]] = middle[i[1]] " " i[2] } }
    END { for(v in middle) { n = split(middle[v], t, " "); different = 0
            for(k = 2; k <= n; ++k) if(t[k] != t[1]) different = 1
            if(!different) exit 1 } }' atlas.obj
done
printf '\357\273\2770\n142\n' > fixed_marked.txt
expect 0 parameterize sheet.off --start off.obj --fixed fixed_marked.txt
printf '3 8\n3 14\n' > bad.txt
expect 17 unwrap doubled.off --repair --seams bad.txt
check "the line is named" grep -q 'bad.txt, line 2: there is no edge' err.txt

# Messages name the element and what helps.
expect 8 parameterize vertex.off
check "the pinched vertex" grep -q 'vertex number 0' err.txt
check "the way out" grep -q 'sub-command unwrap' err.txt
for file in closed components handle; do
  "$program" parameterize $file.off > out.txt 2> err.txt
  check "$file: the way out" grep -q 'sub-command unwrap' err.txt
  check "$file: no function is named" test -z "$(grep '()' err.txt)"
done

# ---------------------------------------------------------------------------------------------------------------------
# Texture coordinates that are there already

# A cube with an island for each side, one of them mirrored and one with a triangle turned over.
awk 'BEGIN {
  for(v = 0; v < 8; ++v) print "v", v % 2, int(v / 2) % 2, int(v / 4)
  split("0 2 3 1 4 5 7 6 0 1 5 4 2 6 7 3 0 4 6 2 1 3 7 5", q, " ")
  for(s = 0; s < 6; ++s) {
    x = 1.5 * (s % 3); y = 2 * int(s / 3); m = s == 2 ? -1 : 1
    print "vt", x, y; print "vt", x + m, y; print "vt", x + m, y + 1; print "vt", (s == 4 ? x + 1.5 : x), (s == 4 ? y : y + 1)
  }
  for(s = 0; s < 6; ++s) {
    for(k = 1; k <= 4; ++k) c[k] = (q[4 * s + k] + 1) "/" (4 * s + k)
    if(s % 2) print "f", c[1], c[2], c[3], c[4]; else { print "f", c[1], c[2], c[3]; print "f", c[1], c[3], c[4] }
  }
  print "v 5 5 5\nf 1 2 9\nv 0.5 0 0\nvt 9 9\nf 1/25 2/25 10/25"
}' > islands.obj
expect 11 measure islands.obj --json measured.json
check "islands are counted" test "$(value measured.json islands)" = 6
check "mirrored and flipped faces are counted" test "$(value measured.json flips)" = 3
check "faces without texture coordinates are counted" test "$(value measured.json faces_without_texture)" = 1
check "faces without area are counted" test "$(value measured.json faces_without_area)" = 1
expect 0 repair islands.obj -o islands_out.obj --json repaired.json
check "two islands are repaired" grep -q 'repaired 2 of 6 islands' repaired.json
expect 0 measure islands_out.obj --json measured.json
check "no flips are left" test "$(value measured.json flips)" = 0
check "islands keep their scale" close "$(value measured.json energy)" 1 1e-6
check "islands that were right are left alone" test \
  "$(awk '$1 == "vt" { t[++n] = $2 " " $3 } /^f 5/ { for(k = 2; k <= 5; ++k) { split($k, i, "/"); print t[i[2]] } }' islands_out.obj)" = \
  "$(awk '$1 == "vt" { t[++n] = $2 " " $3 } /^f 5/ { for(k = 2; k <= 5; ++k) { split($k, i, "/"); print t[i[2]] } }' islands.obj)"
expect 0 repair islands_out.obj -o again.obj --json repaired.json
check "nothing is left to repair" grep -q 'nothing had to be repaired' repaired.json
expect 17 repair sheet.obj
expect 0 pack islands_out.obj -o packed.obj --json packed.json
check "islands that are packed" test "$(value packed.json charts)" = 6
expect 0 measure packed.obj --json measured.json
check "packed islands do not overlap" test "$(value measured.json bijective)" = true
check "the unit square is kept by what has an area" awk '$1 == "vt" && $2 != 9 { for(k = 2; k <= 3; ++k) if($k < 0 || $k > 1) wrong = 1 }
  END { exit wrong }' packed.obj
check "packed islands have one scale" close "$(value measured.json energy_of_similarity)" 1 1e-6
expect 0 pack islands.obj -o packed.obj
expect 11 measure packed.obj --json measured.json
check "what was mirrored stays mirrored" test "$(value measured.json flips)" = 3
expect 17 pack sheet.obj -o packed.obj
expect 16 pack islands.obj --margin 0
# Pinned islands stay. images_of FILE N: the texture coordinates of face N, which counts from 1.
images_of()
{
  awk -v n="$2" '$1 == "vt" { t[++m] = $2 " " $3 }
    $1 == "f" && ++f == n { for(k = 2; k <= NF; ++k) { split($k, i, "/"); print t[i[2]] } }' "$1"
}
expect 0 pack islands.obj -o packed.obj
echo 2 > pinned.txt # the first quad
expect 0 pack packed.obj --pinned pinned.txt --margin 0.05 -o pinned.obj --json pinned.json
check "an island is pinned" test "$(value pinned.json pinned_charts)" = 1
check "the pinned island stays" test "$(images_of pinned.obj 3)" = "$(images_of packed.obj 3)"
check "others do not" test "$(images_of pinned.obj 1)" != "$(images_of packed.obj 1)"
expect 0 unwrap components.off -o split.obj
echo 0 > pinned.txt
expect 0 unwrap split.obj --pinned pinned.txt -o pinned.obj --json pinned.json
pinned="$(total pinned.json pinned_faces)"
check "faces are pinned, but not all" test "$pinned" -gt 0 -a "$pinned" -lt "$(total pinned.json faces)"
same="$(awk '
  FNR == 1 { file++; m = 0; f = 0 }
  $1 == "vt" { t[++m] = $2 " " $3 }
  $1 == "f" { ++f; s = ""; for(k = 2; k <= NF; ++k) { split($k, i, "/"); s = s " " t[i[2]] }
              if(file == 1) first[f] = s; else if(first[f] == s) ++same }
  END { print same + 0 }' split.obj pinned.obj)"
check "pinned faces keep their images" test "$same" = "$pinned"
expect 0 measure pinned.obj --json measured.json
check "nothing overlaps what is pinned" test "$(value measured.json bijective)" = true
echo 100000 > pinned.txt
expect 17 unwrap split.obj --pinned pinned.txt
expect 17 pack split.obj --pinned pinned.txt
expect 2 unwrap split.obj --pinned pinned.txt --no-pack
echo 0 > pinned.txt
expect 17 unwrap sheet.off --pinned pinned.txt
grep -v ' 9$\|/25' islands_out.obj > cube.obj
expect 0 unwrap cube.obj --keep-seams -o kept_seams.obj --json atlas.json
check "seams of the file are kept" test "$(total atlas.json number_of_charts)" = 6
expect 0 measure kept_seams.obj --json measured.json
check "and its charts are flattened anew" close "$(value measured.json energy_of_similarity)" 1 1e-6

# ---------------------------------------------------------------------------------------------------------------------
# Deformations

# Handles arrive exactly, everything else stays as it was: coordinates that follow the heading of an OFF or a Medit file.
vertices_of()
{
  case $1 in
    *.mesh) awk '/Vertices/ { getline count; for(i = 0; i < count; ++i) { getline; print $1, $2, $3 } exit }' "$1" ;;
    *) awk 'NF == 0 || $1 == "OFF" { next } !n { n = $1; next } k++ < n { print $1, $2, $3 }' "$1" ;;
  esac
}
# arrive RESULT HANDLES: handles in the form with numbers.
arrive()
{
  vertices_of "$1" | awk -v handles="$2" '
    { x[NR - 1] = $1; y[NR - 1] = $2; z[NR - 1] = $3 }
    END {
      while((getline line < handles) > 0) {
        n = split(line, h)
        if(x[h[1]] != h[2] || y[h[1]] != h[3] || (n == 4 && z[h[1]] != h[4])) wrong = 1
        ++lines
      }
      exit wrong || lines == 0 || NR == 0
    }'
}

for dimension in 2 3; do
  if [ $dimension = 2 ]; then shape=bar.off vertices=85 elements=128 kind=faces
  else shape=bar.mesh vertices=63 elements=144 kind=tetrahedra; fi
  expect 0 deform $shape --handles index_$dimension.txt -o one_$shape --json one.json --tolerance 1e-6
  check "$shape: converges" test "$(value one.json status)" = success
  check "$shape: vertices" test "$(value one.json vertices)" = $vertices
  check "$shape: elements" test "$(value one.json $kind)" = $elements
  check "$shape: flips" test "$(value one.json flips)" = 0
  check "$shape: distorted" less 1.001 "$(value one.json energy)"
  check "$shape: not very" less "$(value one.json energy)" 1.2
  check "$shape: handles arrive" arrive one_$shape index_$dimension.txt
  check "$shape: number of vertices" test "$(vertices_of one_$shape | wc -l)" = $vertices
  bent=$(value one.json energy)
  expect 0 deform $shape --handles place_$dimension.txt -o two_$shape --json two.json --tolerance 1e-6
  check "$shape: both forms of handles mean the same" cmp -s one_$shape two_$shape
  for method in pp cm slim akvf aqp sobolev newton projected-newton; do
    if [ $dimension = 3 ] && [ $method = cm ]; then
      expect 2 deform $shape --handles index_$dimension.txt --method $method
      continue
    fi
    expect 0 deform $shape --handles index_$dimension.txt --method $method --json method.json --tolerance 1e-6 \
      --max-iterations 20000
    check "$shape: $method converges" test "$(value method.json status)" = success
    check "$shape: $method finds the same energy" close "$(value method.json energy)" "$bent" 1e-6
  done
  for preconditioner in default laplacian killing slim projected-newton absolute-newton vertex-space-newton newton hybrid; do
    expect 0 deform $shape --handles index_$dimension.txt --preconditioner $preconditioner --acceleration inexact-newton \
      --json method.json --tolerance 1e-6 --max-iterations 20000
    check "$shape: inexact-newton is used" test "$(value method.json acceleration)" = inexact_newton
    check "$shape: $preconditioner, inexact-newton: same energy" close "$(value method.json energy)" "$bent" 1e-6
  done
  expect 0 deform $shape --handles index_$dimension.txt --method splitting+ --json method.json --tolerance 1e-7 --max-iterations 20000
  check "$shape: splitting finds the same energy" close "$(value method.json energy)" "$bent" 1e-4
  expect 0 deform $shape --handles index_$dimension.txt --trace deform.csv
  check "$shape: trace" grep -q '^iteration,' deform.csv

  # Two lines in front, the first a good handle: the fault is in the third line.
  if [ $dimension = 2 ]; then more=''; else more=' 0'; fi
  for line in "0" "0 0 0 0 0$more" "$vertices 0 0$more" "-1 0 0$more" "0.5 0 0$more" "1 x 0$more" "1 nan 0$more" \
              "0 0$more -> 1" "0 0 0$more"; do
    printf '0 0 0%s\n# a comment\n%s\n' "$more" "$line" > bad.txt
    rm -f bad_$shape
    expect 17 deform $shape --handles bad.txt -o bad_$shape --json bad.json
    check "$shape: the line of '$line'" grep -q 'bad.txt.*line 3' err.txt
    check "$shape: the status of '$line'" test "$(value bad.json status)" = file_error
    check "$shape: no result for '$line'" test ! -e bad_$shape
  done
  printf '# nothing\n' > bad.txt
  expect 17 deform $shape --handles bad.txt
  expect 17 deform $shape --handles no_such_file.txt
  expect 17 deform $shape --handles index_$dimension.txt -o missing/$shape
  expect 17 deform no_such_$shape --handles index_$dimension.txt
done
check "the plane is kept" test -z "$(vertices_of one_bar.off | awk '$3 != 0.25')"
expect 0 deform bar.mesh --handles index_3.txt -o bar.vtu
check "VTU" grep -q '<VTKFile' bar.vtu
expect 0 deform bar.mesh --handles index_3.txt --start one_bar.mesh --json start.json --tolerance 1e-5
check "a given start that is the optimum" test "$(value start.json iterations)" = 0
expect 17 deform bar.mesh --handles index_3.txt --start no_such_file.mesh
# References and other sections are kept, and what would be torn off is refused.
awk '/^End/ { print "Ridges\n1\n1\nEnd # of all"; next } NF == 4 || NF == 5 { $NF = NR } { print }' bar.mesh > labelled.mesh
expect 0 deform labelled.mesh --handles index_3.txt -o labelled_out.mesh --tolerance 1e-6
check "labels are kept" test "$(awk 'NF == 4 { print "point", $4; next } { print }' labelled_out.mesh)" = \
  "$(awk 'NF == 4 { print "point", $4; next } { print }' labelled.mesh)"
check "and so are places" test "$(vertices_of labelled_out.mesh)" = "$(vertices_of one_bar.mesh)"
expect 0 deform bar.mesh --handles index_3.txt -o plain.node
awk 'NR == 1 { print "# points\n" $1, 3, 1, 1; next } { print $1 + 1, $2, $3, $4, NR / 8, NR % 3, "# " NR }' \
  <(head -n 1 plain.node; vertices_of bar.mesh | awk '{ print NR - 1, $0 }') > labelled.node
awk 'NR == 1 { print $1, 4, 1; next } { print $1 + 1, $2 + 1, $3 + 1, $4 + 1, $5 + 1, NR % 5 }' plain.ele > labelled.ele
expect 0 deform labelled.ele --handles index_3.txt -o labelled_out.node --tolerance 1e-6
check "regions are kept" cmp -s labelled.ele labelled_out.ele
check "attributes and markers are kept" test "$(awk 'NF > 5 { $2 = $3 = $4 = "" } { print }' labelled_out.node)" = \
  "$(awk 'NF > 5 { $2 = $3 = $4 = "" } { print }' labelled.node)"
check "and so are places of TetGen files" test "$(awk 'NF > 5 { print $2, $3, $4 }' labelled_out.node)" = "$(vertices_of one_bar.mesh)"
sed 's/^Tetrahedra/Hexahedra\n1\n1 2 3 4 5 6 7 8 0\nTetrahedra/' bar.mesh > mixed.mesh
expect 17 deform mixed.mesh --handles index_3.txt -o bad.mesh
check "other elements are named" grep -q 'Hexahedra' err.txt
expect 17 deform bar.xyz --handles index_3.txt
check "the formats that are read are named" grep -q '\.obj.*\.mesh' err.txt

# A plane is one up to rounding, and may be any coordinate plane, seen from either side.
awk 'NF == 3 && $1 != 85 { print $1, $2, $3 + (NR % 3) * 1e-15; next } { print }' bar.off > rounded.off
awk 'NF == 3 && $1 != 85 { print $1, $3, $2; next } { print }' bar.off > front.off
awk '$1 == 3 && NF == 4 { print 3, $2, $4, $3; next } { print }' front.off > back.off
awk 'NF == 3 && $1 != 85 { print 7, $1, $2; next } { print }' bar.off > side.off
for view in 'rounded 1 2' 'front 1 3' 'back 1 3' 'side 2 3'; do
  set -- $view
  expect 0 deform $1.off --handles index_2.txt -o $1_out.off --json $1.json --tolerance 1e-6
  check "$1: flips" test "$(value $1.json flips)" = 0
  check "$1: handles arrive" test -z "$(vertices_of $1_out.off | awk -v i=$2 -v j=$3 '
    { x[NR - 1] = $i; y[NR - 1] = $j }
    END { while((getline line < "index_2.txt") > 0) { split(line, h); if(x[h[1]] != h[2] || y[h[1]] != h[3]) print line } }')"
done
check "all sides are bent alike" close "$(value back.json energy)" "$(value front.json energy)" 1e-6
expect 19 deform sheet.off --handles index_2.txt
check "the vertex off the plane is named" grep -q 'of vertex number [0-9]* differs by' err.txt
expect 0 deform bar.mesh --handles index_3.txt --soft-weight 100 -o soft.mesh --json soft.json
check "soft handles give way" less "$(value soft.json energy)" "$bent"

# Files may hold vertices of no element: they are counted, they are no handles, and they stay where they are.
{
  echo OFF; echo "86 128 0"; echo 0.01 0 9; vertices_of bar.off
  awk 'NF == 4 { print 3, $2 + 1, $3 + 1, $4 + 1 }' bar.off
} > unused.off
awk '
  /Vertices/ { print; getline; print $1 + 1; print 0.02, 0, 0, 0; next }
  /Tetrahedra/ { tetrahedra = 1; print; getline; print; next }
  tetrahedra && NF == 5 { print $1 + 1, $2 + 1, $3 + 1, $4 + 1, $5; next }
  { print }' bar.mesh > unused.mesh
for dimension in 2 3; do
  if [ $dimension = 2 ]; then shape=off unused='0.01 0 9'; else shape=mesh unused='0.02 0 0'; fi
  awk '{ $1 += 1; print }' index_$dimension.txt > shifted.txt
  for handles in shifted.txt place_$dimension.txt; do
    rm -f moved.$shape
    expect 0 deform unused.$shape --handles $handles -o moved.$shape --tolerance 1e-6
    check "$shape: an unused vertex stays with $handles" test "$(vertices_of moved.$shape | head -n 1)" = "$unused"
    check "$shape: the others arrive as without it with $handles" test \
      "$(vertices_of moved.$shape | tail -n +2)" = "$(vertices_of one_bar.$shape)"
  done
  expect 17 deform unused.$shape --handles index_$dimension.txt
  check "$shape: an unused vertex is no handle" grep -q 'vertex 0 is not a vertex of any element' err.txt
done

# What is for solids is not ignored in the plane.
for option in '--soft-weight 10' '--start bar.off' '--tikhonov 1'; do
  expect 16 deform bar.off --handles index_2.txt $option
done

# What is not moved is kept.
awk '
  BEGIN { print "# flat\nmtllib puppet.mtl\no puppet"; m = 5; n = 17 }
  NF == 3 && v < m * n && $1 != m * n { ++v; print "v", $0, "0.5 0.5 0.5"; t = t "vt " $1 " " $2 "\n" }
  NF == 4 { if(!f++) printf "%susemtl skin\n", t; print "f", $2 + 1 "/" $2 + 1, $3 + 1 "/" $3 + 1, $4 + 1 "/" $4 + 1 }' bar.off > bar.obj
expect 0 deform bar.obj --handles index_2.txt -o one_bar.obj --tolerance 1e-6
check "the places are those of the OFF" test -z \
  "$(paste -d ' ' <(awk '$1 == "v" { print $2, $3, $4 }' one_bar.obj) <(vertices_of one_bar.off) | awk '$1 != $4 || $2 != $5 || $3 != $6')"
check "everything else is kept" test "$(sed 's/^v .* .* .* \(.* .* .*\)/v \1/' one_bar.obj)" = \
  "$(sed 's/^v .* .* .* \(.* .* .*\)/v \1/' bar.obj)"

# Far from the origin single precision holds no shape: STL must be written with all digits.
{
  echo OFF; echo "85 128 0"
  vertices_of bar.off | awk '{ printf "%.17g %.17g %s\n", $1 + 1e8, $2 + 1e8, $3 }'
  awk 'NF == 4' bar.off
} > far.off
awk '{ printf "%d %.17g %.17g\n", $1, $2 + 1e8, $3 + 1e8 }' index_2.txt > far_handles.txt
expect 0 deform far.off --handles far_handles.txt -o far.stl
expect 0 parameterize far.stl --json far.json
check "all triangles of an STL" test "$(value far.json faces)" = 128

# The surface of the bent bar is given; its inside follows.
# The inner vertices at rest are those with y = z = 1/2 that are not at an end.
paste -d ' ' <(vertices_of bar.mesh) <(vertices_of one_bar.mesh) | awk '
  !($2 == 0.5 && $3 == 0.5 && $1 > 0 && $1 < last) { print NR - 1, $4, $5, $6 }' \
  last="$(vertices_of bar.mesh | awk '$1 > last { last = $1 } END { print last }')" > surface.handles
expect 0 map-volume bar.mesh surface.handles -o mapped.mesh --json mapped.json
check "map-volume: flips" test "$(value mapped.json flips)" = 0
check "map-volume: the surface arrives" arrive mapped.mesh surface.handles
check "map-volume: names the start" grep -q '"start": "uniform extension' mapped.json
check "map-volume: minimises the symmetric gradient energy" test "$(value mapped.json energy_name)" = symmetric_gradient
expect 0 map-volume bar.mesh surface.handles -o mapped.vtu --start one_bar.mesh --energy symmetric-dirichlet --json again.json
check "map-volume: VTU" grep -q '<VTKFile' mapped.vtu
check "map-volume: a given start" grep -q '"start": "given' again.json
check "map-volume: no worse than the bent bar" less "$(value again.json energy)" "$(awk -v e="$bent" 'BEGIN { printf "%.17g", e + 1e-9 }')"
{ echo OFF; echo "$(vertices_of one_bar.mesh | wc -l) 1 0"; vertices_of one_bar.mesh; echo "3 0 1 2"; } > all.off
expect 0 map-volume bar.mesh all.off --json again.json
check "map-volume: nothing to be found" close "$(value again.json iterations)" 0 1
vertices_of bar.mesh | awk '{ print NR - 1, -$1, $2, $3 }' > mirrored.handles
rm -f bad.mesh
expect 12 map-volume bar.mesh mirrored.handles -o bad.mesh --json bad.json

# The ends of the bar pulled apart, its sides in their planes: the affine map.
last="$(vertices_of bar.mesh | awk '$1 > last { last = $1 } END { print last }')"
vertices_of bar.mesh | awk -v last="$last" '$1 == 0 || $1 == last { print NR - 1, 1.5 * $1, $2, $3 }' > pulled.handles
# largest_error FILE: the largest difference of coordinates from those of the affine map.
largest_error()
{
  paste -d ' ' <(vertices_of bar.mesh) <(vertices_of "$1") |
    awk '{ n = NF / 2; for(i = 1; i <= 3; ++i) { d = $(n + i) - (i == 1 ? 1.5 : 1) * $i; if(d < 0) d = -d; if(d > e) e = d } } END { printf "%.17g", e }'
}
expect 0 morph bar.mesh --handles pulled.handles --slide --tolerance 1e-8 -o pulled.mesh --json pulled.json --report pulled.html
check "morph: sides that slide" less "$(largest_error pulled.mesh)" 1e-5
check "a report: the heading" grep -q '<h1>flip_free_maps: success</h1>' pulled.html
check "a report: the figures" grep -q '<tr><td>flips</td><td>0</td></tr>' pulled.html
check "a report: bars" test "$(grep -c '<figcaption>quality.*histogram</figcaption>' pulled.html)" = 2
check "a report: needs no other file" test "$(grep -c 'src="[^d]' pulled.html)" = 0
# One end goes sideways, too: of the other vertices on the side y = 0, those that slide stay there.
awk -v last="$last" '{ print $1, $2, $3 + ($2 > last ? 0.3 : 0), $4 }' pulled.handles > pushed.handles
off_side()
{
  paste -d ' ' <(vertices_of bar.mesh) <(vertices_of "$1") |
    awk -v last="$last" '$2 == 0 && $1 > 0 && $1 < last && ($5 > 1e-12 || $5 < -1e-12) { ++n } END { print n + 0 }'
}
expect 0 morph bar.mesh --handles pushed.handles --slide -o pushed.mesh
check "morph: a side that slides" test "$(off_side pushed.mesh)" = 0
expect 0 morph bar.mesh --handles pushed.handles -o free.mesh
check "morph: a side that is free" less 5 "$(off_side free.mesh)"
expect 2 morph bar.mesh --handles pulled.handles --slide --no-polish -o bad.mesh
expect 2 morph bar.mesh --handles pulled.handles -o pulled.mesh --report pulled.mesh

# A second body that nobody moves.
awk '
  function copy(count, shift, move,    i, j, f) {
    for(i = 0; i < count; ++i) {
      $0 = line[i]
      if(move) { $2 += 5 } else for(j = 1; j < NF; ++j) $j += shift
      print
    }
  }
  $1 == "Vertices" || $1 == "Tetrahedra" {
    moves = $1 == "Vertices"
    print; getline; count = $1; if(moves) n = count
    print 2 * count
    for(i = 0; i < count; ++i) { getline; line[i] = $0; print }
    copy(count, n, moves)
    next
  }
  { print }' bar.mesh > two_bodies.mesh
expect 0 morph two_bodies.mesh --handles pulled.handles -o two_bodies_out.mesh
n="$(vertices_of bar.mesh | wc -l)"
check "morph: a body at rest" test "$(paste -d ' ' <(vertices_of two_bodies.mesh) <(vertices_of two_bodies_out.mesh) |
  awk -v n="$n" 'NR > n { for(i = 1; i <= 3; ++i) { d = $i - $(i + 3); if(d > 1e-12 || d < -1e-12) ++moved } } END { print moved + 0 }')" = 0
check "morph: a body that is moved" close "$(vertices_of two_bodies_out.mesh | head -n "$n" | awk '$1 > l { l = $1 } END { print l }')" \
  "$(awk -v l="$last" 'BEGIN { print 1.5 * l }')" 1e-9

# Four tetrahedra around an edge, one of which is to be flat: there is no map, unless the edge is split.
printf '%s\n' 'MeshVersionFormatted 2' 'Dimension 3' Vertices 6 '0 -1 0 0' '0 1 0 0' '1 0 0 0' '0 0 1 0' '-1 0 0 0' '0 0 -1 0' \
  Tetrahedra 4 '2 1 3 4 7' '2 1 4 5 8' '2 1 5 6 9' '2 1 6 3 10' End > fan.mesh
printf '%s\n' '0 0 -1 0' '1 0 1 0' '2 1 0 0' '3 -1 0 0' '4 -0.5 0 -0.9' '5 0.5 0 -0.9' > flat.handles
expect 12 morph fan.mesh --handles flat.handles -o bad.mesh
expect 0 morph fan.mesh --handles flat.handles --refine -o split.mesh --json split.json
check "--refine: flips" test "$(value split.json flips)" = 0
check "--refine: the new vertex is told" grep -q 'the new vertex has the number 6' split.json
check "--refine: others arrive" arrive split.mesh flat.handles
check "--refine: parts have the region of the whole" test \
  "$(awk '$1 == "Tetrahedra" { getline count; for(i = 0; i < count; ++i) { getline; print $5 } }' split.mesh | sort -n | tr '\n' ' ')" = "7 7 8 8 9 9 10 10 "
expect 12 map-volume fan.mesh flat.handles -o bad.mesh
expect 0 map-volume fan.mesh flat.handles --refine -o split.mesh
check "--refine: map-volume" arrive split.mesh flat.handles

# The boundary of the bent bar in all ways in which it can be given: they are the same.
expect 0 morph bar.mesh --handles surface.handles -o morphed.mesh --json morphed.json
check "morph: flips" test "$(value morphed.json flips)" = 0
check "morph: the surface arrives" arrive morphed.mesh surface.handles
check "morph: the shapes before" less 0.1 "$(tr -d '\n' < morphed.json | sed 's/.*"quality_before": *{[^}]*"min_scaled_jacobian": *\([^,}]*\).*/\1/')"
expect 0 morph bar.mesh --to one_bar.mesh -o morphed_2.mesh
check "morph: the boundary of a solid" cmp -s morphed.mesh morphed_2.mesh
vertices_of bar.mesh | tac > rest.txt
vertices_of one_bar.mesh | tac > moved.txt
for name in rest moved; do
  # Without the inner vertices, from the last to the first.
  { echo OFF; echo "$(awk '{ print $2 }' surface.handles | wc -l) 1 0"
    paste -d ' ' rest.txt "$name.txt" | awk '!($2 == 0.5 && $3 == 0.5 && $1 > 0 && $1 < last) { print $(NF - 2), $(NF - 1), $NF }' \
      last="$(vertices_of bar.mesh | awk '$1 > last { last = $1 } END { print last }')"
    echo "3 0 1 2"; } > "surface_$name.off"
done
expect 0 morph bar.mesh --from surface_rest.off --to surface_moved.off -o morphed_3.mesh
check "morph: a surface elsewhere in order" cmp -s morphed.mesh morphed_3.mesh
expect 17 morph bar.mesh --from surface_rest.off --to bar.off -o bad.mesh
expect 16 morph bar.mesh --from surface_moved.off --to surface_moved.off -o bad.mesh
for arguments in '' '--from surface_rest.off' '--to one_bar.mesh --handles surface.handles' '--displacement d --to one_bar.mesh'; do
  expect 2 morph bar.mesh $arguments -o bad.mesh
done
check "morph: nothing was written" test ! -e bad.mesh
expect 17 map-volume bar.mesh no_such_file.obj -o bad.mesh
expect 17 map-volume broken.mesh surface.handles -o bad.mesh
check "errors give no solid" test ! -e bad.mesh

# Formats of solids: the bent bar in each of them is the minimum, and what is not written is refused before anything is computed.
for extension in mesh meshb vtu vtk msh inp node; do
  expect 0 deform bar.mesh --handles index_3.txt -o again.$extension --tolerance 1e-6
  expect 0 deform bar.mesh --handles index_3.txt --start again.$extension --tolerance 1e-5 --json again.json
  check "$extension: the bent bar comes back" test "$(value again.json iterations)" -le 1
done
for arguments in "-o bad.stl" "-o bad.mesh --encoding binary" "-o bad.msh --encoding compressed" "--encoding ascii"; do
  expect 17 deform bar.mesh --handles index_3.txt $arguments
done
expect 0 deform bar.mesh --handles index_3.txt -o again.vtu --encoding compressed
check "compressed VTU" grep -q 'compressor="vtkZLib' again.vtu
expect 0 deform again.vtu --handles index_3.txt -o again.vtu
check "the encoding is kept" grep -q 'compressor="vtkZLib' again.vtu
check "the regions are kept" test "$(grep -c 'Name="region"' again.vtu)" = 1
check "fields are replaced, not added" test "$(grep -c 'Name="displacement"' again.vtu)" = 1
# Of an affine map all values are known.
vertices_of bar.mesh | awk '{ print NR - 1, 2 * $1 + 3, $2, $3 }' > affine.handles
expect 0 map-volume bar.mesh affine.handles -o affine.vtk --encoding ascii
# Displaced by the same once more: the boundary, and hence the inside.
expect 0 morph affine.vtk --displacement displacement -o twice.mesh --energy symmetric-dirichlet --no-polish
check "morph: displacements" awk '
  NR == FNR { x[FNR] = $1; y[FNR] = $2; z[FNR] = $3; next }
  { a = 3 * x[FNR] + 6 - $1; b = y[FNR] - $2; c = z[FNR] - $3; if(a * a + b * b + c * c > 1e-14) failed = 1 }
  END { exit failed || FNR == 0 }' <(vertices_of bar.mesh) <(vertices_of twice.mesh)
expect 17 morph affine.vtk --displacement nothing -o bad.mesh
check "morph: names of arrays" grep -q "it has .*'displacement'" err.txt
check "values of an affine map" awk '
  function wrong(value, right) { if(value - right > 1e-7 || right - value > 1e-7) { print name ": " value; failed = 1 } }
  /^POINTS/ { n = $2; name = "points"; next }
  /^CELLS/ { name = ""; next }
  $1 ~ /^(displacement|handle|boundary|volume_ratio|singular_values|symmetric_dirichlet_energy|region)$/ { name = $1; seen[name] = 1; k = 0; next }
  name == "points" && k < n { x[k++] = $1 }
  name == "displacement" { wrong($1, (x[k++] - 3) / 2 + 3); wrong($2, 0); wrong($3, 0) }
  name == "handle" { wrong($1, 1) }
  name == "volume_ratio" { wrong($1, 2) }
  name == "singular_values" { wrong($1, 2); wrong($2, 1); wrong($3, 1) }
  /^POINT_DATA|^CELL_DATA/ { name = "" }
  END { for(s in seen) ++number; exit failed || number != 7 }' affine.vtk
# Tetrahedra of ten nodes by their corners.
{
  printf '# vtk DataFile Version 3.0\nten nodes\nASCII\nDATASET UNSTRUCTURED_GRID\n'
  awk '
    BEGIN { split("1 2 2 3 3 1 1 4 2 4 3 4", ends) }
    $1 == "Vertices" { getline; n = $1; for(v = 1; v <= n; ++v) { getline; for(c = 1; c <= 3; ++c) x[v, c] = $c } }
    $1 == "Tetrahedra" {
      getline; cells = $1
      for(i = 1; i <= cells; ++i) {
        getline
        line = "10 " $1 - 1 " " $2 - 1 " " $3 - 1 " " $4 - 1
        for(k = 1; k <= 12; k += 2) {
          a = $(ends[k]); b = $(ends[k + 1])
          if(!((a, b) in middle)) {
            middle[a, b] = middle[b, a] = ++n
            for(c = 1; c <= 3; ++c) x[n, c] = (x[a, c] + x[b, c]) / 2
          }
          line = line " " middle[a, b] - 1
        }
        text = text line "\n"
      }
    }
    END {
      print "POINTS", n, "double"
      for(v = 1; v <= n; ++v) print x[v, 1], x[v, 2], x[v, 3]
      printf "CELLS %d %d\n%sCELL_TYPES %d\n", cells, 11 * cells, text, cells
      for(i = 0; i < cells; ++i) print 24
    }' bar.mesh
} > ten.vtk
expect 17 deform ten.vtk --handles index_3.txt -o bad.vtk
check "tetrahedra of second order are named" grep -q '144 tetrahedra of second order.*--second-order' err.txt
expect 17 deform ten.vtk --second-order --handles index_3.txt -o bad.mesh
expect 0 deform ten.vtk --second-order --handles index_3.txt -o ten_out.vtk --tolerance 1e-6
check "nodes of second order are in the middles" awk '
  BEGIN { split("1 2 2 3 3 1 1 4 2 4 3 4", ends) }
  $1 == "POINTS" { n = $2; for(v = 0; v < n; ++v) { getline; for(c = 1; c <= 3; ++c) x[v, c] = $c } }
  $1 == "CELLS" { cells = $2; for(i = 0; i < cells; ++i) { getline; for(k = 0; k < 6; ++k) for(c = 1; c <= 3; ++c) {
    d = x[$(6 + k), c] - (x[$(1 + ends[2 * k + 1]), c] + x[$(1 + ends[2 * k + 2]), c]) / 2
    if(d > 1e-12 || d < -1e-12) wrong = 1
    ++seen } } }
  END { exit wrong || seen != 18 * cells || cells == 0 }' ten_out.vtk

rm -f bad.off
expect 19 deform sheet.off --handles index_2.txt -o bad.off --json bad.json
check "the status of a sheet that is not planar" test "$(value bad.json status)" = not_planar
expect 11 deform clockwise.off --handles index_2.txt -o bad.off
expect 12 deform triangle.off --handles turned_over.txt -o bad.off --json bad.json
check "the status of handles out of reach" test "$(value bad.json status)" = unreachable_constraints
expect 6 deform components.off --handles index_2.txt -o bad.off
expect 4 deform quads.off --handles index_2.txt --strict -o bad.off
expect 17 deform broken.mesh --handles index_3.txt -o bad.off
check "errors give no shape" test ! -e bad.off

# ---------------------------------------------------------------------------------------------------------------------
# Bad files: code, status and the file

printf 'OFF\n3 1 0\n0 0 0\ninf 0 0\n0 1 0\n3 0 1 2\n' > inf.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n' > negative.off
printf 'OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 2 1 3\n' > count.off
printf 'OFF\n3 1 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n' > collinear.off
printf 'OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3\n3 1 4 2\n' > mixed.off
printf 'OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 2 1 3\n3 0 1 2\n' > repeated.off
while read -r code status file; do
  rm -f bad.json bad.obj
  expect "$code" parameterize "$file" --strict -o bad.obj --json bad.json
  check "$file has the status $status" test "$(value bad.json status)" = "$status"
  check "$file has a message" grep -q '"message": "..........' bad.json
  check "$file gives no map" test ! -e bad.obj
done << 'END'
3 empty_mesh no_vertices.off
3 empty_mesh no_faces.off
4 not_triangular quads.off
5 no_border closed.off
6 several_components components.off
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
17 file_error elephant.ply
17 file_error no_such_file.off
17 file_error inf.off
17 file_error negative.off
17 file_error count.off
9 degenerate_rest_element collinear.off
4 not_triangular mixed.off
8 non_manifold repeated.off
6 several_components unwelded.off
END

# Unusual files that are none the less good.
awk 'NF == 3 && NR > 2 { printf "%.17g %.17g %.17g\n", $1 + 1e6, $2 - 1e6, $3 + 1e6; next } { print }' sheet.off > remote.off
awk 'NF == 3 && NR > 2 { print $1 * 1e150, $2 * 1e150, $3 * 1e150; next } { print }' sheet.off > huge.off
awk 'NF == 3 && NR > 2 { print $1 * 1e-150, $2 * 1e-150, $3 * 1e-150; next } { print }' sheet.off > minute.off
awk 'NR == 2 { print $1 + 1, $2, $3; next } NR == 3 { print; print "5 5 5"; next } $1 == 3 && NF == 4 { for(k = 2; k <= 4; ++k) if($k > 0) ++$k } { print }' \
  sheet.off > isolated.off
printf 'OFF\n5 4 0\n0 0 0\n1 1e-14 0\n2 0 0\n1 1 0\n1 -1 0\n3 0 1 3\n3 1 2 3\n3 0 2 1\n3 0 4 2\n' > thin.off
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 3\n3 0 1 2\n3 2 1 3\n' > two.off
for file in remote huge minute isolated thin two one; do
  expect 0 parameterize $file.off -o good.obj
  expect 0 measure good.obj
done
expect 0 parameterize frame.off -o frame.obj --json frame.json
expect 0 measure frame.obj
expect 0 parameterize frame.off --bijective --json frame.json
check "a map that was asked not to overlap itself" grep -q '"bijective": true' frame.json
expect 9 parameterize zero_area.off --strict
check "the face is named by its number in the file" grep -q 'face number 1' err.txt
# Polygons, faces without area, and triangles that have no points in common.
printf '0 5 5\n' > moved_corner.txt
for file in quads zero_area unwelded; do
  expect 0 parameterize $file.off -o dirty.obj --json dirty.json
  expect 0 measure dirty.obj
  check "$file: an isometry" close "$(value dirty.json energy)" 1 1e-5
  expect 0 deform $file.off --handles moved_corner.txt -o dirty.off --json deformed.json
  check "$file: the handle arrives" arrive dirty.off moved_corner.txt
  if [ $file = zero_area ]; then flat=1; else flat=0; fi
  check "$file: faces without area are counted" test "$(value dirty.json faces_without_area)" = $flat
  check "$file: those of a shape as well" test "$(value deformed.json faces_without_area)" = $flat
done

# A long thin tube may be beyond every start; if not, its map is as good as any.
rm -f tube.obj
"$program" parameterize tube.off -o tube.obj --json tube.json --max-iterations 10 > out.txt 2> err.txt
case $? in
  0) expect 0 measure tube.obj ;;
  11) check "a tube without a start gives no map" test ! -e tube.obj
      check "starts that were tried" grep -q 'uniform.*mean_value.*cotangent' tube.json ;;
  *) fail "the tube ends with $(value tube.json status)" ;;
esac

# What is scaled into the unit square is certified there: a tiny triangle far from another vertex becomes a point.
# All vertices are on the border and stay in their places.
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n3 0 1 2\n3 0 2 3\n' > tiny.off
{
  printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nvt 2 1\nvt 2.0000000000000018 1\nvt 2 1.0000000000000018\nvt -1000 1\n'
  printf 'f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n'
} > tiny_start.obj
expect 0 parameterize tiny.off --start tiny_start.obj --fix-border -o tiny.obj
expect 0 measure tiny.obj
rm -f tiny.obj
expect 15 parameterize tiny.off --start tiny_start.obj --fix-border --unit-square -o tiny.obj
check "a map that flips in the unit square is not written" test ! -e tiny.obj

# Names of files that are not UTF-8 are quoted in messages.
latin=$(printf 'Fl\344che.off')
expect 17 parameterize "$latin" --json latin.json
check "a report with the name of a file that is not UTF-8" test "$(value latin.json status)" = file_error
expect 17 unwrap "$latin" --json latin.json

# Files that cannot be written.
expect 17 parameterize sheet.off -o missing/sheet.obj --json bad.json
check "the report says so" test "$(value bad.json status)" = file_error
expect 17 parameterize sheet.off --json missing/sheet.json
expect 17 parameterize sheet.off --svg missing/sheet.svg
expect 17 parameterize sheet.off --trace missing/trace.csv
expect 17 measure off.obj --json missing/measured.json
if [ -c /dev/full ]; then
  ln -s /dev/full full.obj
  expect 17 parameterize sheet.off -o full.obj
  expect 17 parameterize sheet.off --json /dev/full
  expect 17 parameterize sheet.off --trace /dev/full
fi

# ---------------------------------------------------------------------------------------------------------------------
# Ends

# Limits of time: what is valid is written, and the exit code says that the limit ended it.
expect 1 parameterize sheet.off --time-limit 0.000001 -o limited.obj --json limited.json
check "a limit is told" test "$(value limited.json status)" = time_limit
expect 0 measure limited.obj
expect 1 deform bar.off --handles index_2.txt --time-limit 0.000001 -o limited.off --json limited.json
check "handles on their way are told" grep -q 'before the fixed vertices reached' limited.json
check "the shape on the way is written" test -s limited.off

# Ctrl-C and SIGTERM: likewise, within a second or so. A run that would take long by its tolerance.
grid off 120 120 > long.off
for signal in INT TERM; do
  if [ $signal = INT ] && trap -p INT | grep -q "''"; then
    echo "skipped: SIGINT is ignored here"
    continue
  fi
  rm -f stopped.obj stopped.json
  code=130
  [ $signal = INT ] || code=143
  # timeout sends the signal twice, which counts once.
  timeout --preserve-status --signal=$signal --kill-after=20 3 "$program" parameterize long.off --method aqp --tolerance 0 \
    --max-iterations 100000000 -o stopped.obj --json stopped.json > out.txt 2> err.txt
  check "SIG$signal has an exit code of its own" test $? -eq $code
  check "SIG$signal: status" test "$(value stopped.json status)" = stopped_by_observer
  expect 0 measure stopped.obj
done
check "no temporary files" test -z "$(find . -name '*.tmp')"

finish
