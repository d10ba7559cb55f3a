// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_JOINED_POLYGONS_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_JOINED_POLYGONS_H

#include <CGAL/Flip_free_maps/domains/internal/Polygon_soup.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Polygons of a soup that are joined by their indices, as far as that can be done without parting any of them:
// - points at the same place are one if the polygons fall apart otherwise, and do so less then, unless the soup is welded. In one
//   piece they are kept apart: they may be the sides of a cut;
// - corners like the one before are left out, and polygons that have less than three then;
// - of polygons that occur twice, with the same corners in the same order, the first is kept.
class Joined_polygons
{
public:
  explicit Joined_polygons(Polygon_soup& soup) : m_soup(soup) {}

  // Changes the soup. Its points stay, and have finite coordinates if polygons use them.
  void join();

  // Leaves out the polygons that occur twice; false if there are none.
  bool remove_repeated();

  // The number of pieces that the polygons form by their indices.
  std::size_t number_of_pieces() const;
  std::int32_t number_of_polygons() const { return m_soup.number_of_polygons(); }
  // The number that a polygon had before.
  std::int32_t number(std::int32_t polygon) const { return m_numbers.empty() ? polygon : m_numbers[polygon]; }
  // The point that stands for one, often itself.
  std::int32_t first(std::int32_t point) const { return m_first.empty() ? point : m_first[point]; }
  // The old numbers of the polygons with corners at less than three places, ascending.
  const std::vector<std::int32_t>& without_area() const { return m_without_area; }

private:
  void weld_if_apart();
  void remove_repeated_corners();
  // Keeps the polygons that are marked.
  void keep(const std::vector<char>& is_kept);

  Polygon_soup& m_soup;
  std::vector<std::int32_t> m_numbers, m_first, m_without_area;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/domains/internal/Joined_polygons_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_JOINED_POLYGONS_H
