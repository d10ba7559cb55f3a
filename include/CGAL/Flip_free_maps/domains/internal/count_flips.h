// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_COUNT_FLIPS_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_COUNT_FLIPS_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Element_coloring.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

template <typename Kernel>
bool is_positively_oriented(const std::array<std::int32_t, 3>& v, const Positions<2>& x)
{
  const auto point = [&](std::int32_t i) { return typename Kernel::Point_2(x(0, i), x(1, i)); };
  return typename Kernel::Orientation_2()(point(v[0]), point(v[1]), point(v[2])) == CGAL::POSITIVE;
}

template <typename Kernel>
bool is_positively_oriented(const std::array<std::int32_t, 4>& v, const Positions<3>& x)
{
  const auto point = [&](std::int32_t i) { return typename Kernel::Point_3(x(0, i), x(1, i), x(2, i)); };
  return typename Kernel::Orientation_3()(point(v[0]), point(v[1]), point(v[2]), point(v[3])) == CGAL::POSITIVE;
}

// The number of elements that are not positively oriented, by the kernel's exact predicates.
template <typename Kernel, typename ConcurrencyTag, int D>
std::int64_t count_flips(const Simplicial_domain<D>& domain, const Element_coloring& schedule, const Positions<D>& x)
{
  return static_cast<std::int64_t>(
    schedule.template sum<ConcurrencyTag>([&](std::int64_t e) { return is_positively_oriented<Kernel>(domain.elements[e], x) ? 0. : 1.; }));
}

// Counts the flips of a map as it will be written, and enters them into the summary. `false`, and the status says so, when there
// are some that were not there before.
template <typename Kernel>
bool certify_flips(const Simplicial_domain<2>& domain, const Positions<2>& written, Summary& summary)
{
  const bool allows_flips = summary.flips > 0;
  summary.flips = domain.number_of_elements();
  if(written.allFinite())
    summary.flips = std::count_if(domain.elements.begin(), domain.elements.end(),
                                  [&](const auto& element) { return !is_positively_oriented<Kernel>(element, written); });
  if(summary.flips == 0 || allows_flips)
    return true;
  summary.status = Status::result_not_representable;
  summary.message = "elements flip when the map is converted to the number type of the result";
  return false;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_COUNT_FLIPS_H
