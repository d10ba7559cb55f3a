// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CONSTRAINTS_INTERNAL_OBSTRUCTIONS_H
#define CGAL_FLIP_FREE_MAPS_CONSTRAINTS_INTERNAL_OBSTRUCTIONS_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/boundary_triangles_of_solid.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// What proves, before anything is computed, that no map without flips has the fixed vertices where they are.
template <int D, typename Kernel>
class Obstructions
{
  using Triangle = std::array<std::int32_t, 3>;
  using Edge = std::array<std::int32_t, 2>;

public:
  // Keeps references to the domain and to the positions.
  Obstructions(const Simplicial_domain<D>& domain, const std::vector<std::int32_t>& fixed_vertices, const Positions<D>& x)
    : m_domain(domain), m_x(x), m_is_fixed(domain.number_of_vertices, 0)
  {
    for(std::int32_t v : fixed_vertices)
      m_is_fixed[v] = 1;
  }

  // Enters what is found into the summary. Returns whether there was anything.
  bool find(Summary& summary) const
  {
    for(std::int64_t e = 0; e < m_domain.number_of_elements(); ++e)
      if(std::all_of(m_domain.elements[e].begin(), m_domain.elements[e].end(), [this](std::int32_t v) { return m_is_fixed[v]; }) &&
         !is_positively_oriented<Kernel>(m_domain.elements[e], m_x))
        summary.impossible_elements.push_back(e);
    if constexpr(D == 3)
      find_edges(summary.impossible_edges);
    if(summary.impossible_elements.empty() && summary.impossible_edges.empty())
      return false;
    summary.status = Status::unreachable_constraints;
    summary.message = sentence(summary);
    return true;
  }

private:
  static std::string sentence(const Summary& summary)
  {
    const char* element = D == 2 ? "triangle" : "tetrahedron";
    if(!summary.impossible_elements.empty())
      return std::to_string(summary.impossible_elements.size()) +
             " elements are flipped or flat, and all of their vertices are held, as in " + element + " number " +
             std::to_string(summary.impossible_elements.front());
    return std::to_string(summary.impossible_edges.size()) +
           " edges inside the solid have both ends held on one flat side of the target, as the one from vertex number " +
           std::to_string(summary.impossible_edges.front()[0]) + " to vertex number " +
           std::to_string(summary.impossible_edges.front()[1]) + ": no tetrahedron fits between such an edge and the side";
  }

  typename Kernel::Point_3 point(std::int32_t v) const { return typename Kernel::Point_3(m_x(0, v), m_x(1, v), m_x(2, v)); }

  // Edges inside that leave one of their ends within a triangle of the boundary. Elements without flips surround them, and so
  // cover what is beyond that triangle, but do not where the boundary as a whole does not wind around those places.
  void find_edges(std::vector<Edge>& edges) const
  {
    const std::vector<Triangle> boundary = boundary_triangles_of_solid(m_domain.elements);
    const auto is_held = [this](const Triangle& t) { return m_is_fixed[t[0]] && m_is_fixed[t[1]] && m_is_fixed[t[2]]; };
    if(boundary.empty() || !std::all_of(boundary.begin(), boundary.end(), is_held))
      return;
    std::vector<Edge> on_boundary;
    std::unordered_map<std::int32_t, std::vector<std::size_t>> around;
    for(std::size_t t = 0; t < boundary.size(); ++t)
      for(int k = 0; k < 3; ++k) {
        on_boundary.push_back(edge(boundary[t][k], boundary[t][(k + 1) % 3]));
        around[boundary[t][k]].push_back(t);
      }
    std::sort(on_boundary.begin(), on_boundary.end());
    for(const Edge& inner : edges_between_fixed_vertices())
      if(!std::binary_search(on_boundary.begin(), on_boundary.end(), inner))
        for(int i = 0; i < 2; ++i) {
          const std::int32_t v = inner[i], w = inner[1 - i];
          const auto found = around.find(v);
          if(found != around.end() && std::any_of(found->second.begin(), found->second.end(), [&](std::size_t t) {
               return is_within(boundary[t], v, w) && !is_wound_around(boundary, boundary[t], v, w);
             })) {
            edges.push_back(inner);
            break;
          }
        }
  }

  static Edge edge(std::int32_t v, std::int32_t w) { return {(std::min)(v, w), (std::max)(v, w)}; }

  std::vector<Edge> edges_between_fixed_vertices() const
  {
    std::vector<Edge> result;
    for(const auto& element : m_domain.elements)
      for(int i = 0; i <= D; ++i)
        for(int j = 0; j < i; ++j)
          if(m_is_fixed[element[i]] && m_is_fixed[element[j]])
            result.push_back(edge(element[i], element[j]));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Whether the ray from the triangle's corner v to w runs in the triangle at first.
  bool is_within(const Triangle& t, std::int32_t v, std::int32_t w) const
  {
    const int k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    const auto p = point(v), a = point(t[(k + 1) % 3]), b = point(t[(k + 2) % 3]), q = point(w);
    return typename Kernel::Orientation_3()(p, a, b, q) == CGAL::ZERO && !typename Kernel::Collinear_3()(p, a, b) &&
           typename Kernel::Coplanar_orientation_3()(p, a, b, q) != CGAL::NEGATIVE &&
           typename Kernel::Coplanar_orientation_3()(p, b, a, q) != CGAL::NEGATIVE;
  }

  // Whether the boundary winds around what is just outside the triangle t, near v on the way to w.
  bool is_wound_around(const std::vector<Triangle>& boundary, const Triangle& t, std::int32_t v, std::int32_t w) const
  {
    const auto corner = [this](std::int32_t i) -> Vector<3> { return m_x.template topRows<3>().col(i); };
    const Vector<3> normal = (corner(t[1]) - corner(t[0])).cross(corner(t[2]) - corner(t[0]));
    const double height = std::sqrt(normal.norm());
    const Vector<3> way = corner(w) - corner(v);
    const Vector<3> place = corner(v) + (1e-4 * height) * (way.normalized() + 1e-3 * normal.normalized());
    double angle = 0;
    for(const Triangle& other : boundary) {
      const Vector<3> a = corner(other[0]) - place, b = corner(other[1]) - place, c = corner(other[2]) - place;
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return !(std::abs(angle) < 2 * CGAL_PI);
  }

  const Simplicial_domain<D>& m_domain;
  const Positions<D>& m_x;
  std::vector<char> m_is_fixed;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CONSTRAINTS_INTERNAL_OBSTRUCTIONS_H
