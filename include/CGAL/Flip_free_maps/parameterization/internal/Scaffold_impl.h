// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_SCAFFOLD_IMPL_H
#define CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_SCAFFOLD_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/parameterization/internal/Scaffold.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool Scaffold::build(const Simplicial_domain<2>& domain, const Positions<2>& x)
{
  m_elements.clear();
  m_fixed.clear();
  Triangulation triangulation;
  try {
    triangulate(domain, x, triangulation);
  } catch(const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  mark(triangulation);
  refine(triangulation);

  m_number_of_vertices = domain.number_of_vertices;
  for(const Vertex_handle v : triangulation.finite_vertex_handles())
    if(v->info() < 0) {
      if(v->info() == CORNER)
        m_fixed.push_back(m_number_of_vertices);
      v->info() = m_number_of_vertices++;
    }
  m_positions.resize(2, m_number_of_vertices);
  m_positions.leftCols(domain.number_of_vertices) = x;
  for(const Vertex_handle v : triangulation.finite_vertex_handles())
    if(v->info() >= domain.number_of_vertices)
      m_positions.col(v->info()) << v->point().x(), v->point().y();
  for(const Face_handle f : triangulation.finite_face_handles())
    if(f->info() == OUTSIDE)
      m_elements.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE Simplicial_domain<2> Scaffold::extend(const Simplicial_domain<2>& domain, double weight) const
{
  Simplicial_domain<2> extended;
  extended.elements = domain.elements;
  extended.rest_inverses = domain.rest_inverses;
  extended.measures = domain.measures;
  extended.number_of_vertices = m_number_of_vertices;
  extended.elements.insert(extended.elements.end(), m_elements.begin(), m_elements.end());
  for(std::size_t e = domain.elements.size(); e < extended.elements.size(); ++e) {
    extended.rest_inverses.push_back(extended.image_edges(e, m_positions).inverse());
    extended.measures.push_back(weight / m_elements.size());
  }
  return extended;
}

CGAL_FLIP_FREE_MAPS_INLINE void Scaffold::triangulate(const Simplicial_domain<2>& domain, const Positions<2>& x,
                                                      Triangulation& triangulation)
{
  std::vector<const std::vector<std::int32_t>*> loops{&domain.border};
  for(const auto& hole : domain.holes)
    if(hole.size() > 2)
      loops.push_back(&hole);
  std::vector<std::pair<Point, std::int32_t>> points;
  Vector<2> low = x.col(domain.border[0]), high = low;
  for(const auto* loop : loops)
    for(std::int32_t v : *loop) {
      points.emplace_back(Point(x(0, v), x(1, v)), v);
      low = low.cwiseMin(x.col(v));
      high = high.cwiseMax(x.col(v));
    }
  const Vector<2> centre = 0.5 * (low + high), half = 0.5 * EXTENT * Vector<2>::Constant((high - low).maxCoeff());
  for(const int a : {-1, 1})
    for(const int b : {-1, 1})
      points.emplace_back(Point(centre[0] + a * half[0], centre[1] + b * half[1]), CORNER);
  triangulation.insert(points.begin(), points.end());

  std::vector<Vertex_handle> handles(domain.number_of_vertices);
  for(const Vertex_handle v : triangulation.finite_vertex_handles())
    if(v->info() >= 0)
      handles[v->info()] = v;
  for(const auto* loop : loops)
    for(std::size_t i = 0; i < loop->size(); ++i)
      triangulation.insert_constraint(handles[(*loop)[i]], handles[(*loop)[(i + 1) % loop->size()]]);
}

CGAL_FLIP_FREE_MAPS_INLINE void Scaffold::mark(Triangulation& triangulation)
{
  for(const Face_handle f : triangulation.all_face_handles())
    f->info() = UNKNOWN;
  std::vector<Face_handle> stack{triangulation.infinite_face()};
  stack.back()->info() = OUTSIDE;
  while(!stack.empty()) {
    const Face_handle f = stack.back();
    stack.pop_back();
    for(int i = 0; i < 3; ++i) {
      const Face_handle g = f->neighbor(i);
      if(g->info() != UNKNOWN)
        continue;
      g->info() = f->is_constrained(i) ? (f->info() == OUTSIDE ? INSIDE : OUTSIDE) : f->info();
      stack.push_back(g);
    }
  }
}

CGAL_FLIP_FREE_MAPS_INLINE void Scaffold::refine(Triangulation& triangulation)
{
  std::size_t left = MOST_ADDED * triangulation.number_of_vertices();
  std::deque<Face_handle> queue;
  for(const Face_handle f : triangulation.finite_face_handles())
    queue.push_back(f);
  std::vector<Face_handle> conflicts;
  std::vector<Triangulation::Edge> boundary;
  for(; !queue.empty() && left > 0; queue.pop_front()) {
    const Face_handle f = queue.front();
    if(f->info() != OUTSIDE || triangulation.is_infinite(f) || !is_bad(f))
      continue;
    const Point centre = triangulation.circumcenter(f);
    if(!std::isfinite(centre.x()) || !std::isfinite(centre.y()))
      continue;
    Triangulation::Locate_type type;
    int index;
    const Face_handle start = triangulation.locate(centre, type, index, f);
    if((type != Triangulation::FACE && type != Triangulation::EDGE) || start->info() != OUTSIDE || triangulation.is_infinite(start))
      continue;
    conflicts.clear();
    boundary.clear();
    triangulation.get_conflicts_and_boundary(centre, std::back_inserter(conflicts), std::back_inserter(boundary), start);
    if(std::find(conflicts.begin(), conflicts.end(), f) == conflicts.end() ||
       std::any_of(boundary.begin(), boundary.end(), [&](const auto& edge) { return encroaches(triangulation, edge, centre); }))
      continue;
    const Vertex_handle v = triangulation.insert(centre, start);
    v->info() = ADDED;
    --left;
    auto around = triangulation.incident_faces(v);
    const auto done = around;
    do {
      around->info() = OUTSIDE;
      queue.push_back(around);
    } while(++around != done);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE bool Scaffold::is_bad(const Face_handle& f)
{
  const auto squared_edge = [&f](int i) {
    return CGAL::squared_distance(f->vertex((i + 1) % 3)->point(), f->vertex((i + 2) % 3)->point());
  };
  const double a = squared_edge(0), b = squared_edge(1), c = squared_edge(2);
  const double area = CGAL::area(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
  return a * b * c > 16 * area * area * WORST_SHAPE * WORST_SHAPE * (std::min)({a, b, c});
}

CGAL_FLIP_FREE_MAPS_INLINE bool Scaffold::encroaches(const Triangulation& triangulation, const Triangulation::Edge& edge, const Point& p)
{
  const Face_handle f = edge.first, g = f->neighbor(edge.second);
  if(!f->is_constrained(edge.second) && !triangulation.is_infinite(f) && !triangulation.is_infinite(g))
    return false;
  const Vertex_handle v = f->vertex((edge.second + 1) % 3), w = f->vertex((edge.second + 2) % 3);
  if(triangulation.is_infinite(v) || triangulation.is_infinite(w))
    return true;
  return CGAL::angle(v->point(), p, w->point()) != CGAL::ACUTE;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_SCAFFOLD_IMPL_H
