// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DEFORM_H
#define CGAL_FLIP_FREE_MAPS_DEFORM_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/constraints/internal/repeated_handles.h>
#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/domains/Face_graph_domain.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/domains/internal/write_positions.h>
#include <CGAL/Flip_free_maps/internal/account_run.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/repair/Foldover_free.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/Summary.h>
#include <CGAL/Flip_free_maps/report/internal/name_faces_without_area.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// A shape that is deformed again and again as its handles move: the matrix' pattern is analysed once, each move begins with the
/// result of the last one, and with its factorization as long as that serves. It is what an interactive program holds.
///
/// \tparam D 2 for planar shapes, 3 for solids
/// \tparam Traits must be a model of `MapTraits`. With `Splitting_map_traits` handles jump, iterations cost little, and the shape
///   keeps its place and the status is `flips_remain` where no map without flips was found.
///
/// All positions are in the user's units of length.
template <int D, typename Traits = Flip_free_map_traits<>>
class Deformation
{
public:
  /// Begins with the shape `start`, which must be without flips.
  ///
  /// \param domain the rest shape
  /// \param start a column for each vertex: often the rest shape itself
  /// \param handles the vertices that are held; duplicates do no harm
  /// \param traits the method and its settings
  Deformation(Simplicial_domain<D> domain, const Positions<D>& start, const std::vector<std::int32_t>& handles,
              const Traits& traits = Traits())
    : Deformation(std::move(domain), start, Position_constraints<D>{handles, {}, {}}, traits)
  {}

  /// The same with soft positions, whose targets are in the domain's units, beside the handles.
  Deformation(Simplicial_domain<D> domain, const Positions<D>& start, const Position_constraints<D>& constraints,
              const Traits& traits = Traits())
    : m_domain(std::move(domain)),
      m_handles(constraints.fixed_vertices),
      m_repeated(internal::repeated_handles(m_handles)),
      m_positions(start),
      m_minimizer(m_domain, traits, constraints)
  {
    m_minimizer.options().keep_factorization = true;
    m_x = (start.colwise() - m_domain.origin) / m_domain.scale;
  }

  Deformation(const Deformation&) = delete;
  Deformation& operator=(const Deformation&) = delete;

  /// The handles, in the order in which they were given.
  const std::vector<std::int32_t>& handles() const { return m_handles; }

  /// The current shape.
  const Positions<D>& positions() const { return m_positions; }

  /// The settings, `Map_options`, or `Splitting_options` with `Splitting_map_traits`; they may be changed between moves. An
  /// iteration limit of a few makes a move a quick one that leaves the rest to the next.
  auto& options() { return m_minimizer.options(); }

  /// Moves the handles to `targets`, a column for each, and optimises the shape. On the way there no element flips, however far
  /// the handles go. Handles are exactly at their targets afterwards, unless the time was up, or the observer ended the move, before
  /// they arrived: then they are on their way, and the message says so.
  ///
  /// \returns what happened; `unreachable_constraints` if no path was found, `non_finite_input` for targets that are no numbers,
  ///   `invalid_option` if a handle that is given twice has two targets.
  ///   The shape changes only if the summary `is_valid()`.
  Summary move(const Positions<D>& targets)
  {
    Summary summary;
    move(targets, summary);
    return summary;
  }

  /// The same, adding to the counts and times of a given summary.
  void move(const Positions<D>& targets, Summary& summary)
  {
    if(targets.cols() != static_cast<Eigen::Index>(m_handles.size())) {
      summary.status = Status::invalid_option;
      summary.message = "there must be one target for each handle";
      return;
    }
    for(const auto& [i, j] : m_repeated)
      if(targets.col(i) != targets.col(j)) {
        summary.status = Status::invalid_option;
        summary.message = internal::TWO_TARGETS;
        return;
      }
    Positions<D> all = m_x;
    for(std::size_t i = 0; i < m_handles.size(); ++i)
      if(m_handles[i] >= 0 && m_handles[i] < all.cols())
        all.col(m_handles[i]) = (targets.col(i) - m_domain.origin) / m_domain.scale;
    Positions<D> x = m_x;
    m_minimizer.move_fixed_vertices(x, all, summary);
    if(!summary.is_valid())
      return;

    // Scaling rounds; the result is checked in the numbers that are handed out.
    Positions<D> result = (m_domain.scale * x).colwise() + m_domain.origin;
    for(std::size_t i = 0; i < m_handles.size(); ++i)
      if(x.col(m_handles[i]) == all.col(m_handles[i]))
        result.col(m_handles[i]) = targets.col(i);
    internal::Element_coloring schedule;
    schedule.build(m_domain.elements, m_domain.number_of_vertices);
    const std::int64_t flips = internal::count_flips<typename Traits::Kernel, typename Traits::Concurrency_tag>(m_domain, schedule, result);
    if(flips > summary.flips) {
      summary.flips = flips;
      summary.status = Status::result_not_representable;
      summary.message = "elements flip when the shape is scaled to the user's units";
      return;
    }
    m_x.swap(x);
    m_positions.swap(result);
  }

private:
  Simplicial_domain<D> m_domain;
  std::vector<std::int32_t> m_handles;
  std::vector<std::pair<std::size_t, std::size_t>> m_repeated; // see `repeated_handles()`
  Positions<D> m_positions;
  Positions<D> m_x; // in the domain's units
  typename Traits::template Minimizer<D, Traits> m_minimizer;
};

