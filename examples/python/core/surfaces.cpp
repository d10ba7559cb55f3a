// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Functions on surfaces that hold no method: unwrapping, cutting, packing, and what is measured of a map.

#include "Joined_corners.h"
#include "Rows.h"
#include "Watch.h"
#include "account.h"
#include "functions.h"
#include "options.h"

#include <CGAL/Flip_free_maps/core/default_traits.h>
#include <CGAL/Flip_free_maps/cut_to_disk.h>
#include <CGAL/Flip_free_maps/internal/Disjoint_sets.h>
#include <CGAL/Flip_free_maps/is_bijective.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>
#include <CGAL/Flip_free_maps/pack_charts.h>
#include <CGAL/Flip_free_maps/unwrap.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace {

using Surface = FFM::internal::Triangle_surface;
using FFM::internal::Surface_edge;
using FFM::internal::Surface_face;
using FFM::internal::Surface_halfedge;
using FFM::internal::Surface_vertex;

const std::map<std::string, FFM::Cut_options::Branches> branches{{"none", FFM::Cut_options::Branches::none},
                                                                 {"extremities", FFM::Cut_options::Branches::extremities},
                                                                 {"curvature-peaks", FFM::Cut_options::Branches::curvature_peaks},
                                                                 {"farthest-points", FFM::Cut_options::Branches::farthest_points}};

FFM::Cut_options cut_options(const py::dict& options)
{
  FFM::Cut_options cut;
  std::string name = "extremities";
  read(options, "branches", name);
  cut.branches = branches.at(name);
  read(options, "target_energy", cut.target_energy);
  read(options, "number_of_points", cut.number_of_points);
  read(options, "join_borders", cut.join_borders);
  read(options, "cut_disks", cut.cut_disks);
  read(options, "feature_cost", cut.feature_cost);
  read(options, "crease_preference", cut.crease_preference);
  return cut;
}

FFM::Packing_options packing_options(const py::dict& options)
{
  FFM::Packing_options packing;
  read(options, "margin", packing.margin);
  read(options, "resolution", packing.resolution);
  read(options, "padding", packing.padding);
  read(options, "rotate", packing.rotate);
  return packing;
}

// Marks the edges that pairs of vertices name; `false`, and the summary says which, if there is no such edge.
template <typename Summary>
bool mark_edges(const Surface& surface, const Edges& edges, std::vector<char>& is_marked, Summary& summary)
{
  is_marked.assign(3 * surface.triangles().size(), 0);
  const std::size_t size = surface.number_of_vertices();
  for(const auto& pair : edges) {
    const std::int32_t h =
      surface.halfedge_between(FFM::internal::vertex_of_index(pair[0], size), FFM::internal::vertex_of_index(pair[1], size));
    if(h == Surface::NONE) {
      summary.status = FFM::Status::invalid_option;
      summary.message = "there is no edge from " + std::to_string(pair[0]) + " to " + std::to_string(pair[1]);
      return false;
    }
    is_marked[edge(Surface_halfedge{h}, surface)] = 1;
  }
  return true;
}

// The images of the corners of triangles, keyed by the halfedges to them.
template <typename Number>
struct Corner_map
{
  using key_type = Surface_halfedge;
  using value_type = std::array<Number, 2>;
  using reference = value_type;
  using category = boost::writable_property_map_tag;

  std::vector<std::array<value_type, 3>>* corners;

  friend void put(const Corner_map& map, Surface_halfedge h, const value_type& image)
  {
    (*map.corners)[h.number / 3][(h.number + 1) % 3] = image;
  }
};

// The images of vertices, for functions that ask for those of the corners of triangles. They are read as they were given, and
// written in another type.
template <typename Number>
struct Vertex_images
{
  using key_type = Surface_halfedge;
  using value_type = std::array<Number, 2>;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  const Surface* surface;
  const Planar_points* given;
  std::vector<value_type>* result;

  friend const std::array<double, 2>& get(const Vertex_images& map, Surface_halfedge h) { return (*map.given)[map.surface->target(h)]; }
  friend void put(const Vertex_images& map, Surface_halfedge h, const value_type& image) { (*map.result)[map.surface->target(h)] = image; }
};

