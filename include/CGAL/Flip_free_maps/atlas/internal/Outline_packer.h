// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The outline of a chart: its border edges, with the chart on the same side of all, in any order.
struct Chart_outline
{
  Positions<2> sources, targets;
};

// Where a chart went: turned by the rotation with this cosine and sine, then with its lower left corner here.
struct Outline_place
{
  double x = 0;
  double y = 0;
  double cosine = 1;
  double sine = 0;
};

// The cells of a grid that a figure touches, row by row.
class Cell_mask
{
public:
  Cell_mask() = default;
  Cell_mask(int width, int height) : m_width(width), m_height(height), m_cells(std::size_t(width) * std::size_t(height), 0) {}

  int width() const { return m_width; }
  int height() const { return m_height; }
  char operator()(int x, int y) const { return m_cells[std::size_t(y) * m_width + x]; }
  // Cells from one to the other.
  void fill(int y, int first, int last);

  // Runs of cells as first and last ones, with their rows.
  std::vector<std::array<int, 3>> runs() const;

private:
  int m_width = 0, m_height = 0;
  std::vector<char> m_cells;
};

// Packs charts by their outlines into a square, scaled alike: each, the largest first, in the orientation and at the place where
// its top is lowest, holes and dents of charts before it included. Places are cells of a grid. The cells that a chart touches, and
// all that are nearer to one of these than the distance, are taken afterwards; so distances hold for sure. The scale is found by
// bisection above one that is known to do.
class Outline_packer
{
public:
  // The work of the search, a number of rows that are shifted. So many take about a tenth of a second; with 0 there is the bisection
  // only.
  static constexpr std::int64_t MOST_WORK = 3000000;

  // Charts keep the distance from each other; the square's side is 1. The orientations are evenly spaced, and all of them may be
  // turned further if charts turn freely.
  Outline_packer(const std::vector<Chart_outline>& outlines, double distance, int orientations, bool turns_freely,
                 std::int64_t most_work = MOST_WORK)
    : m_outlines(outlines), m_distance(distance), m_orientations(orientations), m_turns_freely(turns_freely), m_most_work(most_work)
  {}

  // Whether there are packings with scales between these; none are looked for any more once `must_stop()` holds.
  template <typename MustStop>
  bool pack(double low, double high, const MustStop& must_stop)
  {
    sort([](const Vector<2>& box) { return box.maxCoeff(); });
    while(high - low > SCALE_TOLERANCE * high && !must_stop()) {
      const double middle = std::sqrt(low * high);
      (fits(middle, must_stop) ? low : high) = middle;
    }
    if(m_most_work == 0)
      return m_scale > 0;
    // What fits does not depend on the scale monotonically, and other orders may do better.
    for(const double exponent : {0.25, 0.5, 1.}) {
      sort([exponent](const Vector<2>& box) { return box.maxCoeff() * std::pow(box.minCoeff(), exponent); });
      while(!must_stop() && fits(low * (1 + SCALE_TOLERANCE), must_stop))
        low *= 1 + SCALE_TOLERANCE;
    }
    search(low, must_stop);
    return m_scale > 0;
  }

  double scale() const { return m_scale; }
  const std::vector<Outline_place>& places() const { return m_places; }

private:
  static constexpr int SIZE = 512, WORDS = SIZE / 64;
  static constexpr double SCALE_TOLERANCE = 0.01;
  // The least gain that counts in the search.
  static constexpr double SEARCH_STEP = 0.004;
  // Rounding of coordinates, in cells.
  static constexpr double SLACK = 1e-6;

  using Row = std::array<std::uint64_t, WORDS>;

