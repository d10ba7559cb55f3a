// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CONTACTS_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CONTACTS_H

#include <CGAL/Flip_free_maps/domains/internal/Linked_triangles.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A seam between a chart and another one: halfedges of the first that are connected, so that the charts are a disk if each is one and
// the seam is closed.
struct Chart_contact
{
  std::int32_t neighbor;
  std::vector<std::int32_t> halfedges;
  double length = 0;
};

// The contacts of some faces that are a chart, the longest first, along sides that may be closed; `perimeter` receives the length of
// all its sides. `chart_of` tells the charts of all faces.
std::vector<Chart_contact> chart_contacts(const Linked_triangles& surface, const std::vector<std::int32_t>& faces,
                                          const std::vector<std::int32_t>& chart_of, const std::function<bool(std::int32_t)>& may_close,
                                          double& perimeter);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/chart_contacts_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CONTACTS_H
