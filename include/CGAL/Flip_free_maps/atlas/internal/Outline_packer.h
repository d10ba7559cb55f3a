// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_H

#include <CGAL/Flip_free_maps/atlas/internal/Cell_figure.h>
#include <CGAL/Flip_free_maps/atlas/internal/Cell_grid.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Where a chart went: turned by the rotation with this cosine and sine, then with its lower left corner here.
struct Outline_place
{
  double x = 0;
  double y = 0;
  double cosine = 1;
  double sine = 0;
};

// Packs charts by their outlines into a square, scaled alike: each, the largest first, in the orientation and at the place where
// its top is lowest, holes and dents of charts before it included. Places are cells of a grid. The cells that a chart touches, and
// all that are nearer to one of these than the distance, are taken afterwards; so distances hold for sure. The scale is found by
// bisection above one that is known to do, on a coarse grid first, where orders and orientations are tried, then on a fine one.
class Outline_packer
{
public:
  // The most work of the search on the coarse grid, in words of the grid. So much takes half a second or a whole one; the search ends
  // earlier where it gains nothing. With 0 there is the bisection only.
  static constexpr std::int64_t MOST_WORK = 120000000;

  // Takes what is not free from the start, of a grid with so many cells along the square's side, and what is nearer to that than so
  // many cells.
  using Take_obstacles = std::function<void(Cell_grid&, double cells_per_side, double distance)>;

  // Charts keep the distance from each other; the square's side is 1. The orientations, four or a multiple of it, are evenly
  // spaced, and all of them may be turned further if charts turn freely.
  Outline_packer(const std::vector<Chart_outline>& outlines, double distance, int orientations, bool turns_freely,
                 std::int64_t most_work = MOST_WORK, const Take_obstacles& take_obstacles = nullptr)
    : m_outlines(outlines),
      m_distance(distance),
      m_orientations(orientations),
      m_turns_freely(turns_freely),
      m_most_work(most_work),
      m_take_obstacles(take_obstacles)
  {}

  // Whether there are packings with scales between these; none are looked for any more once `must_stop()` holds.
  bool pack(double low, double high, const std::function<bool()>& must_stop);

  double scale() const { return m_scale; }
  const std::vector<Outline_place>& places() const { return m_places; }

private:
  // The cells along the side of a coarse grid at most; and of how many rows of a finer one the first is tried, and the others only where
  // that has room.
  static constexpr int COARSE = 1024, FINE_STEP = 4;

  // So few charts are small work in all places.
  static constexpr std::size_t FEW = 64;
  static constexpr double SCALE_TOLERANCE = 0.01;
  // The least gain that counts in the search and on the fine grid.
  static constexpr double SEARCH_STEP = 0.004;

  // The part of the most work after which the search ends unless it has gained.
  static constexpr int FIRST_PART = 4;

  // Trials of the search at the same time, whatever the number of threads.
  static constexpr std::size_t TRIALS = 4;

  // Between two orientations.
  static constexpr int TURNS = 64;

  // What making figures costs, in words of the grid.
  static constexpr std::int64_t WORK_OF_RUN = 12, WORK_OF_EDGE = 32;

  // A chart in one orientation, and its turn with the corner of its box within the first cell.
  struct Turned_figure
  {
    bool is_known = false;
    Cell_figure cells;
    Outline_place turn;
  };

  // What a packing depends on but the scale: the order of the charts, the turn of all orientations, in parts of the angle between two
  // of them, and the orientation that comes first where several do.
  struct Plan
  {
    std::vector<std::size_t> order;
    double turn = 0;
    int first_orientation = 0;
  };

  // A packing by a plan, as far as it goes, and what it needs; such objects are used again, since figures and grids are expensive.
  struct Attempt
  {
    Plan plan;
    Cell_grid grid;
    std::vector<std::vector<Turned_figure>> figures; // by chart and orientation
    double figures_scale = -1;                       // cells of a unit of length
    double figures_turn = 0;
    std::vector<Outline_place> places;
    std::size_t failed = (std::numeric_limits<std::size_t>::max)(); // the last chart that had no place
    double room = 1; // the part of all charts' area that had a place, or would have had one if charts were larger
    std::int64_t work = 0;
  };

  // From now on packings are on a grid with about so many cells along its side.
  void use_grid(int cells);

  // Charts whose boxes have the largest size come first.
  template <typename Size>
  std::vector<std::size_t> sorted(Size size) const;

  // The largest scale between two ones, to a tolerance.
  double bisect(double low, double high, double tolerance, const std::function<bool()>& must_stop);

  // The same where the largest scale is expected near the lower one: steps become larger as long as there is room.
  void climb(double low, double high, double tolerance, const std::function<bool()>& must_stop);

  // Looks for plans near the best ones that allow a larger scale, for a quarter of the most work, and twice as long as the last gain took.
  double search(double low, const std::function<bool()>& must_stop);

  const Turned_figure& figure(Attempt& attempt, std::size_t c, int orientation) const;

  // Figures of the same class have boxes of nearly the same width and height.
  static constexpr int CLASSES_PER_OCTAVE = 16, BOX_CLASSES = 12 * CLASSES_PER_OCTAVE;
  static int box_class(const Cell_figure& figure);

  // Places all charts, if there is room.
  bool fits(Attempt& attempt, double scale, const std::function<bool()>& must_stop) const;

  // The same, and remembers what fits.
  bool fits(double scale, const std::function<bool()>& must_stop);

  void keep(double scale, Attempt& attempt);

  const std::vector<Chart_outline>& m_outlines;
  double m_distance;
  int m_orientations;
  bool m_turns_freely;
  std::int64_t m_most_work;
  Take_obstacles m_take_obstacles;
  double m_scale = -1;
  std::vector<Outline_place> m_places;
  Plan m_best;
  Attempt m_attempt;
  Cell_grid m_start; // without any chart
  double m_cells_per_side = 0, m_cell_distance = 0;
  std::vector<double> m_areas;
  double m_area = 0;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Outline_packer_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_OUTLINE_PACKER_H
