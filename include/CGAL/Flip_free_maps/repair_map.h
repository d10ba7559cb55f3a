// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPAIR_MAP_H
#define CGAL_FLIP_FREE_MAPS_REPAIR_MAP_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/constraints/internal/Obstructions.h>
#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/domains/Face_graph_domain.h>
#include <CGAL/Flip_free_maps/domains/Map_measure.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/domains/internal/write_positions.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/internal/account_run.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/minimizer/polish_map.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/repair/Repair_options.h>
#include <CGAL/Flip_free_maps/repair/internal/Flip_removal.h>
#include <CGAL/Flip_free_maps/report/Summary.h>
#include <CGAL/Flip_free_maps/report/internal/name_faces_without_area.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

namespace internal {

template <int D>
void fix_borders(const Simplicial_domain<D>& domain, Position_constraints<D>& constraints)
{
  std::vector<std::int32_t>& fixed = constraints.fixed_vertices;
  fixed.insert(fixed.end(), domain.border.begin(), domain.border.end());
  for(const auto& hole : domain.holes)
    fixed.insert(fixed.end(), hole.begin(), hole.end());
}

// Polishes a map without flips. Where that fails, and what is left is as good as collapsed, so does the repair.
template <int D, typename Traits>
void polish_repaired(const Simplicial_domain<D>& domain, const Traits& traits, const Position_constraints<D>& constraints, Positions<D>& x,
                     Summary& summary)
{
  // A map by whose inverse nothing can be told any more: half of the digits are lost.
  constexpr double COLLAPSED = 1e-8;
  if(polish_map<typename Traits::template Minimizer<D, Traits>>(domain, traits, constraints, x, summary))
    return;
  const Map_measure<D, typename Traits::Kernel, typename Traits::Concurrency_tag> measure(domain);
  std::tie(summary.min_singular_value, summary.max_singular_value) = measure.singular_value_range(x);
  if(summary.min_singular_value >= COLLAPSED)
    return;
  summary.status = Status::line_search_failed;
  summary.message += "; some elements are as good as collapsed, the smallest singular value is ";
  char number[32];
  std::snprintf(number, sizeof number, "%.2e", summary.min_singular_value);
  summary.message += number;
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Turns any map into one without flipped elements, and then minimises its distortion without flipping an element again. Two
/// methods take turns: the splitting scheme, stopped at its first iterate without flips (Stein, Li and Solomon 2022), or when
/// flips become no fewer, and a regularised energy (Garanzha et al. 2021), which moves what is near the flips and, where that
/// fails, everything. In space, where the splitting needs many iterations, the energy near the flips is tried first, in the plane
/// after the splitting. A map most of which is mirrored is mirrored first, if no position is constrained.
///
/// All elements are positively oriented then, but where flips were many the map may turn twice around a vertex, and the elements
/// around it overlap, see `Splitting_minimizer`.
///
/// \tparam D dimension, 2 or 3
/// \tparam Traits must be a model of `MapTraits`: what the polish minimises, and how
///
/// \param domain the simplices with their rest shapes
/// \param x the map, in the domain's units; on return the result if the summary `is_valid()`, otherwise unchanged
/// \param constraints fixed vertices keep their positions exactly
/// \param options what is done
/// \param traits the polish
/// \returns what happened; `Summary::start` names the methods that were tried. When the fixed vertices alone exclude a map without
///   flips, nothing is tried: the status is `unreachable_constraints`, and `Summary::impossible_elements` or
///   `Summary::impossible_edges` tell why. When no method finds a map without flips, the status is `flips_remain`, and
///   `Summary::flipped_elements` are those of the best map. When the polish fails,
///   the map that it was given is the result, and `Summary::message` says so; if elements of that are as good as collapsed, with a
///   singular value below 1e-8, the status is `line_search_failed`. Other failures are those of
///   `Splitting_minimizer::minimize()`; settings of the polish that are out of range are `invalid_option` even if there is no
///   polish.
///
/// Complexity: see `Splitting_minimizer` and `Map_minimizer`.
template <int D, typename Traits = Flip_free_map_traits<>>
Summary repair_map(const Simplicial_domain<D>& domain, Positions<D>& x,
                   const Position_constraints<D>& constraints = Position_constraints<D>(), const Repair_options& options = Repair_options(),
                   const Traits& traits = Traits())
{
  Summary summary;
  const auto run = [&] {
    if(!options.is_valid(&summary.message) || !traits.options.is_valid(&summary.message) ||
       !constraints.is_valid(domain.number_of_vertices, &summary.message) ||
       !internal::has_no_sliding_vertices(constraints, &summary.message)) {
      summary.status = Status::invalid_option;
      return;
    }
    Position_constraints<D> used = constraints;
    if(options.fix_border)
      internal::fix_borders(domain, used);

    Positions<D> result = x;
    if(used.empty() && x.cols() == domain.number_of_vertices && x.allFinite()) {
      double mirrored = 0;
      for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
        if(domain.jacobian(e, x).determinant() < 0)
          mirrored += domain.measures[e];
      if(mirrored > 0.5)
        result.row(0) *= -1;
    }
    const Positions<D> given = result;

    const bool is_usable = given.cols() == domain.number_of_vertices && given.allFinite();
    if(is_usable && internal::Obstructions<D, typename Traits::Kernel>(domain, used.fixed_vertices, given).find(summary))
      return;
    using Repair_traits = internal::Repair_traits_of<Traits>;
    internal::Flip_removal<D, Repair_traits> removal(domain, Repair_traits(traits), used, options);
    if(!removal.run(given, result, summary))
      return;

    if(options.polish && !removal.is_stopped())
      internal::polish_repaired(domain, traits, used, result, summary);
    if(summary.is_valid())
      x = result;
  };
  internal::account_run(summary, run);
  return summary;
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template Summary repair_map<2, Flip_free_map_traits<>>(const Simplicial_domain<2>&, Positions<2>&, const Position_constraints<2>&,
                                                              const Repair_options&, const Flip_free_map_traits<>&);
extern template Summary repair_map<3, Flip_free_map_traits<>>(const Simplicial_domain<3>&, Positions<3>&, const Position_constraints<3>&,
                                                              const Repair_options&, const Flip_free_map_traits<>&);
extern template Summary repair_map<3, Any_map_traits>(const Simplicial_domain<3>&, Positions<3>&, const Position_constraints<3>&,
                                                      const Repair_options&, const Any_map_traits&);
extern template Summary repair_map<3, Flip_free_map_traits<CGAL::Default, Symmetric_gradient>>(
  const Simplicial_domain<3>&, Positions<3>&, const Position_constraints<3>&, const Repair_options&,
  const Flip_free_map_traits<CGAL::Default, Symmetric_gradient>&);
#endif

/// \ingroup PkgFlipFreeMapsRef
/// The same with named parameters: `map_traits`, `map_options` and `repair_options` of `Flip_free_maps::parameters`.
template <int D, typename T, typename Tag, typename Base>
Summary repair_map(const Simplicial_domain<D>& domain, Positions<D>& x, const Position_constraints<D>& constraints,
                   const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return repair_map(domain, x, constraints, internal::parameter_or(np, internal::repair_options_tag, Repair_options()),
                    internal::chosen_traits<Flip_free_map_traits<>>(np));
}

namespace internal {

// Repairs the uv map of a patch of `mesh`, which `load(graph, message)` reads.
template <typename TriangleMesh, typename Load, typename VertexUVMap, typename Traits, typename NamedParameters>
Summary repair_patch(const TriangleMesh& mesh, Load&& load, VertexUVMap uv_map, const Repair_options& options, const Traits& traits,
                     const NamedParameters& np)
{
  static_cast<void>(np);
  Summary summary;
  Face_graph_domain<TriangleMesh> graph;
  Positions<2> given, x;
  Position_constraints<2> constraints;
  const auto solve = [&] {
    const Simplicial_domain<2>& domain = graph.domain();
    given.resize(2, domain.number_of_vertices);
    for(std::size_t v = 0; v < graph.vertices().size(); ++v) {
      const auto p = get(uv_map, graph.vertices()[v]);
      given.col(v) << CGAL::to_double(p[0]), CGAL::to_double(p[1]);
      if constexpr(Has_parameter<NamedParameters, CGAL::internal_np::vertex_is_constrained_t>::value)
        if(get(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_is_constrained), graph.vertices()[v]))
          constraints.fixed_vertices.push_back(static_cast<std::int32_t>(v));
    }
    x = given / domain.scale;
    summary = repair_map(domain, x, constraints, options, traits);
  };
  run_map(
    summary, [&](std::string& message) { return load(graph, message); }, solve,
    [&] {
      x *= graph.domain().scale;
      if(options.fix_border)
        fix_borders(graph.domain(), constraints);
      for(const std::int32_t v : constraints.fixed_vertices)
        x.col(v) = given.col(v);
      write_positions<typename Traits::Kernel>(graph.domain(), graph.vertices(), x, uv_map, summary);
      name_faces_without_area(graph.faces_without_area(mesh), summary);
    });
  return summary;
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// The same for the uv map of a surface patch, which may have polygons and faces without area as that of `parameterize()`.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph` whose descriptors are `Hashable`
/// \tparam VertexUVMap must be a model of `ReadWritePropertyMap` with vertex descriptors as keys and planar points as values
/// \tparam Traits must be a model of `MapTraits`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a mesh
/// \param border_halfedge a halfedge on the border of the component to be mapped, which must be a topological disk
/// \param uv_map the map, which is read; it is written once, at the end, if the result is valid, and left untouched otherwise
/// \param options what is done
/// \param traits the polish
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertex descriptors as keys and points in space as values}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{the vertices that stay exactly where they are}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertex descriptors as keys and `bool` as values}
///     \cgalParamDefault{no vertex is fixed}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::strict}
///     \cgalParamDescription{whether polygons that are no triangles, and faces without area, are refused}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
template <typename TriangleMesh, typename VertexUVMap, typename Traits = Flip_free_map_traits<>,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Summary repair_map(const TriangleMesh& mesh, typename internal::Halfedge_of<TriangleMesh>::type border_halfedge, VertexUVMap uv_map,
                   const Repair_options& options = Repair_options(), const Traits& traits = Traits(),
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vertex_points =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, mesh));
  const bool is_strict = choose_parameter(get_parameter(np, internal::strict_tag), false);
  return internal::repair_patch(
    mesh, [&](auto& graph, std::string& message) { return graph.load(mesh, border_halfedge, vertex_points, message, is_strict); }, uv_map,
    options, traits, np);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the method and what is done as named parameters: `map_traits`, `map_options` and `repair_options` of
/// `Flip_free_maps::parameters`.
template <typename TriangleMesh, typename VertexUVMap, typename T, typename Tag, typename Base>
Summary repair_map(const TriangleMesh& mesh, typename internal::Halfedge_of<TriangleMesh>::type border_halfedge, VertexUVMap uv_map,
                   const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return repair_map(mesh, border_halfedge, uv_map, internal::parameter_or(np, internal::repair_options_tag, Repair_options()),
                    internal::chosen_traits<Flip_free_map_traits<>>(np), np);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same for arrays. The component of the longest border is repaired. Of faces that occur twice, one counts.
///
/// \param points the points of the surface: a container with `operator[]`, as `std::vector`, of points in space
/// \param polygons the faces: a container of containers of indices into `points`, of any number of corners, or of triples of them.
///   Points at the same place are not the same for that: they may have different images.
/// \param uv the image of each point, a container of planar points as long as `points`; changed if the map is valid
/// \param np optional named parameters, as above, with indices as keys of property maps
/// \returns as above; also `invalid_option` for an index out of range or a map of another length
template <typename PointRange, typename PolygonRange, typename UVRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<internal::Is_array<PointRange>::value, int> = 0>
Summary repair_map(const PointRange& points, const PolygonRange& polygons, UVRange& uv,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  using Point = typename UVRange::value_type;
  const bool is_strict = internal::parameter_or(np, internal::strict_tag, false);
  internal::Triangle_surface surface;
  std::vector<Point> values(uv.begin(), uv.end());
  const auto load = [&](auto& graph, std::string& message) {
    if(uv.size() != points.size()) {
      message = "the map must have an image for each point";
      return Status::invalid_option;
    }
    internal::Polygon_soup soup;
    Status status = internal::read_polygon_soup(points, polygons, soup, message);
    soup.is_welded = true;
    if(status == Status::success)
      status = surface.load(std::move(soup), is_strict, message);
    if(status != Status::success)
      return status;
    return graph.load(surface, {surface.longest_border()}, get(CGAL::vertex_point, surface), message, is_strict);
  };
  const Summary summary = internal::repair_patch(surface, load, internal::Array_map<Point>{&values},
                                                 internal::parameter_or(np, internal::repair_options_tag, Repair_options()),
                                                 internal::chosen_traits<Flip_free_map_traits<>>(np), np);
  if(summary.is_valid())
    uv = UVRange(values.begin(), values.end());
  return summary;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPAIR_MAP_H
