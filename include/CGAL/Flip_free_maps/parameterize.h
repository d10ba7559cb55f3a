// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PARAMETERIZE_H
#define CGAL_FLIP_FREE_MAPS_PARAMETERIZE_H

#include <CGAL/Flip_free_maps/core/flatten_disk.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/domains/internal/longest_border.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/parameterization/internal/parameterize_patch.h>
#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/core/flatten_disk_impl.h>
#endif

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Flattens a surface patch into the plane with as little distortion as possible and no flipped triangle. The patch is a disk,
/// which may have holes.
///
/// The mesh need not be a clean one of triangles:
/// - Faces may be polygons, convex or not, planar or not. They are cut into triangles by diagonals that suit their shapes; none of
///   these is flipped.
/// - Faces without area, whose corners are on a line, up to rounding, or at less than three places, have no rest shape. They are given
///   thin ones, with about a thousandth of the height that their neighbours have, or less; so they have positive images, and hardly
///   matter for all others. `Summary::faces_without_area` counts them.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph` whose descriptors are `Hashable`: `CGAL::Surface_mesh`,
///   `CGAL::Polyhedron_3`, `CGAL::Seam_mesh`, `CGAL::Face_filtered_graph`, OpenMesh, or a user's own
/// \tparam VertexUVMap must be a model of `WritablePropertyMap` with vertex descriptors as keys and planar points as values
/// \tparam Traits must be a model of `MapTraits`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a mesh
/// \param border_halfedge a halfedge on the outer border of the component to be flattened, which must be of genus 0. All other
///   borders are holes: the start closes them, the map does not. Any border may be the outer one;
///   the choice decides which map is found
/// \param uv_map receives the map in the units of length of the surface: an isometry keeps all lengths. It is written once, at
///   the end, if the map is valid, and left untouched otherwise. Orientation is positive: triangles are counterclockwise.
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
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{the vertices that keep the positions that they have in the start, exactly if a start is given}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertex descriptors as keys and `bool` as values}
///     \cgalParamDefault{no vertex is fixed}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::start_map}
///     \cgalParamDescription{the map to begin with, without flipped triangles, in the units of the surface}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertex descriptors as keys and planar points as values}
///     \cgalParamDefault{a start is computed as `Traits::start` says}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::border_is_fixed}
///     \cgalParamDescription{whether all borders keep the shapes that they have in the start, be they convex or not}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::face_weight_map}
///     \cgalParamDescription{positive weights by which the areas of faces are multiplied in the mean energy}
///     \cgalParamType{a model of `ReadablePropertyMap` with face descriptors as keys and numbers as values}
///     \cgalParamDefault{all weights are 1}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::soft_positions}
///     \cgalParamDescription{places that vertices are pulled to, with weights, see there}
///     \cgalParamType{a range of `std::tuple<vertex_descriptor, Point_2, double>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::strict}
///     \cgalParamDescription{whether polygons that are no triangles, and faces without area, are refused}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::bijective}
///     \cgalParamDescription{whether the image must not overlap itself, see \ref FFMBijective; declared in
///     `CGAL/Flip_free_maps/bijective.h`}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns how it ended and what it cost; `Summary::is_valid()` tells whether `uv_map` was written. Bad input gives a status and
///   a message, not an exception: `no_border`, `empty_mesh`, `not_a_disk`, `non_manifold`, `degenerate_rest_element` if all vertices
///   coincide, `non_finite_input`, `start_not_flip_free`, `invalid_option`, `linear_solver_failed`, `line_search_failed`,
///   `result_not_representable`, `not_bijective`, `out_of_memory`; also `not_triangular` and `degenerate_rest_element` if it is to be
///   strict.
///
/// Complexity: linear in the number of faces except for one sparse factorization per iteration; memory is that of the factor and
/// some hundred bytes per face.
template <typename TriangleMesh, typename VertexUVMap, typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Summary parameterize(const TriangleMesh& mesh, typename internal::Halfedge_of<TriangleMesh>::type border_halfedge, VertexUVMap uv_map,
                     const Traits& traits, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vertex_points =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, mesh));
  Traits used = traits;
  used.options.max_iterations =
    static_cast<int>(choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), used.options.max_iterations));

  const auto given = [&](auto v, auto& p) {
    if constexpr(internal::Has_parameter<NamedParameters, internal::Start_map_tag>::value) {
      const auto q = get(get_parameter(np, internal::start_map_tag), v);
      p << CGAL::to_double(q[0]), CGAL::to_double(q[1]);
    }
    static_cast<void>(v);
    static_cast<void>(p);
    return internal::Has_parameter<NamedParameters, internal::Start_map_tag>::value;
  };
  const auto prepare = [&](auto& graph, internal::Planar_request& request, std::string& message) {
    Position_constraints<2>& constraints = request.constraints;
    if constexpr(internal::Has_parameter<NamedParameters, internal::Start_map_tag>::value)
      request.make_start = [&graph, &given](Positions<2>& x, std::string& name, std::string&) {
        name = "given";
        x.resize(2, graph.domain().number_of_vertices);
        for(std::int32_t v = 0; v < graph.domain().number_of_vertices; ++v) {
          internal::Vector<2> p;
          given(graph.vertices()[v], p);
          x.col(v) = p / graph.domain().scale;
        }
        return Status::success;
      };
    request.keeps_start = static_cast<bool>(request.make_start);
    request.is_bijective = choose_parameter(get_parameter(np, internal::bijective_tag), false);
    if constexpr(internal::Has_parameter<NamedParameters, CGAL::internal_np::vertex_is_constrained_t>::value) {
      const auto is_fixed = get_parameter(np, CGAL::internal_np::vertex_is_constrained);
      for(std::int32_t v = 0; v < graph.domain().number_of_vertices; ++v)
        if(get(is_fixed, graph.vertices()[v]))
          constraints.fixed_vertices.push_back(v);
    }
    if(choose_parameter(get_parameter(np, internal::border_is_fixed_tag), false)) {
      std::vector<std::int32_t>& fixed = constraints.fixed_vertices;
      fixed.insert(fixed.end(), graph.domain().border.begin(), graph.domain().border.end());
      for(const auto& hole : graph.domain().holes)
        fixed.insert(fixed.end(), hole.begin(), hole.end());
    }
    if constexpr(internal::Has_parameter<NamedParameters, internal::Soft_positions_tag>::value)
      for(const auto& soft : get_parameter(np, internal::soft_positions_tag)) {
        const auto& p = std::get<1>(soft);
        const std::int32_t v = graph.number_of(std::get<0>(soft));
        if(v < 0) {
          message = "soft position number " + std::to_string(constraints.soft_positions.size()) + " is not of a vertex of a face";
          return Status::invalid_option;
        }
        constraints.soft_positions.push_back(
          {v, internal::Vector<2>(CGAL::to_double(p[0]), CGAL::to_double(p[1])) / graph.domain().scale, std::get<2>(soft)});
      }
    if constexpr(internal::Has_parameter<NamedParameters, internal::Face_weight_map_tag>::value)
      if(!graph.weigh(get_parameter(np, internal::face_weight_map_tag))) {
        message = "the weights of faces must be positive and finite";
        return Status::invalid_option;
      }
    static_cast<void>(message);
    return Status::success;
  };
  internal::Planar_solver<Traits, internal::Has_parameter<NamedParameters, internal::Bijective_tag>::value> solver{used};
  return internal::parameterize_patch(mesh, border_halfedge, vertex_points, uv_map, used.options,
                                      choose_parameter(get_parameter(np, internal::strict_tag), false), prepare, given, solver);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with default named parameters.
