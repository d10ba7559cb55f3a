// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_UNWRAP_H
#define CGAL_FLIP_FREE_MAPS_UNWRAP_H

#include <CGAL/Flip_free_maps/core/unwrap_polygons.h>
#include <CGAL/Flip_free_maps/domains/Textured_mesh.h>
#include <CGAL/Flip_free_maps/domains/internal/Polygon_triangulator.h>
#include <CGAL/Flip_free_maps/domains/internal/Surface_view.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_surface.h>
#include <CGAL/Flip_free_maps/domains/internal/weld_points.h>
#include <CGAL/Flip_free_maps/domains/internal/write_positions.h>
#include <CGAL/Flip_free_maps/internal/catch_out_of_memory.h>
#include <CGAL/Flip_free_maps/measure/internal/is_bijective_on_arrays.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/core/unwrap_polygons_impl.h>
#endif

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

namespace internal {

template <typename Images, typename = void>
struct Has_resize : std::false_type
{};

template <typename Images>
struct Has_resize<Images, std::void_t<decltype(std::declval<Images&>().resize(std::size_t(3)))>> : std::true_type
{};

enum Face_chart_map_tag
{
  face_chart_map_tag
};
enum Edge_is_seam_map_tag
{
  edge_is_seam_map_tag
};

// Numbers the vertices and corners of a mesh.
template <typename FaceGraph, typename VertexPointMap, typename Face, typename Halfedge>
void read_polygon_soup(const FaceGraph& mesh, const VertexPointMap& vertex_points, std::vector<Face>& all_faces,
                       std::vector<Halfedge>& corners, Polygon_soup& soup)
{
  std::vector<Vector<3>> points;
  std::unordered_map<typename boost::graph_traits<FaceGraph>::vertex_descriptor, std::int32_t> numbers;
  for(const Face face : faces(mesh)) {
    const Halfedge first = halfedge(face, mesh);
    Halfedge h = first;
    do {
      const auto entry = numbers.emplace(target(h, mesh), static_cast<std::int32_t>(points.size()));
      if(entry.second) {
        const auto p = get(vertex_points, target(h, mesh));
        points.emplace_back(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
      }
      corners.push_back(h);
      soup.vertices.push_back(entry.first->second);
      h = next(h, mesh);
    } while(h != first);
    all_faces.push_back(face);
    soup.first_corners.push_back(soup.number_of_corners());
  }
  soup.points.resize(3, points.size());
  for(std::size_t v = 0; v < points.size(); ++v)
    soup.points.col(v) = points[v];
  soup.has_point_numbers = false;
}

// The side to a corner is the one from the corner before.
inline std::vector<std::int32_t> sides_to_corners(const Polygon_soup& soup)
{
  std::vector<std::int32_t> result;
  for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p)
    for(std::int32_t c = soup.first_corners[p]; c < soup.first_corners[p + 1]; ++c)
      result.push_back(soup.prev(p, c));
  return result;
}

// The sides of polygons that a property map of pairs of indices tells about.
template <typename EdgeMap>
std::vector<std::int32_t> marked_sides(const Polygon_soup& soup, const EdgeMap& map)
{
  std::vector<std::int32_t> result;
  for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p)
    for(std::int32_t c = soup.first_corners[p]; c < soup.first_corners[p + 1]; ++c) {
      const auto ends = std::minmax({soup.vertices[c], soup.vertices[soup.next(p, c)]});
      if(get(map, std::pair<std::size_t, std::size_t>(ends.first, ends.second)))
        result.push_back(c);
    }
  return result;
}