namespace internal {

// Opens triangles without area in a planar shape `x`, in the domain's units: moves their vertices, and where that is not enough those
// of their neighbours, too.
template <typename Graph>
bool open_flat_triangles(const Graph& graph, Positions<2>& x, Summary& summary)
{
  const Simplicial_domain<2>& domain = graph.domain();
  std::vector<char> is_free(domain.number_of_vertices, 0);
  for(const std::int64_t e : graph.elements_without_area())
    for(const std::int32_t v : domain.elements[e])
      is_free[v] = 1;
  for(int rings = 0; rings < 3; ++rings) {
    Position_constraints<2> constraints;
    for(std::int32_t v = 0; v < domain.number_of_vertices; ++v)
      if(!is_free[v])
        constraints.fixed_vertices.push_back(v);
    if(Foldover_free<2>(domain, Flip_free_map_traits<>(), constraints).remove_flips(x, summary))
      return true;
    const std::vector<char> was_free = is_free;
    for(const auto& element : domain.elements)
      if(std::any_of(element.begin(), element.end(), [&](std::int32_t v) { return was_free[v]; }))
        for(const std::int32_t v : element)
          is_free[v] = 1;
  }
  summary.status = Status::start_not_flip_free;
  summary.message = "triangles without area cannot be opened: " + summary.message;
  return false;
}

// Deforms a planar mesh that `load(graph, start, message)` reads. Handles are pairs of the mesh' vertices and places.
template <typename TriangleMesh, typename Load, typename Handles, typename VertexPointMap2, typename Traits, typename NamedParameters>
Summary deform_planar(const TriangleMesh& mesh, Load&& load, const Handles& handles, VertexPointMap2 result, const Traits& traits,
                      const NamedParameters& np)
{
  static_cast<void>(np);
  Summary summary;
  Face_graph_domain<TriangleMesh> graph;
  Positions<2> x;
  const Deadline deadline(traits.options.max_seconds);
  const auto solve = [&] {
    const Simplicial_domain<2>& domain = graph.domain();
    if(!Has_parameter<NamedParameters, Start_map_tag>::value && !graph.elements_without_area().empty() &&
       !open_flat_triangles(graph, x, summary))
      return;
    x = (domain.scale * x).colwise() + domain.origin;
    summary.start = "rest shape";
    if constexpr(Has_parameter<NamedParameters, Start_map_tag>::value) {
      summary.start = "given";
      for(std::int32_t v = 0; v < domain.number_of_vertices; ++v) {
        const auto p = get(CGAL::parameters::get_parameter(np, start_map_tag), graph.vertices()[v]);
        x.col(v) << CGAL::to_double(p[0]), CGAL::to_double(p[1]);
      }
    }
    std::vector<std::int32_t> numbers;
    std::vector<Vector<2>> places;
    for(const auto& handle : handles) {
      numbers.push_back(graph.number_of(handle.first));
      places.push_back(Vector<2>(CGAL::to_double(handle.second[0]), CGAL::to_double(handle.second[1])));
      if(numbers.back() < 0) {
        summary.status = Status::invalid_option;
        summary.message = "a handle is not a vertex of a face";
        return;
      }
    }
    Positions<2> targets(2, places.size());
    for(std::size_t i = 0; i < places.size(); ++i)
      targets.col(i) = places[i];
    Deformation<2, Traits> deformation(domain, x, numbers, traits);
    deformation.move(targets, summary);
    x = deformation.positions();
  };
  run_map(
    summary, [&](std::string& message) { return load(graph, x, message); }, solve,
    [&] {
      write_positions<typename Traits::Kernel>(graph.domain(), graph.vertices(), x, result, summary);
      name_faces_without_area(graph.faces_without_area(mesh), summary);
    });
  return summary;
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Deforms a planar shape: vertices that are handles go where they are told, the others follow with as little distortion as
/// possible, and no triangle flips. For handles that move again and again see `Deformation`.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph` whose descriptors are `Hashable`
/// \tparam Handles a range of pairs of vertex descriptors and planar points
/// \tparam VertexPointMap2 must be a model of `WritablePropertyMap` with vertex descriptors as keys and planar points as values
/// \tparam Traits must be a model of `MapTraits`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a connected mesh in the plane, counterclockwise, with any number of borders. Faces may be polygons, and faces without
///   area are opened a little, as `parameterize()` does it
/// \param handles the handles and their targets; a vertex may be given more than once, with the same target
/// \param result receives the deformed shape. It is written once, at the end, if the map is valid, and left untouched otherwise.
/// \param traits the method and its settings
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertex descriptors as keys and points in the plane, or in space with the
///     same third coordinate, as values}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::start_map}
///     \cgalParamDescription{the shape to begin with, instead of the one at rest}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertex descriptors as keys and planar points as values}
///     \cgalParamDefault{the shape at rest}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::strict}
///     \cgalParamDescription{whether polygons that are no triangles, and faces without area, are refused}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns how it ended and what it cost: as `parameterize()`, or `not_planar`,
///   `several_components` or `unreachable_constraints`
template <typename TriangleMesh, typename Handles, typename VertexPointMap2, typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<!internal::Is_array<TriangleMesh>::value, int> = 0>
Summary deform(const TriangleMesh& mesh, const Handles& handles, VertexPointMap2 result, const Traits& traits,
               const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vertex_points =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, mesh));
  const bool is_strict = choose_parameter(get_parameter(np, internal::strict_tag), false);
  return internal::deform_planar(
    mesh, [&](auto& graph, Positions<2>& x, std::string& message) { return graph.load_planar(mesh, vertex_points, x, message, is_strict); },
    handles, result, traits, np);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the method as a named parameter: `Flip_free_maps::parameters::map_traits` and `map_options`.
template <typename TriangleMesh, typename Handles, typename VertexPointMap2, typename T, typename Tag, typename Base,
          std::enable_if_t<!internal::Is_array<TriangleMesh>::value, int> = 0>
Summary deform(const TriangleMesh& mesh, const Handles& handles, VertexPointMap2 result,
               const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return deform(mesh, handles, result, internal::chosen_traits<Flip_free_map_traits<>>(np), np);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the default method.
template <typename TriangleMesh, typename Handles, typename VertexPointMap2>
Summary deform(const TriangleMesh& mesh, const Handles& handles, VertexPointMap2 result)
{
  return deform(mesh, handles, result, Flip_free_map_traits<>(), CGAL::parameters::default_values());
}

/// \ingroup PkgFlipFreeMapsRef
/// The same for arrays. Points at the same place are one vertex if the faces would have several components otherwise. Of faces that
/// occur twice, one counts.
///
/// \param points the points of the shape: a container with `operator[]`, as `std::vector`, of points in the plane, or in space with
///   the same third coordinate
/// \param polygons the faces: a container of containers of indices into `points`, of any number of corners, or of triples of them
/// \param handles pairs of an index into `points` and a planar point
/// \param result a container of planar points, which becomes as long as `points` if the map is valid, and is left untouched otherwise;
///   points that no face uses stay where they are
/// \param np optional named parameters: `map_traits`, `map_options`, `strict` and `start_map`, with indices as keys
/// \returns as for meshes; also `invalid_option` for an index out of range and `non_manifold`
template <typename PointRange, typename PolygonRange, typename Handles, typename ResultRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<internal::Is_array<PointRange>::value, int> = 0>
Summary deform(const PointRange& points, const PolygonRange& polygons, const Handles& handles, ResultRange& result,
               const NamedParameters& np = CGAL::parameters::default_values())
{
  using Point = typename ResultRange::value_type;
  const bool is_strict = internal::parameter_or(np, internal::strict_tag, false);
  internal::Triangle_surface surface;
  std::vector<Point> values;
  std::vector<std::pair<internal::Surface_vertex, internal::Vector<2>>> vertex_handles;
  const auto load = [&](auto& graph, Positions<2>& x, std::string& message) {
    const Status status = surface.load(points, polygons, message, is_strict);
    if(status != Status::success)
      return status;
    for(const auto& p : points)
      values.push_back(internal::make_point_2<Point>(CGAL::to_double(p[0]), CGAL::to_double(p[1])));
    for(const auto& [v, p] : handles) {
      const internal::Surface_vertex given = internal::vertex_of_index(v, points.size());
      vertex_handles.emplace_back(given.number < 0 ? given : internal::Surface_vertex{surface.vertex_of_point(given)},
                                  internal::Vector<2>(CGAL::to_double(p[0]), CGAL::to_double(p[1])));
    }
    return graph.load_planar(surface, get(CGAL::vertex_point, surface), x, message, is_strict);
  };
  const Summary summary = internal::deform_planar(surface, load, vertex_handles, internal::Array_map<Point>{&values},
                                                  internal::chosen_traits<Flip_free_map_traits<>>(np), np);
  if(!summary.is_valid())
    return summary;
  std::vector<Point> places;
  for(std::size_t v = 0; v < values.size(); ++v)
    places.push_back(values[surface.vertex_of_point(static_cast<std::int32_t>(v))]);
  result = ResultRange(places.begin(), places.end());
  return summary;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DEFORM_H
