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

#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE Any_map_traits::Any_map_traits()
{
  use_method("default");
  use_linear_solver<Flip_free_map_traits<>::Linear_solver>();
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
  const bool is_default = name == "default", has_own_search = is_default || (!name.empty() && name.back() == '+');
  const Published_method* method = is_default ? nullptr : find(has_own_search ? name.substr(0, name.size() - 1) : name);
  if(!is_default && method == nullptr)
    return false;
  m_method = name;
  Map_options search = has_own_search ? Map_options() : method->options;
  search.begin_with_largest_step = is_default ? false : has_own_search || search.begin_with_largest_step;
  search_steps_as(search);
  start.place_flaps = !has_own_search && method->place_flaps;
  reference = Progressive_reference();
  if(has_own_search)
    reference.distorted_fraction = 0;
  if(is_default) {
    const Flip_free_map_traits<> defaults;
    preconditioner = Any_preconditioner(defaults.preconditioner);
    acceleration = Any_acceleration(defaults.acceleration);
    refactorization_rule = defaults.refactorization_rule;
    start.multilevel_size = defaults.start.multilevel_size;
    use_fixed_reference();
    return true;
  }
  preconditioner = method->preconditioner;
  acceleration = method->is_accelerated ? Any_acceleration(Nesterov()) : Any_acceleration(No_acceleration());
  refactorization_rule = Every_iteration();
  start.multilevel_size = -1;
  if(!method->is_progressive)
    use_fixed_reference();
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Any_map_traits::stop_as_published()
{
  const Published_method* method = find(m_method.substr(0, m_method.find('+')));
  if(method == nullptr || (method->options.gradient_tolerance == 0 && method->options.relative_energy_tolerance == 0))
    return false;
  options.characteristic_gradient_tolerance = 0;
  options.gradient_tolerance = method->options.gradient_tolerance;
  options.relative_energy_tolerance = method->options.relative_energy_tolerance;
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE const Published_method* Any_map_traits::find(const std::string& name) const
{
  for(const Published_method& method : published_methods())
    if(method.name == name)
      return &method;
  return nullptr;
}

CGAL_FLIP_FREE_MAPS_INLINE void Any_map_traits::search_steps_as(const Map_options& other)
{
  options.step_fraction = other.step_fraction;
  options.armijo = other.armijo;
  options.backtracking = other.backtracking;
  options.max_line_search_steps = other.max_line_search_steps;
  options.extend_steps = other.extend_steps;
  options.begin_with_largest_step = other.begin_with_largest_step;
  options.free_blocked_vertices = other.free_blocked_vertices;
  options.careful_stagnation = other.careful_stagnation;
}

CGAL_FLIP_FREE_MAPS_INLINE void Any_map_traits::adapt_to_developable_surface()
{
  Flip_free_map_traits<> defaults;
  if(m_method != "default" || preconditioner.preconditioner_name() != defaults.preconditioner.name() ||
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

namespace internal {

// min(1, fraction a_max) and plain backtracking, nothing else.
inline Map_options plain_search(double fraction, double armijo, double factor)
{
  Map_options options;
  options.step_fraction = fraction;
  options.armijo = armijo;
  options.backtracking = factor;
  options.extend_steps = false;
  options.free_blocked_vertices = false;
  options.careful_stagnation = false;
  options.characteristic_gradient_tolerance = 0;
  return options;
}

} // namespace internal

CGAL_FLIP_FREE_MAPS_INLINE const std::vector<Published_method>& Any_map_traits::published_methods()
{
  static const std::vector<Published_method> all = [] {
    // Liu et al. 2018, section 3.6: min(1, 0.9 a_max) and Armijo backtracking "for SLIM or CM", relative change of the energy or
    // norm of the gradient below 1e-6 for all the methods that are compared. Constants of the backtracking that no paper gives are
    // the usual ones.
    const Map_options armijo = internal::plain_search(0.9, 1e-4, 0.5);
    Map_options liu = armijo;
    liu.relative_energy_tolerance = 1e-6;
    liu.gradient_tolerance = 1e-6;
    // Claici et al. 2017, sections 5.3 and 5.5. Their energy is four times ours.
    Map_options claici = internal::plain_search(0.8, 1e-5, 0.9);
    claici.begin_with_largest_step = true;
    claici.max_line_search_steps = 400;
    Map_options progressive_claici = claici;
    claici.gradient_tolerance = 1e-5 / 4;
    progressive_claici.relative_energy_tolerance = liu.relative_energy_tolerance;
    progressive_claici.gradient_tolerance = liu.gradient_tolerance;
    const Any_preconditioner cm(Composite_majorization<>{}), slim(Slim{}), killing(Killing{}), laplacian(Laplacian{});
    return std::vector<Published_method>{{"pp", Any_preconditioner(Hybrid<>()), true, false, false, liu},
                                         {"cm", cm, false, false, false, liu},
                                         {"slim", slim, false, false, false, liu},
                                         {"akvf", killing, false, false, true, claici},
                                         {"p-cm", cm, true, false, false, liu},
                                         {"p-slim", slim, true, false, false, liu},
                                         {"p-akvf", killing, true, false, false, progressive_claici},
                                         {"projected-newton", Any_preconditioner(Projected_newton()), false, false, false, armijo},
                                         {"newton", Any_preconditioner(Newton()), false, false, false, armijo},
                                         {"aqp", laplacian, false, true, false, armijo},
                                         {"sobolev", laplacian, false, false, false, armijo}};
  }();
  return all;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_METHOD_ANY_MAP_TRAITS_IMPL_H
