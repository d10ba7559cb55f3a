// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_METHOD_ANY_MAP_TRAITS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_METHOD_ANY_MAP_TRAITS_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>

#include <map>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE Any_map_traits::Any_map_traits()
{
  use_method("default");
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  use_linear_solver<Automatic_solver<Cholmod_solver>>();
#else
  use_linear_solver<Eigen_simplicial_solver>();
#endif
}

CGAL_FLIP_FREE_MAPS_INLINE void Any_map_traits::name_choices(Summary& summary) const
{
  summary.energy_name = energy.energy_name();
  summary.preconditioner = preconditioner.preconditioner_name();
  summary.acceleration = acceleration.acceleration_name();
  summary.reference = has_progressive_reference() ? Progressive_reference::name() : Fixed_reference::name();
}

CGAL_FLIP_FREE_MAPS_INLINE bool Any_map_traits::use_method(const std::string& name)
{
  if(name == "default") {
    m_is_default = true;
    const Flip_free_map_traits<> defaults;
    preconditioner = Any_preconditioner(defaults.preconditioner);
    acceleration = Any_acceleration(defaults.acceleration);
    refactorization_rule = defaults.refactorization_rule;
    start.multilevel_size = defaults.start.multilevel_size;
    options.begin_with_largest_step = defaults.options.begin_with_largest_step;
    use_fixed_reference();
    return true;
  }
  const bool is_progressive = name == "pp" || name.compare(0, 2, "p-") == 0;
  const auto found = preconditioners().find(name != "pp" && is_progressive ? name.substr(2) : name);
  if(found == preconditioners().end() || name == "p-pp" || (is_progressive && found->second.is_constant()))
    return false;
  m_is_default = false;
  preconditioner = found->second;
  acceleration = name == "aqp" ? Any_acceleration(Nesterov()) : Any_acceleration(No_acceleration());
  refactorization_rule = Every_iteration();
  start.multilevel_size = -1;
  options.begin_with_largest_step = true;
  if(is_progressive)
    use_progressive_reference();
  else
    use_fixed_reference();
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE void Any_map_traits::adapt_to_developable_surface()
{
  Flip_free_map_traits<> defaults;
  if(!m_is_default || preconditioner.preconditioner_name() != defaults.preconditioner.name() ||
     acceleration.acceleration_name() != defaults.acceleration.name())
    return;
  defaults.adapt_to_developable_surface();
  preconditioner = Any_preconditioner(defaults.preconditioner);
  acceleration = Any_acceleration(defaults.acceleration);
  refactorization_rule = defaults.refactorization_rule;
  if(start.multilevel_size >= 0) {
    start.unfold = true;
    start.multilevel_size = 0;
  }
}

CGAL_FLIP_FREE_MAPS_INLINE const std::map<std::string, Any_preconditioner>& Any_map_traits::preconditioners()
{
  static const std::map<std::string, Any_preconditioner> all{{"aqp", Any_preconditioner(Laplacian())},
                                                             {"sobolev", Any_preconditioner(Laplacian())},
                                                             {"akvf", Any_preconditioner(Killing())},
                                                             {"slim", Any_preconditioner(Slim())},
                                                             {"cm", Any_preconditioner(Composite_majorization<>())},
                                                             {"pp", Any_preconditioner(Hybrid<>())},
                                                             {"newton", Any_preconditioner(Newton())},
                                                             {"projected-newton", Any_preconditioner(Projected_newton())}};
  return all;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_METHOD_ANY_MAP_TRAITS_IMPL_H
