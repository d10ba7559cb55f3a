// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_RECTANGLE_PACKER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_RECTANGLE_PACKER_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Rectangle_packer.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool Rectangle_packer::pack()
{
  const std::size_t n = m_sizes.size();
  double product = 0, sum = 0, longest = 0;
  for(const auto& size : m_sizes) {
    product += size[0] * size[1];
    sum += size[0] + size[1];
    longest = (std::max)({longest, size[0], size[1]});
  }
  // No scale can exceed that at which the areas add up to 1, the positive root of a quadratic equation,
  // or a rectangle is as long as the square.
  const double room = 1 - n * m_margin * m_margin, half = 0.5 * m_margin * sum;
  if(!(room > 0) || !(longest > 0))
    return false;
  const double bound = (std::min)(room / (half + std::sqrt(half * half + product * room)), (1 - m_margin) / longest);
  m_scale = -1;
  const int last = n > 4000 ? 1 : 3;
  for(int rule = 0; rule < last; ++rule)
    search(static_cast<Turn>(rule), bound);
  return m_scale > 0;
}

CGAL_FLIP_FREE_MAPS_INLINE void Rectangle_packer::search(Turn turn, double bound)
{
  // A rule that does not improve on the others' scale need not be refined.
  double low = (std::max)(m_scale, 0.), high = bound;
  if(low > 0 && !fits(turn, low * 1.001))
    return;
  if(low == 0 && !fits(turn, bound * 1e-6))
    return;
  for(int i = 0; i < 20 && high - low > 1e-3 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (fits(turn, middle) ? low : high) = middle;
  }
}

CGAL_FLIP_FREE_MAPS_INLINE bool Rectangle_packer::fits(Turn turn, double scale)
{
  const std::size_t n = m_sizes.size();
  std::vector<Rectangle_place> places(n);
  std::vector<std::array<double, 2>> boxes(n);
  for(std::size_t i = 0; i < n; ++i) {
    boxes[i] = {{m_sizes[i][0] * scale + m_margin, m_sizes[i][1] * scale + m_margin}};
    places[i].is_turned = turn != Turn::free && (turn == Turn::lying) != (boxes[i][0] >= boxes[i][1]);
    if(places[i].is_turned)
      std::swap(boxes[i][0], boxes[i][1]);
  }
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto height = [&](std::size_t i) { return turn == Turn::free ? (std::max)(boxes[i][0], boxes[i][1]) : boxes[i][1]; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return height(a) > height(b); });

  m_skyline.assign(1, {0, 0});
  for(const std::size_t i : order) {
    Rectangle_place place;
    if(turn == Turn::free) {
      Rectangle_place other;
      const double top = lowest(boxes[i][0], boxes[i][1], place), other_top = lowest(boxes[i][1], boxes[i][0], other);
      if(other_top < top) {
        place = other;
        place.is_turned = true;
        std::swap(boxes[i][0], boxes[i][1]);
      }
      if((std::min)(top, other_top) > 1)
        return false;
    } else {
      if(lowest(boxes[i][0], boxes[i][1], place) > 1)
        return false;
      place.is_turned = places[i].is_turned;
    }
    raise(place, boxes[i]);
    place.x += 0.5 * m_margin;
    place.y += 0.5 * m_margin;
    places[i] = place;
  }
  if(scale > m_scale) {
    m_scale = scale;
    m_places.swap(places);
  }
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE double Rectangle_packer::lowest(double width, double height, Rectangle_place& place) const
{
  double best = std::numeric_limits<double>::infinity();
  for(std::size_t i = 0; i < m_skyline.size() && m_skyline[i].x + width <= 1; ++i) {
    double y = 0;
    for(std::size_t j = i; j < m_skyline.size() && m_skyline[j].x < m_skyline[i].x + width && y + height < best; ++j)
      y = (std::max)(y, m_skyline[j].y);
    if(y + height < best) {
      best = y + height;
      place.x = m_skyline[i].x;
      place.y = y;
    }
  }
  return best;
}

CGAL_FLIP_FREE_MAPS_INLINE void Rectangle_packer::raise(const Rectangle_place& place, const std::array<double, 2>& box)
{
  const double end = place.x + box[0];
  std::vector<Step> skyline;
  skyline.reserve(m_skyline.size() + 2);
  double last = 0; // the height of the skyline at the end of the box
  for(const Step& step : m_skyline)
    if(step.x < end)
      last = step.y;
  std::size_t i = 0;
  for(; i < m_skyline.size() && m_skyline[i].x < place.x; ++i)
    skyline.push_back(m_skyline[i]);
  skyline.push_back({place.x, place.y + box[1]});
  while(i < m_skyline.size() && m_skyline[i].x < end)
    ++i;
  if((i == m_skyline.size() || m_skyline[i].x > end) && end < 1)
    skyline.push_back({end, last});
  skyline.insert(skyline.end(), m_skyline.begin() + i, m_skyline.end());
  m_skyline.swap(skyline);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_RECTANGLE_PACKER_IMPL_H
