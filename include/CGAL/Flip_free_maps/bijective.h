// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BIJECTIVE_H
#define CGAL_FLIP_FREE_MAPS_BIJECTIVE_H

/// \file
/// The named parameter that asks `parameterize()` for a map that does not overlap itself. It is apart from the others because the
/// triangulations behind it take time to compile.

#include <CGAL/Flip_free_maps/core/flatten_disk_bijectively.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/core/flatten_disk_bijectively_impl.h>
#endif

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Flip_free_maps {
namespace parameters {

/// \ingroup PkgFlipFreeMapsRef
/// Whether the image of the surface must not overlap itself, not even where its borders meet; see \ref FFMBijective. Maps that
/// are not certified by exact predicates to be so end with the status `not_bijective`.
template <typename Base = CGAL::parameters::Default_named_parameters>
auto bijective(bool is_bijective, const Base& base = Base())
{
  return CGAL::Named_function_parameters<bool, internal::Bijective_tag, Base>(is_bijective, base);
}

} // namespace parameters
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_BIJECTIVE_H
