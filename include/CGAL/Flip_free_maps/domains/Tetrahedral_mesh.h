// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_TETRAHEDRAL_MESH_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_TETRAHEDRAL_MESH_H

#include <array>
#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Flip_free_maps {

/*!
  \ingroup PkgFlipFreeMapsIO

  Tetrahedral mesh in flat arrays, as files hold it. Nothing is promised about the orientation; `Tetrahedral_domain` checks it.
*/
struct Tetrahedral_mesh
{
  /// Positions in space.
  std::vector<std::array<double, 3>> points;

  /// Corners of the tetrahedra, as indices into `points`.
  std::vector<std::array<int, 4>> tetrahedra;

  /// Triangles that the file or the generator names, in general the boundary; may be empty.
  std::vector<std::array<int, 3>> triangles;
};

/*!
  \ingroup PkgFlipFreeMapsIO

  returns the facets that belong to exactly one tetrahedron, in the order of the tetrahedra. For positively oriented
  tetrahedra they are counterclockwise seen from outside. The cost is \f$ O(n \log n) \f$ for \f$ n \f$ tetrahedra.

  \param mesh a tetrahedral mesh with valid indices
  \param owners if not null, receives for each triangle the index of its tetrahedron
*/
std::vector<std::array<int, 3>> boundary_triangles(const Tetrahedral_mesh& mesh, std::vector<std::size_t>* owners = nullptr);

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_TETRAHEDRAL_MESH_H
