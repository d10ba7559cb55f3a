// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACK_FLAT_CHARTS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACK_FLAT_CHARTS_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/pack_flat_charts.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool is_flip_free(const std::vector<std::array<std::int32_t, 3>>& elements, const Positions<2>& x)
{
  for(const auto& element : elements)
    if(!is_positively_oriented<Exact_kernel>(element, x))
      return false;
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE double signed_area(const Flat_chart& chart, const Positions<2>& x)
{
  double area = 0;
  for(const auto& v : chart.elements) {
    Matrix<2> edges;
    edges << x.col(v[1]) - x.col(v[0]), x.col(v[2]) - x.col(v[0]);
    area += 0.5 * edges.determinant();
  }
  return area;
}

CGAL_FLIP_FREE_MAPS_INLINE Positions<2> joined_charts(const std::vector<Flat_chart>& charts, const std::vector<Positions<2>>& positions,
                                                      std::vector<std::array<std::int32_t, 3>>& elements)
{
  Eigen::Index size = 0;
  for(const Positions<2>& x : positions)
    size += x.cols();
  Positions<2> all(2, size);
  size = 0;
  for(std::size_t c = 0; c < charts.size(); ++c) {
    const std::int32_t first = static_cast<std::int32_t>(size);
    for(const auto& v : charts[c].elements)
      elements.push_back({{first + v[0], first + v[1], first + v[2]}});
    all.middleCols(size, positions[c].cols()) = positions[c];
    size += positions[c].cols();
  }
  return all;
}

CGAL_FLIP_FREE_MAPS_INLINE Positions<2> turned_chart(const Positions<2>& x, bool may_turn, bool is_alone, int attempt)
{
  const Positions<2> centered = x.colwise() - x.rowwise().mean().eval();
  Vector<2> direction(1, 0);
  if(attempt != 1 && may_turn)
    direction = is_alone ? direction_of_smallest_square(centered) : direction_of_smallest_box(centered);
  if(attempt > 1) {
    const double angle = 1e-3 * (attempt - 1);
    direction = (direction + angle * Vector<2>(-direction[1], direction[0])).normalized();
  }
  if(direction == Vector<2>(1, 0))
    return centered;
  Matrix<2> rotation;
  rotation << direction[0], direction[1], -direction[1], direction[0];
  return rotation * centered;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Outline_place> chart_places(const std::vector<Flat_chart>& charts,
                                                                   const std::vector<Positions<2>>& turned, const Packing_options& options,
                                                                   const Packing_obstacles& obstacles,
                                                                   const std::function<bool()>& must_stop, std::int64_t most_work,
                                                                   double& scale)
{
  // Charts as small as cells hardly have dents for others; and large distances leave none.
  const std::size_t most_charts = 20000;
  const double largest_distance = 0.05;
  std::vector<Outline_place> places;
  scale = 0;
  const Packing_obstacles::Square room = obstacles.largest_square(options.distance());
  if(room.side > 0) {
    std::vector<std::array<double, 2>> sizes;
    for(const Positions<2>& x : turned) {
      const Vector<2> size = extent(x);
      sizes.push_back({{size[0], size[1]}});
    }
    Rectangle_packer boxes(sizes, options.distance() / room.side);
    if(boxes.pack()) {
      for(const Rectangle_place& place : boxes.places())
        places.push_back({room.lower_left[0] + room.side * place.x, room.lower_left[1] + room.side * place.y, place.is_turned ? 0. : 1.,
                          place.is_turned ? 1. : 0.});
      scale = room.side * boxes.scale();
    }
  }
  // Between obstacles there may be room where the largest square has none.
  const bool is_open = obstacles.empty();
  const bool are_boxes_enough = places.empty() || charts.size() == 1 || options.distance() > largest_distance;
  if((is_open && are_boxes_enough) || charts.size() > most_charts)
    return places;
  double area = 0;
  std::vector<Chart_outline> outlines(charts.size());
  for(std::size_t c = 0; c < charts.size(); ++c) {
    area += signed_area(charts[c], turned[c]);
    Border_curves border;
    if(!border.load(charts[c].elements, static_cast<std::int32_t>(turned[c].cols())))
      return places;
    const Eigen::Index n = static_cast<Eigen::Index>(border.edges().size());
    outlines[c].sources.resize(2, n);
    outlines[c].targets.resize(2, n);
    for(Eigen::Index i = 0; i < n; ++i) {
      outlines[c].sources.col(i) = turned[c].col(border.edges()[i].source);
      outlines[c].targets.col(i) = turned[c].col(border.edges()[i].target);
    }
  }
  // In the square that is left within the sides' margin.
  const double side = 1 - options.distance();
  const int orientations = !options.rotate || charts.size() > 256 ? 4 : charts.size() > 32 ? 8 : 16;
  const Outline_packer::Take_obstacles take_obstacles = [&](Cell_grid& grid, double cells_per_side, double distance) {
    obstacles.take(grid, Vector<2>::Constant(options.distance() / 2), cells_per_side / side, distance);
  };
  Outline_packer packer(outlines, options.distance() / side, orientations, options.rotate, most_work,
                        is_open ? Outline_packer::Take_obstacles() : take_obstacles);
  const double largest_scale = std::sqrt(1 / area), least_scale = 1e-4 * largest_scale;
  if(packer.pack(scale > 0 ? scale / side : least_scale, largest_scale,
                 [&must_stop] { return (must_stop && must_stop()) || deadline_status() != Status::success; })) {
    scale = packer.scale() * side;
    places = packer.places();
    for(Outline_place& place : places) {
      place.x = options.distance() / 2 + place.x * side;
      place.y = options.distance() / 2 + place.y * side;
    }
  }
  return places;
}

CGAL_FLIP_FREE_MAPS_INLINE std::int64_t search_work(const std::vector<Flat_chart>& charts)
{
  const std::int64_t least = Outline_packer::MOST_WORK / 24, work_of_triangle = Outline_packer::MOST_WORK / 10000;
  std::int64_t work = 0;
  for(const Flat_chart& chart : charts)
    work += work_of_triangle * static_cast<std::int64_t>(chart.elements.size());
  return (std::min)(Outline_packer::MOST_WORK, (std::max)(least, work));
}

CGAL_FLIP_FREE_MAPS_INLINE double expected_occupancy(const std::vector<Flat_chart>& charts, const Packing_options& options,
                                                     const std::function<bool()>& must_stop)
{
  std::vector<Positions<2>> turned;
  double area = 0;
  for(const Flat_chart& chart : charts) {
    turned.push_back(turned_chart(chart.x, options.rotate, charts.size() == 1, 0));
    area += signed_area(chart, chart.x);
  }
  double scale;
  chart_places(charts, turned, options, Packing_obstacles(), must_stop, 0, scale);
  // The search and the finer grid add so much, in the median over many atlases; but nothing to one chart, which is to compare with several.
  const double gain = 1.05;
  return area * scale * scale / (charts.size() > 1 ? 1 : gain);
}

CGAL_FLIP_FREE_MAPS_INLINE void pack_flat_charts(std::vector<Flat_chart>& charts, const Packing_options& options,
                                                 const Packing_obstacles& obstacles, const Rounding& rounded, Packing_summary& summary,
                                                 std::size_t* unrepresentable, const std::function<bool()>& must_stop)
{
  summary.charts = static_cast<int>(charts.size());
  if(!options.is_valid(&summary.message)) {
    summary.status = Status::invalid_option;
    return;
  }
  std::vector<char> was_bijective(charts.size());
  for(std::size_t c = 0; c < charts.size(); ++c) {
    if(!charts[c].x.allFinite() || !is_flip_free(charts[c].elements, charts[c].x)) {
      summary.status = charts[c].x.allFinite() ? Status::start_not_flip_free : Status::non_finite_input;
      summary.message = "chart number " + std::to_string(c) + " has flipped triangles or coordinates that are not finite";
      return;
    }
    const Unbound_work certificate;
    was_bijective[c] = is_bijective(charts[c].elements, charts[c].x);
  }

  std::vector<Positions<2>> turned(charts.size());
  std::vector<int> attempts(charts.size(), options.rotate ? 0 : 1);
  std::vector<char> is_placed(charts.size(), 0);
  const int most_attempts = 8;
  const bool is_alone = charts.size() == 1 && obstacles.empty();
  const auto turn = [&](std::size_t c) { turned[c] = turned_chart(charts[c].x, options.rotate, is_alone, attempts[c]); };
  for(std::size_t c = 0; c < charts.size(); ++c)
    turn(c);

  std::vector<Positions<2>> placed(charts.size());
  for(bool is_done = false; !is_done;) {
    const std::vector<Outline_place> places =
      chart_places(charts, turned, options, obstacles, must_stop, search_work(charts), summary.scale);
    if(places.empty()) {
      summary.status = Status::invalid_option;
      summary.message = obstacles.empty() ? "the margin leaves" : "the margin and what is pinned leave";
      summary.message += " no room for " + std::to_string(charts.size()) + " charts in the unit square";
      return;
    }
    is_done = true;
    const Unbound_work certificate;
    for(std::size_t c = 0; c < charts.size(); ++c) {
      const Outline_place& place = places[c];
      Matrix<2> rotation;
      rotation << place.cosine, -place.sine, place.sine, place.cosine;
      Positions<2> x = rotation * turned[c];
      x.colwise() -= x.rowwise().minCoeff().eval();
      x *= summary.scale;
      x.colwise() += Vector<2>(place.x, place.y);
      x = rounded(x);
      if(was_bijective[c] ? is_bijective(charts[c].elements, x) : is_flip_free(charts[c].elements, x)) {
        placed[c].swap(x);
        continue;
      }
      is_done = false;
      if(++attempts[c] == most_attempts) {
        summary.status = Status::result_not_representable;
        summary.message =
          "triangles of chart number " + std::to_string(c) + " are too small within the unit square for the number type of the result";
        if(unrepresentable != nullptr)
          *unrepresentable = c;
        return;
      }
      turn(c);
    }
  }
  if(!obstacles.empty()) {
    std::vector<std::array<std::int32_t, 3>> elements;
    const Positions<2> all = joined_charts(charts, placed, elements);
    if(obstacles.are_touched(elements, all)) {
      summary.status = Status::result_not_representable;
      summary.message = "charts cannot be kept apart from what is pinned in the number type of the result";
      return;
    }
  }
  summary.occupancy = obstacles.area();
  for(std::size_t c = 0; c < charts.size(); ++c) {
    charts[c].x.swap(placed[c]);
    summary.occupancy += signed_area(charts[c], charts[c].x);
  }
  summary.status = deadline_status();
  summary.message = "the charts are in the unit square";
  if(summary.status != Status::success)
    summary.message += std::string(", but ") + Interruption(summary.status).what();
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACK_FLAT_CHARTS_IMPL_H
