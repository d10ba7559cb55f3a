// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_TETGEN_DOMAIN_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_TETGEN_DOMAIN_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_TETGEN

#include <CGAL/Flip_free_maps/domains/Volume_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/tetgen.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsDomains
/// The tetrahedra of TetGen's `tetgenio`. A vertex is named by its place in `pointlist`, counted from 0 whatever `firstnumber`
/// is. Needs the macro `CGAL_FLIP_FREE_MAPS_USE_TETGEN` and TetGen 1.5.
class Tetgen_domain : public Volume_domain<std::size_t>
{
public:
  /// Reads the points and the tetrahedra. Of tetrahedra with ten nodes only the corners are used.
  ///
  /// \returns `success`, `empty_mesh`, `invalid_option` for an index out of range, `non_finite_input`, `degenerate_rest_element`
  ///   (zero volume, or inverted with respect to others) or `several_components`. With `several_components` the domain is
  ///   complete nevertheless, for uses that hold every component.
  ///
  /// Complexity: linear, on average.
  Status load(const tetgenio& mesh, std::string& message)
  {
    clear();
    const bool has_arrays = mesh.pointlist != nullptr && mesh.tetrahedronlist != nullptr && mesh.numberofcorners >= 4;
    const std::size_t n = has_arrays ? mesh.numberoftetrahedra : 0;
    for(std::size_t e = 0; e < n; ++e) {
      const int* corners = mesh.tetrahedronlist + e * mesh.numberofcorners;
      std::array<std::size_t, 4> vertices;
      for(int k = 0; k < 4; ++k) {
        if(corners[k] < mesh.firstnumber || corners[k] - mesh.firstnumber >= mesh.numberofpoints) {
          message = "tetrahedron number " + std::to_string(e) + " has the vertex " + std::to_string(corners[k]) + ", but there are " +
                    std::to_string(mesh.numberofpoints) + " points, counted from " + std::to_string(mesh.firstnumber);
          return Status::invalid_option;
        }
        vertices[k] = corners[k] - mesh.firstnumber;
      }
      add(vertices);
    }
    return finish([&mesh](std::size_t v) { return Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(mesh.pointlist + 3 * v)); }, message);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_TETGEN

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_TETGEN_DOMAIN_H