// `welded` are the triangles with points that stand for others, if any do.
template <typename Number>
py::tuple unwrap_in(const Points& points, const Triangles& triangles, const std::vector<std::array<std::int64_t, 3>>& welded,
                    const Edges& seams, const Edges& features, FFM::Unwrap_options& options, const program::Method_choice& choice,
                    Watch& watch)
{
  FFM::Unwrap_summary summary;
  std::vector<std::array<std::array<Number, 2>, 3>> corners;
  std::vector<std::int64_t> charts;
  Joined_corners<Number> joined;
  {
    const py::gil_scoped_release unlocked;
    const auto run = [&] {
      Surface surface;
      summary.status = welded.empty() ? surface.load(points, triangles, summary.message) : surface.load(points, welded, summary.message);
      std::vector<char> is_seam, is_feature;
      if(summary.status != FFM::Status::success || !mark_edges(surface, seams, is_seam, summary) ||
         !mark_edges(surface, features, is_feature, summary))
        return;
      corners.resize(triangles.size());
      charts.resize(triangles.size());
      FFM::Flip_free_map_traits<> traits;
      set_limits(choice, traits.options);
      using FFM::internal::Array_map;
      summary = FFM::unwrap(surface, Corner_map<Number>{&corners}, options, traits,
                            FFM::parameters::face_chart_map(Array_map<std::int64_t>{&charts},
                                                            FFM::parameters::edge_is_feature_map(Array_map<char>{&is_feature}))
                              .edge_is_constrained_map(Array_map<char>{&is_seam}));
      if(summary.is_valid())
        joined.join(triangles, points.size(), corners);
    };
    FFM::internal::catch_out_of_memory(run, summary);
  }
  watch.raise();
  return py::make_tuple(array_of(joined.vertices), array_of(joined.faces), array_of(joined.uv), array_of(charts), account(summary));
}

template <typename Number>
py::tuple pack_in(const Triangles& triangles, const Planar_points& images, const FFM::Packing_options& options)
{
  std::vector<std::array<Number, 2>> result;
  FFM::Packing_summary summary;
  {
    const py::gil_scoped_release unlocked;
    const auto run = [&] {
      for(const auto& p : images)
        result.push_back({{static_cast<Number>(p[0]), static_cast<Number>(p[1])}});
      Surface surface;
      summary.status = surface.load(images, triangles, summary.message);
      if(summary.status == FFM::Status::success)
        summary = FFM::pack_charts(surface, Vertex_images<Number>{&surface, &images, &result}, options);
    };
    FFM::internal::catch_out_of_memory(run, summary);
  }
  return py::make_tuple(array_of(result), account(summary));
}

} // namespace

py::tuple unwrap(const py::array& points, const py::array& triangles, const py::array& representatives, const py::array& seams,
                 const py::array& features, const py::dict& given, bool is_single_precision, const py::object& progress)
{
  const Points p(points, "points");
  const Triangles t(triangles, "faces");
  const Edges s(seams, "seams"), f(features, "features");
  const Rows<std::int64_t, 1> of_points(representatives, "representatives");
  std::vector<std::array<std::int64_t, 3>> welded;
  if(of_points.size() == p.size() && p.size() > 0) {
    welded.assign(t.begin(), t.end());
    // Whoever reads the triangles refuses those that are out of range.
    for(auto& triangle : welded)
      for(auto& v : triangle)
        v = static_cast<std::size_t>(v) < p.size() ? of_points[v][0] : v;
  }
  FFM::Unwrap_options options;
  options.cut = cut_options(given);
  options.packing = packing_options(given);
  read(given, "pack", options.pack);
  read(given, "max_distortion", options.max_distortion);
  read(given, "crease_angle", options.crease_angle);
  read(given, "max_length", options.max_length);
  read(given, "time_limit", options.max_seconds);
  Watch watch(progress);
  options.observer = watch.observer<FFM::Unwrap_progress>();
  const program::Method_choice choice = method_choice(given);
  return is_single_precision ? unwrap_in<float>(p, t, welded, s, f, options, choice, watch)
                             : unwrap_in<double>(p, t, welded, s, f, options, choice, watch);
}

py::tuple pack(const py::array& triangles, const py::array& uv, const py::dict& given, bool is_single_precision)
{
  const Triangles t(triangles, "faces");
  const Planar_points images(uv, "uv");
  const FFM::Packing_options options = packing_options(given);
  return is_single_precision ? pack_in<float>(t, images, options) : pack_in<double>(t, images, options);
}

