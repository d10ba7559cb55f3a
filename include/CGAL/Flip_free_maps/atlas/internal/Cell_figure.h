// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_FIGURE_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_FIGURE_H

#include <CGAL/Flip_free_maps/atlas/internal/Cell_mask.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Cells of a row, from the first to the last one.
struct Cell_run
{
  int first, last, row;

  int length() const { return last - first + 1; }
};

// The cells that a chart touches, as runs.
class Cell_figure
{
public:
  // None.
  Cell_figure() = default;

  explicit Cell_figure(const Cell_mask& mask);

  // That of an outline whose coordinates are in cells, and what it is after one, two and three quarter turns. None if it is wider or
  // higher than the grid with so many cells in a row.
  static std::array<Cell_figure, 4> quarter_turns(const Chart_outline& outline, int grid_size);

  // In rows. Whether there is room for higher ones takes longer to find out than it saves.
  static constexpr int HIGHEST_BLOCK = 32;

  int width() const { return m_width; }
  int height() const { return m_height; }

  // The lower left corner of the outline's box, from that of the first cell.
  const Vector<2>& low() const { return m_low; }

  // Ordered so that those who come first are spread over the figure.
  const std::vector<Cell_run>& runs() const { return m_runs; }

  // The widest block of cells that fills 2^k rows, by k: the lowest one's cells, as far as they are in all of them.
  const std::vector<Cell_run>& blocks() const { return m_blocks; }

private:
  // Of the longest runs by row.
  void find_blocks(std::vector<Cell_run> common);

  // Left and right, bottom and top exchanged.
  Cell_figure mirrored(bool in_x, bool in_y) const;

  int m_width = 0, m_height = 0;
  Vector<2> m_low = Vector<2>::Zero(), m_high = Vector<2>::Zero(); // the outline's box
  std::vector<Cell_run> m_runs;
  std::vector<Cell_run> m_blocks;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Cell_figure_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_FIGURE_H