template <typename TriangleMesh, typename VertexUVMap, typename Traits>
Summary parameterize(const TriangleMesh& mesh, typename internal::Halfedge_of<TriangleMesh>::type border_halfedge, VertexUVMap uv_map,
                     const Traits& traits)
{
  return parameterize(mesh, border_halfedge, uv_map, traits, CGAL::parameters::default_values());
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the method as a named parameter: `Flip_free_maps::parameters::map_traits` and `map_options`.
template <typename TriangleMesh, typename VertexUVMap, typename T, typename Tag, typename Base>
Summary parameterize(const TriangleMesh& mesh, typename internal::Halfedge_of<TriangleMesh>::type border_halfedge, VertexUVMap uv_map,
                     const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return parameterize(mesh, border_halfedge, uv_map, internal::chosen_traits<internal::Default_method>(np), np);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the default method and default named parameters.
template <typename TriangleMesh, typename VertexUVMap>
Summary parameterize(const TriangleMesh& mesh, typename internal::Halfedge_of<TriangleMesh>::type border_halfedge, VertexUVMap uv_map)
{
  return parameterize(mesh, border_halfedge, uv_map, internal::Default_method(), CGAL::parameters::default_values());
}

namespace internal {

// Named parameters with indices as keys, as parameters of a surface: points that are one vertex ask for the same, and faces have the
// user's numbers. `is_fixed` is where the fixed vertices are kept.
template <typename NamedParameters>
auto parameters_of_surface(const Triangle_surface& surface, const NamedParameters& np, std::vector<char>& is_fixed)
{
  using CGAL::parameters::get_parameter;
  const std::size_t size = surface.number_of_vertices();
  const auto fixed = [&] {
    if constexpr(Has_parameter<NamedParameters, CGAL::internal_np::vertex_is_constrained_t>::value) {
      const auto map = get_parameter(np, CGAL::internal_np::vertex_is_constrained);
      is_fixed.assign(size, 0);
      for(std::size_t v = 0; v < size; ++v) {
        const std::int32_t vertex = surface.vertex_of_point(static_cast<std::int32_t>(v));
        if(surface.is_used(vertex) && get(map, v))
          is_fixed[vertex] = 1;
      }
      return named_parameter<CGAL::internal_np::vertex_is_constrained_t>(Array_map<char>{&is_fixed}, np);
    } else {
      return np;
    }
  };
  const auto weighted = [&](const auto& base) {
    if constexpr(Has_parameter<NamedParameters, Face_weight_map_tag>::value) {
      const auto map = get_parameter(np, face_weight_map_tag);
      return named_parameter<Face_weight_map_tag>(Map_of_faces<std::decay_t<decltype(map)>>{&surface, map}, base);
    } else {
      return base;
    }
  };
  const auto pulled = [&](const auto& base) {
    if constexpr(Has_parameter<NamedParameters, Soft_positions_tag>::value) {
      std::vector<std::tuple<Surface_vertex, Vector<2>, double>> soft;
      for(const auto& [v, p, weight] : get_parameter(np, soft_positions_tag)) {
        const Surface_vertex given = vertex_of_index(v, size);
        soft.emplace_back(given.number < 0 ? given : Surface_vertex{surface.vertex_of_point(given)},
                          Vector<2>(CGAL::to_double(p[0]), CGAL::to_double(p[1])), weight);
      }
      return named_parameter<Soft_positions_tag>(soft, base);
    } else {
      return base;
    }
  };
  return pulled(weighted(fixed()));
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// The same for the component of the longest border, which is the outer one. The status is `no_border` if there is none.
template <typename TriangleMesh, typename VertexUVMap, typename T, typename Tag, typename Base,
          std::enable_if_t<!internal::Is_array<TriangleMesh>::value, int> = 0>
Summary parameterize(const TriangleMesh& mesh, VertexUVMap uv_map, const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vertex_points =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, mesh));
  const auto border = internal::longest_border(mesh, vertex_points);
  if(!border.has_value()) {
    Summary summary;
    summary.status = num_faces(mesh) == 0 ? Status::empty_mesh : Status::no_border;
    summary.message = num_faces(mesh) == 0 ? "the mesh has no faces" : "the surface is closed; it must be cut open, as by cut_to_disk()";
    return summary;
  }
  return parameterize(mesh, *border, uv_map, np);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the default method and default named parameters.
template <typename TriangleMesh, typename VertexUVMap, std::enable_if_t<!internal::Is_array<TriangleMesh>::value, int> = 0>
Summary parameterize(const TriangleMesh& mesh, VertexUVMap uv_map)
{
  return parameterize(mesh, uv_map, CGAL::parameters::default_values());
}

/// \ingroup PkgFlipFreeMapsRef
/// The same for arrays. The component of the longest border is flattened.
///
/// Points at the same place are one vertex if the faces would have more components otherwise, as those of a polygon soup that lists
/// the corners of each face. Of faces that occur twice, one is flattened.
///
/// \param points the points of the surface: a container with `operator[]`, as `std::vector`, of points in space. Those that no face
///   uses may have any value.
/// \param polygons the faces: a container of containers of indices into `points`, of any number of corners, or of triples of them
/// \param uv a container of planar points, which becomes as long as `points` if the map is valid, and is left untouched otherwise;
///   points that the component does not use get the value (0, 0)
/// \param np optional named parameters, as above, with indices as keys of property maps
/// \returns as above; also `invalid_option` for an index out of range
template <typename PointRange, typename PolygonRange, typename UVRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<internal::Is_array<PointRange>::value, int> = 0>
Summary parameterize(const PointRange& points, const PolygonRange& polygons, UVRange& uv,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  using Point = typename UVRange::value_type;
  internal::Triangle_surface surface;
  Summary summary;
  summary.status = surface.load(points, polygons, summary.message, internal::parameter_or(np, internal::strict_tag, false));
  if(summary.status != Status::success)
    return summary;
  if(surface.longest_border() == internal::Triangle_surface::NONE) {
    summary.status = Status::no_border;
    summary.message = "the surface is closed; it must be cut open before it can be flattened";
    return summary;
  }
  std::vector<Point> values(surface.number_of_vertices(), internal::make_point_2<Point>(0, 0));
  std::vector<char> is_fixed;
  summary = parameterize(surface, {surface.longest_border()}, internal::Array_map<Point>{&values},
                         internal::chosen_traits<internal::Default_method>(np), internal::parameters_of_surface(surface, np, is_fixed));
  if(!summary.is_valid())
    return summary;
  std::vector<Point> images;
  for(std::size_t v = 0; v < values.size(); ++v)
    images.push_back(values[surface.vertex_of_point(static_cast<std::int32_t>(v))]);
  uv = UVRange(images.begin(), images.end());
  return summary;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZE_H
