// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_flattener.h>
#include <CGAL/Flip_free_maps/atlas/internal/pack_flat_charts.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/for_each_index.h>
#include <CGAL/Flip_free_maps/internal/for_each_index_watched.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// From flat arrays of triangles to charts without overlaps.
class Chart_atlas : public Chart_flattener
{
public:
  using Chart_flattener::Chart_flattener;

  // Packs charts around these.
  void avoid(const Packing_obstacles& obstacles) { m_obstacles = obstacles; }

  // Otherwise the summary says what is wrong.
  bool has_valid_options();

  // Cuts, flattens, packs, and tests the atlas in the numbers of the result.
  bool run(const Rounding& rounded);

  // Says how it ended when all is done. An atlas that was cut short and is of no use is none.
  void finish();

protected:
  virtual bool has_valid_method(std::string& message) const = 0;

  // Whether pieces may be worked on at the same time.
  virtual bool is_parallel() const = 0;

private:
  // Does the same for each of the first pieces of a queue, which leave it, at the same time if there are threads. The results are in
  // the pieces' order, and effects are the caller's part, so that nothing depends on threads.
  template <typename Result, typename Work>
  std::vector<std::pair<Piece, Result>> work_on_some(std::deque<Piece>& queue, const Work& work)
  {
    // The numbers bound the memory for open pieces.
    const std::size_t most = is_parallel() ? MOST_PIECES : 1;
    std::vector<std::pair<Piece, Result>> done;
    for(std::size_t faces = 0; !queue.empty() && done.size() < most && faces < MOST_FACES; queue.pop_front()) {
      faces += queue.front().faces.size();
      done.emplace_back(std::move(queue.front()), Result());
    }
    m_charts_at_work = static_cast<int>(done.size());
    report_progress();
    const auto work_on_one = [&, binding = Deadline::state()](std::size_t i) {
      const Bound_work bound(binding);
      work(done[i].first, done[i].second);
    };
    if(m_options.observer)
      for_each_index_watched<CGAL::Parallel_tag>(done.size(), work_on_one, [this] { watch(); });
    else
      for_each_index<CGAL::Parallel_tag>(done.size(), work_on_one);
    return done;
  }

  // Cuts sharp edges and creases, makes charts of pieces that need no seam, and returns the faces of all others.
  std::vector<std::int32_t> keep_what_needs_no_seam(const std::vector<std::int32_t>& all);

  // Cuts pieces open, and describes the surface as a whole.
  void cut_open(const std::vector<std::int32_t>& faces);

  // Flattens some pieces of the queue, and keeps them as charts, cuts or splits them one by one. False when none of that is possible.
  bool process_some();

  // Joins small charts to their neighbors where that meets all bounds.
  void join_crumbs();

  // A small chart and a neighbor that it may be joined to, and what comes of it.
  struct Join
  {
    std::size_t crumb, neighbor;
    Seams seams;
    std::vector<Image> images; // that the faces had before
  };

  // The next ones, no chart in two of them; `trials` counts those of each chart.
  std::vector<Join> next_joins(std::vector<int>& trials) const;

  // Whether the map of a union is as good as that of the neighbor, and that of the crumb as the bounds allow.
  bool is_good_enough(const Join& join, const Piece& piece, const Flat_piece& flat) const;

  // For the observer a piece is a chart as soon as that is decided.
  void count_ahead(Flat_piece& flat);

  bool pack();

  // Charts in the units of the surface, side by side.
  void scale_back();

  // The last word on the numbers that the caller receives.
  bool certify();

  void say_how_it_ended();

  // Pieces at work at the same time, and their triangles.
  static constexpr std::size_t MOST_PIECES = 256, MOST_FACES = 100000;
  // What a crumb is: its polygons, and its part of the area of all and of its neighbor's; and the part of its sides that closing a seam
  // takes away.
  static constexpr std::int64_t MOST_CRUMB_FACES = 64;
  static constexpr double MOST_CRUMB_AREA = 0.01, MOST_OF_NEIGHBOR = 0.5, LEAST_CONTACT = 0.2;
  // Neighbors that are tried.
  static constexpr int MOST_TRIALS = 2;
  // The mean energy from which on an atlas that was cut short is of no use.
  static constexpr double WORST_ENERGY = 2;

  Rounding m_rounded;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Chart_atlas_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_H
