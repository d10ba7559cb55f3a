// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_PROGRESSIVE_DISK_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_PROGRESSIVE_DISK_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Element_coloring.h>
#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>

#include <Eigen/Geometry>

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

// A list of numbers for each vertex, all in one array: lists that outgrow their place move to its end.
class Flat_lists
{
public:
  class List
  {
  public:
    List(const std::int32_t* first, std::int32_t size) : m_first(first), m_size(size) {}
    const std::int32_t* begin() const { return m_first; }
    const std::int32_t* end() const { return m_first + m_size; }
    std::size_t size() const { return m_size; }

  private:
    const std::int32_t* m_first;
    std::int32_t m_size;
  };

  // To each vertex the elements that it belongs to.
  Flat_lists(const std::vector<std::array<std::int32_t, 3>>& elements, std::int32_t number_of_vertices) : m_places(number_of_vertices)
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

  // Valid until a list grows.
  List operator[](std::int32_t v) const { return List(m_numbers.data() + m_places[v].begin, m_places[v].size); }

  std::int32_t size(std::int32_t v) const { return m_places[v].size; }
  std::int32_t number(std::int32_t v, std::int32_t i) const { return m_numbers[m_places[v].begin + i]; }

  void push_back(std::int32_t v, std::int32_t number)
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

  // The last number takes the place of the erased one.
  void erase(std::int32_t v, std::int32_t number)
  {
    Place& place = m_places[v];
    const auto first = m_numbers.begin() + place.begin;
    --place.size;
    *std::find(first, first + place.size, number) = first[place.size];
  }

private:
  struct Place
  {
    std::int64_t begin = 0;
    std::int32_t size = 0, capacity = 0;
  };

  std::vector<Place> m_places;
  std::vector<std::int32_t> m_numbers;
};

// A disk in space, possibly with holes, that is simplified by half-edge collapses and taken back step by step. Collapses come in
// passes: the vertices removed in one pass are pairwise not adjacent, so the triangles around one do not contain another, and
// within a pass they can be put back in any order. Triangles keep their numbers: those that lose an edge sleep, those that lose a
// vertex get its target instead.
class Progressive_disk
{
public:
  using Triangle = std::array<std::int32_t, 3>;

  explicit Progressive_disk(const Simplicial_domain<2>& domain)
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

  std::int64_t number_of_triangles() const { return m_number_of_triangles; }
  std::size_t number_of_passes() const { return m_passes.size(); }

  // Triangles around a vertex, valid until the surface changes.
  Flat_lists::List star(std::int32_t v) const { return m_stars[v]; }
  const Triangle& triangle(std::int32_t t) const { return m_triangles[t]; }
  // Those that sleep included.
  std::int32_t number_of_all_triangles() const { return static_cast<std::int32_t>(m_triangles.size()); }
  bool is_triangle_awake(std::int32_t t) const { return m_is_awake[t]; }
  bool is_awake(std::int32_t v) const { return m_target[v] < 0; }
  bool is_on_border(std::int32_t v) const { return m_next[v] >= 0; }
  const Positions<3>& points() const { return m_points; }

  // Collapses until at most `wanted` triangles are left; fewer passes when no more collapse is possible.
  template <typename ConcurrencyTag>
  void coarsen(std::int64_t wanted)
  {
    int severity = 0;
    while(m_number_of_triangles > wanted && severity < SEVERITIES) {
      const std::int64_t before = m_number_of_triangles;
      coarsen_once<ConcurrencyTag>(wanted, LIMITS[severity]);
      // Thin surfaces stall at strict limits: then shape gives way. Passes that remove little are not worth their time.
      if(before - m_number_of_triangles < (std::max)(std::int64_t(1), before / 10))
        ++severity;
    }
  }

  // The vertices of the last pass, and its removal from the list; each is to be put back with `restore()`.
  std::vector<std::int32_t> take_pass()
  {
    std::vector<std::int32_t> pass = std::move(m_passes.back());
    m_passes.pop_back();
    return pass;
  }

  // Puts a vertex back; the result is the vertex it was collapsed to.
  std::int32_t restore(std::int32_t v)
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

  // Collapses v to its neighbour w. To be undone by `restore()`.
  void remove(std::int32_t v, std::int32_t w)
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

  // The neighbours that a removed vertex would have.
  std::vector<std::int32_t> neighbors_while_removed(std::int32_t v) const
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

  // The surface as it is now, scaled to area 1; `vertices` receives the number here of each vertex there.
  Simplicial_domain<2> domain(std::vector<std::int32_t>& vertices) const
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

private:
  // What a collapse may do to the shape.
  struct Limits
  {
    double least_cosine;  // between a triangle's normals before and after
    double least_quality; // doubled area over squared longest edge, of a triangle after
  };
  static constexpr int SEVERITIES = 4;
  static constexpr Limits LIMITS[SEVERITIES] = {{0.5, 0.2}, {0.2, 0.05}, {-0.5, 0.005}, {-2, 1e-6}};
  static constexpr std::size_t LARGEST_VALENCE = 24;
  static constexpr std::size_t CHUNK_SIZE = 1024; // vertices whose collapses are judged by one thread

  // A triangle (v, a, b).
  struct Corner
  {
    std::int32_t number_a, number_b;
    Vector<3> a, b;
    Vector<3> normal; // as long as twice the area
    double normal_length;
    double squared_side; // opposite of v
  };

  // Those around one vertex that may be removed.
  struct Corners
  {
    std::array<Corner, LARGEST_VALENCE> data;
    std::size_t size;
    const Corner* begin() const { return data.data(); }
    const Corner* end() const { return data.data() + size; }
  };

