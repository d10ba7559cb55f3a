// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_H

#include <CGAL/Flip_free_maps/IO/Textured_mesh.h>
#include <CGAL/Flip_free_maps/Status.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/internal/Signed_svd.h>
#include <CGAL/Flip_free_maps/internal/planar_rest_shape.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Distortion of a map of a whole surface. Means are weighted by the areas of the surface.
struct Distortion_report
{
  Status status = Status::empty_mesh;        ///< `success`, `empty_mesh`, `not_triangular`,
                                             ///< `non_finite_input` or `degenerate_rest_element`
  std::string message;                       ///< a sentence, when the status is not `success`
  std::int64_t elements = 0;                 ///< number of triangles
  std::int64_t flips = 0;                    ///< triangles that are not positively oriented, by exact predicates
  double rest_area = 0;                      ///< area of the surface
  double image_area = 0;                     ///< area of the image, flipped triangles counted negatively
  double energy = 0;                         ///< mean symmetric Dirichlet energy (isometry 1);
                                             ///< infinite when a triangle collapses or flips
  double energy_of_similarity = 0;           ///< the same after the best uniform scaling of the image
  double max_energy = 0;                     ///< largest energy of a triangle
  double mean_angle_distortion = 0;          ///< mean of (s_1/s_2 + s_2/s_1) / 2, 1 for a conformal map
  double mean_area_distortion = 0;           ///< mean of (s_1 s_2 + 1/(s_1 s_2)) / 2, 1 for an equiareal map
  double min_singular_value = 0;             ///< smallest singular value, negative on flipped triangles
  double max_singular_value = 0;             ///< largest singular value
};

namespace internal {

// Adds up the distortions of triangles.
class Distortion_measure
{
public:
  Distortion_measure()
  {
    m_report.min_singular_value = std::numeric_limits<double>::infinity();
    m_report.max_singular_value = -std::numeric_limits<double>::infinity();
  }

  // Enters the triangle with the given columns of corners in space and in the plane. Returns its symmetric Dirichlet energy,
  // +infinity when it is not positively oriented; NaN, with the report's status set, when the triangle cannot be measured.
  double add(const Matrix<3>& points, const Eigen::Matrix<double, 2, 3>& image)
  {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    const double infinity = std::numeric_limits<double>::infinity();
    if(!points.allFinite() || !image.allFinite())
      return fail(Status::non_finite_input, "a coordinate is NaN or infinite in face number ");
    // The unit of length has the magnitude of the first triangle, so that areas neither overflow nor vanish. It is a power of
    // two, which rounds nothing.
    Matrix<3> scaled_points = points;
    scaled_points.colwise() -= points.col(0).eval();
    if(m_report.elements == 0) {
      const double extent = scaled_points.cwiseAbs().maxCoeff();
      m_exponent = extent > 0 && std::isfinite(extent) ? std::ilogb(extent) : 0;
    }
    const auto in_units = [this](double x) { return std::ldexp(x, -m_exponent); };
    scaled_points = scaled_points.unaryExpr(in_units).eval();
    Matrix<2> rest_inverse;
    double area;
    if(!planar_rest_shape(scaled_points.col(0), scaled_points.col(1), scaled_points.col(2), rest_inverse, area))
      return fail(Status::degenerate_rest_element, "zero area, or none within double precision, has face number ");
    Matrix<2> edges;
    edges << image.col(1) - image.col(0), image.col(2) - image.col(0);
    edges = edges.unaryExpr(in_units).eval();
    const Vector<2> s = signed_singular_values(Matrix<2>(edges * rest_inverse));
    const bool is_positive = Kernel::Orientation_2()(Kernel::Point_2(image(0, 0), image(1, 0)), Kernel::Point_2(image(0, 1), image(1, 1)),
                                                     Kernel::Point_2(image(0, 2), image(1, 2))) == CGAL::POSITIVE;
    // A triangle may be positive, but too thin for its singular values to be so.
    const bool is_valid = is_positive && s[1] > 0;
    const double energy = is_valid ? Symmetric_dirichlet().value<2>(s) : infinity;
    ++m_report.elements;
    m_report.flips += is_positive ? 0 : 1;
    m_report.rest_area += area;
    m_report.image_area += area * s.prod();
    m_report.energy += area * energy;
    m_report.max_energy = (std::max)(m_report.max_energy, energy);
    m_report.mean_angle_distortion += area * (is_valid ? 0.5 * (s[0] / s[1] + s[1] / s[0]) : infinity);
    m_report.mean_area_distortion += area * (is_valid ? 0.5 * (s.prod() + 1 / s.prod()) : infinity);
    m_report.min_singular_value = (std::min)(m_report.min_singular_value, s[1]);
    m_report.max_singular_value = (std::max)(m_report.max_singular_value, s[0]);
    m_squares += area * s.squaredNorm();
    m_inverse_squares += area * (is_valid ? s.array().square().inverse().sum() : infinity);
    return energy;
  }

