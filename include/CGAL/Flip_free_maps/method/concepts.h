// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_METHOD_CONCEPTS_H
#define CGAL_FLIP_FREE_MAPS_METHOD_CONCEPTS_H

#include <CGAL/Flip_free_maps/accelerations/Refactorization_rules.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/elements/Increment_form.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/method/Start_options.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <boost/concept_check.hpp>

#include <cstdint>
#include <string>
#include <type_traits>

/// \file
/// Compile-time checks of the concepts of the package, to be used like those of Boost:
/// `BOOST_CONCEPT_ASSERT((CGAL::Flip_free_maps::DistortionEnergyConcept<My_energy, 2>));`. Requirements are compiled, not run.
/// The dimension of a map is not a type, which is why the classes are written out instead of made by the macro `BOOST_concept`.

// In each class the address of `requirements` is taken where Boost instantiates code, since an unused function would not be
// compiled, let alone checked.

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `Energy` is a model of `DistortionEnergy` for maps of dimension `D`.
template <typename Energy, int D>
struct DistortionEnergyConcept : boost::CopyConstructible<Energy>
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(DistortionEnergyConcept)
  {
    static_assert(std::is_same<decltype(Energy::has_barrier), const bool>::value, "has_barrier must be a constant bool");
    static_assert(Energy::has_barrier || !Energy::has_barrier, "has_barrier must be known at compile time");
    const auto check = &DistortionEnergyConcept::requirements;
    boost::ignore_unused_variable_warning(check);
  }

private:
  static void requirements(const Energy& energy, const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient,
                           Eigen::Matrix<double, D, D>& hessian)
  {
    const std::string name = Energy::name();
    const double value = energy.template value<D>(s);
    energy.template derivatives<D>(s, gradient, hessian);
    boost::ignore_unused_variable_warning(name);
    boost::ignore_unused_variable_warning(value);
  }
  /// \endcond
};

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `Energy` is a model of `ConvexConcaveEnergy` for maps of dimension `D`.
template <typename Energy, int D>
struct ConvexConcaveEnergyConcept : DistortionEnergyConcept<Energy, D>
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(ConvexConcaveEnergyConcept)
  {
    const auto check = &ConvexConcaveEnergyConcept::requirements;
    boost::ignore_unused_variable_warning(check);
  }

private:
  static void requirements(const Energy& energy, const Eigen::Matrix<double, D, 1>& s, const Eigen::Matrix<double, D, D>& hessian,
                           Eigen::Matrix<double, D, D>& convex)
  {
    energy.template convex_hessian<D>(s, hessian, convex);
  }
  /// \endcond
};

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `P` is a model of `Preconditioner` for maps of dimension `D` and a given energy.
template <typename P, typename Energy, int D>
struct PreconditionerConcept : boost::CopyConstructible<P>
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(PreconditionerConcept)
  {
    using Category = typename P::Category;
    static_assert(std::is_same<Category, Constant_matrix_tag>::value || std::is_same<Category, Varying_matrix_tag>::value,
                  "Category must be Constant_matrix_tag or Varying_matrix_tag");
    static_assert(std::is_same<std::remove_const_t<decltype(P::is_second_order)>, bool>::value, "is_second_order must be a bool");
    const auto check = &PreconditionerConcept::requirements;
    boost::ignore_unused_variable_warning(check);
  }

private:
  static void requirements(const P& preconditioner, const Energy& energy, const Element_state<D>& state, Increment_form<D>& form)
  {
    const std::string name = P::name();
    const bool is_second_order = preconditioner.is_second_order;
    boost::ignore_unused_variable_warning(is_second_order);
    preconditioner.form(state, energy, form);
    boost::ignore_unused_variable_warning(name);
  }
  /// \endcond
};

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `R` is a model of `Reference` for maps of dimension `D`.
template <typename R, int D>
struct ReferenceConcept : boost::CopyConstructible<R>
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(ReferenceConcept)
  {
    const auto check = &ReferenceConcept::requirements;
    boost::ignore_unused_variable_warning(check);
  }

