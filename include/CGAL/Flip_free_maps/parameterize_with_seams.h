// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PARAMETERIZE_WITH_SEAMS_H
#define CGAL_FLIP_FREE_MAPS_PARAMETERIZE_WITH_SEAMS_H

#include <CGAL/Flip_free_maps/domains/Face_graph_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/write_positions.h>
#include <CGAL/Flip_free_maps/initializers/internal/adapt_to_developable.h>
#include <CGAL/Flip_free_maps/initializers/internal/make_start.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/account_run.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/seams/find_seams.h>
#include <CGAL/Flip_free_maps/seams/meet_seam_constraints.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSeams
/// Flattens a surface that is cut along seams such that the two sides of each seam fit together: by a similarity, or by a
/// rotation by a multiple of 90 degrees and a translation (a seamless map), see `meet_seam_constraints()`. A seam is a chain of
/// seam edges between vertices where it ends, branches, meets the border or passes a cone, a vertex of great curvature; each has
/// one transformation. Cones of a map are at ends of seams, so there should be seams to some points of great curvature,
/// at least three on a sphere.
///
/// \tparam SeamMesh must be a `CGAL::Seam_mesh` of triangles
/// \tparam VertexUVMap must be a model of `WritablePropertyMap` with vertex descriptors of the seam mesh as keys and planar
///   points as values
/// \tparam Traits must be a model of `MapTraits`
///
/// \param mesh the cut surface; the component of `border_halfedge` must be a topological disk, or one with holes
/// \param border_halfedge a halfedge on the outer border of the cut surface, on a seam for example
/// \param uv_map receives the map as `parameterize()` writes it,
///   if the map is valid and the seams meet their tolerance; untouched otherwise
/// \param options what relates the sides of a seam, and how exactly
/// \param traits the method and its settings
/// \param np optional named parameters: `vertex_point_map`, as in `parameterize()`
/// \returns the account of the run, with the residual and the transformations, in the order of `find_seams()`. The statuses are
///   those of `parameterize()`, and `unreachable_constraints`.
///
/// Complexity: some ten runs of the minimiser from one solution to the next.
template <typename SeamMesh, typename VertexUVMap, typename Traits = Flip_free_map_traits<>,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Seam_summary parameterize_with_seams(const SeamMesh& mesh, typename boost::graph_traits<SeamMesh>::halfedge_descriptor border_halfedge,
                                     VertexUVMap uv_map, const Seam_options& options = Seam_options(), const Traits& traits = Traits(),
                                     const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vertex_points =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, mesh));
  Seam_summary summary;
  Face_graph_domain<SeamMesh> graph;
  Positions<2> x;
  const Deadline deadline(traits.options.max_seconds);
  const auto solve = [&] {
    const Simplicial_domain<2>& domain = graph.domain();
    Traits used = traits;
    internal::adapt_to_developable(domain, used);
    double seconds = 0;
    {
      const internal::Phase_timer timer(seconds);
      summary.status = internal::make_start(domain, used, x, summary.start, summary.message);
    }
    if(summary.status == Status::success) {
      const std::string start = summary.start;
      summary = meet_seam_constraints(domain, x, find_seams(mesh, graph, options.cone_curvature), options, used);
      summary.start = start;
      if(summary.status == Status::time_limit || summary.status == Status::stopped_by_observer) {
        summary.status = Status::interrupted;
        summary.message += ", and the seams do not fit together yet";
      }
    }
    summary.seconds.start += seconds;
  };
  internal::run_map(
    summary, [&](std::string& message) { return graph.load(mesh, border_halfedge, vertex_points, message); }, solve,
    [&] {
      x *= graph.domain().scale;
      internal::write_positions<typename Traits::Kernel>(graph.domain(), graph.vertices(), x, uv_map, summary);
    });
  return summary;
}

/// \ingroup PkgFlipFreeMapsSeams
/// The same with named parameters: `map_traits`, `map_options` and `seam_options` of `Flip_free_maps::parameters`.
template <typename SeamMesh, typename VertexUVMap, typename T, typename Tag, typename Base>
Seam_summary parameterize_with_seams(const SeamMesh& mesh, typename boost::graph_traits<SeamMesh>::halfedge_descriptor border_halfedge,
                                     VertexUVMap uv_map, const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return parameterize_with_seams(mesh, border_halfedge, uv_map, internal::parameter_or(np, internal::seam_options_tag, Seam_options()),
                                 internal::chosen_traits<Flip_free_map_traits<>>(np), np);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZE_WITH_SEAMS_H