py::tuple cut_to_disk(const py::array& points, const py::array& triangles, const py::array& seams, const py::dict& given)
{
  const Points p(points, "points");
  const Triangles t(triangles, "faces");
  const Edges s(seams, "seams");
  const FFM::Cut_options options = cut_options(given);
  std::vector<std::array<std::int64_t, 2>> result(s.begin(), s.end());
  FFM::Cut_summary summary;
  {
    const py::gil_scoped_release unlocked;
    summary = FFM::cut_to_disk(p, t, result, FFM::parameters::cut_options(options));
  }
  return py::make_tuple(array_of(result), account(summary));
}

py::tuple cut_along(const py::array& triangles, std::int64_t number_of_points, const py::array& seams)
{
  const Triangles t(triangles, "faces");
  const Edges s(seams, "seams");
  std::vector<std::int64_t> vertices;
  std::vector<std::array<std::int64_t, 3>> faces(t.size());
  FFM::Outcome outcome(FFM::Status::success, "");
  {
    const py::gil_scoped_release unlocked;
    const auto run = [&] {
      Surface surface;
      // Connectivity is all that counts.
      const std::vector<std::array<double, 2>> anywhere(static_cast<std::size_t>(number_of_points), {{0, 0}});
      outcome.status = surface.load(anywhere, t, outcome.message);
      std::vector<char> is_seam;
      if(outcome.status != FFM::Status::success || !mark_edges(surface, s, is_seam, outcome))
        return;
      // Corner k of triangle f, number 3 f + k, is the source of the halfedge of that number.
      FFM::internal::Disjoint_sets corners(3 * t.size());
      for(std::int32_t h = 0; h < static_cast<std::int32_t>(3 * t.size()); ++h) {
        const std::int32_t o = surface.opposite(h);
        if(o < 0 || is_seam[edge(Surface_halfedge{h}, surface)])
          continue;
        corners.unite(h, surface.next(o));
        corners.unite(surface.next(h), o);
      }
      std::vector<std::int64_t> numbers(3 * t.size(), -1);
      for(std::size_t c = 0; c < numbers.size(); ++c) {
        std::int64_t& number = numbers[corners.root(static_cast<std::int32_t>(c))];
        if(number < 0) {
          number = static_cast<std::int64_t>(vertices.size());
          vertices.push_back(t[c / 3][c % 3]);
        }
        faces[c / 3][c % 3] = number;
      }
    };
    FFM::internal::catch_out_of_memory(run, outcome);
  }
  return py::make_tuple(array_of(vertices), array_of(faces), account(outcome));
}

py::tuple measure(const py::array& points, const py::array& triangles, const py::array& uv)
{
  const Points p(points, "points");
  const Triangles t(triangles, "faces");
  const Planar_points images(uv, "uv");
  FFM::Distortion_report report;
  {
    const py::gil_scoped_release unlocked;
    report = FFM::measure_distortion(p, t, images);
  }
  return account(report);
}

py::tuple is_bijective(const py::array& triangles, const py::array& uv)
{
  const Triangles t(triangles, "faces");
  const Planar_points images(uv, "uv");
  std::string message;
  bool answer = false;
  {
    const py::gil_scoped_release unlocked;
    answer = FFM::is_bijective(t, images, &message);
  }
  return py::make_tuple(answer, message);
}

// Points that are exactly the same become one; -0 is 0.
py::array weld(const py::array& points)
{
  const Points p(points, "points");
  std::vector<std::int64_t> result(p.size());
  {
    const py::gil_scoped_release unlocked;
    std::vector<std::int64_t> order(p.size());
    for(std::size_t i = 0; i < order.size(); ++i)
      order[i] = static_cast<std::int64_t>(i);
    // The smallest number of equal points comes first. NaN is left alone: each is a point of its own.
    const auto is_finite = [&](std::int64_t i) { return p[i] == p[i]; };
    const auto last = std::stable_partition(order.begin(), order.end(), is_finite);
    std::sort(order.begin(), last, [&](std::int64_t i, std::int64_t j) { return p[i] != p[j] ? p[i] < p[j] : i < j; });
    for(auto i = order.begin(); i != last; ++i)
      result[*i] = i != order.begin() && p[*i] == p[*(i - 1)] ? result[*(i - 1)] : *i;
    for(auto i = last; i != order.end(); ++i)
      result[*i] = *i;
  }
  return array_of<std::int64_t>(result, {static_cast<py::ssize_t>(result.size()), 1});
}

} // namespace python
