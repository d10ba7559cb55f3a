// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CONTACTS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CONTACTS_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/chart_contacts.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Chart_contact> chart_contacts(const Linked_triangles& surface,
                                                                     const std::vector<std::int32_t>& faces,
                                                                     const std::vector<std::int32_t>& chart_of,
                                                                     const std::function<bool(std::int32_t)>& may_close, double& perimeter)
{
  const auto source = [&surface](std::int32_t h) { return surface.triangles[h / 3][h % 3]; };
  const auto length = [&](std::int32_t h) {
    return (surface.points.col(source(h)) - surface.points.col(source(next_in_triangle(h)))).norm();
  };
  const std::int32_t chart = chart_of[faces[0]];
  const auto neighbor = [&](std::int32_t h) { return surface.opposite[h] < 0 ? -1 : chart_of[surface.opposite[h] / 3]; };
  std::vector<std::int32_t> sides; // to other charts
  perimeter = 0;
  for(const std::int32_t f : faces)
    for(std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      if(neighbor(h) == chart)
        continue;
      perimeter += length(h);
      if(neighbor(h) >= 0 && may_close(h))
        sides.push_back(h);
    }
  std::vector<Chart_contact> contacts;
  std::vector<char> is_taken(sides.size(), 0);
  for(std::size_t first = 0; first < sides.size(); ++first) {
    if(is_taken[first])
      continue;
    is_taken[first] = 1;
    Chart_contact contact{neighbor(sides[first]), {sides[first]}, length(sides[first])};
    for(std::size_t i = 0; i < contact.halfedges.size(); ++i)
      for(std::size_t j = 0; j < sides.size(); ++j) {
        const std::int32_t g = contact.halfedges[i], h = sides[j];
        if(is_taken[j] || neighbor(h) != contact.neighbor)
          continue;
        if(source(h) == source(next_in_triangle(g)) || source(next_in_triangle(h)) == source(g)) {
          is_taken[j] = 1;
          contact.halfedges.push_back(h);
          contact.length += length(h);
        }
      }
    contacts.push_back(contact);
  }
  std::stable_sort(contacts.begin(), contacts.end(), [](const Chart_contact& a, const Chart_contact& b) { return a.length > b.length; });
  return contacts;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_CONTACTS_IMPL_H