  // Charts whose boxes have the largest size come first.
  template <typename Size>
  void sort(Size size)
  {
    std::vector<double> sizes;
    for(const Chart_outline& outline : m_outlines) {
      const Vector<2> box = outline.sources.rowwise().maxCoeff() - outline.sources.rowwise().minCoeff();
      sizes.push_back(size(box));
    }
    m_order.resize(m_outlines.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::stable_sort(m_order.begin(), m_order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  }

  // Looks for orders and orientations near the best ones that allow a larger scale, with a bounded amount of work.
  template <typename MustStop>
  void search(double low, const MustStop& must_stop)
  {
    const std::size_t n = m_outlines.size();
    std::minstd_rand random;
    std::vector<std::size_t> best = m_best_order.empty() ? m_order : m_best_order;
    for(m_work = 0; m_work < m_most_work && !must_stop();) {
      m_order = best;
      // The chart that had no place comes earlier.
      const auto failed = std::find(m_order.begin(), m_order.end(), m_failed);
      if(failed != m_order.end() && failed != m_order.begin() && random() % 2 == 0)
        std::rotate(m_order.begin() + random() % (failed - m_order.begin()), failed, failed + 1);
      for(std::size_t swaps = random() % 3; swaps > 0; --swaps) {
        const std::size_t a = random() % n, b = random() % n;
        std::swap(m_order[a], m_order[b]);
      }
      m_first_orientation = static_cast<int>(random() % m_orientations);
      if(m_turns_freely && (n == 1 || random() % 4 == 0)) {
        m_turn = static_cast<double>(random() % 64) / 64;
        m_figures.clear();
      }
      bool is_better = false;
      while(!must_stop() && fits(low * (1 + SEARCH_STEP), must_stop)) {
        low *= 1 + SEARCH_STEP;
        is_better = true;
      }
      if(is_better)
        best = m_order;
    }
  }

  // A chart in one orientation.
  struct Figure
  {
    int width = 0, height = 0;            // 0 when it is too large
    int longest = 0, longest_row = 0;     // the longest run, and its row
    std::vector<std::array<int, 3>> runs; // of each 16th row first
    Outline_place turn;
  };

  // The cells that a chart touches: those along its border, and those whose centres it contains.
  Figure figure(const Chart_outline& outline, double scale, int orientation) const;

  // The same, made once for a scale.
  const Figure& known_figure(std::size_t c, double scale, int orientation);

  // Moves a row to the left.
  static Row shifted(const Row& row, int by);

  // The first place in a row of the grid where a figure touches no cell that is taken; -1 if there is none.
  int first_place(const Figure& figure, int y);

  static int longest_free_run(const Row& row);

  // Takes all cells that are nearer to a figure than the distance.
  void take(const Figure& figure, int x, int y);

  template <typename MustStop>
  bool fits(double scale, const MustStop& must_stop)
  {
    m_grid.assign(SIZE, Row{});
    m_longest_free.assign(SIZE, SIZE);
    m_work += SIZE / 4; // what that costs, and an end to the search where nothing else does any work
    std::vector<Outline_place> places(m_outlines.size());
    for(const std::size_t c : m_order) {
      if(must_stop())
        return false;
      const Figure* best = nullptr;
      int best_top = SIZE + 1, best_x = 0, best_y = 0;
      for(int i = 0; i < m_orientations; ++i) {
        const Figure& figure = known_figure(c, scale, (m_first_orientation + i) % m_orientations);
        if(figure.height == 0)
          continue;
        for(int y = 0; y + figure.height < best_top && y + figure.height <= SIZE; ++y) {
          const int x = first_place(figure, y);
          if(x < 0)
            continue;
          best_top = y + figure.height;
          best_x = x;
          best_y = y;
          best = &figure;
          break;
        }
      }
      if(best == nullptr) {
        m_failed = c;
        return false;
      }
      take(*best, best_x, best_y);
      places[c] = best->turn;
      places[c].x = static_cast<double>(best_x) / SIZE;
      places[c].y = static_cast<double>(best_y) / SIZE;
    }
    m_scale = scale;
    m_best_order = m_order;
    m_places.swap(places);
    return true;
  }

  const std::vector<Chart_outline>& m_outlines;
  double m_distance;
  int m_orientations;
  bool m_turns_freely;
  std::int64_t m_most_work;
  double m_scale = -1;
  std::vector<std::size_t> m_order, m_best_order;
  std::vector<Outline_place> m_places;
  std::vector<Row> m_grid;
  std::vector<int> m_longest_free;            // the longest run of free cells in each row of the grid
  std::vector<std::vector<Figure>> m_figures; // by chart and orientation, at one scale; empty runs where none was made
  double m_figures_scale = -1;
  double m_turn = 0; // of all orientations, in parts of the angle between two of them
  int m_first_orientation = 0;
  std::size_t m_failed = (std::numeric_limits<std::size_t>::max)(); // the last chart that had no place
  std::int64_t m_work = 0;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Outline_packer_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_H
