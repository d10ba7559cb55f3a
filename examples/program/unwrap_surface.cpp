// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "unwrap_surface.h"

#include "Edge_set.h"

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/unwrap.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

namespace program {

namespace {

using Single_precision_point = CGAL::Simple_cartesian<float>::Point_2;

// One object, its points numbered from 0.
struct Part
{
  std::vector<std::size_t> faces; // their numbers in the surface
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  Vertex_pairs seams;
  Corner_images images;
  FFM::Unwrap_summary summary;
};

std::vector<Part> parts_of(const Surface& surface, const Vertex_pairs& seams)
{
  std::map<std::size_t, std::vector<std::size_t>> faces;
  for(std::size_t i = 0; i < surface.objects.size(); ++i)
    faces[surface.objects[i]].push_back(i);
  std::vector<Part> parts;
  for(auto& [object, numbers] : faces) {
    Part part;
    part.faces = std::move(numbers);
    std::unordered_map<std::size_t, std::size_t> points;
    for(const std::size_t i : part.faces) {
      part.polygons.emplace_back();
      for(const std::size_t v : surface.polygons[i]) {
        const auto entry = points.emplace(v, part.points.size());
        if(entry.second)
          part.points.push_back(surface.points[v]);
        part.polygons.back().push_back(entry.first->second);
      }
    }
    if(!seams.empty())
      for(const auto& [v, w] : seams)
        if(points.count(v) > 0 && points.count(w) > 0)
          part.seams.emplace_back(points[v], points[w]);
    parts.push_back(std::move(part));
  }
  return parts;
}

template <typename Point>
FFM::Unwrap_summary unwrap(const Unwrap_request& request, const FFM::Unwrap_options& options, const std::vector<Kernel::Point_3>& points,
                           const std::vector<std::vector<std::size_t>>& polygons, const Vertex_pairs& seams, Corner_images& images)
{
  std::vector<std::vector<Point>> result(polygons.size());
  std::vector<char> is_pinned = request.is_pinned;
  is_pinned.resize(polygons.size(), 0);
  for(std::size_t i = 0; i < polygons.size(); ++i)
    if(is_pinned[i])
      for(const Image& image : images[i])
        result[i].push_back(FFM::internal::make_point_2<Point>(image[0], image[1]));
  const auto pinned = boost::make_iterator_property_map(is_pinned.begin(), boost::typed_identity_property_map<std::size_t>());
  const FFM::Unwrap_summary summary = FFM::unwrap(
    points, polygons, result,
    FFM::parameters::unwrap_options(
      options, FFM::parameters::map_traits(
                 request.traits, FFM::parameters::face_is_pinned_map(pinned, CGAL::parameters::edge_is_constrained_map(Edge_set(seams))))));
  if(!summary.is_valid())
    return summary;
  images.clear();
  for(const auto& corners : result) {
    images.emplace_back();
    for(const Point& p : corners)
      images.back().push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y())});
  }
  return summary;
}

// What adds up, and what can be said of all objects.
void add(const Part& part, FFM::Unwrap_summary& sum)
{
  const FFM::Unwrap_summary& summary = part.summary;
  const auto area = [](const FFM::Unwrap_summary& s) {
    double result = 0;
    for(const FFM::Chart_summary& chart : s.charts)
      result += chart.area;
    return result;
  };
  const double area_before = area(sum), area_added = area(summary);
  const auto add_count = [](std::int64_t& total, std::int64_t number) { total = (std::max)(total, std::int64_t(0)) + number; };
  if(area_before + area_added > 0)
    sum.energy = ((std::max)(sum.energy, 0.) * area_before + summary.energy * area_added) / (area_before + area_added);
  add_count(sum.faces, summary.faces);
  add_count(sum.flips, summary.flips);
  add_count(sum.seam_edges, summary.seam_edges);
  sum.seam_length = (std::max)(sum.seam_length, 0.) + summary.seam_length;
  sum.charts.insert(sum.charts.end(), summary.charts.begin(), summary.charts.end());
  for(const auto member :
      {&FFM::Unwrap_summary::splits_of_overlaps, &FFM::Unwrap_summary::splits_of_distortion, &FFM::Unwrap_summary::splits_of_length,
       &FFM::Unwrap_summary::splits_of_failures, &FFM::Unwrap_summary::splits_for_packing, &FFM::Unwrap_summary::joined_charts})
    sum.*member += summary.*member;
  for(const auto member : {&FFM::Unwrap_summary::cut_seconds, &FFM::Unwrap_summary::flatten_seconds, &FFM::Unwrap_summary::pack_seconds,
                           &FFM::Unwrap_summary::certify_seconds})
    sum.*member += summary.*member;
  sum.faces_without_area += summary.faces_without_area;
  for(const std::int64_t face : summary.first_faces_without_area)
    if(sum.first_faces_without_area.size() < 10)
      sum.first_faces_without_area.push_back(static_cast<std::int64_t>(part.faces[face]));
  sum.parted_edges += summary.parted_edges;
  sum.scale = sum.scale < 0 ? summary.scale : (std::min)(sum.scale, summary.scale);
  sum.cut.components += summary.cut.components;
  sum.cut.borders += summary.cut.borders;
  sum.cut.genus += summary.cut.genus;
  sum.cut.pieces += summary.cut.pieces;
  sum.cut.borders_of_pieces += summary.cut.borders_of_pieces;
  sum.cut.points += summary.cut.points;
  sum.cut.user_seam_edges += summary.cut.user_seam_edges;
  sum.cut.seam_edges += summary.cut.seam_edges;
  sum.cut.seam_length += summary.cut.seam_length;
  sum.cut.seconds += summary.cut.seconds;
}

