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
#include <CGAL/Flip_free_maps/preconditioners/Composite_majorization.h>
#include <CGAL/Flip_free_maps/preconditioners/Hybrid.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>
#include <CGAL/Flip_free_maps/preconditioners/Laplacian.h>
#include <CGAL/Flip_free_maps/preconditioners/Newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Vertex_space_newton.h>
#include <CGAL/Flip_free_maps/references/Progressive_reference.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CGAL/Default.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

// As Flip_free_map_traits.
#if defined(CGAL_FLIP_FREE_MAPS_USE_CHOLMOD) && !defined(DOXYGEN_RUNNING)
inline namespace with_cholmod {
#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC
inline namespace with_petsc {
#endif
#endif

/// \ingroup PkgFlipFreeMapsRef
/// A method of the literature, with the settings of its paper.
struct Published_method
{
  std::string name;                  ///< as `Any_map_traits::use_method()` takes it
  Any_preconditioner preconditioner; ///< how directions are found
  bool is_progressive = false;       ///< whether references are progressive
  bool is_accelerated = false;       ///< whether steps are accelerated by `Nesterov`
  bool place_flaps = false;          ///< as in `Start_options`
  Map_options options;               ///< line search and tolerances
};

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
  Any_map_traits();

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
  void name_choices(Summary& summary) const;

  /// Makes the choices of a method by its name: preconditioner, reference, acceleration, line search, and a Tutte start; not the
  /// energy, the linear solver, and tolerances. `default` is the method of this package. The others are those of the literature, as
  /// written there, see `published_methods()`:
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
  /// With a `+` at its end, `pp+` for example, a method has the line search of this package instead of that of its paper: it begins
  /// with the largest step, frees blocked vertices, and stops carefully (`Map_options`); progressive references then last until no
  /// element exceeds their bound, and flaps are not placed.
  ///
  /// \returns `false`, and no choice is made, if no method has that name
  bool use_method(const std::string& name);

  /// Takes the tolerances of the paper of the method that was chosen last.
  ///
  /// \returns `false`, and none is taken, if there are none, or the method is the default
  bool stop_as_published();

  /// The methods of the literature: all facts in which they differ.
  static const std::vector<Published_method>& published_methods();

  /// As the function of `Flip_free_map_traits`, if the method is the default and still has its preconditioner and its
  /// acceleration.
  void adapt_to_developable_surface();

private:
  const Published_method* find(const std::string& name) const;
  void search_steps_as(const Map_options& other);

  std::function<Any_linear_solver(double)> m_make_linear_solver;
  std::string m_method;
};

#if defined(CGAL_FLIP_FREE_MAPS_USE_CHOLMOD) && !defined(DOXYGEN_RUNNING)
#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC
} // namespace with_petsc
#endif
} // namespace with_cholmod
#endif

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/method/Any_map_traits_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_METHOD_ANY_MAP_TRAITS_H
