// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_MASK_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_MASK_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Cell_mask.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Cell_mask::Cell_mask(const Chart_outline& outline, int grid_size, const Vector<2>& low)
{
  const Vector<2> size = outline.sources.rowwise().maxCoeff() - low;
  if(size.maxCoeff() > grid_size - 2 * SLACK)
    return;
  m_low = outline.sources.rowwise().minCoeff() - low;
  m_high = size;
  allocate(static_cast<int>(size[0] + SLACK) + 1, static_cast<int>(size[1] + SLACK) + 1);
  mark_interior(mark_border(outline, low));
}

CGAL_FLIP_FREE_MAPS_INLINE void Cell_mask::allocate(int width, int height)
{
  m_width = width;
  m_height = height;
  m_words = (width + BITS_PER_WORD - 1) / BITS_PER_WORD;
  m_bits.assign(std::size_t(m_words) * height, 0);
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Cell_mask::Crossing> Cell_mask::mark_border(const Chart_outline& outline, const Vector<2>& low)
{
  std::vector<Crossing> crossings;
  crossings.reserve(2 * m_height);
  // Coordinates are not below 0 but for rounding, so a conversion rounds down.
  const auto column = [this](double x) { return (std::min)(static_cast<int>(x), m_width - 1); };
  for(Eigen::Index i = 0; i < outline.sources.cols(); ++i) {
    const Vector<2> a = outline.sources.col(i) - low, b = outline.targets.col(i) - low;
    const bool is_up = a[1] <= b[1];
    const Vector<2>&p = is_up ? a : b, &q = is_up ? b : a;
    const bool is_level = !(q[1] - p[1] > SLACK);
    const double slope = is_level ? 0 : (q[0] - p[0]) / (q[1] - p[1]);
    const double slack = SLACK * (1 + std::abs(slope)); // for coordinates of points in which the edge leaves a row
    const double left = (std::min)(p[0], q[0]), right = (std::max)(p[0], q[0]);
    const int first = static_cast<int>(p[1] - SLACK), last = (std::min)(static_cast<int>(q[1] + SLACK), m_height - 1);
    double from = p[0];
    for(int y = first; y <= last; ++y) {
      const double to = y < last && !is_level ? p[0] + slope * (y + 1 - p[1]) : q[0];
      const double begin = is_level ? left : (std::max)(left, (std::min)(from, to) - slack);
      const double end = is_level ? right : (std::min)(right, (std::max)(from, to) + slack);
      set_bits(row(y), column(begin - SLACK), column(end + SLACK));
      const double middle = y + 0.5;
      if(p[1] <= middle && q[1] > middle) {
        const double x = (std::min)(right, (std::max)(left, p[0] + slope * (middle - p[1])));
        crossings.push_back({y, static_cast<int>((std::max)(x, 0.) + 0.5), is_up ? 1 : -1});
      }
      from = to;
    }
  }
  return crossings;
}

CGAL_FLIP_FREE_MAPS_INLINE void Cell_mask::mark_interior(const std::vector<Crossing>& crossings)
{
  std::vector<int> row_ends(m_height + 1, 0);
  for(const Crossing& crossing : crossings)
    ++row_ends[crossing.row + 1];
  std::partial_sum(row_ends.begin(), row_ends.end(), row_ends.begin());
  std::vector<std::pair<int, int>> beyond(crossings.size()); // cell and sign, row by row
  std::vector<int> next(row_ends);
  for(const Crossing& crossing : crossings)
    beyond[next[crossing.row]++] = {crossing.cell, crossing.sign};
  for(int y = 0; y < m_height; ++y) {
    const auto begin = beyond.begin() + row_ends[y], end = beyond.begin() + row_ends[y + 1];
    std::sort(begin, end);
    int turns = 0;
    for(auto c = begin; c != end && c + 1 != end; ++c) {
      turns += c->second;
      const int stop = (std::min)((c + 1)->first, m_width);
      if(turns != 0 && c->first < stop)
        set_bits(row(y), c->first, stop - 1);
    }
  }
}

CGAL_FLIP_FREE_MAPS_INLINE Cell_mask Cell_mask::transposed() const
{
  Cell_mask result;
  result.m_low = {m_low[1], m_low[0]};
  result.m_high = {m_high[1], m_high[0]};
  result.allocate(m_height, m_width);
  std::array<Bit_word, BITS_PER_WORD> square;
  for(int y = 0; y < m_height; y += BITS_PER_WORD)
    for(int x = 0; x < m_width; x += BITS_PER_WORD) {
      square.fill(0);
      for(int i = 0; i < (std::min)(BITS_PER_WORD, m_height - y); ++i)
        square[i] = words(y + i)[x / BITS_PER_WORD];
      transpose_bits(square.data());
      for(int i = 0; i < (std::min)(BITS_PER_WORD, m_width - x); ++i)
        result.row(x + i)[y / BITS_PER_WORD] = square[i];
    }
  return result;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_MASK_IMPL_H
