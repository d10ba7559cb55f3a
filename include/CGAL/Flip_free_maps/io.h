// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_H
#define CGAL_FLIP_FREE_MAPS_IO_H

#include <CGAL/Flip_free_maps/IO/OBJ.h>
#include <CGAL/Flip_free_maps/domains/Textured_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <unordered_map>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsIO
/// Gathers a triangle mesh and its uv map for writing: `write_textured_OBJ(path, textured_mesh(mesh, uv_map))`. Only vertices of
/// faces are taken, in the order in which the faces name them.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph`, of triangles, whose vertex descriptors are `Hashable`
/// \tparam VertexUVMap must be a model of `ReadablePropertyMap` with vertex descriptors as keys and planar points as values
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a triangle mesh
/// \param uv_map its uv map
/// \param np optional named parameters: `vertex_point_map`, as in `parameterize()`
template <typename TriangleMesh, typename VertexUVMap, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Textured_mesh textured_mesh(const TriangleMesh& mesh, VertexUVMap uv_map, const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto vertex_points = CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                                                get_const_property_map(CGAL::vertex_point, mesh));
  Textured_mesh result;
  std::unordered_map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, int> numbers;
  for(const auto face : faces(mesh)) {
    std::array<int, 3> triangle;
    auto h = halfedge(face, mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh)) {
      const auto v = target(h, mesh);
      const auto entry = numbers.emplace(v, static_cast<int>(result.points.size()));
      if(entry.second) {
        const auto p = get(vertex_points, v);
        const auto q = get(uv_map, v);
        result.points.push_back({CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])});
        result.texture.push_back({CGAL::to_double(q[0]), CGAL::to_double(q[1])});
      }
      triangle[k] = entry.first->second;
    }
    result.triangles.push_back(triangle);
    result.texture_triangles.push_back(triangle);
  }
  return result;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_IO_H
