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
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Cell_figure::Cell_figure(const Chart_outline& outline, int grid_size)
{
  const Vector<2> low = outline.sources.rowwise().minCoeff(), size = outline.sources.rowwise().maxCoeff() - low;
  if(size.maxCoeff() > grid_size - 2 * SLACK)
    return;
  m_width = static_cast<int>(size[0] + SLACK) + 1;
  m_height = static_cast<int>(size[1] + SLACK) + 1;
  // Where the border crosses the middles of rows: the first cell whose centre is beyond, and the way, since a chart may overlap itself.
  struct Crossing
  {
    int row, cell, sign;
  };
  std::vector<Crossing> crossings;
  const int words = (m_width + BITS_PER_WORD - 1) / BITS_PER_WORD;
  std::vector<Bit_word> mask(std::size_t(words) * m_height, 0);
  const auto fill = [&](int y, int first, int last) { set_bits(mask.data() + std::size_t(y) * words, first, last); };
  for(Eigen::Index i = 0; i < outline.sources.cols(); ++i) {
    const Vector<2> a = outline.sources.col(i) - low, b = outline.targets.col(i) - low;
    const bool is_up = a[1] <= b[1];
    const Vector<2> p = is_up ? a : b, q = is_up ? b : a;
    const bool is_level = !(q[1] - p[1] > SLACK);
    const double slope = is_level ? 0 : (q[0] - p[0]) / (q[1] - p[1]);
    const auto at = [&](double y) { return p[0] + slope * ((std::min)(q[1], (std::max)(p[1], y)) - p[1]); };
    const int first = (std::max)(static_cast<int>(std::floor(p[1] - SLACK)), 0);
    const int last = (std::min)(static_cast<int>(std::floor(q[1] + SLACK)), m_height - 1);
    for(int y = first; y <= last; ++y) {
      double left = at(y - SLACK), right = at(y + 1 + SLACK);
      if(is_level)
        right = q[0];
      if(left > right)
        std::swap(left, right);
      fill(y, (std::max)(static_cast<int>(std::floor(left - SLACK)), 0),
           (std::min)(static_cast<int>(std::floor(right + SLACK)), m_width - 1));
      if(p[1] <= y + 0.5 && q[1] > y + 0.5)
        crossings.push_back({y, (std::max)(static_cast<int>(std::ceil(at(y + 0.5) - 0.5)), 0), is_up ? 1 : -1});
    }
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& c, const Crossing& d) { return c.row != d.row ? c.row < d.row : c.cell < d.cell; });
  int turns = 0; // none at the end of a row
  for(std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    turns += crossings[i].sign;
    const int end = (std::min)(crossings[i + 1].cell, m_width);
    if(turns != 0 && crossings[i].cell < end)
      fill(crossings[i].row, crossings[i].cell, end - 1);
  }
  for(int y = 0; y < m_height; ++y)
    for_each_run(mask.data() + std::size_t(y) * words, words, [&](int first, int end) { m_runs.push_back({first, end - 1, y}); });
  find_blocks();
  const int stride = 16;
  std::stable_sort(m_runs.begin(), m_runs.end(), [](const Cell_run& r, const Cell_run& s) { return r.row % stride < s.row % stride; });
}

CGAL_FLIP_FREE_MAPS_INLINE void Cell_figure::find_blocks()
{
  // The longest run of each row, then what these have in common with the row 1, 2, 4, ... above.
  std::vector<Cell_run> common;
  for(const Cell_run& run : m_runs)
    if(common.empty() || common.back().row != run.row)
      common.push_back(run);
    else if(run.length() > common.back().length())
      common.back() = run;
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
