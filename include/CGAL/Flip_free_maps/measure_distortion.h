// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_H

#include <CGAL/Flip_free_maps/domains/Textured_mesh.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/measure/Distortion_report.h>
#include <CGAL/Flip_free_maps/measure/internal/Distortion_measure.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

namespace internal {

// Measures the faces of a mesh with a uv map and hands every face's energy to a functor.
template <typename TriangleMesh, typename VertexPointMap, typename VertexUVMap, typename F>
Distortion_report measure_faces(const TriangleMesh& mesh, const VertexPointMap& vertex_points, VertexUVMap uv_map, F&& f)
{
  Distortion_measure measure;
  for(const auto face : faces(mesh)) {
    const auto h = halfedge(face, mesh);
    if(next(next(next(h, mesh), mesh), mesh) != h) {
      measure.fail(Status::not_triangular, "the mesh must consist of triangles; not so face number ");
      break;
    }
    Matrix<3> points;
    Eigen::Matrix<double, 2, 3> image;
    auto g = h;
    for(int k = 0; k < 3; ++k, g = next(g, mesh)) {
      const auto p = get(vertex_points, target(g, mesh));
      const auto q = get(uv_map, target(g, mesh));
      points.col(k) << CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]);
      image.col(k) << CGAL::to_double(q[0]), CGAL::to_double(q[1]);
    }
    const double energy = measure.add(points, image);
    if(std::isnan(energy))
      break;
    f(face, energy);
  }
  return measure.report();
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Measures a map of all faces of a triangle mesh into the plane.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph`
/// \tparam VertexUVMap must be a model of `ReadablePropertyMap` with vertex descriptors as keys and planar points as values
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a triangle mesh
/// \param uv_map the map
/// \param np optional named parameters: `vertex_point_map`, as in `parameterize()`
///
/// Complexity: linear.
template <typename TriangleMesh, typename VertexUVMap, typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<!internal::Is_array<TriangleMesh>::value, int> = 0>
Distortion_report measure_distortion(const TriangleMesh& mesh, VertexUVMap uv_map,
                                     const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto vertex_points = CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                                                get_const_property_map(CGAL::vertex_point, mesh));
  return internal::measure_faces(mesh, vertex_points, uv_map, [](const auto&, double) {});
}

/// \ingroup PkgFlipFreeMapsRef
/// The same for arrays.
///
/// \param points the points of the surface: a container with `operator[]`, as `std::vector`, of points in space
/// \param triangles the triangles: a container of triples of indices into `points`
/// \param uv the image of each point, a container of planar points as long as `points`
/// \returns as above; the status is `invalid_option` for an index out of range or a map of another length
template <typename PointRange, typename TriangleRange, typename UVRange, std::enable_if_t<internal::Is_array<PointRange>::value, int> = 0>
Distortion_report measure_distortion(const PointRange& points, const TriangleRange& triangles, const UVRange& uv)
{
  internal::Distortion_measure measure;
  if(uv.size() != points.size()) {
    measure.fail(Status::invalid_option, "the map must have an image for each point; faces measured: ");
    return measure.report();
  }
  for(const auto& triangle : triangles) {
    internal::Matrix<3> corners;
    Eigen::Matrix<double, 2, 3> image;
    for(int k = 0; k < 3; ++k) {
      // A negative number becomes a very large one.
      const std::size_t v = static_cast<std::size_t>(triangle[k]);
      if(v >= points.size()) {
        measure.fail(Status::invalid_option, "an index is out of range in face number ");
        return measure.report();
      }
      const auto& p = points[v];
      const auto& q = uv[v];
      corners.col(k) << CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]);
      image.col(k) << CGAL::to_double(q[0]), CGAL::to_double(q[1]);
    }
    if(std::isnan(measure.add(corners, image)))
      break;
  }
  return measure.report();
}

/// \ingroup PkgFlipFreeMapsRef
/// Measures a map that is keyed by the corners of the triangles, as files hold it. `face_energies`, if not null, receives the
/// symmetric Dirichlet energy of each triangle, +infinity for those that are collapsed or flipped.
Distortion_report measure_distortion(const Textured_mesh& mesh, std::vector<double>* face_energies = nullptr);

/// \ingroup PkgFlipFreeMapsRef
/// Writes the symmetric Dirichlet energy of each triangle to a property map;
/// +infinity for triangles that are collapsed or flipped.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph`
/// \tparam VertexUVMap must be a model of `ReadablePropertyMap` with vertex descriptors as keys and planar points as values
/// \tparam FaceDistortionMap must be a model of `WritablePropertyMap` with face descriptors as keys and `double` as values
///
/// \returns `success`, `empty_mesh`, `not_triangular`, `non_finite_input` or `degenerate_rest_element`
template <typename TriangleMesh, typename VertexUVMap, typename FaceDistortionMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Status face_distortions(const TriangleMesh& mesh, VertexUVMap uv_map, FaceDistortionMap distortion_map,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto vertex_points = CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                                                get_const_property_map(CGAL::vertex_point, mesh));
  return internal::measure_faces(mesh, vertex_points, uv_map, [&](const auto& face, double energy) { put(distortion_map, face, energy); })
    .status;
}

/// \ingroup PkgFlipFreeMapsRef
/// The number of triangles of a mesh whose image is not positively oriented, by exact predicates. Collapsed triangles count; so
/// do those with a coordinate that is not finite. Reads the uv map only, not the mesh' points.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph`, of triangles
/// \tparam VertexUVMap must be a model of `ReadablePropertyMap` with vertex descriptors as keys and planar points as values
///
/// Complexity: linear.
template <typename TriangleMesh, typename VertexUVMap>
std::int64_t number_of_flipped_elements(const TriangleMesh& mesh, VertexUVMap uv_map)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::int64_t flips = 0;
  for(const auto face : faces(mesh)) {
    Kernel::Point_2 p[3];
    bool is_finite = true;
    auto h = halfedge(face, mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh)) {
      const auto q = get(uv_map, target(h, mesh));
      p[k] = Kernel::Point_2(CGAL::to_double(q[0]), CGAL::to_double(q[1]));
      is_finite = is_finite && std::isfinite(p[k].x()) && std::isfinite(p[k].y());
    }
    if(!is_finite || Kernel::Orientation_2()(p[0], p[1], p[2]) != CGAL::POSITIVE)
      ++flips;
  }
  return flips;
}

/// \ingroup PkgFlipFreeMapsRef
/// Whether every triangle of a mesh has a positively oriented image, by exact predicates.
template <typename TriangleMesh, typename VertexUVMap>
bool is_flip_free(const TriangleMesh& mesh, VertexUVMap uv_map)
{
  return number_of_flipped_elements(mesh, uv_map) == 0;
}

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/measure_distortion_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_H
