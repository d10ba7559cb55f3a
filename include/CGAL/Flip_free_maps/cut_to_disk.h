// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUT_TO_DISK_H
#define CGAL_FLIP_FREE_MAPS_CUT_TO_DISK_H

#include <CGAL/Flip_free_maps/cutting/internal/cut_mesh.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/internal/catch_out_of_memory.h>
#include <CGAL/Flip_free_maps/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSeams
/// Finds seams along which a surface of any genus, with any number of components and borders, closed or not, can be cut so that
/// each piece is a topological disk: what `parameterize()` needs.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph` whose vertex and face descriptors are `Hashable`
/// \tparam EdgeIsCutMap must be a model of `ReadWritePropertyMap` with edge descriptors as keys and `bool` as values
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a triangle mesh
/// \param edge_is_cut the seams. Those that are there before, the user's, are kept, and count; others are added: on success each
///   connected component of the surface without the seams is a disk, or, without `Cut_options::join_borders`, a disk with holes.
///   No piece has a border of two edges. Values on the mesh' border do not matter. On failure nothing is written.
/// \param options what seams shall reach beside what the topology asks for
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertex descriptors as keys and points in space as values}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::edge_is_feature_map}
///     \cgalParamDescription{edges that are preferred as seams, see `Cut_options::feature_cost`}
///     \cgalParamType{a model of `ReadablePropertyMap` with edge descriptors as keys and `bool` as values}
///     \cgalParamDefault{no edge is a feature}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns how it ended: `success`, or `invalid_option`, `empty_mesh`, `not_triangular`, `non_manifold`,
///   `degenerate_rest_element`, `non_finite_input`,
///   `not_a_disk` (the seams failed the check that ends every run), `out_of_memory`
///
/// Handles are opened by a shortest system of loops (Erickson and Whittlesey 2005, Greedy optimal homotopy and homology
/// generators); borders and points are joined to the seams by shortest paths, the nearest first; in the end every chain of seam
/// edges is replaced by the shortest path that does the same. Extremities are peaks of the Gaussian curvature (Sheffer 2002,
/// Spanning tree seams for reducing parameterization distortion of triangulated surfaces) and maxima of the conformal scale that
/// flattens the surface (Ben-Chen, Gotsman and Bunin 2008, Conformal flattening by curvature prescription and metric scaling),
/// which also gives the estimate of the energy.
///
/// Complexity: O(n log n) for each round of branches and each loop of a handle,
/// beside the factorization of one Laplace matrix per round.
template <typename TriangleMesh, typename EdgeIsCutMap, typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<!internal::Is_array<TriangleMesh>::value, int> = 0>
Cut_summary cut_to_disk(const TriangleMesh& mesh, EdgeIsCutMap edge_is_cut, const Cut_options& options = Cut_options(),
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  const auto vertex_points =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, mesh));
  const auto is_feature = [&np](const Edge& e) {
    static_cast<void>(np);
    static_cast<void>(e);
    if constexpr(internal::Has_parameter<NamedParameters, internal::Edge_is_feature_map_tag>::value)
      return static_cast<bool>(get(get_parameter(np, internal::edge_is_feature_map_tag), e));
    else
      return false;
  };
  return internal::cut_mesh(mesh, vertex_points, edge_is_cut, is_feature, options);
}

/// \ingroup PkgFlipFreeMapsSeams
/// The same with what seams shall reach as a named parameter: `cut_options` of `Flip_free_maps::parameters`.
template <typename TriangleMesh, typename EdgeIsCutMap, typename T, typename Tag, typename Base,
          std::enable_if_t<!internal::Is_array<TriangleMesh>::value, int> = 0>
Cut_summary cut_to_disk(const TriangleMesh& mesh, EdgeIsCutMap edge_is_cut, const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return cut_to_disk(mesh, edge_is_cut, internal::parameter_or(np, internal::cut_options_tag, Cut_options()), np);
}

/// \ingroup PkgFlipFreeMapsSeams
/// The same for arrays.
///
/// \param points the points of the surface: a container with `operator[]`, as `std::vector`, of points in space
/// \param triangles the triangles: a container of triples of indices into `points`
/// \param seams a container of pairs of indices, such as `std::vector<std::array<int, 2>>`: the edges that are seams. Those that are
///   there before, the user's, are kept; on success the others follow.
/// \param np optional named parameters: `cut_options`
/// \returns as for meshes; also `invalid_option` for an index out of range and for a seam that is no edge
template <typename PointRange, typename TriangleRange, typename SeamRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<internal::Is_array<PointRange>::value, int> = 0>
Cut_summary cut_to_disk(const PointRange& points, const TriangleRange& triangles, SeamRange& seams,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  using Seam = typename SeamRange::value_type;
  using Index = std::decay_t<decltype(std::declval<const Seam&>()[0])>;
  internal::Triangle_surface surface;
  Cut_summary summary;
  const auto run = [&] {
    summary.status = surface.load(points, triangles, summary.message);
    if(summary.status != Status::success)
      return;
    std::vector<char> is_cut(surface.number_of_halfedges(), 0);
    for(const Seam& seam : seams) {
      const std::int32_t h =
        surface.halfedge_between(internal::vertex_of_index(seam[0], points.size()), internal::vertex_of_index(seam[1], points.size()));
      if(h == internal::Triangle_surface::NONE) {
        summary.status = Status::invalid_option;
        summary.message = "there is no edge from " + std::to_string(seam[0]) + " to " + std::to_string(seam[1]);
        return;
      }
      is_cut[edge(internal::Surface_halfedge{h}, surface)] = 1;
    }
    std::vector<char> was_cut = is_cut;
    summary = internal::cut_mesh(
      surface, get(CGAL::vertex_point, surface), internal::Array_map<char>{&is_cut}, [](const internal::Surface_edge&) { return false; },
      internal::parameter_or(np, internal::cut_options_tag, Cut_options()));
    for(std::size_t h = 0; h < is_cut.size(); ++h)
      if(is_cut[h] && !was_cut[h]) {
        const std::int32_t e = static_cast<std::int32_t>(h);
        seams.push_back(Seam{static_cast<Index>(surface.source(e)), static_cast<Index>(surface.target(e))});
      }
  };
  internal::catch_out_of_memory(run, summary);
  return summary;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUT_TO_DISK_H
