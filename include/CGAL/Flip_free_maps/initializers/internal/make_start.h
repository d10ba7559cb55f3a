// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_MAKE_START_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_MAKE_START_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/initializers/Multilevel_initializer.h>
#include <CGAL/Flip_free_maps/initializers/Tutte_initializer.h>
#include <CGAL/Flip_free_maps/initializers/internal/unfold_developable.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <cstdint>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Whether no element is flipped, and few are distorted much.
template <typename Kernel>
bool is_unfolded(const Simplicial_domain<2>& domain, const Positions<2>& x)
{
  constexpr double LARGEST_ENERGY = 1.5;
  double energy = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    if(!is_positively_oriented<Kernel>(domain.elements[e], x))
      return false;
    const Matrix<2> jacobian = domain.jacobian(e, x);
    const double square = jacobian.squaredNorm(), determinant = jacobian.determinant();
    energy += domain.measures[e] * 0.25 * (square + square / (determinant * determinant));
  }
  return energy <= LARGEST_ENERGY;
}

// The start that `Traits::start` asks for. Where one kind fails the other is tried, if fallbacks are allowed.
template <typename Traits>
Status make_start(const Simplicial_domain<2>& domain, const Traits& traits, Positions<2>& x, std::string& name, std::string& message)
{
  const auto tutte = [&] {
    return Tutte_initializer<typename Traits::Kernel, typename Traits::Linear_solver, typename Traits::Concurrency_tag>(traits.start)(
      domain, [&traits] { return traits.make_linear_solver(); }, x, name, message);
  };
  const auto multilevel = [&] { return Multilevel_initializer<Traits>(traits)(domain, x, name, message); };

  if(traits.start.unfold) {
    unfold_developable(domain, x);
    // A surface that is not quite developable may tear.
    if(is_unfolded<typename Traits::Kernel>(domain, x)) {
      name = "unfolded";
      return Status::success;
    }
  }
  const bool begins_coarse = traits.start.multilevel_size >= 0 && domain.number_of_elements() >= traits.start.multilevel_size;
  Status status = begins_coarse ? multilevel() : tutte();
  if(status != Status::start_not_flip_free || !traits.start.fall_back)
    return status;
  const std::string failure = message;
  status = begins_coarse ? tutte() : multilevel();
  if(status == Status::success)
    name += "; after: " + failure;
  else
    message = failure + "; then " + message;
  return status;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_MAKE_START_H
