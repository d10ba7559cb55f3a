// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_POLYGON_TRIANGULATOR_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_POLYGON_TRIANGULATOR_IMPL_H

#include <CGAL/Flip_free_maps/domains/internal/Polygon_triangulator.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <limits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE Vector<3> area_vector(const Positions<3>& corners)
{
  Vector<3> sum = Vector<3>::Zero();
  const Vector<3> first = corners.col(0);
  for(Eigen::Index i = 1; i + 1 < corners.cols(); ++i)
    sum += 0.5 * Vector<3>(corners.col(i) - first).cross(Vector<3>(corners.col(i + 1) - first));
  return sum;
}

CGAL_FLIP_FREE_MAPS_INLINE const std::vector<std::array<int, 3>>& Polygon_triangulator::triangulate(const Positions<3>& corners,
                                                                                                    const Is_undesired& is_undesired)
{
  const int n = static_cast<int>(corners.cols());
  m_corners = &corners;
  m_is_undesired = &is_undesired;
  m_normal = area_vector(corners).normalized();
  m_triangles.clear();
  if(n == 3) {
    add(0, 1, 2);
  } else if(n == 4) {
    if(cost(0, 1, 2) + cost(0, 2, 3) + diagonal_cost(0, 2) <= cost(0, 1, 3) + cost(1, 2, 3) + diagonal_cost(1, 3)) {
      add(0, 1, 2);
      add(0, 2, 3);
    } else {
      add(0, 1, 3);
      add(1, 2, 3);
    }
  } else if(n <= FEW_CORNERS || (!triangulate_in_plane(corners, m_normal) && n <= MOST_CORNERS)) {
    choose_best(n);
  } else if(m_triangles.empty()) {
    strip(n);
  }
  return m_triangles;
}

CGAL_FLIP_FREE_MAPS_INLINE double Polygon_triangulator::cost(int i, int j, int k) const
{
  const Vector<3> a = m_corners->col(j) - m_corners->col(i), b = m_corners->col(k) - m_corners->col(i);
  const double size = a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm();
  const double area = a.cross(b).dot(m_normal);
  if(!(a.squaredNorm() > 0 && b.squaredNorm() > 0 && (b - a).squaredNorm() > 0))
    return TWO_AT_ONE_PLACE;
  return area > 1e-9 * size ? size / area : NOT_POSITIVE * (2 - area / size);
}

CGAL_FLIP_FREE_MAPS_INLINE double Polygon_triangulator::diagonal_cost(int i, int j) const
{
  return (*m_is_undesired)(i, j) ? UNDESIRED : 0;
}

// Of the polygon between corners i and j > i, with the diagonal between them as a side, the best is known when those of all shorter
// ones are.
CGAL_FLIP_FREE_MAPS_INLINE void Polygon_triangulator::choose_best(int n)
{
  m_costs.assign(n * n, 0.);
  m_tips.assign(n * n, -1);
  for(int length = 2; length < n; ++length)
    for(int i = 0; i + length < n; ++i) {
      const int j = i + length;
      double best = std::numeric_limits<double>::infinity();
      for(int k = i + 1; k < j; ++k) {
        const double sum = m_costs[i * n + k] + m_costs[k * n + j] + cost(i, k, j);
        if(sum < best) {
          best = sum;
          m_tips[i * n + j] = k;
        }
      }
      m_costs[i * n + j] = best + (length < n - 1 ? diagonal_cost(i, j) : 0);
    }
  std::vector<std::pair<int, int>> parts{{0, n - 1}};
  while(!parts.empty()) {
    const auto [i, j] = parts.back();
    parts.pop_back();
    if(j - i < 2)
      continue;
    const int k = m_tips[i * n + j];
    add(i, k, j);
    parts.emplace_back(k, j);
    parts.emplace_back(i, k);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE bool Polygon_triangulator::triangulate_in_plane(const Positions<3>& corners, const Vector<3>& normal)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
                                                                   CGAL::No_constraint_intersection_tag>;
  if(!(normal.squaredNorm() > 0))
    return false;
  const int n = static_cast<int>(corners.cols());
  const Vector<3> x = normal.unitOrthogonal(), y = normal.cross(x);
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices(n);
  std::vector<std::pair<Kernel::Point_2, int>> points;
  for(int i = 0; i < n; ++i)
    points.emplace_back(Kernel::Point_2(x.dot(corners.col(i)), y.dot(corners.col(i))), i);
  triangulation.insert(points.begin(), points.end());
  if(static_cast<int>(triangulation.number_of_vertices()) < n || triangulation.dimension() < 2)
    return false;
  for(const auto v : triangulation.finite_vertex_handles())
    vertices[v->info()] = v;
  try {
    for(int i = 0; i < n; ++i)
      triangulation.insert_constraint(vertices[i], vertices[(i + 1) % n]);
  } catch(const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  // From outside over all edges but the sides.
  std::unordered_set<Triangulation::Face_handle> outside{triangulation.infinite_face()};
  std::vector<Triangulation::Face_handle> front{triangulation.infinite_face()};
  while(!front.empty()) {
    const Triangulation::Face_handle f = front.back();
    front.pop_back();
    for(int k = 0; k < 3; ++k)
      if(!f->is_constrained(k) && outside.insert(f->neighbor(k)).second)
        front.push_back(f->neighbor(k));
  }
  for(const auto f : triangulation.finite_face_handles())
    if(outside.count(f) == 0) {
      std::array<int, 3> t{{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()}};
      std::sort(t.begin(), t.end());
      m_triangles.push_back(t);
    }
  if(static_cast<int>(m_triangles.size()) == n - 2)
    return true;
  m_triangles.clear();
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE void Polygon_triangulator::strip(int n)
{
  for(int low = 0, high = n - 1; high - low >= 2;) {
    add(low, low + 1, high);
    ++low;
    if(high - low >= 2) {
      add(low, high - 1, high);
      --high;
    }
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_POLYGON_TRIANGULATOR_IMPL_H
