// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_GRID_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_GRID_H

#include <CGAL/Flip_free_maps/atlas/internal/Cell_figure.h>
#include <CGAL/Flip_free_maps/atlas/internal/bit_row.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A square of cells that are free or taken, a bit each, and where figures have room.
class Cell_grid
{
public:
  // All are free, so many along a side.
  explicit Cell_grid(int size = 0);

  int size() const { return m_size; }

  // What is taken is what is in another grid of the same size, and no work was done.
  void restore(const Cell_grid& other);

  // The lower left cell of the largest square of free cells, and how many are along its side.
  struct Free_square
  {
    int x = 0, y = 0, size = 0;
  };
  Free_square largest_free_square() const;

  // The first place in a row where a figure touches no cell that is taken, for its leftmost cells; -1 if there is none.
  int first_place(const Cell_figure& figure, int y);

  // Takes the cells within a figure, and those nearer to one of its cells than a distance, as far as they are in the grid.
  void take(const Cell_figure& figure, int x, int y, double distance);

  // What was done since then, in words that were looked at or written.
  std::int64_t work() const { return m_work; }

private:
  using Word = Bit_word;
  static constexpr int BITS = BITS_PER_WORD;

  // Words at the end of a row that stay 0.
  static constexpr int PADDING = 2;

  Word* row(int y, int k = 0) { return m_taken[k].data() + std::size_t(y) * (m_words + PADDING); }

  // Whether some of the 2^k cells from a cell on is taken, for each cell of a row.
  const Word* taken_within(int k, int y);

  // Whether some cell between these is taken.
  bool is_any_taken(int y, int first, int last);

  // Removes from the words of places, first to last one, those where a run would touch a cell that is taken.
  void exclude(const Cell_run& run, int y, int& first_word, int& last_word);

  // The most cells side by side that are free in all of 2^k rows.
  int longest_free(int k, int y, int wanted);

  int m_size, m_words;
  // By k, what `taken_within()` gives; for k = 0 the cells, for others perhaps not what it is by now.
  std::vector<std::vector<Word>> m_taken;
  std::vector<std::vector<char>> m_is_old;
  // By k, for the 2^k rows from each row on. Cells are only ever taken, so an old length is a bound.
  std::vector<std::vector<int>> m_longest_free;
  std::vector<std::vector<char>> m_is_bound;
  std::vector<Word> m_places, m_union;
  std::int64_t m_work = 0;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Cell_grid_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_GRID_H
