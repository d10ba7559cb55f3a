// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_BORDER_CURVES_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_BORDER_CURVES_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline Exact_kernel::Point_2 exact_point(const Positions<2>& x, std::int32_t v) { return Exact_kernel::Point_2(x(0, v), x(1, v)); }

// An edge with a triangle on its left and none on its right.
struct Border_edge
{
  std::int32_t source;
  std::int32_t target;
  std::int32_t element; // the triangle
  std::int32_t curve;   // the closed curve that the edge belongs to
};

// The border of a surface as closed curves.
class Border_curves
{
public:
  // False when the triangles do not form a surface with a border of disjoint simple curves: an edge has several triangles on one
  // side, or a border passes through a vertex twice.
  bool load(const std::vector<std::array<std::int32_t, 3>>& elements, std::int32_t number_of_vertices);

  // The same where it is known which sides of triangles have nothing across them: those halfedges whose opposite one is -1.
  bool load(const std::vector<std::array<std::int32_t, 3>>& elements, const std::vector<std::int32_t>& opposite,
            std::int32_t number_of_vertices);

  const std::vector<Border_edge>& edges() const { return m_edges; }

  // The curves, each as numbers of edges in their order.
  const std::vector<std::vector<std::int32_t>>& curves() const { return m_curves; }

  // Calls f(i, j) for pairs of edges whose images have a point in common that is not the image of a common vertex, until f
  // returns false. By exact predicates.
  template <typename F>
  void for_each_crossing(const Positions<2>& x, F&& f) const
  {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::int32_t>;
    std::vector<Box> boxes;
    boxes.reserve(m_edges.size());
    for(std::size_t i = 0; i < m_edges.size(); ++i)
      boxes.emplace_back(exact_point(x, m_edges[i].source).bbox() + exact_point(x, m_edges[i].target).bbox(), static_cast<std::int32_t>(i));
    struct Enough
    {};
    // The enumeration of pairs can be left by an exception only; it may have very many pairs to go.
    try {
      std::size_t pairs = 0;
      CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
        ask_deadline_sometimes(pairs++);
        if(cross(m_edges[a.info()], m_edges[b.info()], x) && !f(a.info(), b.info()))
          throw Enough();
      });
    } catch(const Enough&) {}
  }

  // Whether the curves, which must not cross, bound regions that each lie inside of exactly one of them more than outside: outer
  // borders counterclockwise, borders of holes clockwise and directly inside an outer one, and so on inwards.
  bool are_nested(const Positions<2>& x) const;

private:
  // Strings edges together.
  bool link(std::int32_t number_of_vertices);

  static bool cross(const Border_edge& a, const Border_edge& b, const Positions<2>& x);

  // How often a curve winds around a point that is not on it.
  int winding_number(const std::vector<std::int32_t>& curve, const Positions<2>& x, const Exact_kernel::Point_2& p) const;

  std::vector<Border_edge> m_edges;
  std::vector<std::vector<std::int32_t>> m_curves;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/measure/internal/Border_curves_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_BORDER_CURVES_H
