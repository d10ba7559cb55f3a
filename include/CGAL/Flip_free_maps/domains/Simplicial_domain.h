// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_SIMPLICIAL_DOMAIN_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_SIMPLICIAL_DOMAIN_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

// Fast arithmetic knows neither NaN nor infinity, which tests for bad input and line searches look for, nor the rounding that exact
// predicates rely on.
#if defined(__FAST_MATH__) && !defined(CGAL_FLIP_FREE_MAPS_ALLOW_FAST_MATH)
#error "Flip_free_maps: no guarantee holds with -ffast-math; CGAL_FLIP_FREE_MAPS_ALLOW_FAST_MATH permits it all the same"
#endif

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Positions of the vertices of a map: column v holds the D coordinates of vertex v.
template <int D>
using Positions = Eigen::Matrix<double, D, Eigen::Dynamic>;

/// \ingroup PkgFlipFreeMapsRef
/// The flat arrays between the user's mesh and the solvers: simplices with their rest shapes. Meshes are converted to it by the
/// classes of the folder `domains/`; a user may also fill it by hand.
///
/// \tparam D dimension of the map: 2 for triangles, 3 for tetrahedra
///
/// The rest shape is scaled to total measure (area, volume) 1; `scale` is the factor back to the user's units of length.
template <int D>
struct Simplicial_domain
{
  static_assert(D == 2 || D == 3, "maps of triangles (D = 2) and tetrahedra (D = 3)");

  /// Dimension of the map.
  static constexpr int dimension = D;
  /// Vertices of one element, positively oriented.
  using Element = std::array<std::int32_t, D + 1>;

  /// Vertices of all elements, numbers 0 to `number_of_vertices` - 1.
  std::vector<Element> elements;
  /// Inverses of the D x D rest edge matrices:
  /// column k of an edge matrix is the rest position of vertex k+1 minus that of vertex 0.
  std::vector<internal::Matrix<D>> rest_inverses;
  /// Rest measures (areas, volumes), with sum 1.
  std::vector<double> measures;
  /// Number of vertices.
  std::int32_t number_of_vertices = 0;
  /// For a surface in space: the rest positions of its vertices, in this domain's units. Needed by starts that simplify the
  /// surface; may be empty.
  Positions<3> rest_points;
  /// User's unit of length over this domain's unit of length.
  double scale = 1;
  /// For shapes that lie where their maps do: the user's coordinates of this domain's origin. User's coordinates are `origin`
  /// plus `scale` times this domain's.
  internal::Vector<D> origin = internal::Vector<D>::Zero();
  /// For a disk, with holes or without: its border vertices, counterclockwise as seen from the elements. Otherwise empty.
  std::vector<std::int32_t> border;
  /// Rest lengths of the border edges; edge i goes from `border[i]` to the next.
  std::vector<double> border_lengths;
  /// For a disk with holes: the vertices around each, in the order of the elements' edges there, that is, clockwise around the
  /// hole in a map. `border` is the outer one then.
  std::vector<std::vector<std::int32_t>> holes;

  /// Number of elements.
  std::int64_t number_of_elements() const { return static_cast<std::int64_t>(elements.size()); }

  /// The edge matrix of the image of element `e`: column k is the position of vertex k+1 minus that of vertex 0.
  internal::Matrix<D> image_edges(std::int64_t e, const Positions<D>& x) const
  {
    const Element& v = elements[e];
    internal::Matrix<D> edges;
    for(int k = 0; k < D; ++k)
      edges.col(k) = x.col(v[k + 1]) - x.col(v[0]);
    return edges;
  }

  /// The Jacobian of the map on element `e`: rest shape to image.
  internal::Matrix<D> jacobian(std::int64_t e, const Positions<D>& x) const { return image_edges(e, x) * rest_inverses[e]; }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_SIMPLICIAL_DOMAIN_H