// Writes for each edge, a pair of indices, whether it is a seam: whether a side of a polygon there has other images than what is
// across it. Nothing is across a border.
template <typename SeamMap>
void put_seams(const Polygon_soup& soup, const std::vector<char>& seams, const SeamMap& map)
{
  using Key = std::pair<std::size_t, std::size_t>;
  std::vector<std::int32_t> place(soup.points.cols(), -1);
  for(const std::int32_t v : soup.vertices)
    place[v] = v;
  weld_points(soup.points, place);
  std::map<Key, int> sides_at;
  std::map<Key, bool> is_seam;
  const auto for_each_side = [&soup](auto&& visit) {
    for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p)
      for(std::int32_t c = soup.first_corners[p]; c < soup.first_corners[p + 1]; ++c)
        visit(c, soup.vertices[c], soup.vertices[soup.next(p, c)]);
  };
  const auto key = [](std::int32_t v, std::int32_t w) { return Key((std::min)(v, w), (std::max)(v, w)); };
  for_each_side([&](std::int32_t, std::int32_t v, std::int32_t w) { ++sides_at[key(place[v], place[w])]; });
  for_each_side([&](std::int32_t c, std::int32_t v, std::int32_t w) {
    bool& value = is_seam[key(v, w)];
    value = value || (seams[c] && place[v] != place[w] && sides_at[key(place[v], place[w])] > 1);
  });
  using boost::put; // for pointers
  for(const auto& [edge, value] : is_seam)
    put(map, edge, value);
}

// Reads which faces are pinned, by their numbers, and the images of their corners.
template <typename IsPinned, typename ImageOf>
void read_pinned_polygons(const IsPinned& is_pinned, const ImageOf& image_of, Atlas_request& request)
{
  const Polygon_soup& soup = request.surface;
  bool is_any = false;
  for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p) {
    request.is_pinned.push_back(is_pinned(p));
    is_any = is_any || is_pinned(p);
  }
  if(!is_any) {
    request.is_pinned.clear();
    return;
  }
  request.images.resize(soup.number_of_corners());
  for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p)
    for(std::int32_t c = soup.first_corners[p]; request.is_pinned[p] && c < soup.first_corners[p + 1]; ++c) {
      const auto image = image_of(p, c);
      request.images[c] = {{CGAL::to_double(image[0]), CGAL::to_double(image[1])}};
    }
}

// Whether a container of images can have as many as a polygon has corners, and makes it have them.
template <typename Images>
bool resize_images(Images& images, std::size_t size)
{
  if constexpr(Has_resize<Images>::value)
    images.resize(size);
  return number_of_corners(images) == size;
}

} // namespace internal