private:
  static void requirements(R& reference, const R& const_reference, const Simplicial_domain<D>& domain, const Positions<D>& x,
                           std::int64_t e)
  {
    const std::string name = R::name();
    reference.restart();
    const bool is_rest_shape = reference.update(domain, x);
    const double relative_decrease = const_reference.relative_decrease();
    const Eigen::Matrix<double, D, D>& rest_inverse = const_reference.rest_inverse(domain, e);
    const double weight = const_reference.weight(domain, e);
    boost::ignore_unused_variable_warning(name);
    boost::ignore_unused_variable_warning(is_rest_shape);
    boost::ignore_unused_variable_warning(relative_decrease);
    boost::ignore_unused_variable_warning(rest_inverse);
    boost::ignore_unused_variable_warning(weight);
  }
  /// \endcond
};

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `A` is a model of `Acceleration`.
template <typename A>
struct AccelerationConcept : boost::CopyConstructible<A>
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(AccelerationConcept)
  {
    const auto check = &AccelerationConcept::requirements;
    boost::ignore_unused_variable_warning(check);
  }

private:
  struct Solve
  {
    bool operator()(const Eigen::VectorXd&, Eigen::VectorXd&) const { return false; }
    void multiply(const Eigen::VectorXd&, Eigen::VectorXd&) const {}
  };
  static void requirements(A& acceleration, const Eigen::VectorXd& x, const Eigen::VectorXd& gradient, Eigen::VectorXd& direction)
  {
    const std::string name = A::name();
    acceleration.reset();
    const bool success = acceleration.direction(x, gradient, Solve(), direction);
    boost::ignore_unused_variable_warning(name);
    boost::ignore_unused_variable_warning(success);
  }
  /// \endcond
};

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `Rule` is a model of `RefactorizationRule`.
template <typename Rule>
struct RefactorizationRuleConcept : boost::CopyConstructible<Rule>
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(RefactorizationRuleConcept)
  {
    const auto check = &RefactorizationRuleConcept::requirements;
    boost::ignore_unused_variable_warning(check);
  }

private:
  static void requirements(Rule& rule, int age, double last_step, double relative_decrease)
  {
    const Refactorization refactorization = rule(age, last_step, relative_decrease);
    boost::ignore_unused_variable_warning(refactorization);
  }
  /// \endcond
};

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `Solver` is a model of `SymmetricSparseSolver`.
template <typename Solver>
struct SymmetricSparseSolverConcept
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(SymmetricSparseSolverConcept)
  {
    const auto check = &SymmetricSparseSolverConcept::requirements;
    boost::ignore_unused_variable_warning(check);
  }

private:
  static void requirements(Solver& solver, const Solver& const_solver, const Block_sparse_matrix& matrix, const Eigen::VectorXd& b,
                           Eigen::VectorXd& x)
  {
    const std::string name = const_solver.name();
    const std::string ordering = const_solver.ordering();
    const bool analyzed = solver.analyze_pattern(matrix);
    const bool factorized = solver.factorize(matrix);
    const bool solved = solver.solve(b, x);
    const std::int64_t entries = const_solver.factor_entries();
    boost::ignore_unused_variable_warning(name);
    boost::ignore_unused_variable_warning(ordering);
    boost::ignore_unused_variable_warning(analyzed);
    boost::ignore_unused_variable_warning(factorized);
    boost::ignore_unused_variable_warning(solved);
    boost::ignore_unused_variable_warning(entries);
  }
  /// \endcond
};

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `I` is a model of `Initializer` when given a functor `MakeLinearSolver` that returns a new linear solver.
template <typename I, typename MakeLinearSolver>
struct InitializerConcept : boost::CopyConstructible<I>
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(InitializerConcept)
  {
    const auto check = &InitializerConcept::requirements;
    boost::ignore_unused_variable_warning(check);
  }

