// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_PROGRESSIVE_DISK_IMPL_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_PROGRESSIVE_DISK_IMPL_H

#include <CGAL/Flip_free_maps/initializers/internal/Progressive_disk.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Flat_lists::Flat_lists(const std::vector<std::array<std::int32_t, 3>>& elements, std::int32_t number_of_vertices)
  : m_places(number_of_vertices)
{
  for(const auto& element : elements)
    for(std::int32_t v : element)
      ++m_places[v].capacity;
  std::int64_t begin = 0;
  for(Place& place : m_places) {
    place.begin = begin;
    begin += place.capacity;
  }
  m_numbers.reserve(2 * begin);
  m_numbers.resize(begin);
  for(std::size_t e = 0; e < elements.size(); ++e)
    for(std::int32_t v : elements[e])
      push_back(v, static_cast<std::int32_t>(e));
}

CGAL_FLIP_FREE_MAPS_INLINE void Flat_lists::push_back(std::int32_t v, std::int32_t number)
{
  Place& place = m_places[v];
  if(place.size == place.capacity) {
    const std::int64_t begin = static_cast<std::int64_t>(m_numbers.size());
    place.capacity = 2 * place.capacity + 2;
    m_numbers.resize(begin + place.capacity);
    std::copy_n(m_numbers.begin() + place.begin, place.size, m_numbers.begin() + begin);
    place.begin = begin;
  }
  m_numbers[place.begin + place.size++] = number;
}

CGAL_FLIP_FREE_MAPS_INLINE void Flat_lists::erase(std::int32_t v, std::int32_t number)
{
  Place& place = m_places[v];
  const auto first = m_numbers.begin() + place.begin;
  --place.size;
  *std::find(first, first + place.size, number) = first[place.size];
}