  double fail(Status status, const char* text)
  {
    m_report.status = status;
    m_report.message = text + std::to_string(m_report.elements);
    return std::numeric_limits<double>::quiet_NaN();
  }

  // The means, when no triangle failed.
  Distortion_report report()
  {
    if(!m_report.message.empty())
      return m_report;
    if(m_report.elements == 0) {
      m_report.message = "there are no faces";
      return m_report;
    }
    m_report.status = Status::success;
    m_report.energy /= m_report.rest_area;
    m_report.mean_angle_distortion /= m_report.rest_area;
    m_report.mean_area_distortion /= m_report.rest_area;
    // Scaling the image by t makes it (t^2 a + b / t^2) / 4, smallest for t^4 = b / a.
    m_report.energy_of_similarity = 0.5 * std::sqrt(m_squares / m_report.rest_area) * std::sqrt(m_inverse_squares / m_report.rest_area);
    m_report.rest_area = std::ldexp(m_report.rest_area, 2 * m_exponent);
    m_report.image_area = std::ldexp(m_report.image_area, 2 * m_exponent);
    return m_report;
  }

private:
  Distortion_report m_report;
  int m_exponent = 0; // binary logarithm of the unit of length
  double m_squares = 0;
  double m_inverse_squares = 0;
};

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
      const auto& p = get(vertex_points, target(g, mesh));
      const auto& q = get(uv_map, target(g, mesh));
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
template <typename TriangleMesh, typename VertexUVMap, typename NamedParameters = parameters::Default_named_parameters>
Distortion_report measure_distortion(const TriangleMesh& mesh, VertexUVMap uv_map,
                                     const NamedParameters& np = parameters::default_values())
{
  const auto vertex_points = parameters::choose_parameter(parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                                          get_const_property_map(CGAL::vertex_point, mesh));
  return internal::measure_faces(mesh, vertex_points, uv_map, [](const auto&, double) {});
}

/// \ingroup PkgFlipFreeMapsRef
/// Measures a map that is keyed by the corners of the triangles, as files hold it. `face_energies`, if not null, receives the
/// symmetric Dirichlet energy of each triangle, +infinity for those that are collapsed or flipped.
inline Distortion_report measure_distortion(const Textured_mesh& mesh, std::vector<double>* face_energies = nullptr)
{
  internal::Distortion_measure measure;
  if(face_energies != nullptr)
    face_energies->clear();
  for(std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    internal::Matrix<3> points;
    Eigen::Matrix<double, 2, 3> image;
    for(int k = 0; k < 3; ++k) {
      points.col(k) = Eigen::Map<const Eigen::Vector3d>(mesh.points[mesh.triangles[i][k]].data());
      image.col(k) = Eigen::Map<const Eigen::Vector2d>(mesh.texture[mesh.texture_triangles[i][k]].data());
    }
    const double energy = measure.add(points, image);
    if(std::isnan(energy))
      break;
    if(face_energies != nullptr)
      face_energies->push_back(energy);
  }
  return measure.report();
}

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
          typename NamedParameters = parameters::Default_named_parameters>
Status face_distortions(const TriangleMesh& mesh, VertexUVMap uv_map, FaceDistortionMap distortion_map,
                        const NamedParameters& np = parameters::default_values())
{
  const auto vertex_points = parameters::choose_parameter(parameters::get_parameter(np, CGAL::internal_np::vertex_point),
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
      const auto& q = get(uv_map, target(h, mesh));
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

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_H
