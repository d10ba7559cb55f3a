// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPAIR_MAP_IMPL_H
#define CGAL_FLIP_FREE_MAPS_REPAIR_MAP_IMPL_H

#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/repair_map.h>

namespace CGAL {
namespace Flip_free_maps {

template class Foldover_free<2>;
template class internal::Flip_removal<2, internal::Repair_traits_of<Flip_free_map_traits<>>>;
template class internal::Flip_removal<3, internal::Repair_traits_of<Flip_free_map_traits<>>>;
template class internal::Flip_removal<3, internal::Repair_traits_of<Any_map_traits>>;
template Summary repair_map<2, Flip_free_map_traits<>>(const Simplicial_domain<2>&, Positions<2>&, const Position_constraints<2>&,
                                                       const Repair_options&, const Flip_free_map_traits<>&);
template Summary repair_map<3, Flip_free_map_traits<>>(const Simplicial_domain<3>&, Positions<3>&, const Position_constraints<3>&,
                                                       const Repair_options&, const Flip_free_map_traits<>&);
template Summary repair_map<3, Any_map_traits>(const Simplicial_domain<3>&, Positions<3>&, const Position_constraints<3>&,
                                               const Repair_options&, const Any_map_traits&);
template Summary repair_map<3, Flip_free_map_traits<CGAL::Default, Symmetric_gradient>>(
  const Simplicial_domain<3>&, Positions<3>&, const Position_constraints<3>&, const Repair_options&,
  const Flip_free_map_traits<CGAL::Default, Symmetric_gradient>&);

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPAIR_MAP_IMPL_H
