// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_SCAFFOLD_H
#define CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_SCAFFOLD_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/LU>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Triangles that fill what an injective planar map leaves of a large box around it, its holes included. The border of the map
// keeps its edges; vertices are added inside of the rest, where triangles would be long and thin otherwise. As long as none of
// these triangles flips, nor one of the map's, the map stays injective.
class Scaffold
{
public:
  // Triangulates around the map `x`, in which all triangles of the disk with holes `domain` must be positive and its borders
  // disjoint simple curves. False if they are not.
  bool build(const Simplicial_domain<2>& domain, const Positions<2>& x);

  // The map with the triangles around it, whose rest shape is the present one. The new triangles share the weight `weight`.
  Simplicial_domain<2> extend(const Simplicial_domain<2>& domain, double weight) const;

  // The map's vertices, then the new ones.
  const Positions<2>& positions() const { return m_positions; }

  // The corners of the box.
  const std::vector<std::int32_t>& fixed_vertices() const { return m_fixed; }

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::int32_t, Kernel>;
  using Face_base = CGAL::Triangulation_face_base_with_info_2<signed char, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
                                                                   CGAL::No_constraint_intersection_tag>;
  using Vertex_handle = Triangulation::Vertex_handle;
  using Face_handle = Triangulation::Face_handle;
  using Point = Triangulation::Point;

  // Numbers of vertices that are not the map's.
  static constexpr std::int32_t CORNER = -1;
  static constexpr std::int32_t ADDED = -2;
  // Kinds of faces.
  static constexpr signed char UNKNOWN = -1;
  static constexpr signed char OUTSIDE = 0;
  static constexpr signed char INSIDE = 1;

  // Of the box, over the map's.
  static constexpr double EXTENT = 3;
  // Circumradius over shortest edge beyond which a triangle gets a vertex in it.
  static constexpr double WORST_SHAPE = 1.5;
  // Added vertices for each vertex of the border, at most.
  static constexpr std::size_t MOST_ADDED = 4;

  static void triangulate(const Simplicial_domain<2>& domain, const Positions<2>& x, Triangulation& triangulation);

  // Outside are the faces that an even number of borders separates from the far.
  static void mark(Triangulation& triangulation);

  // Adds circumcentres of badly shaped triangles outside (Ruppert 1995), but never one that would ask for another vertex on a
  // constrained edge.
  static void refine(Triangulation& triangulation);

  static bool is_bad(const Face_handle& f);

  // Whether a new vertex is too near to a constrained edge, or an edge of the box.
  static bool encroaches(const Triangulation& triangulation, const Triangulation::Edge& edge, const Point& p);

  std::vector<std::array<std::int32_t, 3>> m_elements;
  std::vector<std::int32_t> m_fixed;
  Positions<2> m_positions;
  std::int32_t m_number_of_vertices = 0;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/parameterization/internal/Scaffold_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_SCAFFOLD_H