namespace parameters {

/// \ingroup PkgFlipFreeMapsRef
/// Receives the number of each face's chart: a model of `WritablePropertyMap` with face descriptors as keys and integers as
/// values.
template <typename FaceChartMap, typename Base = CGAL::parameters::Default_named_parameters>
auto face_chart_map(const FaceChartMap& map, const Base& base = Base())
{
  return CGAL::Named_function_parameters<FaceChartMap, internal::Face_chart_map_tag, Base>(map, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// Receives whether an edge is a seam: a model of `WritablePropertyMap` with edge descriptors as keys and `bool` as values.
template <typename EdgeIsSeamMap, typename Base = CGAL::parameters::Default_named_parameters>
auto edge_is_seam_map(const EdgeIsSeamMap& map, const Base& base = Base())
{
  return CGAL::Named_function_parameters<EdgeIsSeamMap, internal::Edge_is_seam_map_tag, Base>(map, base);
}

} // namespace parameters

/// \ingroup PkgFlipFreeMapsRef
/// Makes a texture atlas of any polygon mesh, closed or with holes, of any genus and any number of components: cuts it open,
/// flattens the pieces with as little distortion as possible, and packs them into the unit square. Polygons are counterclockwise in
/// the order of their own corners, none of the triangles that they consist of is flipped, and no two polygons of the atlas overlap,
/// by exact predicates on the numbers that the caller receives.
///
/// What is flattened is a view of the mesh, which itself is not touched:
/// - Vertices at the same place are one vertex as far as it matters which faces are neighbours.
/// - Faces may be polygons, convex or not, planar or not. They are cut into triangles by diagonals that suit their shapes; no seam
///   runs through a face.
/// - Where more than two faces have an edge, or faces of different windings, or several sheets a vertex, they are kept apart by
///   seams: no image is mirrored. Faces that occur twice have two images. `Unwrap_summary::parted_edges` counts such edges.
/// - Faces without area are counted and named, see `Unwrap_summary::faces_without_area`. Those with corners at less than three
///   places get the images of these places, all others thin ones that are as valid as any.
///
/// With `Unwrap_options::strict` all these are refused; but beside pinned faces several sheets may meet at a vertex.
///
/// \tparam FaceGraph must be a model of `FaceListGraph` whose vertex descriptors are `Hashable`
/// \tparam HalfedgeUVMap must be a model of `WritablePropertyMap` with halfedge descriptors as keys and planar points as values; with
///   pinned faces of `ReadWritePropertyMap`
/// \tparam Traits must be a model of `MapTraits`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a mesh of polygons; it is not changed
/// \param uv_map receives the image of `target(h, mesh)` in the face `face(h, mesh)` for each halfedge `h` that is not on the
///   border. It is written once, at the end, if the atlas is valid, and left untouched otherwise.
/// \param options where to cut, when to split, how to pack, when to stop
/// \param traits the method and its settings, for each chart, see `Flip_free_map_traits`
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertex descriptors as keys and points in space as values}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{the caller's seams, all of which are cut}
///     \cgalParamType{a model of `ReadablePropertyMap` with edge descriptors as keys and `bool` as values}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::edge_is_feature_map}
///     \cgalParamDescription{edges that are preferred as seams, see `Cut_options::feature_cost`}
///     \cgalParamType{a model of `ReadablePropertyMap` with edge descriptors as keys and `bool` as values}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::face_is_pinned_map}
///     \cgalParamDescription{faces that keep the images they have in `uv_map`, mirrored or upon each other or not. All others are
///     flattened by themselves and packed around them. `Unwrap_options::pack` must be set}
///     \cgalParamType{a model of `ReadablePropertyMap` with face descriptors as keys and `bool` as values}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::face_chart_map}
///     \cgalParamDescription{receives the number of each face's chart, its place in `Unwrap_summary::charts`; -1 for faces with
///     corners at less than three places, and for pinned ones}
///     \cgalParamType{a model of `WritablePropertyMap` with face descriptors as keys and integers as values}
///     \cgalParamDefault{not written}
///   \cgalParamNEnd
///   \cgalParamNBegin{Flip_free_maps::parameters::edge_is_seam_map}
///     \cgalParamDescription{receives whether an edge is a seam: whether its two faces give different images to it.
///     `false` on the border}
///     \cgalParamType{a model of `WritablePropertyMap` with edge descriptors as keys and `bool` as values}
///     \cgalParamDefault{not written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Pieces are cut by `cut_to_disk()` and flattened as by `parameterize()`. A piece may overlap itself at its borders. Where
/// distortion is bounded, sides of a seam that lie over each other by a little are led apart; otherwise it is split between the
/// places of the border that cross, and parts whose piece of the map is not good enough are flattened on from there. A piece whose
/// distortion exceeds `Unwrap_options::max_distortion` is cut again or split, too. Both come to an end at single faces, which are
/// not split. When the time is up, or the observer has asked to stop, parts keep the map that the whole had, which is valid, too.
///
/// \returns how it ended and what each chart is like; `Unwrap_summary::is_valid()` tells whether the maps were written. Bad input
///   gives a status and a message, not an exception: `empty_mesh`, `degenerate_rest_element` if no face has corners at three
///   different places, `non_finite_input` for a coordinate of a face that is NaN or infinite, `invalid_option`,
///   `start_not_flip_free`, `linear_solver_failed`, `line_search_failed`, `result_not_representable`, `out_of_memory`; also
///   `not_triangular`, `non_manifold` and `degenerate_rest_element` if it is to be strict.
///
/// Complexity: O(n log n) for the view; that of `cut_to_disk()` and of `parameterize()`, for each time that a piece is flattened, and of `is_bijective()`.
template <typename FaceGraph, typename HalfedgeUVMap, typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Unwrap_summary unwrap(const FaceGraph& mesh, HalfedgeUVMap uv_map, const Unwrap_options& options, const Traits& traits,
                      const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Halfedge = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;
  using Face = typename boost::graph_traits<FaceGraph>::face_descriptor;
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  const auto vertex_points =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, mesh));
  Unwrap_summary summary;
  const auto run = [&] {
    std::vector<Face> all_faces;
    std::vector<Halfedge> corners;
    internal::Atlas_request request;
    internal::read_polygon_soup(mesh, vertex_points, all_faces, corners, request.surface);
    const std::vector<std::int32_t> sides = internal::sides_to_corners(request.surface);
    const auto marked = [&](const auto& map) {
      std::vector<std::int32_t> result;
      for(std::size_t c = 0; c < corners.size(); ++c)
        if(get(map, edge(corners[c], mesh)))
          result.push_back(sides[c]);
      return result;
    };
    if constexpr(internal::Has_parameter<NamedParameters, CGAL::internal_np::edge_is_constrained_t>::value)
      request.seams = marked(get_parameter(np, CGAL::internal_np::edge_is_constrained));
    if constexpr(internal::Has_parameter<NamedParameters, internal::Edge_is_feature_map_tag>::value)
      request.features = marked(get_parameter(np, internal::edge_is_feature_map_tag));
    static_cast<void>(marked);
    if constexpr(internal::Has_parameter<NamedParameters, internal::Face_is_pinned_map_tag>::value) {
      const auto map = get_parameter(np, internal::face_is_pinned_map_tag);
      internal::read_pinned_polygons([&](std::int32_t p) { return static_cast<bool>(get(map, all_faces[p])); },
                                     [&](std::int32_t, std::int32_t c) { return get(uv_map, corners[c]); }, request);
    }
    request.is_single_precision = std::is_same_v<internal::Coordinate<Point>, float>;

    internal::Atlas_result result;
    Traits method = traits;
    unwrap_polygons(request, options, method, result, summary);
    if(!summary.is_valid())
      return;
    using boost::put; // for pointers
    const internal::Polygon_soup& soup = request.surface;
    for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p)
      for(std::int32_t c = soup.first_corners[p]; !request.keeps(p) && c < soup.first_corners[p + 1]; ++c)
        put(uv_map, corners[c], internal::make_point_2<Point>(result.images[c][0], result.images[c][1]));
    if constexpr(internal::Has_parameter<NamedParameters, internal::Face_chart_map_tag>::value) {
      const auto chart_map = get_parameter(np, internal::face_chart_map_tag);
      using Number = typename boost::property_traits<std::decay_t<decltype(chart_map)>>::value_type;
      for(std::size_t f = 0; f < all_faces.size(); ++f)
        put(chart_map, all_faces[f], static_cast<Number>(result.charts[f]));
    }
    if constexpr(internal::Has_parameter<NamedParameters, internal::Edge_is_seam_map_tag>::value) {
      const auto seam_map = get_parameter(np, internal::edge_is_seam_map_tag);
      const auto null_face = boost::graph_traits<FaceGraph>::null_face();
      for(std::size_t c = 0; c < corners.size(); ++c)
        put(seam_map, edge(corners[c], mesh), result.seams[sides[c]] && face(opposite(corners[c], mesh), mesh) != null_face);
    }
  };
  internal::catch_out_of_memory(run, summary);
  return summary;
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the default method.
template <typename FaceGraph, typename HalfedgeUVMap, typename T, typename Tag, typename Base>
Unwrap_summary unwrap(const FaceGraph& mesh, HalfedgeUVMap uv_map, const Unwrap_options& options,
                      const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return unwrap(mesh, uv_map, options, internal::chosen_traits<internal::Default_method>(np), np);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with everything else as named parameters: `map_traits`, `map_options` and `unwrap_options` of
/// `Flip_free_maps::parameters` beside those above.
template <typename FaceGraph, typename HalfedgeUVMap, typename T, typename Tag, typename Base>
Unwrap_summary unwrap(const FaceGraph& mesh, HalfedgeUVMap uv_map, const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return unwrap(mesh, uv_map, internal::parameter_or(np, internal::unwrap_options_tag, Unwrap_options()),
                internal::chosen_traits<internal::Default_method>(np), np);
}

/// \ingroup PkgFlipFreeMapsRef
/// The same for a polygon soup, as the functions of CGAL's package Polygon_mesh_processing take it.
///
/// \param points the points of the surface: a container with `operator[]`, as `std::vector`, of points in space. Those that no
///   polygon uses may have any value.
/// \param polygons the faces: a container of containers of indices into `points`, of any number of corners, or of triples of them
/// \param uv_of_corners receives the images of the corners of each polygon, in the order of its indices: a container of
///   `std::vector<Point_2>`, or of `std::array<Point_2, 3>` for triangles; it is left untouched if the atlas is not valid. Pinned
///   polygons must have their images there before
/// \param np optional named parameters: `map_traits`, `map_options` and `unwrap_options`; `edge_is_constrained_map`,
///   `edge_is_feature_map` and `edge_is_seam_map`, whose keys are pairs `std::pair<std::size_t, std::size_t>` of indices, the smaller
///   one first; and `face_is_pinned_map` and `face_chart_map`, whose keys are the numbers of polygons. An edge is a seam if faces
///   that meet there, by their indices or their places, give different images to it.
/// \returns as above; also `invalid_option` for an index out of range
template <typename PointRange, typename PolygonRange, typename CornerRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<internal::Is_array<PointRange>::value, int> = 0>
Unwrap_summary unwrap(const PointRange& points, const PolygonRange& polygons, CornerRange& uv_of_corners,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::get_parameter;
  using Corners = typename CornerRange::value_type;
  using Point = std::decay_t<decltype(std::declval<Corners>()[0])>;
  Unwrap_summary summary;
  const auto run = [&] {
    internal::Atlas_request request;
    internal::Polygon_soup& soup = request.surface;
    summary.status = internal::read_polygon_soup(points, polygons, soup, summary.message);
    if(summary.status != Status::success)
      return;
    std::vector<Corners> corners(soup.number_of_polygons());
    for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p)
      if(!internal::resize_images(corners[p], soup.size(p))) {
        summary.status = Status::invalid_option;
        summary.message = "face number " + std::to_string(p) + " has " + std::to_string(soup.size(p)) + " corners, but there is room for " +
                          std::to_string(internal::number_of_corners(corners[p])) + " images";
        return;
      }
    if constexpr(internal::Has_parameter<NamedParameters, CGAL::internal_np::edge_is_constrained_t>::value)
      request.seams = internal::marked_sides(soup, get_parameter(np, CGAL::internal_np::edge_is_constrained));
    if constexpr(internal::Has_parameter<NamedParameters, internal::Edge_is_feature_map_tag>::value)
      request.features = internal::marked_sides(soup, get_parameter(np, internal::edge_is_feature_map_tag));
    if constexpr(internal::Has_parameter<NamedParameters, internal::Face_is_pinned_map_tag>::value) {
      const auto map = get_parameter(np, internal::face_is_pinned_map_tag);
      const auto is_pinned = [&](std::int32_t p) { return static_cast<bool>(get(map, static_cast<std::size_t>(p))); };
      for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p) {
        const std::size_t number = static_cast<std::size_t>(p);
        if(!is_pinned(p))
          continue;
        if(number >= uv_of_corners.size() || internal::number_of_corners(uv_of_corners[number]) != corners[p].size()) {
          summary.status = Status::invalid_option;
          summary.message = "face number " + std::to_string(p) + " is pinned, but not all of its corners have images";
          return;
        }
        corners[p] = uv_of_corners[number];
      }
      internal::read_pinned_polygons(
        is_pinned, [&](std::int32_t p, std::int32_t c) { return corners[p][c - soup.first_corners[p]]; }, request);
    }
    request.is_single_precision = std::is_same_v<internal::Coordinate<Point>, float>;
    internal::Atlas_result result;
    auto method = internal::chosen_traits<internal::Default_method>(np);
    unwrap_polygons(request, internal::parameter_or(np, internal::unwrap_options_tag, Unwrap_options()), method, result, summary);
    if(!summary.is_valid())
      return;
    for(std::int32_t p = 0; p < soup.number_of_polygons(); ++p)
      for(std::int32_t k = 0; !request.keeps(p) && k < soup.size(p); ++k) {
        const auto& image = result.images[soup.first_corners[p] + k];
        corners[p][k] = internal::make_point_2<Point>(image[0], image[1]);
      }
    if constexpr(internal::Has_parameter<NamedParameters, internal::Face_chart_map_tag>::value) {
      using boost::put; // for pointers
      const auto chart_map = get_parameter(np, internal::face_chart_map_tag);
      using Number = typename boost::property_traits<std::decay_t<decltype(chart_map)>>::value_type;
      for(std::size_t p = 0; p < corners.size(); ++p)
        put(chart_map, p, static_cast<Number>(result.charts[p]));
    }
    if constexpr(internal::Has_parameter<NamedParameters, internal::Edge_is_seam_map_tag>::value)
      internal::put_seams(soup, result.seams, get_parameter(np, internal::edge_is_seam_map_tag));
    uv_of_corners = CornerRange(corners.begin(), corners.end());
  };
  internal::catch_out_of_memory(run, summary);
  return summary;
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with default named parameters.
template <typename FaceGraph, typename HalfedgeUVMap, typename Traits>
Unwrap_summary unwrap(const FaceGraph& mesh, HalfedgeUVMap uv_map, const Unwrap_options& options, const Traits& traits)
{
  return unwrap(mesh, uv_map, options, traits, CGAL::parameters::default_values());
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with the default method and default named parameters.
template <typename FaceGraph, typename HalfedgeUVMap>
Unwrap_summary unwrap(const FaceGraph& mesh, HalfedgeUVMap uv_map, const Unwrap_options& options = Unwrap_options())
{
  return unwrap(mesh, uv_map, options, internal::Default_method(), CGAL::parameters::default_values());
}

/// \ingroup PkgFlipFreeMapsIO
/// Gathers a polygon mesh and a map of its corners, as `unwrap()` writes it, for files:
/// `write_textured_OBJ(path, textured_atlas(mesh, uv_map))`. Corners with the same vertex and the same image share their texture
/// coordinates. Points are numbered in the order of the vertices of `mesh`, isolated ones included, and triangles in the order of
/// its faces. Polygons become triangles that are counterclockwise in the plane where the polygons are.
///
/// \tparam FaceGraph must be a model of `FaceListGraph` and `VertexListGraph`, whose vertex descriptors are `Hashable`
/// \tparam HalfedgeUVMap must be a model of `ReadablePropertyMap` with halfedge descriptors as keys and planar points as values
///
/// \param mesh a mesh of polygons
/// \param uv_map its map
/// \param np optional named parameters: `vertex_point_map`, as in `unwrap()`
template <typename FaceGraph, typename HalfedgeUVMap, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Textured_mesh textured_atlas(const FaceGraph& mesh, HalfedgeUVMap uv_map, const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vertex_points =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, mesh));
  Textured_mesh result;
  std::unordered_map<typename boost::graph_traits<FaceGraph>::vertex_descriptor, int> numbers;
  for(const auto v : vertices(mesh)) {
    numbers.emplace(v, static_cast<int>(result.points.size()));
    const auto p = get(vertex_points, v);
    result.points.push_back({CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])});
  }
  internal::Corner_numbers<int> images;
  internal::Polygon_triangulator triangulator;
  const std::vector<std::array<int, 3>> single{{{0, 1, 2}}};
  std::vector<int> polygon, texture_polygon;
  std::vector<internal::Vector<3>> places;
  for(const auto face : faces(mesh)) {
    polygon.clear();
    texture_polygon.clear();
    places.clear();
    const auto first = halfedge(face, mesh);
    auto h = first;
    do {
      const auto p = get(uv_map, h);
      places.emplace_back(CGAL::to_double(p[0]), CGAL::to_double(p[1]), 0);
      polygon.push_back(numbers.at(target(h, mesh)));
      texture_polygon.push_back(images(polygon.back(), places.back().x(), places.back().y()));
      h = next(h, mesh);
    } while(h != first);
    Positions<3> corners(3, places.size());
    for(std::size_t k = 0; k < places.size(); ++k)
      corners.col(k) = places[k];
    for(const auto& t : places.size() == 3 ? single : triangulator.triangulate(corners, [](int, int) { return false; })) {
      result.triangles.push_back({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
      result.texture_triangles.push_back({texture_polygon[t[0]], texture_polygon[t[1]], texture_polygon[t[2]]});
    }
  }
  const Positions<2> x = images.positions();
  for(Eigen::Index i = 0; i < x.cols(); ++i)
    result.texture.push_back({x(0, i), x(1, i)});
  return result;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_UNWRAP_H
