// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_JOINED_POLYGONS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_JOINED_POLYGONS_IMPL_H

#include <CGAL/Flip_free_maps/domains/internal/Joined_polygons.h>
#include <CGAL/Flip_free_maps/domains/internal/weld_points.h>
#include <CGAL/Flip_free_maps/internal/Disjoint_sets.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The number of pieces that polygons form by their indices, of which `first` tells the point that stands for one.
CGAL_FLIP_FREE_MAPS_INLINE std::size_t number_of_pieces(const Polygon_soup& soup, const std::vector<std::int32_t>& first)
{
  Disjoint_sets sets(first.size());
  std::size_t pieces = 0;
  std::vector<char> is_used(first.size(), 0);
  const auto use = [&](std::int32_t v) {
    pieces += is_used[v] ? 0 : 1;
    is_used[v] = 1;
  };
  for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p)
    for(std::int32_t c = soup.first_corners[p]; c < soup.first_corners[p + 1]; ++c) {
      use(first[soup.vertices[c]]);
      if(c > soup.first_corners[p] && sets.unite(first[soup.vertices[c - 1]], first[soup.vertices[c]]))
        --pieces;
    }
  return pieces;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> numbers_to(std::size_t size)
{
  std::vector<std::int32_t> numbers(size);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

CGAL_FLIP_FREE_MAPS_INLINE std::size_t Joined_polygons::number_of_pieces() const
{
  return internal::number_of_pieces(m_soup, numbers_to(m_soup.points.cols()));
}

CGAL_FLIP_FREE_MAPS_INLINE void Joined_polygons::join()
{
  if(!m_soup.is_welded)
    weld_if_apart();
  remove_repeated_corners();
}

CGAL_FLIP_FREE_MAPS_INLINE void Joined_polygons::weld_if_apart()
{
  std::vector<std::int32_t> first = numbers_to(m_soup.points.cols());
  const std::size_t pieces = internal::number_of_pieces(m_soup, first);
  if(pieces < 2)
    return;
  std::vector<char> is_used(first.size(), 0);
  for(const std::int32_t v : m_soup.vertices)
    is_used[v] = 1;
  for(std::size_t v = 0; v < first.size(); ++v)
    if(!is_used[v])
      first[v] = -1;
  weld_points(m_soup.points, first);
  for(std::size_t v = 0; v < first.size(); ++v)
    if(first[v] < 0)
      first[v] = static_cast<std::int32_t>(v);
  if(internal::number_of_pieces(m_soup, first) == pieces)
    return;
  for(std::int32_t& v : m_soup.vertices)
    v = first[v];
  m_first.swap(first);
}

CGAL_FLIP_FREE_MAPS_INLINE void Joined_polygons::remove_repeated_corners()
{
  const std::int32_t polygons = m_soup.number_of_polygons();
  std::vector<char> is_kept(polygons, 1);
  std::vector<std::int32_t> vertices, first_corners{0};
  vertices.reserve(m_soup.vertices.size());
  first_corners.reserve(m_soup.first_corners.size());
  for(std::int32_t p = 0; p < polygons; ++p) {
    for(std::int32_t c = m_soup.first_corners[p]; c < m_soup.first_corners[p + 1]; ++c)
      if(m_soup.vertices[c] != m_soup.vertices[m_soup.prev(p, c)])
        vertices.push_back(m_soup.vertices[c]);
    const auto begin = vertices.begin() + first_corners.back();
    const bool has_third = std::any_of(begin, vertices.end(), [&](std::int32_t v) { return v != begin[0] && v != begin[1]; });
    if(!has_third) {
      is_kept[p] = 0;
      m_without_area.push_back(p);
    }
    first_corners.push_back(static_cast<std::int32_t>(vertices.size()));
  }
  m_soup.vertices.swap(vertices);
  m_soup.first_corners.swap(first_corners);
  if(!m_without_area.empty())
    keep(is_kept);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Joined_polygons::remove_repeated()
{
  std::set<std::vector<std::int32_t>> seen;
  std::vector<char> is_kept(m_soup.number_of_polygons(), 1);
  bool is_any = false;
  for(std::int32_t p = 0; p < m_soup.number_of_polygons(); ++p) {
    std::vector<std::int32_t> corners(m_soup.vertices.begin() + m_soup.first_corners[p],
                                      m_soup.vertices.begin() + m_soup.first_corners[p + 1]);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    is_kept[p] = seen.insert(std::move(corners)).second;
    is_any = is_any || !is_kept[p];
  }
  if(is_any)
    keep(is_kept);
  return is_any;
}

CGAL_FLIP_FREE_MAPS_INLINE void Joined_polygons::keep(const std::vector<char>& is_kept)
{
  std::vector<std::int32_t> vertices, first_corners{0}, numbers;
  for(std::int32_t p = 0; p < m_soup.number_of_polygons(); ++p) {
    if(!is_kept[p])
      continue;
    vertices.insert(vertices.end(), m_soup.vertices.begin() + m_soup.first_corners[p],
                    m_soup.vertices.begin() + m_soup.first_corners[p + 1]);
    first_corners.push_back(static_cast<std::int32_t>(vertices.size()));
    numbers.push_back(number(p));
  }
  m_soup.vertices.swap(vertices);
  m_soup.first_corners.swap(first_corners);
  m_numbers.swap(numbers);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_JOINED_POLYGONS_IMPL_H
