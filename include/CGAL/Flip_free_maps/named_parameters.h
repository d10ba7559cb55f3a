// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_NAMED_PARAMETERS_H
#define CGAL_FLIP_FREE_MAPS_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {

namespace internal {

// Whether a named parameter is given.
template <typename NamedParameters, typename Tag>
struct Has_parameter
  : std::bool_constant<
      !std::is_same_v<std::decay_t<decltype(CGAL::parameters::get_parameter(std::declval<const NamedParameters&>(), std::declval<Tag>()))>,
                      CGAL::internal_np::Param_not_found>>
{};

enum Start_map_tag
{
  start_map_tag
};
enum Face_weight_map_tag
{
  face_weight_map_tag
};
enum Soft_positions_tag
{
  soft_positions_tag
};
enum Border_is_fixed_tag
{
  border_is_fixed_tag
};
enum Bijective_tag
{
  bijective_tag
};
enum Edge_is_feature_map_tag
{
  edge_is_feature_map_tag
};

} // namespace internal

/// Named parameters of this package, beside those of CGAL. They chain with the latter by their second argument:
/// `Flip_free_maps::parameters::start_map(uv, CGAL::parameters::vertex_point_map(points))`.
namespace parameters {

using namespace CGAL::parameters;

/// \ingroup PkgFlipFreeMapsRef
/// The positions to begin with: a model of `ReadablePropertyMap` with vertex descriptors as keys and planar points as values, in
/// the units of the surface. They must be without flipped triangles.
template <typename StartMap, typename Base = CGAL::parameters::Default_named_parameters>
auto start_map(const StartMap& map, const Base& base = Base())
{
  return CGAL::Named_function_parameters<StartMap, internal::Start_map_tag, Base>(map, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// Weights of the faces, by which their areas are multiplied in the mean energy: a model of `ReadablePropertyMap` with face
/// descriptors as keys and positive numbers as values.
template <typename FaceWeightMap, typename Base = CGAL::parameters::Default_named_parameters>
auto face_weight_map(const FaceWeightMap& map, const Base& base = Base())
{
  return CGAL::Named_function_parameters<FaceWeightMap, internal::Face_weight_map_tag, Base>(map, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// Soft positions: a range of `std::tuple<vertex_descriptor, Point_2, double>`, a vertex, the place that it is pulled to and the
/// weight. Each adds weight |x - place|^2, with lengths in units of the square root of the surface's area, to the mean energy.
template <typename SoftPositions, typename Base = CGAL::parameters::Default_named_parameters>
auto soft_positions(const SoftPositions& positions, const Base& base = Base())
{
  return CGAL::Named_function_parameters<SoftPositions, internal::Soft_positions_tag, Base>(positions, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// Whether all border vertices keep their positions in the start.
template <typename Base = CGAL::parameters::Default_named_parameters>
auto border_is_fixed(bool is_fixed, const Base& base = Base())
{
  return CGAL::Named_function_parameters<bool, internal::Border_is_fixed_tag, Base>(is_fixed, base);
}

/// \ingroup PkgFlipFreeMapsSeams
/// The feature edges, which are preferred as seams:
/// a model of `ReadablePropertyMap` with edge descriptors as keys and `bool` as values.
template <typename EdgeIsFeatureMap, typename Base = CGAL::parameters::Default_named_parameters>
auto edge_is_feature_map(const EdgeIsFeatureMap& map, const Base& base = Base())
{
  return CGAL::Named_function_parameters<EdgeIsFeatureMap, internal::Edge_is_feature_map_tag, Base>(map, base);
}

} // namespace parameters
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_NAMED_PARAMETERS_H
