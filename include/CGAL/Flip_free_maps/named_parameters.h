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

// A named parameter after those of `base`. A parameter is a tag and a function that calls this one.
template <typename Tag, typename T, typename Base>
CGAL::Named_function_parameters<T, Tag, Base> named_parameter(const T& value, const Base& base)
{
  return CGAL::Named_function_parameters<T, Tag, Base>(value, base);
}

// A copy of what a named parameter holds, or of a default.
template <typename NamedParameters, typename Tag, typename Value>
auto parameter_or(const NamedParameters& np, Tag tag, const Value& otherwise)
{
  if constexpr(Has_parameter<NamedParameters, Tag>::value) {
    static_cast<void>(otherwise);
    return CGAL::parameters::get_parameter(np, tag);
  } else {
    static_cast<void>(np);
    static_cast<void>(tag);
    return otherwise;
  }
}

enum Map_traits_tag
{
  map_traits_tag
};
enum Map_options_tag
{
  map_options_tag
};
enum Repair_options_tag
{
  repair_options_tag
};
enum Seam_options_tag
{
  seam_options_tag
};
enum Cut_options_tag
{
  cut_options_tag
};
enum Packing_options_tag
{
  packing_options_tag
};
enum Unwrap_options_tag
{
  unwrap_options_tag
};
enum Volume_options_tag
{
  volume_options_tag
};
enum Tetrahedralization_options_tag
{
  tetrahedralization_options_tag
};

// The method that named parameters ask for: `map_traits`, with `map_options` in place of its own settings.
template <typename DefaultTraits, typename NamedParameters>
auto chosen_traits(const NamedParameters& np)
{
  auto traits = parameter_or(np, map_traits_tag, DefaultTraits());
  if constexpr(Has_parameter<NamedParameters, Map_options_tag>::value)
    traits.options = CGAL::parameters::get_parameter(np, map_options_tag);
  return traits;
}

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
enum Strict_tag
{
  strict_tag
};
enum Edge_is_feature_map_tag
{
  edge_is_feature_map_tag
};
enum Face_is_pinned_map_tag
{
  face_is_pinned_map_tag
};

} // namespace internal

