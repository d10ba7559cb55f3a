// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PARAMETERIZE_H
#define CGAL_FLIP_FREE_MAPS_PARAMETERIZE_H

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/internal/flatten.h>
#include <CGAL/Flip_free_maps/internal/make_start.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Flattens a surface patch into the plane with as little distortion as possible and no flipped triangle.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph` whose descriptors are `Hashable`: `CGAL::Surface_mesh`, `CGAL::Polyhedron_3`,
///   `CGAL::Seam_mesh`, `CGAL::Face_filtered_graph`, OpenMesh, or a user's own
/// \tparam VertexUVMap must be a model of `WritablePropertyMap` with vertex descriptors as keys and planar points as values
/// \tparam Traits must be a model of `MapTraits`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a triangle mesh
/// \param border_halfedge a halfedge on the border of the component to be flattened, which must be a topological disk
/// \param uv_map receives the map in the units of length of the surface: an isometry keeps all lengths. It is written once, at the
///   end, if the map is valid, and left untouched otherwise. Orientation is positive: triangles are counterclockwise.
/// \param traits the method and its settings, see `Flip_free_map_traits`
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertex descriptors as keys and points in space as values}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{limit of iterations; overrides the traits' options}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{`Map_options::max_iterations`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns how it ended and what it cost; `Summary::is_valid()` tells whether `uv_map` was written. Bad input gives a status and a
///   message, not an exception: `no_border`, `empty_mesh`, `not_triangular`, `not_a_disk`, `non_manifold`,
///   `degenerate_rest_element`, `non_finite_input`, `start_not_flip_free`, `invalid_option`, `linear_solver_failed`,
///   `line_search_failed`, `result_not_representable`, `out_of_memory`.
///
/// Complexity: linear in the number of faces except for one sparse factorization per iteration; memory is that of the factor and
/// some hundred bytes per face.
template <typename TriangleMesh, typename VertexUVMap, typename Traits, typename NamedParameters = parameters::Default_named_parameters>
Summary parameterize(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border_halfedge,
                     VertexUVMap uv_map, const Traits& traits, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto vertex_points =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, mesh));
  Traits used = traits;
  used.options.max_iterations = static_cast<int>(
    choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), used.options.max_iterations));
  const auto start = [&](const Simplicial_domain<2>& domain, const auto&, Positions<2>& x, std::string& name, std::string& message) {
    return internal::make_start(domain, used, x, name, message);
  };
  return internal::flatten(mesh, border_halfedge, vertex_points, uv_map, used, start);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with default named parameters.
template <typename TriangleMesh, typename VertexUVMap, typename Traits>
Summary parameterize(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border_halfedge,
                     VertexUVMap uv_map, const Traits& traits)
{
  return parameterize(mesh, border_halfedge, uv_map, traits, parameters::default_values());
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the default method.
template <typename TriangleMesh, typename VertexUVMap, typename T, typename Tag, typename Base>
Summary parameterize(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border_halfedge,
                     VertexUVMap uv_map, const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return parameterize(mesh, border_halfedge, uv_map, Flip_free_map_traits<>(), np);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the default method and default named parameters.
template <typename TriangleMesh, typename VertexUVMap>
Summary parameterize(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border_halfedge,
                     VertexUVMap uv_map)
{
  return parameterize(mesh, border_halfedge, uv_map, Flip_free_map_traits<>(), parameters::default_values());
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZE_H
