// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUT_TO_DISK_H
#define CGAL_FLIP_FREE_MAPS_CUT_TO_DISK_H

#include <CGAL/Flip_free_maps/cutting/internal/cut_mesh.h>
#include <CGAL/Flip_free_maps/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

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
template <typename TriangleMesh, typename EdgeIsCutMap, typename NamedParameters = CGAL::parameters::Default_named_parameters>
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

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUT_TO_DISK_H
