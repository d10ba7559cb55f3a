// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_FIGURE_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_FIGURE_H

#include <CGAL/Flip_free_maps/atlas/internal/bit_row.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The outline of a chart: its border edges, with the chart on the same side of all, in any order.
struct Chart_outline
{
  Positions<2> sources, targets;
};

// Cells of a row, from the first to the last one.
struct Cell_run
{
  int first, last, row;

  int length() const { return last - first + 1; }
};

// The cells that a chart touches: those along its border, and those whose centres it contains.
class Cell_figure
{
public:
  // None.
  Cell_figure() = default;

  // Those of an outline whose coordinates are in cells. None if it is wider or higher than the grid with so many cells in a row.
  Cell_figure(const Chart_outline& outline, int grid_size) : Cell_figure(outline, grid_size, outline.sources.rowwise().minCoeff()) {}

  // The same with the lower left corner of the first cell here, at most one cell from the outline.
  Cell_figure(const Chart_outline& outline, int grid_size, const Vector<2>& low);

  // In rows. Whether there is room for higher ones takes longer to find out than it saves.
  static constexpr int HIGHEST_BLOCK = 32;

  int width() const { return m_width; }
  int height() const { return m_height; }

  // Ordered so that those who come first are spread over the figure.
  const std::vector<Cell_run>& runs() const { return m_runs; }

  // The widest block of cells that fills 2^k rows, by k: the lowest one's cells, as far as they are in all of them.
  const std::vector<Cell_run>& blocks() const { return m_blocks; }

private:
  // Rounding of coordinates, in cells.
  static constexpr double SLACK = 1e-6;

  // Of the rows' bits, so many words a row.
  void find_blocks(const std::vector<Bit_word>& mask, int words);

  int m_width = 0, m_height = 0;
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
