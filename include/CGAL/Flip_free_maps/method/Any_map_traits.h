// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_METHOD_ANY_MAP_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_METHOD_ANY_MAP_TRAITS_H

#include <CGAL/Flip_free_maps/accelerations/Any_acceleration.h>
#include <CGAL/Flip_free_maps/energies/Any_energy.h>
#include <CGAL/Flip_free_maps/linear_solvers/Any_linear_solver.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/preconditioners/Any_preconditioner.h>
#include <CGAL/Flip_free_maps/preconditioners/Hybrid.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>
#include <CGAL/Flip_free_maps/preconditioners/Laplacian.h>
#include <CGAL/Flip_free_maps/preconditioners/Newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Vertex_space_newton.h>
#include <CGAL/Flip_free_maps/references/Progressive_reference.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Traits whose choices are made at run time. One instantiation of an algorithm serves all methods, at the price of a few percent
/// of speed: for programs that let their users choose, and for comparisons.
/// A default-constructed object holds the default method.
///
/// \cgalModels{MapTraits}
class Any_map_traits
  : public Flip_free_map_traits<CGAL::Default, Any_energy, Any_preconditioner, Progressive_reference, Any_linear_solver, Any_acceleration,
                                std::function<Refactorization(int, double, double)>>
{
public:
  /// The default method.
  Any_map_traits()
  {
    use_method("default");
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
    use_linear_solver<Automatic_solver<Cholmod_solver>>();
#else
    use_linear_solver<Eigen_simplicial_solver>();
#endif
  }

  /// Measures against the rest shape only, as `Fixed_reference` does: no distortion is beyond an infinite bound.
  void use_fixed_reference() { reference.bound = std::numeric_limits<double>::infinity(); }

  /// Measures against progressive references with their default bound, or another.
  void use_progressive_reference(double bound = Progressive_reference().bound) { reference.bound = bound; }

  /// Whether references are progressive.
  bool has_progressive_reference() const { return reference.bound < std::numeric_limits<double>::infinity(); }

  /// Chooses the type of the linear solver.
  template <typename Solver>
  void use_linear_solver()
  {
    m_make_linear_solver = &Any_linear_solver::make<Solver>;
  }

  /// A new linear solver of the chosen type.
  Any_linear_solver make_linear_solver() const { return m_make_linear_solver(options.memory_budget); }

  /// Enters the names of what is held into the account of a run.
  void name_choices(Summary& summary) const
  {
    summary.energy_name = energy.energy_name();
    summary.preconditioner = preconditioner.preconditioner_name();
    summary.acceleration = acceleration.acceleration_name();
    summary.reference = has_progressive_reference() ? Progressive_reference::name() : Fixed_reference::name();
  }

  /// Makes the choices of a method of the literature, energy, linear solver and stopping rules apart, and a Tutte start. Names,
  /// with what they stand for:
  ///
  /// | name | preconditioner | reference | acceleration |
  /// |------|----------------|-----------|--------------|
  /// | `default` | `Adaptive_preconditioner` | fixed; start from coarse to fine | `Lbfgs`, `On_demand` |
  /// | `pp` | `Hybrid` | progressive | none |
  /// | `cm`, `p-cm` | `Composite_majorization` | fixed, progressive | none |
  /// | `slim`, `p-slim` | `Slim` | fixed, progressive | none |
  /// | `akvf`, `p-akvf` | `Killing` | fixed, progressive | none |
  /// | `projected-newton` | `Projected_newton` | fixed | none |
  /// | `newton` | `Newton` | fixed | none |
  /// | `aqp` | `Laplacian` | fixed | `Nesterov` |
  /// | `sobolev` | `Laplacian` | fixed | none |
  ///
  /// \returns `false`, and no choice is made, if no method has that name
  bool use_method(const std::string& name)
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

  /// As the function of `Flip_free_map_traits`, if the method is the default and still has its preconditioner and its
  /// acceleration.
  void adapt_to_developable_surface()
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

  /// The preconditioners of the methods without progressive references.
  static const std::map<std::string, Any_preconditioner>& preconditioners()
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

private:
  std::function<Any_linear_solver(double)> m_make_linear_solver;
  bool m_is_default = true;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_METHOD_ANY_MAP_TRAITS_H
