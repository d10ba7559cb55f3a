// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_IS_BIJECTIVE_ON_ARRAYS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_IS_BIJECTIVE_ON_ARRAYS_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/measure/internal/is_bijective_on_arrays.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool is_bijective(const std::vector<std::array<std::int32_t, 3>>& elements, const Positions<2>& x,
                                             std::string* message)
{
  if(!x.allFinite())
    return fail(message, "a coordinate of the map is NaN or infinite");
  for(const auto& element : elements)
    if(!is_positively_oriented<Exact_kernel>(element, x))
      return fail(message, "a triangle is flipped or collapsed");
  Border_curves border;
  if(!border.load(elements, static_cast<std::int32_t>(x.cols())))
    return fail(message, "the surface touches itself at a vertex or an edge");
  bool is_crossed = false;
  border.for_each_crossing(x, [&is_crossed](std::int32_t, std::int32_t) {
    is_crossed = true;
    return false;
  });
  if(is_crossed)
    return fail(message, "the image of the border crosses or touches itself");
  if(!border.are_nested(x))
    return fail(message, "a part of the surface covers another one");
  return true;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_IS_BIJECTIVE_ON_ARRAYS_IMPL_H