/// Named parameters of this package, beside those of CGAL. Those of CGAL follow as members, those of this package go around what
/// is there: `parameters::start_map(uv, parameters::map_traits(traits)).vertex_point_map(points)`.
namespace parameters {

/// \ingroup PkgFlipFreeMapsRef
/// The method and its settings: a model of `MapTraits`. <b>Default:</b> `Flip_free_map_traits<>`.
template <typename Traits, typename Base = CGAL::parameters::Default_named_parameters>
auto map_traits(const Traits& traits, const Base& base = Base())
{
  return internal::named_parameter<internal::Map_traits_tag>(traits, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// The settings of the method, in place of those that its traits hold: `Map_options`, or `Splitting_options` with
/// `Splitting_map_traits`.
template <typename Options, typename Base = CGAL::parameters::Default_named_parameters>
auto map_options(const Options& options, const Base& base = Base())
{
  return internal::named_parameter<internal::Map_options_tag>(options, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// `Repair_options`, how `repair_map()` removes flips.
template <typename Options, typename Base = CGAL::parameters::Default_named_parameters>
auto repair_options(const Options& options, const Base& base = Base())
{
  return internal::named_parameter<internal::Repair_options_tag>(options, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// `Seam_options`, how seams are met.
template <typename Options, typename Base = CGAL::parameters::Default_named_parameters>
auto seam_options(const Options& options, const Base& base = Base())
{
  return internal::named_parameter<internal::Seam_options_tag>(options, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// `Cut_options`, what seams shall reach.
template <typename Options, typename Base = CGAL::parameters::Default_named_parameters>
auto cut_options(const Options& options, const Base& base = Base())
{
  return internal::named_parameter<internal::Cut_options_tag>(options, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// `Packing_options`, margin and rotation of charts.
template <typename Options, typename Base = CGAL::parameters::Default_named_parameters>
auto packing_options(const Options& options, const Base& base = Base())
{
  return internal::named_parameter<internal::Packing_options_tag>(options, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// `Unwrap_options`, how `unwrap()` cuts, splits and packs.
template <typename Options, typename Base = CGAL::parameters::Default_named_parameters>
auto unwrap_options(const Options& options, const Base& base = Base())
{
  return internal::named_parameter<internal::Unwrap_options_tag>(options, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// `Deform_volume_options`, soft handles and another start.
template <typename Options, typename Base = CGAL::parameters::Default_named_parameters>
auto volume_options(const Options& options, const Base& base = Base())
{
  return internal::named_parameter<internal::Volume_options_tag>(options, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// `Tetrahedralization_options`, or `Tetgen_options` for `tetrahedralize_with_tetgen()`: the sizes of tetrahedra.
template <typename Options, typename Base = CGAL::parameters::Default_named_parameters>
auto tetrahedralization_options(const Options& options, const Base& base = Base())
{
  return internal::named_parameter<internal::Tetrahedralization_options_tag>(options, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// The positions to begin with: a model of `ReadablePropertyMap` with vertex descriptors as keys and planar points as values, in
/// the units of the surface. They must be without flipped triangles.
template <typename StartMap, typename Base = CGAL::parameters::Default_named_parameters>
auto start_map(const StartMap& map, const Base& base = Base())
{
  return internal::named_parameter<internal::Start_map_tag>(map, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// Weights of the faces, by which their areas are multiplied in the mean energy: a model of `ReadablePropertyMap` with face
/// descriptors as keys and positive numbers as values.
template <typename FaceWeightMap, typename Base = CGAL::parameters::Default_named_parameters>
auto face_weight_map(const FaceWeightMap& map, const Base& base = Base())
{
  return internal::named_parameter<internal::Face_weight_map_tag>(map, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// Soft positions: a range of `std::tuple<vertex_descriptor, Point_2, double>`, a vertex, the place that it is pulled to and the
/// weight. Each adds weight |x - place|^2, with lengths in units of the square root of the surface's area, to the mean energy.
template <typename SoftPositions, typename Base = CGAL::parameters::Default_named_parameters>
auto soft_positions(const SoftPositions& positions, const Base& base = Base())
{
  return internal::named_parameter<internal::Soft_positions_tag>(positions, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// Whether all border vertices keep their positions in the start.
template <typename Base = CGAL::parameters::Default_named_parameters>
auto border_is_fixed(bool is_fixed, const Base& base = Base())
{
  return internal::named_parameter<internal::Border_is_fixed_tag>(is_fixed, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// Whether polygons that are no triangles, faces without area, and arrays whose points or faces are there twice, are refused.
template <typename Base = CGAL::parameters::Default_named_parameters>
auto strict(bool is_strict, const Base& base = Base())
{
  return internal::named_parameter<internal::Strict_tag>(is_strict, base);
}

/// \ingroup PkgFlipFreeMapsSeams
/// The feature edges, which are preferred as seams:
/// a model of `ReadablePropertyMap` with edge descriptors as keys and `bool` as values.
template <typename EdgeIsFeatureMap, typename Base = CGAL::parameters::Default_named_parameters>
auto edge_is_feature_map(const EdgeIsFeatureMap& map, const Base& base = Base())
{
  return internal::named_parameter<internal::Edge_is_feature_map_tag>(map, base);
}

/// \ingroup PkgFlipFreeMapsRef
/// The faces that are pinned, whose images stay where they are:
/// a model of `ReadablePropertyMap` with face descriptors as keys and `bool` as values.
template <typename FaceIsPinnedMap, typename Base = CGAL::parameters::Default_named_parameters>
auto face_is_pinned_map(const FaceIsPinnedMap& map, const Base& base = Base())
{
  return internal::named_parameter<internal::Face_is_pinned_map_tag>(map, base);
}

} // namespace parameters
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_NAMED_PARAMETERS_H
