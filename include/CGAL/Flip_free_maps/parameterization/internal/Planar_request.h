// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_PLANAR_REQUEST_H
#define CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_PLANAR_REQUEST_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <functional>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A disk that is to be flattened, as flat arrays: what is asked of every method alike.
struct Planar_request
{
  explicit Planar_request(const Simplicial_domain<2>& disk) : domain(disk) {}

  const Simplicial_domain<2>& domain;
  Position_constraints<2> constraints;
  // `make_start(x, name, message)` computes the start; if empty, the method's own is made.
  std::function<Status(Positions<2>&, std::string&, std::string&)> make_start;
  // Whether a rough map will not be improved, since its user wants another surface then. Empty if all maps are.
  std::function<bool(const Positions<2>&)> is_hopeless;
  // Whether the map is to be injective as a whole, and whether no other start than the given one may be taken for that.
  bool is_bijective = false;
  bool keeps_start = false;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_PLANAR_REQUEST_H
