// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_TETRAHEDRAL_DOMAIN_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_TETRAHEDRAL_DOMAIN_H

#include <CGAL/Flip_free_maps/domains/Volume_domain.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsDomains
/// A tetrahedral mesh given by an array of points and an array of tetrahedra. A vertex is named by its index in the array of
/// points; when every point belongs to a tetrahedron, its number in the flat arrays is the same.
class Tetrahedral_domain : public Volume_domain<std::size_t>
{
public:
  /// Reads the arrays.
  ///
  /// \tparam PointRange a random access container of points, whose `[0]`, `[1]`, `[2]` are numbers
  /// \tparam TetrahedronRange a range of tetrahedra, whose `[0]` to `[3]` are integers, indices into `points`
  /// \param points rest positions; those that no tetrahedron uses may have any value
  /// \param tetrahedra the tetrahedra, all of the same orientation
  /// \param message receives a sentence on failure
  /// \returns `success`, `empty_mesh`, `invalid_option` for an index out of range, or one of `non_finite_input`,
  ///   `degenerate_rest_element` (zero volume, or inverted with respect to others) and `several_components`. With
  ///   `several_components` the domain is complete nevertheless, for uses that hold every component.
  ///
  /// Complexity: linear, on average.
  template <typename PointRange, typename TetrahedronRange>
  Status load(const PointRange& points, const TetrahedronRange& tetrahedra, std::string& message)
  {
    clear();
    const std::size_t size = points.size();
    std::vector<char> is_used(size, 0);
    std::size_t e = 0;
    for(const auto& tetrahedron : tetrahedra) {
      for(int k = 0; k < 4; ++k) {
        // A negative number becomes a very large one.
        const std::size_t v = static_cast<std::size_t>(tetrahedron[k]);
        if(v >= size) {
          message = "tetrahedron number " + std::to_string(e) + " has the vertex " + std::to_string(tetrahedron[k]) + ", but there are " +
                    std::to_string(size) + " points";
          return Status::invalid_option;
        }
        is_used[v] = 1;
      }
      ++e;
    }
    for(std::size_t v = 0; v < size; ++v)
      if(is_used[v])
        add_vertex(v);
    for(const auto& t : tetrahedra)
      add({static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2]), static_cast<std::size_t>(t[3])});
    return finish(
      [&points](std::size_t v) {
        const auto& p = points[v];
        return Eigen::Vector3d(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
      },
      message);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_TETRAHEDRAL_DOMAIN_H
