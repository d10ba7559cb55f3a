// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "number_files.h"

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace program {

namespace {

using Edge = std::pair<std::size_t, std::size_t>;

Edge make_edge(std::size_t v, std::size_t w) { return {(std::min)(v, w), (std::max)(v, w)}; }

// All edges in order.
Vertex_pairs edges_of(const Surface& surface)
{
  Vertex_pairs edges;
  for(const auto& polygon : surface.polygons)
    for(std::size_t k = 0; k < polygon.size(); ++k)
      edges.push_back(make_edge(polygon[k], polygon[(k + 1) % polygon.size()]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

} // namespace

std::vector<Number_row> read_number_rows(const std::string& path, std::size_t per_row)
{
  namespace internal = FFM::internal;
  std::string text, message;
  check(internal::read_whole_file(path, text, &message), message);
  std::vector<Number_row> rows;
  for(internal::Word_reader reader(text); !reader.at_end();) {
    rows.push_back({path + ", line " + std::to_string(reader.line()), {}});
    do {
      double value;
      check(internal::parse_number(reader.word(), value) == std::errc() && std::isfinite(value),
            rows.back().where + ": " + internal::quoted_word(reader.word()) + " is not a finite number");
      rows.back().numbers.push_back(value);
      reader.skip_word();
    } while(reader.is_line_continued());
    check(rows.back().numbers.size() == per_row,
          rows.back().where + ": " + std::to_string(per_row) + " numbers are expected, not " + std::to_string(rows.back().numbers.size()));
  }
  return rows;
}

namespace {

std::size_t number_of(const char* kind, const char* kinds, const Number_row& row, std::size_t k, std::size_t size)
{
  const double number = row.numbers[k];
  std::string text;
  FFM::internal::append_number(text, number);
  check(number >= 0 && number < static_cast<double>(size) && number == std::floor(number),
        row.where + " names the " + kind + " " + text + ", which does not exist: the mesh has " + std::to_string(size) + " " + kinds +
          ", numbered from 0");
  return static_cast<std::size_t>(number);
}

} // namespace

std::size_t vertex_of(const Number_row& row, std::size_t k, std::size_t number_of_vertices)
{
  return number_of("vertex", "vertices", row, k, number_of_vertices);
}

std::vector<char> read_pinned_faces(const std::string& path, const Surface& surface, const Atlas& atlas)
{
  std::vector<char> is_pinned(surface.polygons.size(), 0);
  if(path.empty())
    return is_pinned;
  for(const Number_row& row : read_number_rows(path, 1)) {
    const std::size_t face = number_of("face", "faces", row, 0, is_pinned.size());
    check(!surface.images[face].empty(), row.where + " names the face " + std::to_string(face) + ", which has no texture coordinates");
    is_pinned[face] = 1;
  }
  for(const std::vector<std::size_t>& island : islands(atlas))
    if(std::any_of(island.begin(), island.end(), [&](std::size_t triangle) { return is_pinned[atlas.polygons[triangle]]; }))
      for(const std::size_t triangle : island)
        is_pinned[atlas.polygons[triangle]] = 1;
  return is_pinned;
}

Vertex_pairs read_seams(const std::string& path, const Surface& surface)
{
  const Vertex_pairs edges = edges_of(surface);
  Vertex_pairs seams;
  for(const Number_row& row : read_number_rows(path, 2)) {
    seams.push_back(make_edge(vertex_of(row, 0, surface.points.size()), vertex_of(row, 1, surface.points.size())));
    check(std::binary_search(edges.begin(), edges.end(), seams.back()), row.where + ": there is no edge between these vertices");
  }
  return seams;
}

Vertex_pairs seams_of_images(const Surface& surface)
{
  // The images of the ends at the first polygon, those of the lower vertex first.
  std::map<Edge, std::pair<Image, Image>> first;
  Vertex_pairs seams;
  for(std::size_t i = 0; i < surface.polygons.size(); ++i) {
    const auto& polygon = surface.polygons[i];
    const auto& images = surface.images[i];
    for(std::size_t k = 0; k < images.size(); ++k) {
      const std::size_t next = (k + 1) % polygon.size();
      const bool is_rising = polygon[k] < polygon[next];
      const std::pair<Image, Image> ends(images[is_rising ? k : next], images[is_rising ? next : k]);
      const Edge edge = make_edge(polygon[k], polygon[next]);
      const auto entry = first.emplace(edge, ends);
      if(!entry.second && entry.first->second != ends)
        seams.push_back(edge);
    }
  }
  return seams;
}

Vertex_pairs repaired_seams(const Vertex_pairs& seams, const std::vector<Kernel::Point_3>& points, const Surface& repaired)
{
  std::map<Kernel::Point_3, std::vector<std::size_t>> vertices;
  for(std::size_t v = 0; v < repaired.points.size(); ++v)
    vertices[repaired.points[v]].push_back(v);
  const Vertex_pairs edges = edges_of(repaired);
  Vertex_pairs result;
  for(const Edge& seam : seams) {
    bool is_found = false;
    for(const std::size_t v : vertices[points[seam.first]])
      for(const std::size_t w : vertices[points[seam.second]])
        if(std::binary_search(edges.begin(), edges.end(), make_edge(v, w))) {
          result.push_back(make_edge(v, w));
          is_found = true;
        }
    check(is_found || points[seam.first] == points[seam.second],
          "the seam between the vertices " + std::to_string(seam.first) + " and " + std::to_string(seam.second) +
            " is no edge any more after --repair; without it, seams are cut as they are given");
  }
  return result;
}

} // namespace program
