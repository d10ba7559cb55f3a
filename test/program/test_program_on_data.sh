#!/usr/bin/env bash
# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

# The program on a collection of scanned, faulty and borderline meshes. Without it: exit code 77, skipped.
# Usage: test_program_on_data.sh PROGRAM DATA_DIRECTORY

data=${2:-}
if [ ! -e "$data/bad_annulus.off" ]; then
  echo "Skipped: there are no meshes in '$data'."
  exit 77
fi
. "$(dirname -- "$0")/checks.sh"

for file in closed_g0_spot_low closed_g12_boot10k holes_spot3 holes_g1_torus2; do
  atlas "$data/$file.off"
done

while read -r code file; do
  rm -f bad.obj
  expect "$code" parameterize "$data/$file" -o bad.obj
  if [ "$code" = 0 ]; then
    expect 0 measure bad.obj
  else
    check "$file gives no map" test ! -e bad.obj
  fi
done << 'END'
0 bad_annulus.off
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

finish