  struct Collapse
  {
    float cost; // not negative
    std::int32_t v;
    std::int32_t w; // -1 for none
  };

  void add_loop(const std::vector<std::int32_t>& loop)
  {
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const std::int32_t v = loop[i], w = loop[(i + 1) % loop.size()];
      m_next[v] = w;
      m_previous[w] = v;
      m_loop[v] = static_cast<std::int32_t>(m_loop_sizes.size());
    }
    m_loop_sizes.push_back(loop.size());
  }

  // One pass. A guess of what the removal of a vertex costs orders them; only those whose turn comes before that of all their
  // neighbours are judged in detail.
  template <typename ConcurrencyTag>
  void coarsen_once(std::int64_t wanted, const Limits& limits)
  {
    const std::size_t number_of_vertices = m_target.size();
    std::vector<Collapse> guesses;
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      if(m_target[v] < 0)
        guesses.push_back({0, static_cast<std::int32_t>(v), -1});
    for_each_chunk<ConcurrencyTag>(guesses.size(), [&](std::size_t i) { guess(guesses[i]); });
    sort_by_cost(guesses);
    // The dear quarter waits for a later pass, when cheaper collapses may have become possible instead.
    if(guesses.size() > 64)
      guesses.resize(guesses.size() * 3 / 4);

    std::vector<char> is_locked(number_of_vertices, 0), is_reserved;
    std::vector<std::int32_t> pass;
    std::vector<Collapse> collapses;
    // Neighbours of vertices that cannot be removed have their turn in the second round.
    for(int round = 0; round < 2 && m_number_of_triangles > wanted; ++round) {
      is_reserved = is_locked;
      collapses.clear();
      for(Collapse& guess : guesses) {
        if(m_number_of_triangles - 2 * static_cast<std::int64_t>(collapses.size()) <= wanted)
          break;
        if(guess.v < 0 || is_reserved[guess.v])
          continue;
        mark_star(guess.v, is_reserved);
        collapses.push_back(guess);
        guess.v = -1;
      }
      // They are independent of each other; in the order of their numbers they are close to each other in memory.
      std::sort(collapses.begin(), collapses.end(), [](const Collapse& a, const Collapse& b) { return a.v < b.v; });
      for_each_chunk<ConcurrencyTag>(collapses.size(), [&](std::size_t i) { judge(collapses[i], limits); });
      for(const Collapse& collapse : collapses) {
        if(collapse.w < 0 || !is_possible(collapse.v, collapse.w))
          continue;
        mark_star(collapse.v, is_locked);
        remove(collapse.v, collapse.w);
        pass.push_back(collapse.v);
      }
    }
    if(!pass.empty())
      m_passes.push_back(std::move(pass));
  }

  // Sorts by the leading bits of the costs, which is exact to 3 % and takes linear time.
  static void sort_by_cost(std::vector<Collapse>& collapses)
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

  void mark_star(std::int32_t v, std::vector<char>& is_marked) const
  {
    for(std::int32_t t : m_stars[v])
      for(std::int32_t u : m_triangles[t])
        is_marked[u] = 1;
  }

  template <typename ConcurrencyTag, typename F>
  static void for_each_chunk(std::size_t n, F&& f)
  {
    for_each_index<ConcurrencyTag>((n + CHUNK_SIZE - 1) / CHUNK_SIZE, [&](std::size_t c) {
      for(std::size_t i = c * CHUNK_SIZE; i < (std::min)(n, (c + 1) * CHUNK_SIZE); ++i)
        f(i);
    });
  }

  // Enters the cheapest collapse of a vertex and about what it costs, by the distances of its neighbours to the planes around it
  // (Garland and Heckbert 1997).
  void guess(Collapse& collapse) const
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

  // Chooses the cheapest possible collapse within the limits, where the guessed one is not.
  void judge(Collapse& collapse, const Limits& limits) const
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

  // Copies the triangles around v to where all candidates of a collapse find them.
  void load_corners(std::int32_t v, Corners& corners) const
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

  // How much the surface changes: squared distances of v to the new triangles, weighted by their areas, and a little of the
  // edge's length so that flat parts thin out evenly. Infinite beyond the limits, and where it is found to exceed `bound`.
  double collapse_cost(std::int32_t v, std::int32_t w, const Limits& limits, const Corners& corners, double bound) const
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

  // The vertex behind v in a triangle, in the triangle's sense. Of all triangles around v, those are all its neighbours, but for
  // the last one at the border.
  std::int32_t next_in(std::int32_t t, std::int32_t v) const
  {
    const Triangle& triangle = m_triangles[t];
    return triangle[0] == v ? triangle[1] : triangle[1] == v ? triangle[2] : triangle[0];
  }

  // Whether the surface keeps its topology, with three triangles at least around inner vertices.
  bool is_possible(std::int32_t v, std::int32_t w) const
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

  const Positions<3>& m_points;
  std::vector<Triangle> m_triangles;
  std::vector<char> m_is_awake;
  Flat_lists m_stars;
  std::vector<std::int32_t> m_next; // along the border, -1 inside; kept for removed vertices
  std::vector<std::int32_t> m_previous;
  std::vector<std::int32_t> m_target; // of removed vertices, -1 for the others
  std::vector<std::int32_t> m_loop;   // 0 on the outer border, 1 + h on that of hole h, -1 inside
  std::int64_t m_number_of_triangles;
  std::vector<std::size_t> m_loop_sizes;
  std::vector<std::vector<std::int32_t>> m_passes;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_PROGRESSIVE_DISK_H
