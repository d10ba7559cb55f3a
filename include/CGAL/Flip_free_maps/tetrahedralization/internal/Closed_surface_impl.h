// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZATION_INTERNAL_CLOSED_SURFACE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZATION_INTERNAL_CLOSED_SURFACE_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/tetrahedralization/internal/Closed_surface.h>

#include <CGAL/Bbox_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Status Closed_surface::check(std::string& message)
{
  const auto point = [this](std::int32_t v) -> const Kernel::Point_3& { return m_mesh.point(Mesh::Vertex_index(v)); };
  CGAL::Bbox_3 box;
  for(std::size_t i = 0; i < m_triangles.size(); ++i) {
    const std::array<std::int32_t, 3>& t = m_triangles[i];
    if(Kernel().collinear_3_object()(point(t[0]), point(t[1]), point(t[2]))) {
      message = "zero area has " + numbered(i);
      return Status::degenerate_rest_element;
    }
    for(const std::int32_t v : t)
      box += point(v).bbox();
  }
  m_low = Kernel::Point_3(box.xmin(), box.ymin(), box.zmin());
  m_high = Kernel::Point_3(box.xmax(), box.ymax(), box.zmax());
  if(!std::isfinite(diagonal()) || !(diagonal() > 0)) {
    message = "the extent of the surface is not in the range of double precision";
    return Status::non_finite_input;
  }
  if(CGAL::Polygon_mesh_processing::does_self_intersect(m_mesh)) {
    message = "the surface intersects itself";
    return Status::non_manifold;
  }
  return Status::success;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZATION_INTERNAL_CLOSED_SURFACE_IMPL_H
