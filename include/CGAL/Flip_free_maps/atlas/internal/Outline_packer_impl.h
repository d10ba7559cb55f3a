// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Outline_packer.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void Cell_mask::fill(int y, int first, int last)
{
  if(y < 0 || y >= m_height)
    return;
  first = (std::max)(first, 0);
  last = (std::min)(last, m_width - 1);
  if(first <= last)
    std::fill(m_cells.begin() + std::size_t(y) * m_width + first, m_cells.begin() + std::size_t(y) * m_width + last + 1, 1);
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::array<int, 3>> Cell_mask::runs() const
{
  std::vector<std::array<int, 3>> result;
  for(int y = 0; y < m_height; ++y)
    for(int x = 0, end; x < m_width; x = end + 1) {
      end = x;
      if(!(*this)(x, y))
        continue;
      while(end + 1 < m_width && (*this)(end + 1, y))
        ++end;
      result.push_back({{x, end, y}});
    }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE Outline_packer::Figure Outline_packer::figure(const Chart_outline& outline, double scale, int orientation) const
{
  Figure result;
  // Quarter turns are exact.
  const int quarter = 4 * orientation / m_orientations;
  const double rest = 2 * CGAL_PI * (orientation + m_turn) / m_orientations - CGAL_PI / 2 * quarter;
  const double c = std::cos(rest), s = std::sin(rest);
  const double cosines[] = {c, -s, -c, s}, sines[] = {s, c, -s, -c};
  result.turn.cosine = cosines[quarter];
  result.turn.sine = sines[quarter];
  Matrix<2> rotation;
  rotation << result.turn.cosine, -result.turn.sine, result.turn.sine, result.turn.cosine;
  Positions<2> a = (SIZE * scale) * (rotation * outline.sources), b = (SIZE * scale) * (rotation * outline.targets);
  const Vector<2> low = a.rowwise().minCoeff();
  a.colwise() -= low;
  b.colwise() -= low;
  const Vector<2> size = a.rowwise().maxCoeff();
  if(size.maxCoeff() > SIZE - 2 * SLACK)
    return result;
  result.width = static_cast<int>(size[0] + SLACK) + 1;
  result.height = static_cast<int>(size[1] + SLACK) + 1;
  Cell_mask mask(result.width, result.height);
  // With signs, since a chart may overlap itself.
  std::vector<std::vector<std::pair<double, int>>> crossings(result.height);
  for(Eigen::Index i = 0; i < a.cols(); ++i) {
    const bool is_up = a(1, i) <= b(1, i);
    const Vector<2> p = is_up ? a.col(i) : b.col(i), q = is_up ? b.col(i) : a.col(i);
    const auto at = [&](double y) {
      return q[1] > p[1] ? p[0] + (q[0] - p[0]) * (std::min)(1., (std::max)(0., (y - p[1]) / (q[1] - p[1]))) : p[0];
    };
    const int last = static_cast<int>(std::floor(q[1] + SLACK));
    for(int y = static_cast<int>(std::floor(p[1] - SLACK)); y <= last; ++y) {
      const double x0 = q[1] > p[1] ? at(y - SLACK) : p[0], x1 = q[1] > p[1] ? at(y + 1 + SLACK) : q[0];
      mask.fill(y, static_cast<int>(std::floor((std::min)(x0, x1) - SLACK)), static_cast<int>(std::floor((std::max)(x0, x1) + SLACK)));
      if(y >= 0 && y < result.height && p[1] <= y + 0.5 && q[1] > y + 0.5)
        crossings[y].emplace_back(at(y + 0.5), is_up ? 1 : -1);
    }
  }
  for(int y = 0; y < result.height; ++y) {
    std::sort(crossings[y].begin(), crossings[y].end());
    int turns = 0;
    for(std::size_t i = 0; i + 1 < crossings[y].size(); ++i) {
      turns += crossings[y][i].second;
      if(turns != 0)
        mask.fill(y, static_cast<int>(std::ceil(crossings[y][i].first - 0.5)),
                  static_cast<int>(std::floor(crossings[y][i + 1].first - 0.5)));
    }
  }
  const int stride = 16;
  result.runs = mask.runs();
  std::stable_sort(result.runs.begin(), result.runs.end(),
                   [](const std::array<int, 3>& r, const std::array<int, 3>& t) { return r[2] % stride < t[2] % stride; });
  for(const auto& run : result.runs)
    if(run[1] - run[0] + 1 > result.longest) {
      result.longest = run[1] - run[0] + 1;
      result.longest_row = run[2];
    }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE int Outline_packer::longest_free_run(const Row& row)
{
  const auto both = [](const Row& a, const Row& b, Row& result) {
    std::uint64_t any = 0;
    for(int i = 0; i < WORDS; ++i)
      any |= result[i] = a[i] & b[i];
    return any != 0;
  };
  // Cells from which 1, 2, 4, ... are free; then the length is found digit by digit.
  std::vector<Row> powers(1, row);
  for(std::uint64_t& word : powers[0])
    word = ~word;
  Row next;
  while(both(powers.back(), shifted(powers.back(), 1 << (powers.size() - 1)), next))
    powers.push_back(next);
  Row from = powers.back();
  int length = 1 << (powers.size() - 1);
  for(int digit = static_cast<int>(powers.size()) - 2; digit >= 0; --digit)
    if(both(from, shifted(powers[digit], length), next)) {
      from = next;
      length += 1 << digit;
    }
  return both(from, from, next) ? length : 0;
}

CGAL_FLIP_FREE_MAPS_INLINE const Outline_packer::Figure& Outline_packer::known_figure(std::size_t c, double scale, int orientation)
{
  if(scale != m_figures_scale || m_figures.empty()) {
    m_figures.assign(m_outlines.size(), std::vector<Figure>(m_orientations));
    m_figures_scale = scale;
  }
  Figure& known = m_figures[c][orientation];
  if(known.runs.empty()) {
    known = figure(m_outlines[c], scale, orientation);
    m_work += m_outlines[c].sources.cols() / 4;
  }
  return known;
}

CGAL_FLIP_FREE_MAPS_INLINE Outline_packer::Row Outline_packer::shifted(const Row& row, int by)
{
  Row result;
  const int words = by / 64, bits = by % 64;
  for(int i = 0; i < WORDS; ++i) {
    const std::uint64_t low = i + words < WORDS ? row[i + words] : 0, high = i + words + 1 < WORDS ? row[i + words + 1] : 0;
    result[i] = bits == 0 ? low : (low >> bits) | (high << (64 - bits));
  }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE int Outline_packer::first_place(const Figure& figure, int y)
{
  ++m_work;
  if(m_longest_free[y + figure.longest_row] < figure.longest)
    return -1;
  const int places = SIZE - figure.width + 1;
  Row free;
  for(int i = 0; i < WORDS; ++i)
    free[i] = places >= 64 * (i + 1) ? ~std::uint64_t(0) : places <= 64 * i ? 0 : (std::uint64_t(1) << (places - 64 * i)) - 1;
  for(const auto& run : figure.runs) {
    // Cells from which some of the next ones, as many as the run has, are taken.
    Row taken = m_grid[y + run[2]];
    const int length = run[1] - run[0] + 1;
    int done = 1;
    while(done < length) {
      const int step = (std::min)(done, length - done);
      const Row other = shifted(taken, step);
      for(int i = 0; i < WORDS; ++i)
        taken[i] |= other[i];
      done += step;
      ++m_work;
    }
    taken = shifted(taken, run[0]);
    ++m_work;
    std::uint64_t any = 0;
    for(int i = 0; i < WORDS; ++i)
      any |= free[i] &= ~taken[i];
    if(any == 0)
      return -1;
  }
  for(int x = 0; x < places; ++x)
    if(free[x / 64] >> (x % 64) & 1)
      return x;
  return -1;
}

CGAL_FLIP_FREE_MAPS_INLINE void Outline_packer::take(const Figure& figure, int x, int y)
{
  const double distance = m_distance * SIZE;
  const int reach = static_cast<int>(std::ceil(distance)) + 1;
  for(int dy = -reach; dy <= reach; ++dy) {
    const double gap = (std::max)(std::abs(dy) - 1, 0);
    int dx = -1;
    while(std::hypot(gap, (std::max)(dx, 0)) < distance)
      ++dx; // cells apart by dx have cells of dx - 1 between them
    if(dx < 0)
      continue;
    for(const auto& run : figure.runs) {
      const int row = y + run[2] + dy;
      if(row < 0 || row >= SIZE)
        continue;
      const int first = (std::max)(0, x + run[0] - dx), last = (std::min)(SIZE - 1, x + run[1] + dx);
      for(int i = first; i <= last; ++i)
        m_grid[row][i / 64] |= std::uint64_t(1) << (i % 64);
    }
  }
  for(int row = (std::max)(0, y - reach); row < (std::min)(SIZE, y + figure.height + reach); ++row)
    m_longest_free[row] = longest_free_run(m_grid[row]);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_IMPL_H
