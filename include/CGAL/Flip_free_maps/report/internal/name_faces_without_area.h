// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPORT_INTERNAL_NAME_FACES_WITHOUT_AREA_H
#define CGAL_FLIP_FREE_MAPS_REPORT_INTERNAL_NAME_FACES_WITHOUT_AREA_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Enters the faces without area, by their numbers in ascending order, into an account.
template <typename Numbers, typename Account>
void name_faces_without_area(const Numbers& faces, Account& summary)
{
  constexpr std::size_t MOST_NAMES = 10;
  summary.faces_without_area = static_cast<std::int64_t>(faces.size());
  summary.first_faces_without_area.assign(faces.begin(), faces.begin() + (std::min)(faces.size(), MOST_NAMES));
  if(faces.empty() || !summary.is_valid())
    return;
  std::string numbers;
  for(const std::int64_t f : summary.first_faces_without_area)
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(f);
  summary.message += "; without area: " + std::to_string(faces.size()) + (faces.size() == 1 ? " face, number " : " faces, numbers ") +
                     numbers + (faces.size() > MOST_NAMES ? ", ..." : "");
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPORT_INTERNAL_NAME_FACES_WITHOUT_AREA_H
