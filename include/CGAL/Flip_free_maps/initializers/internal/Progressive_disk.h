// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_PROGRESSIVE_DISK_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_PROGRESSIVE_DISK_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/for_each_index.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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
  Flat_lists(const std::vector<std::array<std::int32_t, 3>>& elements, std::int32_t number_of_vertices);

  // Valid until a list grows.
  List operator[](std::int32_t v) const { return List(m_numbers.data() + m_places[v].begin, m_places[v].size); }

  std::int32_t size(std::int32_t v) const { return m_places[v].size; }
  std::int32_t number(std::int32_t v, std::int32_t i) const { return m_numbers[m_places[v].begin + i]; }

  void push_back(std::int32_t v, std::int32_t number);

  // The last number takes the place of the erased one.
  void erase(std::int32_t v, std::int32_t number);

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

  explicit Progressive_disk(const Simplicial_domain<2>& domain);

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
      ask_deadline();
      const std::int64_t before = m_number_of_triangles;
      coarsen_once<ConcurrencyTag>(wanted, LIMITS[severity]);
      // Thin surfaces stall at strict limits: then shape gives way. Passes that remove little are not worth their time.
      if(before - m_number_of_triangles < (std::max)(std::int64_t(1), before / 10))
        ++severity;
    }
  }

  // The vertices of the last pass, and its removal from the list; each is to be put back with `restore()`.
  std::vector<std::int32_t> take_pass();

  // Puts a vertex back; the result is the vertex it was collapsed to.
  std::int32_t restore(std::int32_t v);

  // Collapses v to its neighbour w. To be undone by `restore()`.
  void remove(std::int32_t v, std::int32_t w);

  // The neighbours that a removed vertex would have.
  std::vector<std::int32_t> neighbors_while_removed(std::int32_t v) const;

  // The surface as it is now, scaled to area 1; `vertices` receives the number here of each vertex there.
  Simplicial_domain<2> domain(std::vector<std::int32_t>& vertices) const;

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

  void add_loop(const std::vector<std::int32_t>& loop);

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
    ask_deadline();
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
      ask_deadline();
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
  static void sort_by_cost(std::vector<Collapse>& collapses);

  void mark_star(std::int32_t v, std::vector<char>& is_marked) const;

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
  void guess(Collapse& collapse) const;

  // Chooses the cheapest possible collapse within the limits, where the guessed one is not.
  void judge(Collapse& collapse, const Limits& limits) const;

  // Copies the triangles around v to where all candidates of a collapse find them.
  void load_corners(std::int32_t v, Corners& corners) const;

  // How much the surface changes: squared distances of v to the new triangles, weighted by their areas, and a little of the
  // edge's length so that flat parts thin out evenly. Infinite beyond the limits, and where it is found to exceed `bound`.
  double collapse_cost(std::int32_t v, std::int32_t w, const Limits& limits, const Corners& corners, double bound) const;

  // The vertex behind v in a triangle, in the triangle's sense. Of all triangles around v, those are all its neighbours, but for
  // the last one at the border.
  std::int32_t next_in(std::int32_t t, std::int32_t v) const;

  // Whether the surface keeps its topology, with three triangles at least around inner vertices.
  bool is_possible(std::int32_t v, std::int32_t w) const;

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

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/initializers/internal/Progressive_disk_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_PROGRESSIVE_DISK_H
