// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SEAMS_FIND_SEAMS_H
#define CGAL_FLIP_FREE_MAPS_SEAMS_FIND_SEAMS_H

#include <CGAL/Flip_free_maps/domains/Face_graph_domain.h>
#include <CGAL/Flip_free_maps/initializers/internal/angle_sums.h>
#include <CGAL/Flip_free_maps/seams/Seam_constraints.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_type_config.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSeams
/// The seams of a cut surface: maximal chains of seam edges with the component on both sides. Chains end where other than two of
/// these edges meet, at the border of the uncut mesh, and at cones, since the sides of one chain turn together.
///
/// \tparam SeamMesh must be a `CGAL::Seam_mesh`
/// \param mesh the cut surface
/// \param graph its component, loaded
/// \param cone_curvature the difference of a vertex' angle sum from 2 pi, in radians, from which on it is a cone
/// \returns the seams, in the order of their first edges in the uncut mesh
///
/// Complexity: linear in the number of edges, on average.
template <typename SeamMesh>
std::vector<Seam> find_seams(const SeamMesh& mesh, const Face_graph_domain<SeamMesh>& graph, double cone_curvature)
{
  const auto& uncut = mesh.mesh();
  using Uncut = std::decay_t<decltype(uncut)>;
  using Halfedge = typename boost::graph_traits<Uncut>::halfedge_descriptor;
  using Vertex = typename boost::graph_traits<Uncut>::vertex_descriptor;
  using Seam_halfedge = typename boost::graph_traits<SeamMesh>::halfedge_descriptor;

  const auto number_of_target = [&](Halfedge h) { return graph.number_of(target(Seam_halfedge(h), mesh)); };
  const auto number_of_source = [&](Halfedge h) { return graph.number_of(source(Seam_halfedge(h), mesh)); };
  const auto is_inner_seam = [&](Halfedge h) {
    const Halfedge o = opposite(h, uncut);
    return mesh.has_on_seam(edge(h, uncut)) && !CGAL::is_border(h, uncut) && !CGAL::is_border(o, uncut) && number_of_target(h) >= 0 &&
           number_of_target(o) >= 0;
  };
  std::vector<Halfedge> edges_of_seams;
  std::unordered_map<Vertex, std::vector<Halfedge>> leaving;
  std::unordered_set<Vertex> on_border;
  for(const auto e : edges(uncut)) {
    const Halfedge h = halfedge(e, uncut), o = opposite(h, uncut);
    if(is_inner_seam(h)) {
      edges_of_seams.push_back(h);
      leaving[source(h, uncut)].push_back(h);
      leaving[source(o, uncut)].push_back(o);
    } else if(CGAL::is_border(h, uncut) || CGAL::is_border(o, uncut)) {
      on_border.insert(source(h, uncut));
      on_border.insert(source(o, uncut));
    }
  }
  std::unordered_map<Vertex, double> defects;
  const std::vector<double> angles = internal::angle_sums(graph.domain());
  for(std::size_t v = 0; v < angles.size(); ++v)
    defects.emplace(target(Halfedge(graph.vertices()[v]), uncut), 2 * CGAL_PI).first->second -= angles[v];
  const auto ends = [&](Vertex v) {
    return leaving.at(v).size() != 2 || on_border.count(v) > 0 || std::abs(defects.at(v)) >= cone_curvature;
  };

  std::vector<Seam> seams;
  std::unordered_set<Halfedge> done;
  for(const Halfedge first : edges_of_seams) {
    if(done.count(first) > 0)
      continue;
    // Back to the beginning of the chain, or once around if it is closed.
    const auto next_of = [&](Halfedge h) {
      const std::vector<Halfedge>& all = leaving.at(target(h, uncut));
      return all[0] == opposite(h, uncut) ? all[1] : all[0];
    };
    Halfedge h = opposite(first, uncut);
    while(!ends(target(h, uncut)) && next_of(h) != opposite(first, uncut))
      h = next_of(h);
    h = opposite(h, uncut);
    Seam seam;
    for(;;) {
      const Halfedge o = opposite(h, uncut);
      done.insert(h);
      done.insert(o);
      seam.edges.push_back({number_of_source(h), number_of_target(h), number_of_target(o), number_of_source(o)});
      const auto& points = graph.domain().rest_points;
      seam.lengths.push_back((points.col(seam.edges.back()[1]) - points.col(seam.edges.back()[0])).norm());
      if(ends(target(h, uncut)) || done.count(next_of(h)) > 0)
        break;
      h = next_of(h);
    }
    seams.push_back(seam);
  }
  return seams;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SEAMS_FIND_SEAMS_H
