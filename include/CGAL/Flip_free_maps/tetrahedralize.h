// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_H
#define CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_H

#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>
#include <CGAL/Flip_free_maps/internal/error_message.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/report/Outcome.h>
#include <CGAL/Flip_free_maps/report/Status.h>
#include <CGAL/Flip_free_maps/tetrahedralization/internal/Closed_surface.h>

#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/make_mesh_3.h>

#include <array>
#include <new>
#include <string>
#include <unordered_map>
#include <utility>

/// \file

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Settings of `tetrahedralize()`. Lengths are relative to the diagonal of the bounding box of the surface.
struct Tetrahedralization_options
{
  /// Upper bound for the circumradii of the tetrahedra, and for the circumradii of the facets on the boundary; from 0.001 to 1.
  /// The number of tetrahedra grows with the third power of its inverse.
  double cell_size = 0.05;
  /// Upper bound for the distance between the facets on the boundary and the surface; from 1e-5 to 1.
  double facet_distance = 0.005;
  /// Lower bound for the angles of the facets on the boundary, in degrees; from 0 to 30.
  double facet_angle = 25;
  /// Upper bound for the ratio of circumradius and shortest edge of the tetrahedra; at least 2.
  double cell_radius_edge_ratio = 3;
  /// Edges at which the normals turn by more than this angle, in degrees, become edges of the tetrahedra; from 0 to 180, where
  /// 180 leaves all edges free.
  double feature_angle = 60;

  /// Checks the ranges; when a value is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const;
};

namespace internal {

template <typename MeshComplex>
void copy_complex(const MeshComplex& complex, Tetrahedral_mesh& mesh)
{
  std::unordered_map<typename MeshComplex::Vertex_handle, int> numbers;
  const auto& triangulation = complex.triangulation();
  const auto construct_point = triangulation.geom_traits().construct_point_3_object();
  for(auto c = complex.cells_in_complex_begin(); c != complex.cells_in_complex_end(); ++c) {
    std::array<int, 4> tetrahedron;
    for(int k = 0; k < 4; ++k) {
      const auto v = c->vertex(k);
      const auto entry = numbers.emplace(v, static_cast<int>(mesh.points.size()));
      if(entry.second) {
        const auto p = construct_point(triangulation.point(v));
        mesh.points.push_back({{p.x(), p.y(), p.z()}});
      }
      tetrahedron[k] = entry.first->second;
    }
    mesh.tetrahedra.push_back(tetrahedron);
  }
}

void mesh_closed_surface(const Closed_surface& surface, const Tetrahedralization_options& options, Tetrahedral_mesh& mesh);

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Fills a closed triangle mesh with tetrahedra, by the mesh generator of the CGAL package 3D Mesh Generation. The boundary is
/// remeshed: it approximates the surface, and its vertices are new ones. A surface of several components bounds the places around
/// which it passes an odd number of times, so that voids are possible.
///
/// \tparam FaceGraph must be a model of `VertexListGraph` and `FaceListGraph` whose vertex descriptors are `Hashable`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param surface a closed triangle mesh without self-intersections; the orientation does not matter
/// \param volume receives the tetrahedra, positively oriented, and the triangles of their boundary, counterclockwise seen from
///   outside; not changed on failure
/// \param options sizes
/// \param message receives a sentence on failure
/// \param np optional named parameters: `vertex_point_map`, as in `parameterize()`
///
/// \returns `success`, `invalid_option`, `empty_mesh` (also when the tetrahedra are too large for the volume), `not_triangular`,
///   `non_manifold` (not closed, several sheets at a vertex, or self-intersecting), `degenerate_rest_element`, `non_finite_input`
///   or `out_of_memory`
template <typename FaceGraph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Status tetrahedralize(const FaceGraph& surface, Tetrahedral_mesh& volume, const Tetrahedralization_options& options, std::string& message,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Closed_surface closed;
  const Status status = internal::load_closed_surface(surface, options, np, closed, message);
  if(status != Status::success)
    return status;
  Tetrahedral_mesh result;
  try {
    internal::mesh_closed_surface(closed, options, result);
  } catch(const std::bad_alloc&) {
    message = "not enough memory for so many tetrahedra";
    return Status::out_of_memory;
  }
  if(result.tetrahedra.empty()) {
    message = "no tetrahedron of this size fits into the surface";
    return Status::empty_mesh;
  }
  result.triangles = boundary_triangles(result);
  volume = std::move(result);
  return Status::success;
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the sizes as a named parameter, `tetrahedralization_options` of `Flip_free_maps::parameters`.
template <typename FaceGraph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Outcome tetrahedralize(const FaceGraph& surface, Tetrahedral_mesh& volume, const NamedParameters& np = CGAL::parameters::default_values())
{
  Outcome outcome(Status::success, "");
  outcome.status =
    tetrahedralize(surface, volume, internal::parameter_or(np, internal::tetrahedralization_options_tag, Tetrahedralization_options()),
                   outcome.message, np);
  return outcome;
}

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/tetrahedralize_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_H
