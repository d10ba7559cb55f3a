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
#include <CGAL/Flip_free_maps/internal/catch_out_of_memory.h>
#include <CGAL/Flip_free_maps/seams/find_seams.h>
#include <CGAL/Flip_free_maps/seams/meet_seam_constraints.h>

#include <string>
#include <vector>

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
/// \returns the account of the run, with the residual and the transformations, in the order of `find_seams()`. The statuses are
///   those of `parameterize()`, and `unreachable_constraints`.
///
/// Complexity: some ten runs of the minimiser from one solution to the next.
template <typename SeamMesh, typename VertexUVMap, typename Traits = Flip_free_map_traits<>>
Seam_summary parameterize_with_seams(const SeamMesh& mesh, typename boost::graph_traits<SeamMesh>::halfedge_descriptor border_halfedge,
                                     VertexUVMap uv_map, const Seam_options& options = Seam_options(), const Traits& traits = Traits())
{
  Seam_summary summary;
  double seconds = 0, cpu_seconds = 0;
  const auto run = [&] {
    const internal::Phase_timer total(seconds, &cpu_seconds);
    Face_graph_domain<SeamMesh> graph;
    summary.status = graph.load(mesh, border_halfedge, get(CGAL::vertex_point, mesh), summary.message);
    if(summary.status != Status::success)
      return;
    const Simplicial_domain<2>& domain = graph.domain();
    Traits used = traits;
    internal::adapt_to_developable(domain, used);
    Positions<2> x;
    summary.status = internal::make_start(domain, used, x, summary.start, summary.message);
    if(summary.status != Status::success)
      return;
    const std::string start = summary.start;
    summary = meet_seam_constraints(domain, x, find_seams(mesh, graph, options.cone_curvature), options, used);
    summary.start = start;
    if(!summary.is_valid())
      return;
    x *= domain.scale;
    internal::write_positions<typename Traits::Kernel>(domain, graph.vertices(), x, uv_map, summary);
  };
  internal::catch_out_of_memory(run, summary);
  summary.seconds.total = seconds;
  summary.cpu_seconds = cpu_seconds;
  return summary;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZE_WITH_SEAMS_H