// The points with each object in a cell of its own, in a cube of cells, so that objects touch nowhere.
std::vector<Kernel::Point_3> parted_points(const Surface& surface)
{
  std::map<std::size_t, CGAL::Bbox_3> boxes;
  std::vector<std::size_t> object_of(surface.points.size(), 0);
  for(std::size_t i = 0; i < surface.polygons.size(); ++i)
    for(const std::size_t v : surface.polygons[i]) {
      object_of[v] = surface.objects[i];
      boxes[surface.objects[i]] += surface.points[v].bbox();
    }
  double size = 0;
  for(const auto& entry : boxes)
    for(int c = 0; c < 3; ++c)
      size = (std::max)(size, entry.second.max(c) - entry.second.min(c));
  const std::size_t side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(boxes.size()))));
  std::map<std::size_t, std::size_t> cells;
  for(const auto& entry : boxes)
    cells.emplace(entry.first, cells.size());
  std::vector<Kernel::Point_3> points = surface.points;
  for(std::size_t v = 0; v < points.size(); ++v) {
    const auto box = boxes.find(object_of[v]);
    if(box == boxes.end())
      continue;
    const std::size_t cell = cells[object_of[v]];
    const std::array<std::size_t, 3> places{cell % side, cell / side % side, cell / side / side};
    std::array<double, 3> p;
    for(int c = 0; c < 3; ++c)
      p[c] = points[v][c] - box->second.min(c) + 2 * size * static_cast<double>(places[c]);
    points[v] = Kernel::Point_3(p[0], p[1], p[2]);
  }
  return points;
}

} // namespace

FFM::Unwrap_summary unwrap_surface(const Unwrap_request& request, const Surface& surface, const Vertex_pairs& seams, Corner_images& images)
{
  const auto unwrap_one = request.is_single_precision ? &unwrap<Single_precision_point> : &unwrap<Kernel::Point_2>;
  const bool has_several =
    std::any_of(surface.objects.begin(), surface.objects.end(), [&](std::size_t object) { return object != surface.objects[0]; });
  if(!has_several || !request.has_atlas_per_object)
    return unwrap_one(request, request.options, has_several && surface.are_objects_apart ? parted_points(surface) : surface.points,
                      surface.polygons, seams, images);

  const double begin = FFM::internal::wall_seconds();
  std::vector<Part> parts = parts_of(surface, seams);
  FFM::Unwrap_summary sum;
  sum.occupancy = 0;
  for(Part& part : parts) {
    FFM::Unwrap_options options = request.options;
    options.max_seconds = (std::max)(0., options.max_seconds - (FFM::internal::wall_seconds() - begin));
    part.summary = unwrap_one(request, options, part.points, part.polygons, part.seams, part.images);
    if(!part.summary.is_valid()) {
      sum = part.summary;
      sum.message += ", in the object " + FFM::internal::quoted_word(surface.object_names[surface.objects[part.faces[0]]]) +
                     ", whose first face is number " + std::to_string(part.faces[0]);
      return sum;
    }
    add(part, sum);
    sum.occupancy += part.summary.occupancy / static_cast<double>(parts.size());
  }
  sum.status = sum.cut.status = parts[0].summary.status;
  sum.message = sum.cut.message = parts[0].summary.message;
  sum.message += "; " + std::to_string(parts.size()) + " objects, each with an atlas";
  std::stable_sort(sum.charts.begin(), sum.charts.end(),
                   [](const FFM::Chart_summary& a, const FFM::Chart_summary& b) { return a.area > b.area; });
  sum.seconds = FFM::internal::wall_seconds() - begin;
  images.assign(surface.polygons.size(), {});
  for(Part& part : parts)
    for(std::size_t i = 0; i < part.faces.size(); ++i)
      images[part.faces[i]] = std::move(part.images[i]);
  return sum;
}

} // namespace program
