// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_NAMED_PARAMETERS_H
#define CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_NAMED_PARAMETERS_H

#include <CGAL/Flip_free_maps/named_parameters.h>

namespace CGAL {
namespace Flip_free_maps {

namespace internal {

enum Edge_is_feature_map_tag { edge_is_feature_map_tag };

} // namespace internal

namespace parameters {

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

#endif // CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_NAMED_PARAMETERS_H
