// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_MAKE_START_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_MAKE_START_H

#include <CGAL/Flip_free_maps/domains/Map_measure.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/initializers/Multilevel_initializer.h>
#include <CGAL/Flip_free_maps/initializers/Tutte_initializer.h>
#include <CGAL/Flip_free_maps/initializers/internal/unfold_developable.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Whether no element is flipped, and few are distorted much.
template <typename Traits>
bool is_unfolded(const Simplicial_domain<2>& domain, const Positions<2>& x)
{
  constexpr double LARGEST_ENERGY = 1.5;
  const Map_measure<2, typename Traits::Kernel, typename Traits::Concurrency_tag> measure(domain);
  return measure.number_of_flips(x) == 0 && measure.mean_energy(Symmetric_dirichlet(), x) <= LARGEST_ENERGY;
}

// The start that `Traits::start` asks for. Where one kind fails the other is tried, if fallbacks are allowed.
template <typename Traits>
Status make_start(const Simplicial_domain<2>& domain, const Traits& traits, Positions<2>& x, std::string& name, std::string& message)
{
  const Needed_work work;
  const auto tutte = [&] {
    return Tutte_initializer<typename Traits::Kernel, typename Traits::Linear_solver, typename Traits::Concurrency_tag>(traits.start)(
      domain, [&traits] { return traits.make_linear_solver(); }, x, name, message);
  };
  const auto multilevel = [&] { return Multilevel_initializer<Traits>(traits)(domain, x, name, message); };

  if(traits.start.unfold) {
    unfold_developable(domain, x);
    // A surface that is not quite developable may tear.
    if(is_unfolded<Traits>(domain, x)) {
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