CGAL_FLIP_FREE_MAPS_INLINE Progressive_disk::Progressive_disk(const Simplicial_domain<2>& domain)
  : m_points(domain.rest_points),
    m_triangles(domain.elements),
    m_is_awake(domain.elements.size(), 1),
    m_stars(domain.elements, domain.number_of_vertices),
    m_next(domain.number_of_vertices, -1),
    m_previous(domain.number_of_vertices, -1),
    m_target(domain.number_of_vertices, -1),
    m_loop(domain.number_of_vertices, -1),
    m_number_of_triangles(domain.number_of_elements())
{
  add_loop(domain.border);
  for(const auto& hole : domain.holes)
    add_loop(hole);
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Progressive_disk::take_pass()
{
  std::vector<std::int32_t> pass = std::move(m_passes.back());
  m_passes.pop_back();
  return pass;
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Progressive_disk::restore(std::int32_t v)
{
  const std::int32_t w = m_target[v];
  m_target[v] = -1;
  for(std::int32_t i = 0; i < m_stars.size(v); ++i) {
    const std::int32_t t = m_stars.number(v, i);
    Triangle& triangle = m_triangles[t];
    if(!m_is_awake[t]) {
      m_is_awake[t] = 1;
      ++m_number_of_triangles;
      for(std::int32_t u : triangle)
        if(u != v)
          m_stars.push_back(u, t);
    } else {
      std::replace(triangle.begin(), triangle.end(), w, v);
      m_stars.erase(w, t);
    }
  }
  if(is_on_border(v)) {
    ++m_loop_sizes[m_loop[v]];
    m_next[m_previous[v]] = v;
    m_previous[m_next[v]] = v;
  }
  return w;
}

CGAL_FLIP_FREE_MAPS_INLINE void Progressive_disk::remove(std::int32_t v, std::int32_t w)
{
  m_target[v] = w;
  for(std::int32_t i = 0; i < m_stars.size(v); ++i) {
    const std::int32_t t = m_stars.number(v, i);
    Triangle& triangle = m_triangles[t];
    if(std::find(triangle.begin(), triangle.end(), w) != triangle.end()) {
      m_is_awake[t] = 0;
      --m_number_of_triangles;
      for(std::int32_t u : triangle)
        if(u != v)
          m_stars.erase(u, t);
    } else {
      std::replace(triangle.begin(), triangle.end(), v, w);
      m_stars.push_back(w, t);
    }
  }
  if(is_on_border(v)) {
    --m_loop_sizes[m_loop[v]];
    m_next[m_previous[v]] = m_next[v];
    m_previous[m_next[v]] = m_previous[v];
  }
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Progressive_disk::neighbors_while_removed(std::int32_t v) const
{
  std::vector<std::int32_t> result{m_target[v]};
  for(std::int32_t t : m_stars[v])
    for(std::int32_t u : m_triangles[t])
      if(u != v)
        result.push_back(u);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE Simplicial_domain<2> Progressive_disk::domain(std::vector<std::int32_t>& vertices) const
{
  Simplicial_domain<2> result;
  std::vector<std::int32_t> numbers(m_target.size(), -1);
  vertices.clear();
  double total = 0;
  for(std::size_t t = 0; t < m_triangles.size(); ++t) {
    if(!m_is_awake[t])
      continue;
    Triangle element;
    for(int k = 0; k < 3; ++k) {
      const std::int32_t v = m_triangles[t][k];
      if(numbers[v] < 0) {
        numbers[v] = static_cast<std::int32_t>(vertices.size());
        vertices.push_back(v);
      }
      element[k] = numbers[v];
    }
    Matrix<2> rest_inverse = Matrix<2>::Zero();
    double area = 0;
    planar_rest_shape(m_points.col(m_triangles[t][0]), m_points.col(m_triangles[t][1]), m_points.col(m_triangles[t][2]), rest_inverse,
                      area);
    result.elements.push_back(element);
    result.rest_inverses.push_back(rest_inverse);
    result.measures.push_back(area);
    total += area;
  }
  const double length = std::sqrt(total);
  for(auto& rest_inverse : result.rest_inverses)
    rest_inverse *= length;
  for(double& measure : result.measures)
    measure /= total;
  result.number_of_vertices = static_cast<std::int32_t>(vertices.size());
  result.scale = length;

  std::vector<std::int32_t> first(m_loop_sizes.size(), -1);
  for(std::size_t v = m_loop.size(); v-- > 0;)
    if(m_loop[v] >= 0 && m_target[v] < 0)
      first[m_loop[v]] = static_cast<std::int32_t>(v);
  result.holes.resize(first.size() - 1);
  for(std::size_t l = 0; l < first.size(); ++l) {
    std::vector<std::int32_t>& loop = l == 0 ? result.border : result.holes[l - 1];
    std::int32_t v = first[l];
    do {
      loop.push_back(numbers[v]);
      if(l == 0)
        result.border_lengths.push_back((m_points.col(m_next[v]) - m_points.col(v)).norm() / length);
      v = m_next[v];
    } while(v != first[l]);
  }
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE void Progressive_disk::add_loop(const std::vector<std::int32_t>& loop)
{
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const std::int32_t v = loop[i], w = loop[(i + 1) % loop.size()];
    m_next[v] = w;
    m_previous[w] = v;
    m_loop[v] = static_cast<std::int32_t>(m_loop_sizes.size());
  }
  m_loop_sizes.push_back(loop.size());
}

CGAL_FLIP_FREE_MAPS_INLINE void Progressive_disk::sort_by_cost(std::vector<Collapse>& collapses)
{
  constexpr int SHIFT = 18;
  const auto key = [](const Collapse& collapse) {
    std::uint32_t bits;
    std::memcpy(&bits, &collapse.cost, sizeof(bits));
    return bits >> SHIFT;
  };
  std::vector<std::size_t> places((std::uint32_t(1) << (32 - SHIFT)) + 1, 0);
  for(const Collapse& collapse : collapses)
    ++places[key(collapse) + 1];
  std::partial_sum(places.begin(), places.end(), places.begin());
  std::vector<Collapse> sorted(collapses.size());
  for(const Collapse& collapse : collapses)
    sorted[places[key(collapse)]++] = collapse;
  collapses.swap(sorted);
}

CGAL_FLIP_FREE_MAPS_INLINE void Progressive_disk::mark_star(std::int32_t v, std::vector<char>& is_marked) const
{
  for(std::int32_t t : m_stars[v])
    for(std::int32_t u : m_triangles[t])
      is_marked[u] = 1;
}

CGAL_FLIP_FREE_MAPS_INLINE void Progressive_disk::guess(Collapse& collapse) const
{
  const std::int32_t v = collapse.v;
  const Vector<3> p = m_points.col(v);
  const Flat_lists::List star = m_stars[v];
  double least = std::numeric_limits<double>::infinity();
  collapse.cost = std::numeric_limits<float>::infinity();
  if(star.size() >= LARGEST_VALENCE)
    return;
  std::array<Vector<3>, LARGEST_VALENCE> edges;
  std::array<std::int32_t, LARGEST_VALENCE> ends;
  std::size_t n = 0;
  Vector<3> sum = Vector<3>::Zero(), squares = Vector<3>::Zero(), products = Vector<3>::Zero();
  for(std::int32_t t : star) {
    const Triangle& triangle = m_triangles[t];
    const int k = triangle[0] == v ? 0 : triangle[1] == v ? 1 : 2;
    ends[n] = triangle[(k + 1) % 3];
    const Vector<3> a = edges[n] = m_points.col(ends[n]) - p, b = m_points.col(triangle[(k + 2) % 3]) - p, normal = a.cross(b);
    ++n;
    sum += normal;
    squares += normal.cwiseProduct(normal);
    products += Vector<3>(normal[1] * normal[2], normal[2] * normal[0], normal[0] * normal[1]);
  }
  // All triangles count as if they were equally large.
  const double area = sum.norm(), factor = area > 0 ? n / area : 0;
  const auto consider = [&](std::int32_t w, const Vector<3>& edge) {
    const double length = edge.squaredNorm();
    const double distances = squares.dot(edge.cwiseProduct(edge)) +
                             2 * (products[0] * edge[1] * edge[2] + products[1] * edge[2] * edge[0] + products[2] * edge[0] * edge[1]);
    const double cost = factor * distances + 1e-3 * length * (area + length);
    if(cost < least) {
      least = cost;
      collapse.w = w;
    }
  };
  if(is_on_border(v)) {
    const Vector<3> next = m_points.col(m_next[v]) - p, previous = m_points.col(m_previous[v]) - p;
    consider(m_next[v], next);
    consider(m_previous[v], previous);
    least += next.cross(previous).squaredNorm();
  } else {
    for(std::size_t i = 0; i < n; ++i)
      consider(ends[i], edges[i]);
  }
  collapse.cost = static_cast<float>((std::max)(least, 0.));
}

CGAL_FLIP_FREE_MAPS_INLINE void Progressive_disk::judge(Collapse& collapse, const Limits& limits) const
{
  const std::int32_t v = collapse.v;
  if(collapse.w < 0)
    return;
  Corners corners;
  load_corners(v, corners);
  double least = std::numeric_limits<double>::infinity();
  if(collapse_cost(v, collapse.w, limits, corners, least) < least && is_possible(v, collapse.w))
    return;
  collapse.w = -1;
  const auto consider = [&](std::int32_t w) {
    const double cost = collapse_cost(v, w, limits, corners, least);
    if(cost < least && is_possible(v, w)) {
      least = cost;
      collapse.w = w;
    }
  };
  if(is_on_border(v)) {
    consider(m_next[v]);
    consider(m_previous[v]);
  } else {
    for(const Corner& corner : corners)
      consider(corner.number_a);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Progressive_disk::load_corners(std::int32_t v, Corners& corners) const
{
  corners.size = 0;
  const Vector<3> p = m_points.col(v);
  for(std::int32_t t : m_stars[v]) {
    const Triangle& triangle = m_triangles[t];
    const int k = triangle[0] == v ? 0 : triangle[1] == v ? 1 : 2;
    Corner& corner = corners.data[corners.size++];
    corner.number_a = triangle[(k + 1) % 3];
    corner.number_b = triangle[(k + 2) % 3];
    corner.a = m_points.col(corner.number_a);
    corner.b = m_points.col(corner.number_b);
    corner.normal = (corner.a - p).cross(corner.b - p);
    corner.normal_length = corner.normal.norm();
    corner.squared_side = (corner.b - corner.a).squaredNorm();
  }
}

CGAL_FLIP_FREE_MAPS_INLINE double Progressive_disk::collapse_cost(std::int32_t v, std::int32_t w, const Limits& limits,
                                                                  const Corners& corners, double bound) const
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Vector<3> p = m_points.col(v), q = m_points.col(w);
  const double length = (q - p).squaredNorm();
  double cost = 0, area = 0;
  for(const Corner& corner : corners) {
    if(corner.number_a == w || corner.number_b == w)
      continue;
    const Vector<3> x = corner.a - q, y = corner.b - q, after = x.cross(y);
    const double after_length = after.norm();
    const double longest = (std::max)({x.squaredNorm(), y.squaredNorm(), corner.squared_side});
    if(!(after_length >= limits.least_quality * longest) ||
       !(corner.normal.dot(after) >= limits.least_cosine * corner.normal_length * after_length))
      return infinity;
    const double distance = after.dot(p - corner.a) / after_length;
    cost += after_length * distance * distance;
    area += after_length;
    if(cost > bound)
      return infinity;
  }
  if(is_on_border(v)) {
    const std::int32_t u = w == m_next[v] ? m_previous[v] : m_next[v];
    const Vector<3> side = m_points.col(u) - q, offset = p - q;
    const double along = side.squaredNorm() > 0 ? offset.dot(side) / side.squaredNorm() : 0;
    cost += (offset - along * side).squaredNorm() * (side.squaredNorm() + length);
  }
  return cost + 1e-3 * length * (area + length);
}

CGAL_FLIP_FREE_MAPS_INLINE std::int32_t Progressive_disk::next_in(std::int32_t t, std::int32_t v) const
{
  const Triangle& triangle = m_triangles[t];
  return triangle[0] == v ? triangle[1] : triangle[1] == v ? triangle[2] : triangle[0];
}

CGAL_FLIP_FREE_MAPS_INLINE bool Progressive_disk::is_possible(std::int32_t v, std::int32_t w) const
{
  const bool on_border = is_on_border(v);
  if(on_border && ((w != m_next[v] && w != m_previous[v]) || m_loop_sizes[m_loop[v]] <= 4))
    return false;
  if(m_stars[v].size() + m_stars[w].size() > LARGEST_VALENCE)
    return false;
  std::array<std::int32_t, LARGEST_VALENCE + 2> ring;
  auto end = ring.begin();
  for(std::int32_t t : m_stars[w])
    *end++ = next_in(t, w);
  if(is_on_border(w)) {
    *end++ = m_next[w];
    *end++ = m_previous[w];
  }
  int common = 0;
  const auto is_too_close = [&](std::int32_t u) {
    if(u == w || std::find(ring.begin(), end, u) == end)
      return false;
    ++common;
    return m_stars[u].size() < (is_on_border(u) ? 2u : 4u);
  };
  bool meets_next = false, meets_previous = false;
  for(std::int32_t t : m_stars[v]) {
    const std::int32_t u = next_in(t, v);
    meets_next = meets_next || u == m_next[v];
    meets_previous = meets_previous || u == m_previous[v];
    if(is_too_close(u))
      return false;
  }
  if(on_border && ((!meets_next && is_too_close(m_next[v])) || (!meets_previous && is_too_close(m_previous[v]))))
    return false;
  return common == (on_border ? 1 : 2);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_PROGRESSIVE_DISK_IMPL_H
