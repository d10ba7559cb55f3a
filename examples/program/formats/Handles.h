// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_HANDLES_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_HANDLES_H

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/*!
  Vertices and the places where they are to go.

  \tparam D dimension, 2 or 3
*/
template <int D>
struct Handles
{
  /// The vertices, by their columns in the positions that were given to `read_handles()`. No vertex occurs twice.
  std::vector<std::int32_t> vertices;

  /// Where the vertices go: column i is for `vertices[i]`.
  Positions<D> targets = Positions<D>(D, 0);
};

namespace internal {

// Answers which of the points that may be handles is nearest to a place, the first one of those at the same distance. Points are
// sorted along the first axis, and a search goes from the place to both sides until that axis alone is too far.
// Lengths are compared in units of their own magnitude, a power of two, since squares of tiny ones vanish.
template <int D>
class Nearest_point
{
public:
  explicit Nearest_point(const Positions<D>& points, const std::vector<bool>& may_be_handle = std::vector<bool>()) : m_points(points)
  {
    for(std::int32_t v = 0; v < points.cols(); ++v)
      if(may_be_handle.empty() || may_be_handle[v])
        m_order.push_back(v);
    m_magnitude = points.size() > 0 ? points.cwiseAbs().maxCoeff() : 0;
    std::sort(m_order.begin(), m_order.end(), [&points](std::int32_t a, std::int32_t b) { return points(0, a) < points(0, b); });
  }

  std::int32_t operator()(const Vector<D>& place) const
  {
    const std::size_t size = m_order.size();
    const std::size_t start =
      std::lower_bound(m_order.begin(), m_order.end(), place[0], [this](std::int32_t v, double x) { return m_points(0, v) < x; }) -
      m_order.begin();
    const double magnitude = (std::max)(m_magnitude, place.cwiseAbs().maxCoeff());
    const double unit = magnitude > 0 ? std::ldexp(1., -(std::max)(-1000, (std::min)(1000, std::ilogb(magnitude)))) : 1.;
    double least = std::numeric_limits<double>::infinity();
    std::int32_t nearest = -1;
    // Returns whether points further on may still be nearer.
    const auto visit = [&](std::int32_t v) {
      const Vector<D> way = unit * m_points.col(v) - unit * place;
      if(way[0] * way[0] > least)
        return false;
      const double distance = way.squaredNorm();
      if(nearest < 0 || distance < least || (distance == least && v < nearest)) {
        least = distance;
        nearest = v;
      }
      return true;
    };
    for(std::size_t i = start; i < size && visit(m_order[i]); ++i)
      ;
    for(std::size_t i = start; i > 0 && visit(m_order[i - 1]); --i)
      ;
    return nearest;
  }

private:
  const Positions<D>& m_points;
  std::vector<std::int32_t> m_order;
  double m_magnitude = 0;
};

template <int D>
class Handle_reader
{
public:
  Handle_reader(const Positions<D>& points, const std::vector<bool>& may_be_handle)
    : m_points(points), m_may_be_handle(may_be_handle), m_nearest(points, may_be_handle)
  {}

  // Returns the empty string, or what is wrong with the file.
  std::string read(std::string_view text)
  {
    Word_reader reader(text);
    while(!reader.at_end()) {
      const long long line = reader.line();
      m_words.clear();
      do {
        m_words.push_back(reader.word());
        reader.skip_word();
      } while(reader.is_line_continued());
      const std::string error = read_line(line);
      if(!error.empty())
        return "line " + std::to_string(line) + ": " + error;
    }
    if(m_vertices.empty())
      return "the file has no handle";
    return std::string();
  }

