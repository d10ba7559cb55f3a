// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_TEXTURED_MESH_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_TEXTURED_MESH_H

#include <array>
#include <vector>

/// \file

namespace CGAL {
namespace Flip_free_maps {

/*!
  \ingroup PkgFlipFreeMapsIO

  Triangle mesh in space with texture coordinates per corner, in flat arrays.

  Points and texture coordinates are numbered independently, so that a point on a seam has one entry in `points` and
  one entry in `texture` for each side of the seam.
*/
struct Textured_mesh
{
  /// Positions in space, in the units of the surface.
  std::vector<std::array<double, 3>> points;

  /// Texture coordinates `(u, v)`, in the units of the surface when they come from a map of this package.
  std::vector<std::array<double, 2>> texture;

  /// Corners of the triangles, as indices into `points`, counterclockwise seen from outside.
  std::vector<std::array<int, 3>> triangles;

  /// `texture_triangles[i][k]` is the index into `texture` of corner `k` of triangle `i`; as many entries as `triangles`.
  std::vector<std::array<int, 3>> texture_triangles;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_TEXTURED_MESH_H
