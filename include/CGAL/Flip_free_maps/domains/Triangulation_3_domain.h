// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_TRIANGULATION_3_DOMAIN_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_TRIANGULATION_3_DOMAIN_H

#include <CGAL/Flip_free_maps/domains/Volume_domain.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsDomains
/// The finite cells of a 3D triangulation, or some of them. A vertex is named by its handle. The triangulation is only read:
/// results go to a property map keyed by the vertex handles,
/// since moving the points themselves would make the triangulation invalid.
///
/// \tparam Triangulation_ an instance of `CGAL::Triangulation_3`, `CGAL::Delaunay_triangulation_3` or
///   `CGAL::Regular_triangulation_3`, or a class derived from one; of weighted points the weights are ignored
template <typename Triangulation_>
class Triangulation_3_domain : public Volume_domain<typename Triangulation_::Vertex_handle>
{
  using Base = Volume_domain<typename Triangulation_::Vertex_handle>;

public:
  /// The triangulation.
  using Triangulation = Triangulation_;
  /// Its vertices.
  using Vertex_handle = typename Triangulation::Vertex_handle;
  /// Its cells.
  using Cell_handle = typename Triangulation::Cell_handle;

  /// Reads all finite cells.
  /// \returns as the other overload
  Status load(const Triangulation& triangulation, std::string& message)
  {
    return load(
      triangulation, [](Cell_handle) { return true; }, message);
  }

  /// Reads the finite cells that `is_selected` is `true` for.
  ///
  /// \tparam CellPredicate a function from `Cell_handle` to `bool`
  /// \param triangulation the triangulation
  /// \param is_selected chooses the cells
  /// \param message receives a sentence on failure
  /// \returns `success`, `empty_mesh`, `non_finite_input`, `degenerate_rest_element` (a cell of zero volume; the message counts
  ///   the selected cells from 0 in the order of the triangulation) or `several_components`. With `several_components` the domain
  ///   is complete nevertheless, for uses that hold every component.
  ///
  /// Complexity: linear, on average.
  template <typename CellPredicate>
  Status load(const Triangulation& triangulation, const CellPredicate& is_selected, std::string& message)
  {
    this->clear();
    for(auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c) {
      const Cell_handle cell = c;
      if(is_selected(cell))
        this->add({cell->vertex(0), cell->vertex(1), cell->vertex(2), cell->vertex(3)});
    }
    return this->finish(point_of(triangulation), message);
  }

protected:
  /// The function from the vertices of a triangulation to their positions.
  static auto point_of(const Triangulation& triangulation)
  {
    return [&triangulation](Vertex_handle v) {
      const auto p = triangulation.geom_traits().construct_point_3_object()(triangulation.point(v));
      return Eigen::Vector3d(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    };
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_TRIANGULATION_3_DOMAIN_H
