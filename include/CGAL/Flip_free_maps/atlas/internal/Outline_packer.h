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
#include <numeric>
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
  // Charts keep the distance from each other; the square's side is 1.
  Outline_packer(const std::vector<Chart_outline>& outlines, double distance, int orientations)
    : m_outlines(outlines), m_distance(distance), m_orientations(orientations)
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
    // What fits does not depend on the scale monotonically, and other orders may do better.
    for(const double exponent : {0.25, 0.5, 1.}) {
      sort([exponent](const Vector<2>& box) { return box.maxCoeff() * std::pow(box.minCoeff(), exponent); });
      while(!must_stop() && fits(low * (1 + SCALE_TOLERANCE), must_stop))
        low *= 1 + SCALE_TOLERANCE;
    }
    return m_scale > 0;
  }

  double scale() const { return m_scale; }
  const std::vector<Outline_place>& places() const { return m_places; }

private:
  static constexpr int SIZE = 512, WORDS = SIZE / 64;
  static constexpr double SCALE_TOLERANCE = 0.01;
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

  // A chart in one orientation.
  struct Figure
  {
    Cell_mask mask;
    std::vector<std::array<int, 3>> runs; // of each 16th row first
    Outline_place turn;
  };

  // The cells that a chart touches: those along its border, and those whose centres it contains. Empty when it is too large.
  Figure figure(const Chart_outline& outline, double scale, int orientation) const;

  // Moves a row to the left.
  static Row shifted(const Row& row, int by);

  // The first place in a row of the grid where a figure touches no cell that is taken; -1 if there is none.
  int first_place(const Figure& figure, int y) const;

  // Takes all cells that are nearer to a figure than the distance.
  void take(const Figure& figure, int x, int y);

  template <typename MustStop>
  bool fits(double scale, const MustStop& must_stop)
  {
    m_grid.assign(SIZE, Row{});
    std::vector<Outline_place> places(m_outlines.size());
    for(const std::size_t c : m_order) {
      if(must_stop())
        return false;
      Figure best;
      int best_top = SIZE + 1, best_x = 0, best_y = 0;
      for(int orientation = 0; orientation < m_orientations; ++orientation) {
        Figure figure = this->figure(m_outlines[c], scale, orientation);
        const int height = figure.mask.height();
        if(height == 0)
          continue;
        for(int y = 0; y + height < best_top && y + height <= SIZE; ++y) {
          const int x = first_place(figure, y);
          if(x < 0)
            continue;
          best_top = y + height;
          best_x = x;
          best_y = y;
          best = std::move(figure);
          break;
        }
      }
      if(best_top > SIZE)
        return false;
      take(best, best_x, best_y);
      places[c] = best.turn;
      places[c].x = static_cast<double>(best_x) / SIZE;
      places[c].y = static_cast<double>(best_y) / SIZE;
    }
    m_scale = scale;
    m_places.swap(places);
    return true;
  }

  const std::vector<Chart_outline>& m_outlines;
  double m_distance;
  int m_orientations;
  double m_scale = -1;
  std::vector<std::size_t> m_order;
  std::vector<Outline_place> m_places;
  std::vector<Row> m_grid;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Outline_packer_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_H
