// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/tetrahedralize.h>

#include <string>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE bool Tetrahedralization_options::is_valid(std::string* message) const
{
  const auto check = [message](const char* name, double value, double low, double high) {
    return (value >= low && value <= high) ||
           internal::fail(message, std::string(name) + " is not from " + std::to_string(low) + " to " + std::to_string(high));
  };
  return check("cell_size", cell_size, 0.001, 1) && check("facet_distance", facet_distance, 1e-5, 1) &&
         check("facet_angle", facet_angle, 0, 30) && check("cell_radius_edge_ratio", cell_radius_edge_ratio, 2, 1e6) &&
         check("feature_angle", feature_angle, 0, 180);
}

} // namespace Flip_free_maps
} // namespace CGAL

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void mesh_closed_surface(const Closed_surface& surface, const Tetrahedralization_options& options,
                                                    Tetrahedral_mesh& mesh)
{
  using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Closed_surface::Kernel, Closed_surface::Mesh>;
  using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
  using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;
  using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

  Domain domain(surface.mesh());
  if(options.feature_angle < 180)
    domain.detect_features(options.feature_angle);
  const double size = options.cell_size * surface.diagonal(), distance = options.facet_distance * surface.diagonal();
  const Criteria criteria(CGAL::parameters::edge_size = size, CGAL::parameters::facet_angle = options.facet_angle,
                          CGAL::parameters::facet_size = size, CGAL::parameters::facet_distance = distance,
                          CGAL::parameters::cell_radius_edge_ratio = options.cell_radius_edge_ratio, CGAL::parameters::cell_size = size);
  copy_complex(CGAL::make_mesh_3<Complex>(domain, criteria), mesh);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_IMPL_H
