// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PACK_CHARTS_H
#define CGAL_FLIP_FREE_MAPS_PACK_CHARTS_H

#include <CGAL/Flip_free_maps/atlas/Packing_options.h>
#include <CGAL/Flip_free_maps/atlas/internal/pack_flat_charts.h>
#include <CGAL/Flip_free_maps/domains/Textured_mesh.h>
#include <CGAL/Flip_free_maps/is_bijective.h>
#include <CGAL/Flip_free_maps/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Splits triangles into charts, the parts that are connected by vertices.
std::vector<Flat_chart> separate_charts(const std::vector<std::array<std::int32_t, 3>>& elements, const Positions<2>& x);

// Packs those without a pinned face around the others, which are removed.
void pack_free_charts(std::vector<Flat_chart>& charts, const std::vector<char>& is_pinned, const Packing_options& options,
                      const Rounding& rounded, Packing_summary& summary);

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Moves the charts of an atlas into the unit square, apart from each other. All are scaled by the same factor, so that a length on
/// the surface has the same length on all charts as far as it had before. Charts are turned and laid into dents and holes of
/// others; thousands of them, or with a wide margin, as boxes. An edge is a seam where its two triangles give different images to
/// it; charts are the parts of the surface between seams.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph`, of triangles, whose vertex descriptors are `Hashable`
/// \tparam HalfedgeUVMap must be a model of `ReadWritePropertyMap` with halfedge descriptors as keys and planar points as values:
///   the image of `target(h, mesh)` in the triangle `face(h, mesh)`. Values of border halfedges are neither read nor written.
///
/// \param mesh a triangle mesh
/// \param uv_map a map without flipped triangles. It is written once, at the end, if all went well. Triangles stay unflipped, and
///   charts that do not overlap themselves stay so, by exact predicates, also after rounding.
/// \param options margin and rotation
///
/// \param np optional named parameters: `packing_options` in place of `options`, and `face_is_pinned_map`. Charts with a pinned face
///   stay where they are, and need not be free of flips; all others are packed around them, by a factor of their own.
///
/// \returns `success`, or `empty_mesh`, `invalid_option` (also when the margin leaves no room for so many charts),
///   `non_finite_input`, `start_not_flip_free`, or `result_not_representable` when triangles are too small within the unit square
///   for the map's number type
///
/// Complexity: \f$ O(n \log n) \f$ for \f$ n \f$ triangles, and a bounded amount of work beyond what the first packings of the
/// charts take, some tenths of a second.
template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Packing_summary pack_charts(const TriangleMesh& mesh, HalfedgeUVMap uv_map, const Packing_options& options, const NamedParameters& np)
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  Packing_summary summary;
  internal::Corner_numbers<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> numbers;
  std::vector<std::array<std::int32_t, 3>> elements;
  std::vector<std::array<Halfedge, 3>> corners;
  std::vector<char> is_pinned;
  for(const auto face : faces(mesh)) {
    if constexpr(internal::Has_parameter<NamedParameters, internal::Face_is_pinned_map_tag>::value)
      is_pinned.push_back(static_cast<bool>(get(CGAL::parameters::get_parameter(np, internal::face_is_pinned_map_tag), face)));
    std::array<std::int32_t, 3> element;
    std::array<Halfedge, 3> corner;
    auto h = halfedge(face, mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh)) {
      const auto p = get(uv_map, h);
      element[k] = numbers(target(h, mesh), CGAL::to_double(p[0]), CGAL::to_double(p[1]));
      corner[k] = h;
    }
    elements.push_back(element);
    corners.push_back(corner);
  }
  if(elements.empty()) {
    summary.status = Status::empty_mesh;
    summary.message = "the mesh has no faces";
    return summary;
  }
  std::vector<internal::Flat_chart> charts = internal::separate_charts(elements, numbers.positions());
  internal::pack_free_charts(charts, is_pinned, options,
                             internal::as_rounded_by<typename boost::property_traits<HalfedgeUVMap>::value_type>, summary);
  if(!summary.is_valid())
    return summary;
  internal::write_charts(charts, uv_map, [&](std::int32_t face, int k) { return corners[face][k]; });
  return summary;
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with default named parameters.
template <typename TriangleMesh, typename HalfedgeUVMap>
Packing_summary pack_charts(const TriangleMesh& mesh, HalfedgeUVMap uv_map, const Packing_options& options = Packing_options())
{
  return pack_charts(mesh, uv_map, options, CGAL::parameters::default_values());
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with all options as named parameters: `packing_options` and `face_is_pinned_map` of `Flip_free_maps::parameters`.
template <typename TriangleMesh, typename HalfedgeUVMap, typename T, typename Tag, typename Base>
Packing_summary pack_charts(const TriangleMesh& mesh, HalfedgeUVMap uv_map, const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return pack_charts(mesh, uv_map, internal::parameter_or(np, internal::packing_options_tag, Packing_options()), np);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same for a mesh in flat arrays, as `read_textured_OBJ()` gives it. Charts are the parts that are connected by corners with the same
/// point and the same image.
///
/// \param mesh its triangles must be counterclockwise in the plane, and its indices valid. The texture coordinates of corners are replaced
///   if the packing is valid, and numbered anew: corners with the same point and the same image share them. Otherwise the mesh is left
///   untouched.
/// \param options distances and rotations
/// \param is_pinned whether each triangle is pinned, or nothing if none is: charts with such a triangle stay where they are
/// \returns the same, also `invalid_option` for an index out of range
Packing_summary pack_charts(Textured_mesh& mesh, const Packing_options& options = Packing_options(),
                            const std::vector<char>& is_pinned = std::vector<char>());

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/pack_charts_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_PACK_CHARTS_H
