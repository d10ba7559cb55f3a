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
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Cell_figure::Cell_figure(const Cell_mask& mask)
  : m_width(mask.width()), m_height(mask.height()), m_low(mask.low()), m_high(mask.high())
{
  std::vector<Cell_run> runs, longest;
  std::vector<std::size_t> row_begins(1, 0);
  runs.reserve(2 * m_height);
  longest.reserve(m_height);
  row_begins.reserve(m_height + 1);
  for(int y = 0; y < m_height; ++y) {
    longest.push_back({0, -1, y});
    for_each_run(mask.words(y), mask.number_of_words(), [&](int first, int end) {
      runs.push_back({first, end - 1, y});
      if(runs.back().length() > longest.back().length())
        longest.back() = runs.back();
    });
    row_begins.push_back(runs.size());
  }
  const int stride = 16;
  m_runs.reserve(runs.size());
  for(int phase = 0; phase < stride; ++phase)
    for(int y = phase; y < m_height; y += stride)
      m_runs.insert(m_runs.end(), runs.begin() + row_begins[y], runs.begin() + row_begins[y + 1]);
  find_blocks(std::move(longest));
}

CGAL_FLIP_FREE_MAPS_INLINE std::array<Cell_figure, 4> Cell_figure::quarter_turns(const Chart_outline& outline, int grid_size)
{
  const Cell_mask mask(outline, grid_size, outline.sources.rowwise().minCoeff());
  const Cell_figure figure(mask), transposed(mask.transposed());
  return {{figure, transposed.mirrored(true, false), figure.mirrored(true, true), transposed.mirrored(false, true)}};
}

CGAL_FLIP_FREE_MAPS_INLINE void Cell_figure::find_blocks(std::vector<Cell_run> common)
{
  // What the longest runs have in common with the row 1, 2, 4, ... above.
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

CGAL_FLIP_FREE_MAPS_INLINE Cell_figure Cell_figure::mirrored(bool in_x, bool in_y) const
{
  Cell_figure result(*this);
  const auto mirror = [&](Cell_run& run, int rows) {
    if(in_x)
      run = {m_width - 1 - run.last, m_width - 1 - run.first, run.row};
    if(in_y)
      run.row = m_height - rows - run.row;
  };
  for(Cell_run& run : result.m_runs)
    mirror(run, 1);
  for(std::size_t k = 0; k < m_blocks.size(); ++k)
    mirror(result.m_blocks[k], 1 << k);
  if(in_x) {
    result.m_low[0] = m_width - m_high[0];
    result.m_high[0] = m_width - m_low[0];
  }
  if(in_y) {
    result.m_low[1] = m_height - m_high[1];
    result.m_high[1] = m_height - m_low[1];
  }
  return result;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_FIGURE_IMPL_H