  Handles<D> handles() const
  {
    Handles<D> result;
    result.vertices = m_vertices;
    result.targets = Eigen::Map<const Positions<D>>(m_targets.data(), D, m_vertices.size());
    return result;
  }

private:
  // index x y [z], or x y [z] -> x' y' [z']
  std::string read_line(long long line)
  {
    Vector<D> target;
    std::int32_t vertex = -1;
    std::string error;
    if(m_words.size() == 2 * D + 1 && m_words[D] == "->") {
      Vector<D> place;
      error = read_place(0, place);
      if(error.empty())
        error = read_place(D + 1, target);
      if(error.empty())
        vertex = m_nearest(place);
    } else if(m_words.size() == D + 1) {
      long long index = -1;
      if(parse_number(m_words[0], index) != std::errc())
        return quoted_word(m_words[0]) + " is not the index of a vertex";
      if(index < 0 || index >= m_points.cols())
        return "vertex index " + std::to_string(index) + " is out of range, there are " + std::to_string(m_points.cols()) + " vertices";
      if(!m_may_be_handle.empty() && !m_may_be_handle[index])
        return "vertex " + std::to_string(index) + " is not a vertex of any element";
      vertex = static_cast<std::int32_t>(index);
      error = read_place(1, target);
    } else
      return std::string("expected 'index ") + (D == 2 ? "x y' or 'x y -> x y'" : "x y z' or 'x y z -> x y z'") + ", found " +
             std::to_string(m_words.size()) + " words";
    if(!error.empty())
      return error;

    const auto entry = m_lines.emplace(vertex, line);
    if(!entry.second)
      return "this is vertex " + std::to_string(vertex) + ", as in line " + std::to_string(entry.first->second);
    m_vertices.push_back(vertex);
    m_targets.insert(m_targets.end(), target.data(), target.data() + D);
    return std::string();
  }

  std::string read_place(std::size_t first_word, Vector<D>& place) const
  {
    for(int k = 0; k < D; ++k)
      if(parse_number(m_words[first_word + k], place[k]) != std::errc() || !std::isfinite(place[k]))
        return quoted_word(m_words[first_word + k]) + " is not a finite number";
    return std::string();
  }

  const Positions<D>& m_points;
  const std::vector<bool>& m_may_be_handle;
  const Nearest_point<D> m_nearest;
  std::vector<std::string_view> m_words;
  std::vector<std::int32_t> m_vertices;
  std::vector<double> m_targets;
  std::unordered_map<std::int32_t, long long> m_lines;
};

} // namespace internal

/*!
  reads handles, one per line, in one of two forms (with D coordinates, here for D = 3):

  - `index x y z`: the vertex with this index, from 0, goes to the place;
  - `x y z -> x' y' z'`: the vertex nearest to the first place goes to the second one. The first place itself is not constrained.
    Of several vertices at the least Euclidean distance it is the one with the lowest index.

  A number sign begins a comment. The locale has no influence. On average the cost of a line is far below that of visiting all
  vertices.

  \tparam D dimension, 2 or 3
  \param path name of the file
  \param points positions of the vertices, column v for the vertex with index v; only finite ones
  \param handles receives the handles, in the order of the lines; they are not changed if the file cannot be read
  \param message if not null, receives the reason of a failure with the number of the line, and the empty string on success
  \param may_be_handle empty, or for each vertex whether it may be a handle. Files of meshes may hold vertices of no element: these
         are counted, but a place never means them, and their indices are refused

  \returns `false` if the file cannot be opened or has no handle, if a line is not of one of the forms, an index is out of range or
           that of a vertex that may not be a handle, or two lines mean the same vertex

  \pre `may_be_handle` is empty, or has as many entries as `points` has columns
*/
template <int D>
bool read_handles(const std::string& path, const Positions<D>& points, Handles<D>& handles, std::string* message = nullptr,
                  const std::vector<bool>& may_be_handle = std::vector<bool>())
{
  if(points.cols() == 0 || (!may_be_handle.empty() && std::find(may_be_handle.begin(), may_be_handle.end(), true) == may_be_handle.end()))
    return internal::fail(message, "cannot read " + path + ": there are no vertices for handles");
  std::string text;
  if(!internal::read_whole_file(path, text, message))
    return false;
  internal::Handle_reader<D> reader(points, may_be_handle);
  const std::string error = reader.read(text);
  if(!error.empty())
    return internal::fail(message, "cannot read " + path + ": " + error);
  handles = reader.handles();
  return internal::succeed(message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_HANDLES_H
