// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_FIGURE_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_FIGURE_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Cell_figure.h>
#include <CGAL/Flip_free_maps/atlas/internal/bit_row.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Cell_figure::Cell_figure(const Chart_outline& outline, int grid_size, const Vector<2>& low)
{
  const Vector<2> size = outline.sources.rowwise().maxCoeff() - low;
  if(size.maxCoeff() > grid_size - 2 * SLACK)
    return;
  m_width = static_cast<int>(size[0] + SLACK) + 1;
  m_height = static_cast<int>(size[1] + SLACK) + 1;
  const int words = (m_width + BITS_PER_WORD - 1) / BITS_PER_WORD;
  std::vector<Bit_word> mask(std::size_t(words) * m_height, 0);
  // By row, where the border crosses its middle: the first cell whose centre is beyond, and the way, since a chart may overlap itself.
  struct Crossing
  {
    int row, cell, sign;
  };
  std::vector<Crossing> crossings;
  std::vector<int> row_ends(m_height + 1, 0);
  // Coordinates are not below 0 but for rounding, so a conversion rounds down.
  const auto column = [this](double x) { return (std::min)(static_cast<int>(x), m_width - 1); };
  for(Eigen::Index i = 0; i < outline.sources.cols(); ++i) {
    const Vector<2> a = outline.sources.col(i) - low, b = outline.targets.col(i) - low;
    const bool is_up = a[1] <= b[1];
    const Vector<2>&p = is_up ? a : b, &q = is_up ? b : a;
    const bool is_level = !(q[1] - p[1] > SLACK);
    const double slope = is_level ? 0 : (q[0] - p[0]) / (q[1] - p[1]);
    const auto at = [&](double y) { return p[0] + slope * ((std::min)(q[1], (std::max)(p[1], y)) - p[1]); };
    const int first = static_cast<int>(p[1] - SLACK), last = (std::min)(static_cast<int>(q[1] + SLACK), m_height - 1);
    for(int y = first; y <= last; ++y) {
      const double from = at(y - SLACK), to = is_level ? q[0] : at(y + 1 + SLACK);
      set_bits(mask.data() + std::size_t(y) * words, column((std::min)(from, to) - SLACK), column((std::max)(from, to) + SLACK));
      if(p[1] <= y + 0.5 && q[1] > y + 0.5) {
        crossings.push_back({y, (std::max)(static_cast<int>(std::ceil(at(y + 0.5) - 0.5)), 0), is_up ? 1 : -1});
        ++row_ends[y + 1];
      }
    }
  }
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
        set_bits(mask.data() + std::size_t(y) * words, c->first, stop - 1);
    }
  }
  find_blocks(mask, words);
  const int stride = 16;
  for(int phase = 0; phase < stride; ++phase)
    for(int y = phase; y < m_height; y += stride)
      for_each_run(mask.data() + std::size_t(y) * words, words, [&](int first, int end) { m_runs.push_back({first, end - 1, y}); });
}

CGAL_FLIP_FREE_MAPS_INLINE void Cell_figure::find_blocks(const std::vector<Bit_word>& mask, int words)
{
  // The longest run of each row, then what these have in common with the row 1, 2, 4, ... above.
  std::vector<Cell_run> common;
  common.reserve(m_height);
  for(int y = 0; y < m_height; ++y) {
    common.push_back({0, -1, y});
    for_each_run(mask.data() + std::size_t(y) * words, words, [&common, y](int first, int end) {
      if(end - first > common.back().length())
        common.back() = {first, end - 1, y};
    });
  }
  for(std::size_t rows = 1; rows <= std::size_t(HIGHEST_BLOCK) && !common.empty(); rows *= 2) {
    m_blocks.push_back(
      *std::max_element(common.begin(), common.end(), [](const Cell_run& r, const Cell_run& s) { return r.length() < s.length(); }));
    if(m_blocks.back().length() <= 0) {
      m_blocks.pop_back();
      return;
    }
    const std::size_t n = common.size() > rows ? common.size() - rows : 0;
    for(std::size_t y = 0; y < n; ++y) {
      common[y].first = (std::max)(common[y].first, common[y + rows].first);
      common[y].last = (std::min)(common[y].last, common[y + rows].last);
    }
    common.resize(n);
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_FIGURE_IMPL_H
