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
#include <CGAL/Flip_free_maps/worlds/internal/world_traits.h>

#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <boost/concept_check.hpp>

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// Compile-time checks of the concepts of the package, to be used like those of Boost:
/// `BOOST_CONCEPT_ASSERT((CGAL::Flip_free_maps::DistortionEnergyConcept<My_energy, 2>));`. A member that is missing, or cannot be
/// called as it must be, is named by concept in the first error. Nothing of a model is compiled for it.
/// The dimension of a map is not a type, which is why the classes are written out instead of made by the macro `BOOST_concept`.

namespace CGAL {
namespace Flip_free_maps {

namespace internal {

// Whether a generic lambda takes such arguments and gives what converts to R: the expression that is asked for is the lambda's
// return type, so that it is looked up and nothing else.
template <typename R, typename... Args, typename Lambda>
constexpr bool gives(const Lambda&)
{
  return std::is_invocable_r<R, const Lambda&, Args...>::value;
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `Energy` is a model of `DistortionEnergy` for maps of dimension `D`.
template <typename Energy, int D>
struct DistortionEnergyConcept : boost::CopyConstructible<Energy>
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(DistortionEnergyConcept)
  {
    using internal::gives;
    using Vector = Eigen::Matrix<double, D, 1>;
    using Matrix = Eigen::Matrix<double, D, D>;
    static_assert(gives<std::string, const Energy&>([](auto& e) -> decltype(std::decay_t<decltype(e)>::name()) {}),
                  "DistortionEnergy: a static function name() must return the name of the energy");
    static_assert(gives<bool, const Energy&>([](auto& e) -> std::bool_constant<std::decay_t<decltype(e)>::has_barrier> {}),
                  "DistortionEnergy: has_barrier must be a bool that is known at compile time");
    static_assert(gives<double, const Energy&, const Vector&>([](auto& e, auto& s) -> decltype(e.template value<D>(s)) {}),
                  "DistortionEnergy: value<D>(s) const must return the energy at the singular values s");
    static_assert(gives<void, const Energy&, const Vector&, Vector&, Matrix&>(
                    [](auto& e, auto& s, auto& g, auto& h) -> decltype(e.template derivatives<D>(s, g, h)) {}),
                  "DistortionEnergy: derivatives<D>(s, gradient, hessian) const must write the derivatives at s");
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
    using Matrix = Eigen::Matrix<double, D, D>;
    static_assert(internal::gives<void, const Energy&, const Eigen::Matrix<double, D, 1>&, const Matrix&, Matrix&>(
                    [](auto& e, auto& s, auto& h, auto& convex) -> decltype(e.template convex_hessian<D>(s, h, convex)) {}),
                  "ConvexConcaveEnergy: convex_hessian<D>(s, hessian, convex) const must write the Hessian of the convex part");
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
    using internal::gives;
    static_assert(gives<std::string, const P&>([](auto& p) -> decltype(std::decay_t<decltype(p)>::name()) {}),
                  "Preconditioner: a static function name() must return the name of the preconditioner");
    static_assert(gives<Constant_matrix_tag, const P&>([](auto& p) -> typename std::decay_t<decltype(p)>::Category {}) ||
                    gives<Varying_matrix_tag, const P&>([](auto& p) -> typename std::decay_t<decltype(p)>::Category {}),
                  "Preconditioner: Category must be Constant_matrix_tag or Varying_matrix_tag");
    static_assert(gives<const bool&, const P&>([](auto& p) -> decltype((p.is_second_order)) {}),
                  "Preconditioner: is_second_order must be a bool");
    static_assert(gives<void, const P&, const Element_state<D>&, const Energy&, Increment_form<D>&>(
                    [](auto& p, auto& state, auto& energy, auto& form) -> decltype(p.form(state, energy, form)) {}),
                  "Preconditioner: form(state, energy, form) const must write the form of an element, for this energy and dimension");
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
    using internal::gives;
    using Domain = Simplicial_domain<D>;
    static_assert(gives<std::string, const R&>([](auto& r) -> decltype(std::decay_t<decltype(r)>::name()) {}),
                  "Reference: a static function name() must return the name of the reference");
    static_assert(gives<void, R&>([](auto& r) -> decltype(r.restart()) {}), "Reference: restart() is missing");
    static_assert(
      gives<bool, R&, const Domain&, const Positions<D>&>([](auto& r, auto& domain, auto& x) -> decltype(r.update(domain, x)) {}),
      "Reference: update(domain, x) must return whether the reference is the rest shape");
    static_assert(gives<double, const R&>([](auto& r) -> decltype(r.relative_decrease()) {}),
                  "Reference: relative_decrease() const must return a number");
    static_assert(gives<Eigen::Matrix<double, D, D>, const R&, const Domain&>(
                    [](auto& r, auto& domain) -> decltype(r.rest_inverse(domain, std::int64_t())) {}),
                  "Reference: rest_inverse(domain, e) const must return the inverse of the reference's edge matrix");
    static_assert(gives<double, const R&, const Domain&>([](auto& r, auto& domain) -> decltype(r.weight(domain, std::int64_t())) {}),
                  "Reference: weight(domain, e) const must return the weight of an element");
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
    using internal::gives;
    using Vector = Eigen::VectorXd;
    static_assert(gives<std::string, const A&>([](auto& a) -> decltype(std::decay_t<decltype(a)>::name()) {}),
                  "Acceleration: a static function name() must return the name of the acceleration");
    static_assert(gives<void, A&>([](auto& a) -> decltype(a.reset()) {}), "Acceleration: reset() is missing");
    static_assert(gives<bool, A&, const Vector&, const Solve&, Vector&>(
                    [](auto& a, auto& x, auto& solve, auto& direction) -> decltype(a.direction(x, x, solve, direction)) {}),
                  "Acceleration: direction(x, gradient, solve, direction) must return whether the linear solver succeeded");
  }

private:
  struct Solve
  {
    bool operator()(const Eigen::VectorXd&, Eigen::VectorXd&) const { return false; }
    void multiply(const Eigen::VectorXd&, Eigen::VectorXd&) const {}
    double dot(const Eigen::VectorXd&, const Eigen::VectorXd&) const { return 0; }
    double norm(const Eigen::VectorXd&) const { return 0; }
  };
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
    static_assert(std::is_invocable_r<Refactorization, Rule&, int, double, double>::value,
                  "RefactorizationRule: a call with age, last step and relative decrease must return a Refactorization");
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
    using internal::gives;
    static_assert(gives<std::string, const Solver&>([](auto& s) -> decltype(s.name()) {}),
                  "SymmetricSparseSolver: name() const must return the name of the solver");
    static_assert(gives<std::string, const Solver&>([](auto& s) -> decltype(s.ordering()) {}),
                  "SymmetricSparseSolver: ordering() const must return the name of the ordering");
    static_assert(gives<bool, Solver&, const Block_sparse_matrix&>([](auto& s, auto& m) -> decltype(s.analyze_pattern(m)) {}),
                  "SymmetricSparseSolver: analyze_pattern(matrix) must return whether it succeeded");
    static_assert(gives<bool, Solver&, const Block_sparse_matrix&>([](auto& s, auto& m) -> decltype(s.factorize(m)) {}),
                  "SymmetricSparseSolver: factorize(matrix) must return whether it succeeded");
    static_assert(
      gives<bool, Solver&, const Eigen::VectorXd&, Eigen::VectorXd&>([](auto& s, auto& b, auto& x) -> decltype(s.solve(b, x)) {}),
      "SymmetricSparseSolver: solve(b, x) must return whether it succeeded");
    static_assert(gives<std::int64_t, const Solver&>([](auto& s) -> decltype(s.factor_entries()) {}),
                  "SymmetricSparseSolver: factor_entries() const must return the number of entries of the factor");
    // One without the other is a slip of the pen, which would leave the member uncalled.
    static_assert(gives<bool, const Solver&>([](auto& s) -> std::bool_constant<std::decay_t<decltype(s)>::takes_positions> {}) ==
                    gives<void, Solver&, const Eigen::VectorXd&>([](auto& s, auto& x) -> decltype(s.set_positions(x)) {}),
                  "SymmetricSparseSolver: takes_positions and set_positions(positions) are there both, or neither");
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
    static_assert(std::is_invocable_r<Status, const I&, const Simplicial_domain<2>&, MakeLinearSolver&, Positions<2>&, std::string&,
                                      std::string&>::value,
                  "Initializer: a const call with domain, make_linear_solver, x, name and message must return a Status");
  }
  /// \endcond
};

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `W` is a model of `World`.
template <typename W>
struct WorldConcept : boost::CopyConstructible<W>
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(WorldConcept)
  {
    using internal::gives;
    using Vector = Eigen::VectorXd;
    static_assert(gives<bool, const W&>([](auto& w) -> std::bool_constant<std::decay_t<decltype(w)>::is_sequential> {}),
                  "World: is_sequential must be a constant");
    static_assert(gives<std::int64_t, const W&>([](auto& w) -> decltype(w.counted_elements(std::int64_t())) {}),
                  "World: counted_elements(elements) const must return a number");
    static_assert(gives<std::int32_t, const W&>([](auto& w) -> decltype(w.owned_vertices(std::int32_t())) {}),
                  "World: owned_vertices(vertices) const must return a number");
    static_assert(gives<double, const W&>([](auto& w) -> decltype(w.sum(0.) + w.minimum(0.)) {}),
                  "World: sum(x) const and minimum(x) const must return a number");
    static_assert(gives<int, const W&>([](auto& w) -> decltype(w.maximum(0)) {}), "World: maximum(x) const must return a number");
    static_assert(gives<bool, const W&>([](auto& w) -> decltype(w.any(false)) {}), "World: any(x) const must return whether one has it");
    static_assert(gives<double, const W&, const Vector&>([](auto& w, auto& a) -> decltype(w.dot(a, a) + w.norm(a)) {}),
                  "World: dot(a, b) const and norm(a) const must return a number");
    static_assert(gives<void, W&, const std::vector<std::int32_t>&>([](auto& w, auto& n) -> decltype(w.number_unknowns(n)) {}),
                  "World: number_unknowns(numbers) is missing");
    static_assert(gives<bool, const W&>([](auto& w) -> decltype(w.owns_first_unknown()) {}),
                  "World: owns_first_unknown() const must return whether it does");
    static_assert(gives<const Vector&, const W&, const Vector&>([](auto& w, auto& a) -> decltype(w.with_ghosts(a)) {}),
                  "World: with_ghosts(owned) const must return a vector");
    static_assert(gives<void, const W&, Vector&>([](auto& w, auto& a) -> decltype(w.keep_owned(a)) {}),
                  "World: keep_owned(vector) const is missing");
    static_assert(gives<void, const W&, void (*const&)()>([](auto& w, auto& f) -> decltype(w.together(f)) {}),
                  "World: together(f) const is missing");
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
  BOOST_CONCEPT_ASSERT((WorldConcept<typename internal::World_of<Traits>::type>));

  // Only the name: the class may be incomplete here, and checks the traits itself.
  using Minimizer = typename Traits::template Minimizer<D, Traits>;

  BOOST_CONCEPT_USAGE(MapTraitsConcept)
  {
    using internal::gives;
    static_assert(std::is_class<Minimizer>::value, "MapTraits: Minimizer must be a class");
    static_assert(std::is_convertible<Concurrency_tag, CGAL::Sequential_tag>::value ||
                    std::is_convertible<Concurrency_tag, CGAL::Parallel_tag>::value,
                  "MapTraits: Concurrency_tag must be one of CGAL's concurrency tags");
    static_assert(gives<Energy&, Traits&>([](auto& t) -> decltype((t.energy)) {}), "MapTraits: energy must be an Energy");
    static_assert(gives<Preconditioner&, Traits&>([](auto& t) -> decltype((t.preconditioner)) {}),
                  "MapTraits: preconditioner must be a Preconditioner");
    static_assert(gives<Reference&, Traits&>([](auto& t) -> decltype((t.reference)) {}), "MapTraits: reference must be a Reference");
    static_assert(gives<Acceleration&, Traits&>([](auto& t) -> decltype((t.acceleration)) {}),
                  "MapTraits: acceleration must be an Acceleration");
    static_assert(gives<Refactorization_rule&, Traits&>([](auto& t) -> decltype((t.refactorization_rule)) {}),
                  "MapTraits: refactorization_rule must be a Refactorization_rule");
    static_assert(gives<Map_options&, Traits&>([](auto& t) -> decltype((t.options)) {}), "MapTraits: options must be Map_options");
    static_assert(gives<Start_options&, Traits&>([](auto& t) -> decltype((t.start)) {}), "MapTraits: start must be Start_options");
    // By reference it could be copied, and linear solvers need not be copyable.
    static_assert(std::is_same<decltype(std::declval<const Traits&>().make_linear_solver()), Linear_solver>::value,
                  "MapTraits: make_linear_solver() const must return a Linear_solver by value");
    static_assert(has_orientation(), "MapTraits: Kernel must have the points of dimension D and their predicate Orientation_D");
  }

private:
  static constexpr bool has_orientation()
  {
    if constexpr(D == 2)
      return internal::gives<bool, const Kernel&>([](auto& k) -> decltype(orientation_2<std::decay_t<decltype(k)>>()) {});
    else
      return internal::gives<bool, const Kernel&>([](auto& k) -> decltype(orientation_3<std::decay_t<decltype(k)>>()) {});
  }

  // Declared only.
  template <typename K, typename P = typename K::Point_2, typename = decltype(P(0., 0.))>
  static auto orientation_2()
    -> decltype(typename K::Orientation_2()(std::declval<P>(), std::declval<P>(), std::declval<P>()) == CGAL::POSITIVE);
  template <typename K, typename P = typename K::Point_3, typename = decltype(P(0., 0., 0.))>
  static auto orientation_3()
    -> decltype(typename K::Orientation_3()(std::declval<P>(), std::declval<P>(), std::declval<P>(), std::declval<P>()) == CGAL::POSITIVE);
  /// \endcond
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_METHOD_CONCEPTS_H
