// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DEFORM_VOLUME_H
#define CGAL_FLIP_FREE_MAPS_DEFORM_VOLUME_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/constraints/internal/Obstructions.h>
#include <CGAL/Flip_free_maps/constraints/internal/repeated_handles.h>
#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/domains/Volume_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/internal/account_run.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Settings of `deform_volume()`.
struct Deform_volume_options
{
  /// If positive, handles are pulled to their targets instead of being held there: this times the squared distance in the
  /// domain's units, in which the volume is 1, is added to the mean energy for each.
  double soft_weight = 0;
  /// The shape to begin with, without flips: user's coordinates of the vertices by their numbers in the domain.
  /// Empty for the rest shape.
  Positions<3> start = Positions<3>(3, 0);
};

namespace internal {

// Deforms a solid that `load(message)` reads into `volume`.
template <typename Vertex, typename World, typename Load, typename Handles, typename VertexPointMap, typename Traits>
Summary deform_loaded_volume(Load&& load, const Volume_domain<Vertex, World>& volume, const Handles& handles, VertexPointMap result,
                             const Traits& traits, const Deform_volume_options& options)
{
  Summary summary;
  summary.dimension = 3;
  const Simplicial_domain<3>& domain = volume.domain();
  std::vector<std::pair<std::int32_t, Eigen::Vector3d>> exact_places;
  Positions<3> x;
  const auto fail = [&summary](Status status, const std::string& message) {
    summary.status = status;
    summary.message = message;
  };
  const Deadline deadline(traits.options.max_seconds);
  const auto solve = [&] {
    if(!volume.world().any(domain.number_of_elements() > 0))
      return fail(Status::empty_mesh, "the domain holds no tetrahedra");
    if(volume.number_of_components() > 1)
      return fail(Status::several_components, "the tetrahedra form several components");
    if(!(options.soft_weight >= 0) || !std::isfinite(options.soft_weight) ||
       (options.start.cols() != 0 && options.start.cols() != domain.number_of_vertices))
      return fail(Status::invalid_option, "soft_weight must be finite and not negative, and a start must have a column for each vertex");
    Position_constraints<3> constraints;
    x = domain.rest_points;
    summary.start = options.start.cols() == 0 ? "rest shape" : "given";
    if(options.start.cols() != 0)
      x = (options.start.colwise() - domain.origin) / domain.scale;
    Positions<3> targets = x;
    for(const auto& handle : handles) {
      const std::int32_t v = volume.number(handle.first);
      if(v < 0)
        return fail(Status::invalid_option, "a handle is not a vertex of a tetrahedron");
      const Eigen::Vector3d place(CGAL::to_double(handle.second[0]), CGAL::to_double(handle.second[1]), CGAL::to_double(handle.second[2]));
      if(options.soft_weight > 0) {
        constraints.soft_positions.push_back({v, volume.to_domain(place), options.soft_weight});
        continue;
      }
      constraints.fixed_vertices.push_back(v);
      targets.col(v) = volume.to_domain(place);
      exact_places.emplace_back(v, place);
    }
    for(const auto& [i, j] : repeated_handles(constraints.fixed_vertices))
      if(exact_places[i].second != exact_places[j].second)
        return fail(Status::invalid_option, TWO_TARGETS + (", as numbers " + std::to_string(i)) + " and " + std::to_string(j));
    // Where the whole mesh is: the faces of a part are no boundary.
    if constexpr(World::is_sequential)
      if(targets.allFinite() && Obstructions<3, typename Traits::Kernel>(domain, constraints.fixed_vertices, targets).find(summary))
        return;
    typename Traits::template Minimizer<3, Traits> minimizer(domain, traits, constraints);
    minimizer.move_fixed_vertices(x, targets, summary);
    const auto is_on_its_way = [&](const auto& place) { return x.col(place.first) != targets.col(place.first); };
    exact_places.erase(std::remove_if(exact_places.begin(), exact_places.end(), is_on_its_way), exact_places.end());
  };
  const auto write = [&] {
    std::string message;
    const Status status = volume.write_back(x, result, message, exact_places);
    if(status != Status::success)
      fail(status, message);
  };
  run_map(summary, load, solve, write, volume.world());
  return summary;
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Deforms a solid: vertices that are handles go where they are told, the others follow with as little distortion as possible,
/// and no tetrahedron flips. For handles that move again and again see `Deformation`.
///
/// \tparam Vertex what the user names a vertex by: a handle of a triangulation, or a number
/// \tparam Handles a range of pairs of `Vertex` and points in space
/// \tparam VertexPointMap must be a model of `WritablePropertyMap` with `Vertex` as key and points in space as values
/// \tparam Traits must be a model of `MapTraits`
///
/// \param volume the rest shape: a loaded `Mesh_complex_3_domain`, `Triangulation_3_domain`,
///   `Tetgen_domain` or `Tetrahedral_domain`
/// \param handles the handles and their targets; a vertex may be given more than once, but held at one target only
/// \param result receives the deformed positions of all vertices of tetrahedra. It is written once, at the end, if the map is
///   valid, and left untouched otherwise; the points of the user's mesh are never moved.
/// \param traits the method and its settings
/// \param options soft handles, and another start
///
/// \returns how it ended and what it cost: a valid map, or one of `empty_mesh`, `several_components` (each needs handles of its
///   own: deform them one by one), `invalid_option`, `unreachable_constraints`, `non_finite_input`, `linear_solver_failed`,
///   `line_search_failed`, `result_not_representable` and `out_of_memory`. Where the targets alone exclude a map without flips
///   it is said at once, by `Summary::impossible_elements` and `Summary::impossible_edges`.
template <typename Vertex, typename Handles, typename VertexPointMap, typename Traits = Flip_free_map_traits<>>
Summary deform_volume(const Volume_domain<Vertex>& volume, const Handles& handles, VertexPointMap result, const Traits& traits = Traits(),
                      const Deform_volume_options& options = Deform_volume_options())
{
  return internal::deform_loaded_volume([](std::string&) { return Status::success; }, volume, handles, result, traits, options);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with named parameters: `map_traits`, `map_options` and `volume_options` of `Flip_free_maps::parameters`.
template <typename Vertex, typename Handles, typename VertexPointMap, typename T, typename Tag, typename Base>
Summary deform_volume(const Volume_domain<Vertex>& volume, const Handles& handles, VertexPointMap result,
                      const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return deform_volume(volume, handles, result, internal::chosen_traits<Flip_free_map_traits<>>(np),
                       internal::parameter_or(np, internal::volume_options_tag, Deform_volume_options()));
}

/// \ingroup PkgFlipFreeMapsRef
/// The same for arrays.
///
/// \param points the points of the solid: a container with `operator[]`, as `std::vector`, of points in space
/// \param tetrahedra the tetrahedra: a container of quadruples of indices into `points`
/// \param handles pairs of an index into `points` and a point in space
/// \param result a container of points in space, which becomes as long as `points` if the map is valid, and is left untouched
///   otherwise; points that no tetrahedron uses stay where they are
/// \param np optional named parameters, as above
/// \returns as above, or what `Tetrahedral_domain::load()` finds
template <typename PointRange, typename TetrahedronRange, typename Handles, typename ResultRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<internal::Is_array<PointRange>::value, int> = 0>
Summary deform_volume(const PointRange& points, const TetrahedronRange& tetrahedra, const Handles& handles, ResultRange& result,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  using Point = typename ResultRange::value_type;
  Tetrahedral_domain volume;
  std::vector<Point> values;
  std::vector<std::pair<std::size_t, Eigen::Vector3d>> vertex_handles;
  for(const auto& [v, p] : handles)
    vertex_handles.emplace_back(static_cast<std::size_t>(v),
                                Eigen::Vector3d(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])));
  const auto load = [&](std::string& message) {
    for(const auto& p : points)
      values.push_back(internal::make_point_3<Point>(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])));
    return volume.load(points, tetrahedra, message);
  };
  const Summary summary = internal::deform_loaded_volume<std::size_t, Sequential_world>(
    load, volume, vertex_handles, internal::Array_map<Point>{&values}, internal::chosen_traits<Flip_free_map_traits<>>(np),
    internal::parameter_or(np, internal::volume_options_tag, Deform_volume_options()));
  if(summary.is_valid())
    result = ResultRange(values.begin(), values.end());
  return summary;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DEFORM_VOLUME_H
