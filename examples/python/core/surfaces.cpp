// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Functions on surfaces that hold no method: unwrapping, cutting, packing, and what is measured of a map.

#include "../../program/Edge_set.h"
#include "Joined_corners.h"
#include "Polygons.h"
#include "Rows.h"
#include "Watch.h"
#include "account.h"
#include "functions.h"
#include "options.h"

#include <CGAL/Flip_free_maps/cut_to_disk.h>
#include <CGAL/Flip_free_maps/internal/Disjoint_sets.h>
#include <CGAL/Flip_free_maps/is_bijective.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/pack_charts.h>
#include <CGAL/Flip_free_maps/unwrap.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace {

using Surface = FFM::internal::Triangle_surface;
using FFM::internal::Surface_halfedge;

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
  read(options, "max_rounds", cut.max_rounds);
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
  is_marked.assign(surface.number_of_halfedges(), 0);
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

// Whether all edges are sides of polygons; the summary names the first that is none.
bool are_sides(const Polygons& polygons, const Edges& edges, FFM::Unwrap_summary& summary)
{
  std::set<std::pair<std::size_t, std::size_t>> missing;
  const auto key = [](std::size_t v, std::size_t w) { return std::make_pair((std::min)(v, w), (std::max)(v, w)); };
  for(const auto& edge : edges)
    missing.insert(key(edge[0], edge[1]));
  if(missing.empty())
    return true;
  for(const auto& polygon : polygons)
    for(std::size_t k = 0; k < polygon.size(); ++k)
      missing.erase(key(polygon[k], polygon[k + 1 == polygon.size() ? 0 : k + 1]));
  for(const auto& edge : edges)
    if(missing.count(key(edge[0], edge[1])) != 0) {
      summary.status = FFM::Status::invalid_option;
      summary.message = "there is no edge from " + std::to_string(edge[0]) + " to " + std::to_string(edge[1]);
      return false;
    }
  return true;
}

// Whether each face is pinned.
std::vector<char> flags_of(const Polygons::Numbers& numbers)
{
  std::vector<char> flags;
  for(const auto& number : numbers)
    flags.push_back(number[0] != 0);
  return flags;
}

auto by_number(const std::vector<char>& flags)
{
  return boost::make_iterator_property_map(flags.begin(), boost::typed_identity_property_map<std::size_t>());
}

template <typename Number>
py::tuple unwrap_in(const Points& points, const Polygons& polygons, const Edges& seams, const Edges& features,
                    const std::vector<char>& is_pinned, const Planar_points& images, const FFM::Unwrap_options& options,
                    const program::Method_choice& choice, Watch& watch)
{
  FFM::Unwrap_summary summary;
  std::vector<std::int64_t> charts;
  Joined_corners<Number> joined;
  {
    const py::gil_scoped_release unlocked;
    const auto run = [&] {
      if(!are_sides(polygons, seams, summary) || !are_sides(polygons, features, summary))
        return;
      // Pinned faces have images already.
      std::vector<std::vector<std::array<Number, 2>>> corners(images.size() > 0 ? polygons.size() : 0);
      for(std::size_t p = 0, c = 0; p < corners.size(); ++p)
        for(std::size_t k = 0; k < polygons[p].size(); ++k, ++c)
          corners[p].push_back({{static_cast<Number>(images[c][0]), static_cast<Number>(images[c][1])}});
      charts.resize(polygons.size());
      FFM::Map_options map_options;
      set_limits(choice, map_options);
      namespace parameters = FFM::parameters;
      const auto edge_maps =
        parameters::edge_is_feature_map(program::Edge_set(features), CGAL::parameters::edge_is_constrained_map(program::Edge_set(seams)));
      summary = FFM::unwrap(
        points, polygons, corners,
        parameters::unwrap_options(
          options, parameters::map_options(map_options, parameters::face_is_pinned_map(
                                                          by_number(is_pinned), parameters::face_chart_map(charts.data(), edge_maps)))));
      if(summary.is_valid())
        joined.join(polygons, points.size(), corners);
    };
    FFM::internal::catch_out_of_memory(run, summary);
  }
  watch.raise();
  return py::make_tuple(array_of(joined.vertices), array_of(joined.faces), array_of(joined.uv), array_of(charts), account(summary));
}

template <typename Number>
py::tuple pack_in(const Triangles& triangles, const Planar_points& images, const std::vector<char>& is_pinned,
                  const FFM::Packing_options& options)
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
        summary = FFM::pack_charts(surface, Vertex_images<Number>{&surface, &images, &result}, options,
                                   FFM::parameters::face_is_pinned_map(by_number(is_pinned)));
    };
    FFM::internal::catch_out_of_memory(run, summary);
  }
  return py::make_tuple(array_of(result), account(summary));
}

} // namespace

py::tuple unwrap(const py::array& points, const py::array& values, const py::array& offsets, const py::array& seams,
                 const py::array& features, const py::array& pinned, const py::array& images, const py::dict& given,
                 bool is_single_precision, const py::object& progress)
{
  const Points p(points, "points");
  const Polygons polygons(values, offsets);
  const Edges s(seams, "seams"), f(features, "features");
  const std::vector<char> is_pinned = flags_of(Polygons::Numbers(pinned, "pinned"));
  const Planar_points uv(images, "uv");
  FFM::Unwrap_options options;
  options.cut = cut_options(given);
  options.packing = packing_options(given);
  read(given, "pack", options.pack);
  read(given, "max_distortion", options.max_distortion);
  read(given, "max_stretch", options.max_stretch);
  read(given, "seam_angle", options.seam_angle);
  read(given, "crease_angle", options.crease_angle);
  read(given, "max_length", options.max_length);
  read(given, "min_occupancy", options.min_occupancy);
  read(given, "strict", options.strict);
  read(given, "time_limit", options.max_seconds);
  Watch watch(progress);
  options.observer = watch.observer<FFM::Unwrap_progress>();
  const program::Method_choice choice = method_choice(given);
  return is_single_precision ? unwrap_in<float>(p, polygons, s, f, is_pinned, uv, options, choice, watch)
                             : unwrap_in<double>(p, polygons, s, f, is_pinned, uv, options, choice, watch);
}

py::tuple pack(const py::array& triangles, const py::array& uv, const py::array& pinned, const py::dict& given, bool is_single_precision)
{
  const Triangles t(triangles, "faces");
  const Planar_points images(uv, "uv");
  const FFM::Packing_options options = packing_options(given);
  const std::vector<char> is_pinned = flags_of(Polygons::Numbers(pinned, "pinned"));
  return is_single_precision ? pack_in<float>(t, images, is_pinned, options) : pack_in<double>(t, images, is_pinned, options);
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

} // namespace python
