// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_GRID_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_GRID_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Cell_grid.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Cell_grid::Cell_grid(int size)
  : m_size(size), m_words((size + BITS - 1) / BITS), m_places(m_words), m_union(m_words)
{
  for(int cells = 1; cells <= size; cells *= 2) {
    m_taken.emplace_back(std::size_t(size) * (m_words + PADDING), 0);
    m_is_old.emplace_back(size, 0);
  }
  for(int rows = 1; rows <= (std::min)(size, Cell_figure::HIGHEST_BLOCK); rows *= 2) {
    m_longest_free.emplace_back(size - rows + 1, size);
    m_is_bound.emplace_back(size - rows + 1, 0);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Cell_grid::restore(const Cell_grid& other)
{
  if(m_size == 0)
    return;
  m_taken[0] = other.m_taken[0];
  for(std::vector<char>& is_old : m_is_old)
    std::fill(is_old.begin(), is_old.end(), 1);
  m_longest_free = other.m_longest_free;
  m_is_bound = other.m_is_bound;
  m_work = 0;
}

CGAL_FLIP_FREE_MAPS_INLINE Cell_grid::Free_square Cell_grid::largest_free_square() const
{
  // By cell, the largest one with its upper right corner there: one more than the least of those at three neighbors.
  Free_square best;
  std::vector<int> below(m_size + 1, 0), here(m_size + 1, 0);
  for(int y = 0; y < m_size; ++y, below.swap(here))
    for(int x = 0; x < m_size; ++x) {
      const Word word = m_taken[0][std::size_t(y) * (m_words + PADDING) + x / BITS];
      here[x + 1] = (word >> x % BITS & 1) != 0 ? 0 : 1 + (std::min)({below[x], below[x + 1], here[x]});
      if(here[x + 1] > best.size)
        best = {x - here[x + 1] + 1, y - here[x + 1] + 1, here[x + 1]};
    }
  return best;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Cell_grid::is_any_taken(int y, int first, int last)
{
  const Word* const words = row(y);
  const int begin = first / BITS, end = last / BITS;
  m_work += end - begin + 1;
  Word any = 0;
  for(int w = begin; w <= end; ++w)
    any |= words[w] & bits_within(w, first, last);
  return any != 0;
}

CGAL_FLIP_FREE_MAPS_INLINE const Cell_grid::Word* Cell_grid::taken_within(int k, int y)
{
  Word* const words = row(y, k);
  if(k == 0 || !m_is_old[k][y])
    return words;
  m_is_old[k][y] = 0;
  const Word* const half = taken_within(k - 1, y);
  const int cells = 1 << (k - 1), skip = cells / BITS, rest = cells % BITS;
  for(int w = 0; w < m_words; ++w)
    words[w] = half[w] | (w + skip < m_words ? bits_from(half + w + skip, rest) : 0);
  m_work += m_words;
  return words;
}

CGAL_FLIP_FREE_MAPS_INLINE void Cell_grid::exclude(const Cell_run& run, int y, int& first_word, int& last_word)
{
  // Two parts that overlap make up the run.
  const int k = highest_bit(run.length()), second = run.last - (1 << k) + 1;
  const Word* const taken = taken_within(k, y + run.row);
  const Word *const p = taken + run.first / BITS, *const q = taken + second / BITS;
  const int p_bits = run.first % BITS, q_bits = second % BITS;
  m_work += last_word - first_word + 1;
  for(int w = first_word; w <= last_word; ++w)
    m_places[w] &= ~(bits_from(p + w, p_bits) | bits_from(q + w, q_bits));
  while(first_word <= last_word && m_places[first_word] == 0)
    ++first_word;
  while(last_word >= first_word && m_places[last_word] == 0)
    --last_word;
}

CGAL_FLIP_FREE_MAPS_INLINE int Cell_grid::longest_free(int k, int y, int wanted)
{
  int& known = m_longest_free[k][y];
  if(known < wanted || !m_is_bound[k][y])
    return known;
  m_is_bound[k][y] = 0;
  std::copy(row(y), row(y) + m_words, m_union.begin());
  for(int i = 1; i < 1 << k; ++i) {
    const Word* const other = row(y + i);
    for(int w = 0; w < m_words; ++w)
      m_union[w] |= other[w];
  }
  m_work += std::int64_t(m_words) << k;
  known = 0;
  int begin = 0; // of the run of free cells
  for_each_run(m_union.data(), m_words, [&](int first, int end) {
    known = (std::max)(known, first - begin);
    begin = end;
  });
  known = (std::max)(known, m_size - begin);
  return known;
}

CGAL_FLIP_FREE_MAPS_INLINE int Cell_grid::first_place(const Cell_figure& figure, int y)
{
  ++m_work;
  for(std::size_t k = figure.blocks().size(); k-- > 0;) {
    const Cell_run& block = figure.blocks()[k];
    if(longest_free(static_cast<int>(k), y + block.row, block.length()) < block.length())
      return -1;
  }
  // So few places are looked at one by one.
  const int few = 8;
  const int places = m_size - figure.width() + 1;
  int first = 0, last = (places - 1) / BITS;
  std::fill(m_places.begin(), m_places.begin() + last, ~Word(0));
  m_places[last] = ~Word(0) >> (BITS * (last + 1) - places);
  const std::vector<Cell_run>& runs = figure.runs();
  std::size_t i = 0;
  for(bool are_few = false; i < runs.size() && !are_few; ++i) {
    exclude(runs[i], y, first, last);
    if(first > last)
      return -1;
    int number = 0;
    for(int w = first; w <= last && number <= few; ++w)
      for(Word rest = m_places[w]; rest != 0 && number <= few; rest &= rest - 1)
        ++number;
    are_few = number <= few;
  }
  for(int w = first; w <= last; ++w)
    for(Word rest = m_places[w]; rest != 0; rest &= rest - 1) {
      const int x = BITS * w + lowest_bit(rest);
      std::size_t j = i;
      while(j < runs.size() && !is_any_taken(y + runs[j].row, x + runs[j].first, x + runs[j].last))
        ++j;
      if(j == runs.size())
        return x;
    }
  return -1;
}

CGAL_FLIP_FREE_MAPS_INLINE void Cell_grid::take(const Cell_figure& figure, int x, int y, double distance)
{
  const int reach = static_cast<int>(std::ceil(distance)) + 1;
  for(int dy = -reach; dy <= reach; ++dy) {
    const double gap = (std::max)(std::abs(dy) - 1, 0);
    int dx = dy == 0 ? 0 : -1;
    while(std::hypot(gap, (std::max)(dx, 0)) < distance)
      ++dx; // cells apart by dx have cells of dx - 1 between them
    if(dx < 0)
      continue;
    for(const Cell_run& run : figure.runs()) {
      const int r = y + run.row + dy;
      if(r < 0 || r >= m_size)
        continue;
      const int first = (std::max)(0, x + run.first - dx), last = (std::min)(m_size - 1, x + run.last + dx);
      if(first > last)
        continue;
      set_bits(row(r), first, last);
      m_work += (last - first) / BITS + 1;
    }
  }
  const int begin = (std::max)(0, y - reach), end = (std::min)(m_size, y + figure.height() + reach);
  if(begin >= end)
    return;
  for(std::vector<char>& is_old : m_is_old)
    std::fill(is_old.begin() + begin, is_old.begin() + end, 1);
  for(std::size_t k = 0; k < m_is_bound.size(); ++k) {
    std::vector<char>& is_bound = m_is_bound[k];
    const int from = (std::max)(0, begin - (1 << k) + 1), to = (std::min)(end, static_cast<int>(is_bound.size()));
    if(from < to)
      std::fill(is_bound.begin() + from, is_bound.begin() + to, 1);
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CELL_GRID_IMPL_H
