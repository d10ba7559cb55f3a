// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_MASK_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_MASK_H

#include <CGAL/Flip_free_maps/atlas/internal/bit_row.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The outline of a chart: its border edges, with the chart on the same side of all, in any order.
struct Chart_outline
{
  Positions<2> sources, targets;
};

// Rows of cells that a chart touches, a bit each: those along its border, and those whose centres it contains.
class Cell_mask
{
public:
  // No cells.
  Cell_mask() = default;

  // The cells of an outline whose coordinates are in cells, with the lower left corner of the first one here, at most one cell from
  // the outline. None if it is wider or higher than the grid with so many cells in a row.
  Cell_mask(const Chart_outline& outline, int grid_size, const Vector<2>& low);

  int width() const { return m_width; }
  int height() const { return m_height; }

  // The box of the outline, from the lower left corner of the first cell.
  const Vector<2>& low() const { return m_low; }
  const Vector<2>& high() const { return m_high; }

  // Of a row, and how many there are.
  const Bit_word* words(int y) const { return m_bits.data() + std::size_t(y) * m_words; }
  int number_of_words() const { return m_words; }

  // Rows as columns.
  Cell_mask transposed() const;

private:
  // Rounding of coordinates, in cells.
  static constexpr double SLACK = 1e-6;

  // Where the border crosses the middle of a row: the first cell whose centre is beyond, and the way, since a chart may overlap itself.
  struct Crossing
  {
    int row, cell, sign;
  };

  void allocate(int width, int height);
  Bit_word* row(int y) { return m_bits.data() + std::size_t(y) * m_words; }

  std::vector<Crossing> mark_border(const Chart_outline& outline, const Vector<2>& low);
  void mark_interior(const std::vector<Crossing>& crossings);

  int m_width = 0, m_height = 0, m_words = 0;
  Vector<2> m_low = Vector<2>::Zero(), m_high = Vector<2>::Zero();
  std::vector<Bit_word> m_bits;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Cell_mask_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_MASK_H
