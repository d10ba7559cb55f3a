// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_VOLUME_DOMAIN_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_VOLUME_DOMAIN_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Distributed_volume_domain.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE Status Distributed_volume_domain::load(const Positions<3>& points, const std::vector<Tetrahedron>& tetrahedra,
                                                                  const std::vector<std::int64_t>& handles, std::string& message)
{
  clear();
  m_division = internal::Mesh_division<4>(world());
  const auto find_known = [&](const auto&, std::vector<std::int64_t>& known, std::string&) {
    known = handles;
    return Status::success;
  };
  const Status status = m_division.divide(static_cast<std::size_t>(points.cols()), tetrahedra, find_known, message);
  if(status != Status::success)
    return status;
  for(std::int64_t v : m_division.vertices())
    add_vertex(v);
  for(const auto& tetrahedron : m_division.simplices())
    add(tetrahedron.vertices);
  m_division.forget_simplices();
  const Positions<3> part = to_parts(points);
  return finish([&](std::int64_t v) { return Eigen::Vector3d(part.col(number(v))); }, message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_DISTRIBUTED_VOLUME_DOMAIN_IMPL_H
