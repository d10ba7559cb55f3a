// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_MESH_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_MESH_H

#include <CGAL/Flip_free_maps/cutting/Cut_options.h>
#include <CGAL/Flip_free_maps/cutting/Cut_summary.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_planner.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_surface.h>
#include <CGAL/Flip_free_maps/domains/internal/Linked_triangles.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/catch_out_of_memory.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Cuts the pieces of a mesh open and enters the new seams; writes nothing on failure. `is_feature(e)` says which edges are preferred.
// Once `must_stop()` holds there are no more seams than are needed, and they are not improved.
template <typename TriangleMesh, typename VertexPointMap, typename EdgeIsCutMap, typename IsFeature>
Cut_summary cut_mesh(const TriangleMesh& mesh, const VertexPointMap& vertex_points, EdgeIsCutMap edge_is_cut, const IsFeature& is_feature,
                     const Cut_options& options, const std::function<bool()>& must_stop = nullptr)
{
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  Cut_summary summary;
  const auto run = [&] {
    const Phase_timer timer(summary.seconds);
    if(!options.is_valid(&summary.message)) {
      summary.status = Status::invalid_option;
      return;
    }
    Cut_surface surface;
    std::vector<Edge> edges;
    summary.status = load_cut_surface(
      mesh, vertex_points, [&edge_is_cut](const Edge& e) { return static_cast<bool>(get(edge_is_cut, e)); }, is_feature, surface, edges,
      summary.message);
    if(summary.status != Status::success)
      return;
    std::vector<char> is_cut;
    plan_cuts(surface, options, is_cut, summary, must_stop);
    if(!summary.is_valid())
      return;
    for(std::size_t e = 0; e < edges.size(); ++e)
      if(is_cut[e])
        put(edge_is_cut, edges[e], true);
  };
  catch_out_of_memory(run, summary);
  return summary;
}

// The same for linked triangles with marks of halfedges, which are the same on both sides of an edge; diagonals are not cut.
inline Cut_summary cut_triangles(const Linked_triangles& triangles, std::vector<char>& is_cut, const std::vector<char>& is_feature,
                                 const Cut_options& options, const std::function<bool()>& must_stop)
{
  Cut_summary summary;
  const auto run = [&] {
    const Phase_timer timer(summary.seconds);
    if(!options.is_valid(&summary.message)) {
      summary.status = Status::invalid_option;
      return;
    }
    Cut_surface surface;
    summary.status = load_cut_surface(triangles, is_cut, is_feature, surface, summary.message);
    if(summary.status != Status::success)
      return;
    std::vector<char> is_edge_cut;
    plan_cuts(surface, options, is_edge_cut, summary, must_stop);
    if(!summary.is_valid())
      return;
    for(std::size_t h = 0; h < is_cut.size(); ++h)
      if(is_edge_cut[surface.edge_of[h]])
        is_cut[h] = 1;
  };
  catch_out_of_memory(run, summary);
  return summary;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_INTERNAL_CUT_MESH_H
