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
#include <CGAL/Flip_free_maps/atlas/internal/Packing_obstacles.h>
#include <CGAL/Flip_free_maps/atlas/internal/Rectangle_packer.h>
#include <CGAL/Flip_free_maps/atlas/internal/smallest_boxes.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/domains/internal/write_positions.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/measure/internal/Border_curves.h>
#include <CGAL/Flip_free_maps/measure/internal/is_bijective_on_arrays.h>

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

inline Vector<2> extent(const Positions<2>& x) { return x.rowwise().maxCoeff() - x.rowwise().minCoeff(); }

bool is_flip_free(const std::vector<std::array<std::int32_t, 3>>& elements, const Positions<2>& x);

double signed_area(const Flat_chart& chart, const Positions<2>& x);

// Rounds positions to the numbers of a result.
using Rounding = std::function<Positions<2>(const Positions<2>&)>;

// As a point type does.
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

// The places of charts by their outlines, or those of their bounding boxes in the largest square without obstacles, whichever allow
// the larger scale; none if there is no room. One chart has nothing but its box.
std::vector<Outline_place> chart_places(const std::vector<Flat_chart>& charts, const std::vector<Positions<2>>& turned,
                                        const Packing_options& options, const Packing_obstacles& obstacles,
                                        const std::function<bool()>& must_stop, std::int64_t most_work, double& scale);

// All triangles and the positions of all vertices as one.
Positions<2> joined_charts(const std::vector<Flat_chart>& charts, const std::vector<Positions<2>>& positions,
                           std::vector<std::array<std::int32_t, 3>>& elements);

// A chart's positions about its centre, turned to its smallest box if it may be turned, or to its smallest square if it is the only
// chart. Rounding is another one in the directions of further attempts.
Positions<2> turned_chart(const Positions<2>& x, bool may_turn, bool is_alone, int attempt);

// The most work of a search for better places, which grows with the number of triangles.
std::int64_t search_work(const std::vector<Flat_chart>& charts);

// How much of the unit square charts cover at least, by a first packing of many.
double expected_occupancy(const std::vector<Flat_chart>& charts, const Packing_options& options, const std::function<bool()>& must_stop);

// Moves charts without flips into the unit square: each turned, all scaled alike, apart by the margin from each other and from
// obstacles. Whatever the charts had, no flips or no overlaps, they have afterwards, in the numbers of the result; or the status says
// otherwise and the charts stay as they are. `unrepresentable` receives the number of a chart that these are too coarse for.
void pack_flat_charts(std::vector<Flat_chart>& charts, const Packing_options& options, const Packing_obstacles& obstacles,
                      const Rounding& rounded, Packing_summary& summary, std::size_t* unrepresentable = nullptr,
                      const std::function<bool()>& must_stop = nullptr);

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
