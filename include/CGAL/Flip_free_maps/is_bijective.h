// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IS_BIJECTIVE_H
#define CGAL_FLIP_FREE_MAPS_IS_BIJECTIVE_H

#include <CGAL/Flip_free_maps/domains/Textured_mesh.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/internal/error_message.h>
#include <CGAL/Flip_free_maps/measure/internal/is_bijective_on_arrays.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Reads the corners of all triangles, whose image `image(h)` gives for the halfedge to the corner, and decides.
template <typename TriangleMesh, typename Image>
bool is_bijective_on_corners(const TriangleMesh& mesh, Image&& image, std::string* message)
{
  Corner_numbers<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> numbers;
  std::vector<std::array<std::int32_t, 3>> elements;
  for(const auto face : faces(mesh)) {
    std::array<std::int32_t, 3> element;
    auto h = halfedge(face, mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh)) {
      const auto& p = image(h);
      element[k] = numbers(target(h, mesh), CGAL::to_double(p[0]), CGAL::to_double(p[1]));
    }
    elements.push_back(element);
  }
  return is_bijective(elements, numbers.positions(), message);
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Whether a map of a whole triangle mesh into the plane takes different points to different points, by exact predicates: no
/// triangle is flipped or collapsed, and no part of the image covers another part.
/// The mesh may have holes and several components.
///
/// Touching counts as covering: where borders share a point in the plane that they do not share on the surface, the map is not
/// bijective, also if no area is covered twice.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph`, of triangles, whose vertex descriptors are `Hashable`; also a
///   `CGAL::Seam_mesh`, whose seams are borders
/// \tparam VertexUVMap must be a model of `ReadablePropertyMap` with vertex descriptors as keys and planar points as values
///
/// \param mesh a triangle mesh
/// \param uv_map the map
/// \param message if not null, receives a sentence when the answer is `false`
///
/// The number of preimages of a point of the plane is the number of times that the borders wind around it once all triangles are
/// positive. Therefore borders are all that is tested beside orientations: no two of their edges cross or touch,
/// and each curve encloses what it should.
///
/// Complexity: \f$ O(n \log n + b \log^2 b + k + c^2) \f$ for \f$ n \f$ triangles, \f$ b \f$ border edges with \f$ k \f$ pairs of
/// overlapping bounding boxes, and \f$ c \f$ borders.
template <typename TriangleMesh, typename VertexUVMap, std::enable_if_t<!internal::Is_array<TriangleMesh>::value, int> = 0>
bool is_bijective(const TriangleMesh& mesh, VertexUVMap uv_map, std::string* message = nullptr)
{
  return internal::is_bijective_on_corners(
    mesh, [&](auto h) { return get(uv_map, target(h, mesh)); }, message);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same for a map that is keyed by the corners of triangles, as `unwrap()` writes it. An edge is a seam where its two
/// triangles give different images to it.
///
/// \tparam HalfedgeUVMap must be a model of `ReadablePropertyMap` with halfedge descriptors as keys and planar points as values:
///   the image of `target(h, mesh)` in the triangle `face(h, mesh)`. Values of border halfedges are not read.
template <typename TriangleMesh, typename HalfedgeUVMap>
bool is_atlas_bijective(const TriangleMesh& mesh, HalfedgeUVMap uv_map, std::string* message = nullptr)
{
  return internal::is_bijective_on_corners(
    mesh, [&](auto h) { return get(uv_map, h); }, message);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same for texture coordinates of a file.
bool is_bijective(const Textured_mesh& mesh, std::string* message = nullptr);

/// \ingroup PkgFlipFreeMapsRef
/// The same for arrays: triples of indices into `uv`, a container of planar points with `operator[]`. `false`, with a message, also
/// for an index out of range.
template <typename TriangleRange, typename UVRange, std::enable_if_t<internal::Is_array<TriangleRange>::value, int> = 0>
bool is_bijective(const TriangleRange& triangles, const UVRange& uv, std::string* message = nullptr)
{
  internal::Corner_numbers<std::size_t> numbers;
  std::vector<std::array<std::int32_t, 3>> elements;
  for(const auto& triangle : triangles) {
    std::array<std::int32_t, 3> element;
    for(int k = 0; k < 3; ++k) {
      // A negative number becomes a very large one.
      const std::size_t v = static_cast<std::size_t>(triangle[k]);
      if(v >= uv.size())
        return internal::fail(message, "an index is out of range in triangle number " + std::to_string(elements.size()));
      element[k] = numbers(v, CGAL::to_double(uv[v][0]), CGAL::to_double(uv[v][1]));
    }
    elements.push_back(element);
  }
  return internal::is_bijective(elements, numbers.positions(), message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/is_bijective_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_IS_BIJECTIVE_H