private:
  static void requirements(const I& initializer, const Simplicial_domain<2>& domain, MakeLinearSolver& make_linear_solver, Positions<2>& x,
                           std::string& name, std::string& message)
  {
    const Status status = initializer(domain, make_linear_solver, x, name, message);
    boost::ignore_unused_variable_warning(status);
  }
  /// \endcond
};

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `Traits` is a model of `MapTraits` for maps of dimension `D`, and that its parts are models of their concepts.
template <typename Traits, int D>
struct MapTraitsConcept : boost::CopyConstructible<Traits>
{
  /// \cond SKIP_IN_MANUAL
  using Kernel = typename Traits::Kernel;
  using Energy = typename Traits::Energy;
  using Preconditioner = typename Traits::Preconditioner;
  using Reference = typename Traits::Reference;
  using Linear_solver = typename Traits::Linear_solver;
  using Acceleration = typename Traits::Acceleration;
  using Refactorization_rule = typename Traits::Refactorization_rule;
  using Concurrency_tag = typename Traits::Concurrency_tag;

  BOOST_CONCEPT_ASSERT((DistortionEnergyConcept<Energy, D>));
  BOOST_CONCEPT_ASSERT((PreconditionerConcept<Preconditioner, Energy, D>));
  BOOST_CONCEPT_ASSERT((ReferenceConcept<Reference, D>));
  BOOST_CONCEPT_ASSERT((SymmetricSparseSolverConcept<Linear_solver>));
  BOOST_CONCEPT_ASSERT((AccelerationConcept<Acceleration>));
  BOOST_CONCEPT_ASSERT((RefactorizationRuleConcept<Refactorization_rule>));

  // Only the name: the class may be incomplete here, and checks the traits itself.
  using Minimizer = typename Traits::template Minimizer<D, Traits>;

  BOOST_CONCEPT_USAGE(MapTraitsConcept)
  {
    static_assert(std::is_class<Minimizer>::value, "Minimizer must be a class");
    static_assert(std::is_convertible<Concurrency_tag, CGAL::Sequential_tag>::value ||
                    std::is_convertible<Concurrency_tag, CGAL::Parallel_tag>::value,
                  "Concurrency_tag must be one of CGAL's concurrency tags");
    const auto check = &MapTraitsConcept::requirements;
    boost::ignore_unused_variable_warning(check);
    const auto kernel_check = &MapTraitsConcept::kernel_requirements;
    boost::ignore_unused_variable_warning(kernel_check);
  }

private:
  static void requirements(Traits& traits, const Traits& const_traits)
  {
    Energy& energy = traits.energy;
    Preconditioner& preconditioner = traits.preconditioner;
    Reference& reference = traits.reference;
    Acceleration& acceleration = traits.acceleration;
    Refactorization_rule& rule = traits.refactorization_rule;
    Map_options& options = traits.options;
    Start_options& start = traits.start;
    // Not a conversion: linear solvers need not be copyable.
    static_assert(std::is_same<decltype(const_traits.make_linear_solver()), Linear_solver>::value,
                  "make_linear_solver() must return a Linear_solver by value");
    boost::ignore_unused_variable_warning(energy);
    boost::ignore_unused_variable_warning(preconditioner);
    boost::ignore_unused_variable_warning(reference);
    boost::ignore_unused_variable_warning(acceleration);
    boost::ignore_unused_variable_warning(rule);
    boost::ignore_unused_variable_warning(options);
    boost::ignore_unused_variable_warning(start);
  }
  static void kernel_requirements()
  {
    bool is_positive;
    if constexpr(D == 2) {
      const typename Kernel::Point_2 p(0., 0.), q(1., 0.), r(0., 1.);
      is_positive = typename Kernel::Orientation_2()(p, q, r) == CGAL::POSITIVE;
    } else {
      const typename Kernel::Point_3 p(0., 0., 0.), q(1., 0., 0.), r(0., 1., 0.), s(0., 0., 1.);
      is_positive = typename Kernel::Orientation_3()(p, q, r, s) == CGAL::POSITIVE;
    }
    boost::ignore_unused_variable_warning(is_positive);
  }
  /// \endcond
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_METHOD_CONCEPTS_H
