// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACK_FLAT_CHARTS_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACK_FLAT_CHARTS_H

#include <CGAL/Flip_free_maps/atlas/Packing_options.h>
#include <CGAL/Flip_free_maps/atlas/internal/Outline_packer.h>
#include <CGAL/Flip_free_maps/atlas/internal/Rectangle_packer.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/domains/internal/write_positions.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/measure/internal/Border_curves.h>
#include <CGAL/Flip_free_maps/measure/internal/is_bijective_on_arrays.h>

#include <CGAL/Min_quadrilateral_traits_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A part of a surface that is mapped as a whole. Its vertices are numbered from 0.
struct Flat_chart
{
  std::vector<std::array<std::int32_t, 3>> elements;
  Positions<2> x;
  std::vector<std::int32_t> faces; // the elements' numbers in the mesh
};

// The direction of a side of the smallest rectangle around some points.
Vector<2> direction_of_smallest_box(const Positions<2>& x);

inline Vector<2> extent(const Positions<2>& x) { return x.rowwise().maxCoeff() - x.rowwise().minCoeff(); }

bool is_flip_free(const std::vector<std::array<std::int32_t, 3>>& elements, const Positions<2>& x);

double signed_area(const Flat_chart& chart, const Positions<2>& x);

// Rounds positions as a point type does.
template <typename Point>
Positions<2> as_rounded_by(const Positions<2>& x)
{
  Positions<2> rounded(2, x.cols());
  for(Eigen::Index v = 0; v < x.cols(); ++v) {
    const Point p = make_point_2<Point>(x(0, v), x(1, v));
    rounded.col(v) << CGAL::to_double(p[0]), CGAL::to_double(p[1]);
  }
  return rounded;
}

// The places of charts by their outlines, or those of their bounding boxes, whichever allow the larger scale.
std::vector<Outline_place> places_by_outlines(const std::vector<Flat_chart>& charts, const std::vector<Positions<2>>& turned,
                                              const Rectangle_packer& boxes, const Packing_options& options,
                                              const std::function<bool()>& must_stop, std::int64_t most_work, double& scale);

// A chart's positions about its centre, turned to its smallest box if it may be turned. Rounding is another one in the directions of
// further attempts.
Positions<2> turned_chart(const Positions<2>& x, bool may_turn, int attempt);

// How much of the unit square charts cover at least, by a first packing of many.
double expected_occupancy(const std::vector<Flat_chart>& charts, const Packing_options& options, const std::function<bool()>& must_stop);

// Moves charts without flips into the unit square: each turned, all scaled alike, apart by the margin. Whatever the charts had, no flips or no overlaps, they have afterwards, in the numbers that the point type can hold; or the status says
// otherwise and the charts stay as they are. `unrepresentable` receives the number of a chart that the point type is too coarse
// for.
template <typename Point>
void pack_flat_charts(std::vector<Flat_chart>& charts, const Packing_options& options, Packing_summary& summary,
                      std::size_t* unrepresentable = nullptr, const std::function<bool()>& must_stop = nullptr)
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
    was_bijective[c] = is_bijective(charts[c].elements, charts[c].x);
  }

  std::vector<Positions<2>> turned(charts.size());
  std::vector<std::array<double, 2>> sizes(charts.size());
  std::vector<int> attempts(charts.size(), options.rotate ? 0 : 1);
  std::vector<char> is_placed(charts.size(), 0);
  const int most_attempts = 8;
  const auto turn = [&](std::size_t c) {
    turned[c] = turned_chart(charts[c].x, options.rotate, attempts[c]);
    const Vector<2> size = extent(turned[c]);
    sizes[c] = {{size[0], size[1]}};
  };
  for(std::size_t c = 0; c < charts.size(); ++c)
    turn(c);

  std::vector<Positions<2>> placed(charts.size());
  for(bool is_done = false; !is_done;) {
    Rectangle_packer packer(sizes, options.distance());
    if(!packer.pack()) {
      summary.status = Status::invalid_option;
      summary.message = "the margin leaves no room for " + std::to_string(charts.size()) + " charts in the unit square";
      return;
    }
    const std::vector<Outline_place> places =
      places_by_outlines(charts, turned, packer, options, must_stop, Outline_packer::MOST_WORK, summary.scale);
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
      x = as_rounded_by<Point>(x);
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
  summary.occupancy = 0;
  for(std::size_t c = 0; c < charts.size(); ++c) {
    charts[c].x.swap(placed[c]);
    summary.occupancy += signed_area(charts[c], charts[c].x);
  }
  summary.status = deadline_status();
  summary.message = "the charts are in the unit square";
  if(summary.status != Status::success)
    summary.message += std::string(", but ") + Interruption(summary.status).what();
}

// Writes charts to a map that is keyed by corners: `corner_of(face, k)` gives the key.
template <typename HalfedgeUVMap, typename CornerOf>
void write_charts(const std::vector<Flat_chart>& charts, HalfedgeUVMap uv_map, CornerOf&& corner_of)
{
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  using boost::put; // for pointers
  for(const Flat_chart& chart : charts)
    for(std::size_t e = 0; e < chart.elements.size(); ++e)
      for(int k = 0; k < 3; ++k) {
        const auto p = chart.x.col(chart.elements[e][k]);
        put(uv_map, corner_of(chart.faces[e], k), make_point_2<Point>(p[0], p[1]));
      }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/pack_flat_charts_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_PACK_FLAT_CHARTS_H
