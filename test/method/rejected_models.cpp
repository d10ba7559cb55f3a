// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Types that lack one requirement of a concept each. With REJECTED_MODEL from 1 to 15 this file must not compile; with 0 it must.

#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/method/concepts.h>

namespace FFM = CGAL::Flip_free_maps;

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;
template <int D>
using Matrix = Eigen::Matrix<double, D, D>;
using Traits = FFM::Flip_free_map_traits<>;

#if REJECTED_MODEL == 0
BOOST_CONCEPT_ASSERT((FFM::MapTraitsConcept<Traits, 2>));
BOOST_CONCEPT_ASSERT((FFM::MapTraitsConcept<Traits, 3>));

#elif REJECTED_MODEL == 1 // the energy has no name
struct Energy
{
  static constexpr bool has_barrier = true;
  template <int D>
  double value(const Vector<D>&) const
  {
    return 0;
  }
  template <int D>
  void derivatives(const Vector<D>&, Vector<D>&, Matrix<D>&) const
  {}
};
BOOST_CONCEPT_ASSERT((FFM::DistortionEnergyConcept<Energy, 2>));

#elif REJECTED_MODEL == 2 // evaluating the energy may change it
struct Energy
{
  static constexpr bool has_barrier = true;
  static const char* name() { return "rejected"; }
  template <int D>
  double value(const Vector<D>&)
  {
    return 0;
  }
  template <int D>
  void derivatives(const Vector<D>&, Vector<D>&, Matrix<D>&) const
  {}
};
BOOST_CONCEPT_ASSERT((FFM::DistortionEnergyConcept<Energy, 3>));

#elif REJECTED_MODEL == 3 // an energy without a convex part
struct Energy
{
  static constexpr bool has_barrier = true;
  static const char* name() { return "rejected"; }
  template <int D>
  double value(const Vector<D>&) const
  {
    return 0;
  }
  template <int D>
  void derivatives(const Vector<D>&, Vector<D>&, Matrix<D>&) const
  {}
};
BOOST_CONCEPT_ASSERT((FFM::DistortionEnergyConcept<Energy, 2>));
BOOST_CONCEPT_ASSERT((FFM::ConvexConcaveEnergyConcept<Energy, 2>));

#elif REJECTED_MODEL == 4 // the category of the preconditioner is none
struct Preconditioner
{
  using Category = int;
  static constexpr bool is_second_order = true;
  static const char* name() { return "rejected"; }
  template <int D, typename Energy>
  void form(const FFM::Element_state<D>&, const Energy&, FFM::Increment_form<D>&) const
  {}
};
BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<Preconditioner, Traits::Energy, 2>));

#elif REJECTED_MODEL == 5 // the preconditioner writes no form
struct Preconditioner
{
  using Category = FFM::Constant_matrix_tag;
  static constexpr bool is_second_order = true;
  static const char* name() { return "rejected"; }
};
BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<Preconditioner, Traits::Energy, 2>));

#elif REJECTED_MODEL == 6 // the reference does not say whether it is the rest shape
struct Reference : FFM::Fixed_reference
{
  template <int D>
  void update(const FFM::Simplicial_domain<D>&, const FFM::Positions<D>&)
  {}
};
BOOST_CONCEPT_ASSERT((FFM::ReferenceConcept<Reference, 2>));

#elif REJECTED_MODEL == 7 // the acceleration cannot forget
struct Acceleration
{
  static const char* name() { return "rejected"; }
  template <typename Solve>
  bool direction(const Eigen::VectorXd&, const Eigen::VectorXd&, Solve&&, Eigen::VectorXd&)
  {
    return false;
  }
};
BOOST_CONCEPT_ASSERT((FFM::AccelerationConcept<Acceleration>));

#elif REJECTED_MODEL == 8 // the rule knows yes and no only
struct Rule
{
  bool operator()(int, double, double) const { return true; }
};
BOOST_CONCEPT_ASSERT((FFM::RefactorizationRuleConcept<Rule>));

#elif REJECTED_MODEL == 9 // the solver does not report failures
struct Solver : FFM::Eigen_simplicial_solver
{
  void factorize(const FFM::Block_sparse_matrix&) {}
};
BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<Solver>));

#elif REJECTED_MODEL == 10 // the initializer has no place for a message
struct Initializer
{
  template <typename Make>
  FFM::Status operator()(const FFM::Simplicial_domain<2>&, Make&&, FFM::Positions<2>&, std::string&) const
  {
    return FFM::Status::success;
  }
};
BOOST_CONCEPT_ASSERT((FFM::InitializerConcept<Initializer, FFM::Eigen_simplicial_solver (*)()>));

#elif REJECTED_MODEL == 11 // the traits have no energy object
struct No_energy : Traits
{
private:
  using Traits::energy;
};
BOOST_CONCEPT_ASSERT((FFM::MapTraitsConcept<No_energy, 2>));

#elif REJECTED_MODEL == 12 // one part of the traits is no model of its concept
struct Rule
{
  bool operator()(int, double) const { return true; }
};
using Bad_part = FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, Rule>;
BOOST_CONCEPT_ASSERT((FFM::MapTraitsConcept<Bad_part, 2>));

#elif REJECTED_MODEL == 13 // the traits do not say what runs them
struct No_minimizer : Traits
{
private:
  using Traits::Minimizer;
};
BOOST_CONCEPT_ASSERT((FFM::MapTraitsConcept<No_minimizer, 2>));

#elif REJECTED_MODEL == 14 // the solver would never be told the positions
struct Solver : FFM::Eigen_simplicial_solver
{
  static constexpr bool takes_positions = true;
  void set_position(const Eigen::VectorXd&) {}
};
BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<Solver>));

#elif REJECTED_MODEL == 15 // nor would this one
struct Solver : FFM::Eigen_simplicial_solver
{
  static constexpr bool takes_position = true;
  void set_positions(const Eigen::VectorXd&) {}
};
BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<Solver>));

#else
#error "there is no such model"
#endif

int main() { return 0; }
