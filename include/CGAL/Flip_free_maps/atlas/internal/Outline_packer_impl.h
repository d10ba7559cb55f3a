// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Outline_packer.h>
#include <CGAL/Flip_free_maps/internal/for_each_index.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

template <typename Size>
std::vector<std::size_t> Outline_packer::sorted(Size size) const
{
  std::vector<double> sizes;
  for(const Chart_outline& outline : m_outlines) {
    const Vector<2> box = outline.sources.rowwise().maxCoeff() - outline.sources.rowwise().minCoeff();
    sizes.push_back(size(box));
  }
  std::vector<std::size_t> order(m_outlines.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  return order;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Outline_packer::pack(double low, double high, const std::function<bool()>& must_stop)
{
  for(const Chart_outline& outline : m_outlines) {
    const auto &p = outline.sources.array(), &q = outline.targets.array();
    m_areas.push_back(0.5 * (p.row(0) * q.row(1) - p.row(1) * q.row(0)).sum());
  }
  m_area = std::accumulate(m_areas.begin(), m_areas.end(), 0.);
  // Cells should be small next to charts, and the fewer charts the more orientations.
  const std::size_t several = 256, many = 1000, n = m_outlines.size();
  const bool are_many = n > many;
  use_grid(n > several ? COARSE : COARSE / 2);
  const int fine_size = n <= FEW ? COARSE : 2 * COARSE;
  m_attempt.plan.order = sorted([](const Vector<2>& box) { return box.maxCoeff(); });
  low = bisect(low, high, are_many ? 3 * SCALE_TOLERANCE : SCALE_TOLERANCE, must_stop);
  if(m_most_work == 0)
    return m_scale > 0;
  if(!are_many) {
    // What fits does not depend on the scale monotonically, and other orders may do better.
    for(const double exponent : {0.25, 0.5, 1.}) {
      m_attempt.plan.order = sorted([exponent](const Vector<2>& box) { return box.maxCoeff() * std::pow(box.minCoeff(), exponent); });
      while(!must_stop() && fits(low * (1 + SCALE_TOLERANCE), must_stop))
        low *= 1 + SCALE_TOLERANCE;
    }
    low = search(low, must_stop);
  }
  use_grid(fine_size);
  if(m_scale > 0)
    m_attempt.plan = m_best;
  climb(low, high, are_many ? 2 * SCALE_TOLERANCE : SEARCH_STEP, must_stop);
  return m_scale > 0;
}

CGAL_FLIP_FREE_MAPS_INLINE void Outline_packer::use_grid(int cells)
{
  // The distance is a whole number of cells if it is at least one, lest it be rounded up.
  const int gap = static_cast<int>(m_distance * cells);
  m_cells_per_side = gap > 0 ? gap / m_distance : cells;
  m_cell_distance = gap > 0 ? gap : m_distance * cells;
  m_start = Cell_grid(static_cast<int>(m_cells_per_side));
  if(m_take_obstacles)
    m_take_obstacles(m_start, m_cells_per_side, m_cell_distance);
}

CGAL_FLIP_FREE_MAPS_INLINE double Outline_packer::bisect(double low, double high, double tolerance, const std::function<bool()>& must_stop)
{
  double next = std::sqrt(low * high);
  for(bool is_guess = false; high - low > tolerance * high && !must_stop(); is_guess = !is_guess) {
    const double scale = next;
    (fits(scale, must_stop) ? low : high) = scale;
    // Where the areas would just do, every other time.
    const double least = low * (1 + tolerance / 2), most = high / (1 + tolerance / 2);
    next = is_guess || least > most ? std::sqrt(low * high) : (std::min)(most, (std::max)(least, scale * std::sqrt(m_attempt.room)));
  }
  return low;
}

CGAL_FLIP_FREE_MAPS_INLINE void Outline_packer::climb(double low, double high, double tolerance, const std::function<bool()>& must_stop)
{
  for(double step = 1 + tolerance; low * step < high && !must_stop(); step *= step) {
    if(!fits(low * step, must_stop)) {
      high = low * step;
      break;
    }
    low *= step;
  }
  bisect(low, high, tolerance, must_stop);
}

CGAL_FLIP_FREE_MAPS_INLINE double Outline_packer::search(double low, const std::function<bool()>& must_stop)
{
  const std::size_t n = m_outlines.size();
  std::minstd_rand random;
  if(m_scale <= 0)
    m_best = m_attempt.plan;
  std::vector<Attempt> attempts(TRIALS);
  for(Attempt& attempt : attempts)
    attempt.failed = m_attempt.failed;
  // One chart, between obstacles, has nothing but its turn.
  int turns = 0;
  std::int64_t most_work = m_most_work / FIRST_PART;
  for(std::int64_t work = 0; work < most_work && (n > 1 || (m_turns_freely && turns < TURNS)) && !must_stop();) {
    for(Attempt& attempt : attempts) {
      Plan& plan = attempt.plan;
      plan.order = m_best.order;
      // The chart that had no place comes earlier.
      const auto failed = std::find(plan.order.begin(), plan.order.end(), attempt.failed);
      if(failed != plan.order.end() && failed != plan.order.begin() && random() % 2 == 0)
        std::rotate(plan.order.begin() + random() % (failed - plan.order.begin()), failed, failed + 1);
      for(std::size_t swaps = random() % 3; swaps > 0; --swaps) {
        const std::size_t a = random() % n, b = random() % n;
        std::swap(plan.order[a], plan.order[b]);
      }
      plan.first_orientation = static_cast<int>(random() % m_orientations);
      if(n == 1)
        plan.turn = static_cast<double>(turns++) / TURNS;
      else if(m_turns_freely && random() % 4 == 0)
        plan.turn = static_cast<double>(random() % TURNS) / TURNS;
    }
    // Each goes as far as it gets from the same scale, and the farthest counts.
    std::vector<double> scales(TRIALS, 0.);
    for_each_index<CGAL::Parallel_tag>(TRIALS, [&](std::size_t i) {
      attempts[i].work = 0;
      std::vector<Outline_place> places;
      for(double scale = low * (1 + SEARCH_STEP); !must_stop() && fits(attempts[i], scale, must_stop); scale *= 1 + SEARCH_STEP) {
        scales[i] = scale;
        places.swap(attempts[i].places);
      }
      attempts[i].places.swap(places);
    });
    for(const Attempt& attempt : attempts)
      work += attempt.work;
    const std::size_t best = std::max_element(scales.begin(), scales.end()) - scales.begin();
    if(scales[best] > 0) {
      low = scales[best];
      keep(low, attempts[best]);
      most_work = (std::min)(m_most_work, (std::max)(most_work, 2 * work));
    }
  }
  return low;
}

CGAL_FLIP_FREE_MAPS_INLINE const Outline_packer::Turned_figure& Outline_packer::figure(Attempt& attempt, std::size_t c,
                                                                                       int orientation) const
{
  Turned_figure& figure = attempt.figures[c][orientation];
  if(figure.is_known)
    return figure;
  // Quarter turns are exact, and cost less than other ones.
  const int quarter = m_orientations / 4, first = orientation % quarter;
  const double angle = 2 * CGAL_PI * (first + attempt.plan.turn) / m_orientations, cosine = std::cos(angle), sine = std::sin(angle);
  const double cosines[] = {cosine, -sine, -cosine, sine}, sines[] = {sine, cosine, -sine, -cosine};
  Matrix<2> rotation;
  rotation << cosine, -sine, sine, cosine;
  rotation *= attempt.figures_scale;
  const Chart_outline& outline = m_outlines[c];
  std::array<Cell_figure, 4> turned =
    Cell_figure::quarter_turns({rotation * outline.sources, rotation * outline.targets}, attempt.grid.size());
  for(int i = 0; i < 4; ++i) {
    Turned_figure& result = attempt.figures[c][first + i * quarter];
    result.is_known = true;
    result.turn = {turned[i].low()[0], turned[i].low()[1], cosines[i], sines[i]};
    result.cells = std::move(turned[i]);
    attempt.work += WORK_OF_RUN * result.cells.runs().size();
  }
  attempt.work += WORK_OF_EDGE * outline.sources.cols();
  return figure;
}

CGAL_FLIP_FREE_MAPS_INLINE int Outline_packer::box_class(const Cell_figure& figure)
{
  const auto size_class = [](int size) { return static_cast<int>(CLASSES_PER_OCTAVE * std::log2(size)); };
  return BOX_CLASSES * size_class(figure.width()) + size_class(figure.height());
}

CGAL_FLIP_FREE_MAPS_INLINE bool Outline_packer::fits(Attempt& attempt, double scale, const std::function<bool()>& must_stop) const
{
  const int size = m_start.size();
  if(scale * m_cells_per_side != attempt.figures_scale || attempt.plan.turn != attempt.figures_turn) {
    attempt.figures.assign(m_outlines.size(), std::vector<Turned_figure>(m_orientations));
    attempt.figures_scale = scale * m_cells_per_side;
    attempt.figures_turn = attempt.plan.turn;
  }
  Cell_grid& grid = attempt.grid;
  if(grid.size() != size)
    grid = Cell_grid(size);
  grid.restore(m_start);
  attempt.work += 2 * size; // what that costs, and an end to the search where nothing else does any work
  std::vector<Outline_place> places(m_outlines.size());
  // By orientation and class of the box: below there was no room for another figure, and none is looked for if there are many.
  const bool are_few = m_outlines.size() <= FEW;
  std::vector<std::vector<int>> first_rows(are_few ? 0 : m_orientations, std::vector<int>(BOX_CLASSES * BOX_CLASSES, 0));
  const int row_step = size > COARSE ? FINE_STEP : 1;
  int top = 1;
  double placed_area = 0;
  const auto place_all = [&] {
    for(const std::size_t c : attempt.plan.order) {
      if(must_stop())
        return false;
      const Turned_figure* best = nullptr;
      int best_top = size + 1, best_x = 0, best_y = 0;
      for(int i = 0; i < m_orientations; ++i) {
        const Turned_figure& turned = figure(attempt, c, (attempt.plan.first_orientation + i) % m_orientations);
        const int height = turned.cells.height();
        if(height == 0)
          continue;
        int lowest = 0;
        int& y = are_few ? lowest : first_rows[i][box_class(turned.cells)];
        const int highest = (std::min)(best_top - 1, size) - height;
        int x = -1, lowest_untried = y;
        for(; y <= highest && (x = grid.first_place(turned.cells, y)) < 0; y += row_step)
          lowest_untried = y + 1;
        for(int below; x >= 0 && y > lowest_untried && (below = grid.first_place(turned.cells, y - 1)) >= 0; --y)
          x = below;
        if(x < 0)
          continue;
        best_top = y + height;
        best_x = x;
        best_y = y;
        best = &turned;
      }
      if(best == nullptr) {
        attempt.failed = c;
        attempt.room = placed_area / m_area;
        return false;
      }
      grid.take(best->cells, best_x, best_y, m_cell_distance);
      top = (std::max)(top, best_top);
      placed_area += m_areas[c];
      places[c] = best->turn;
      places[c].x = (best_x + best->turn.x) / m_cells_per_side;
      places[c].y = (best_y + best->turn.y) / m_cells_per_side;
    }
    attempt.room = static_cast<double>(size) / top;
    return true;
  };
  const bool is_placed = place_all();
  attempt.work += grid.work();
  if(is_placed)
    attempt.places.swap(places);
  return is_placed;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Outline_packer::fits(double scale, const std::function<bool()>& must_stop)
{
  if(!fits(m_attempt, scale, must_stop))
    return false;
  keep(scale, m_attempt);
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE void Outline_packer::keep(double scale, Attempt& attempt)
{
  m_scale = scale;
  m_best = attempt.plan;
  m_places.swap(attempt.places);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_IMPL_H
