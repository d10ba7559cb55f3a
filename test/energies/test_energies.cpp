// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Every energy in the plane and in space: its derivatives against finite differences, and the properties that its
// documentation promises.

#include "support/unit_test.h"

#include "support/all_energies.h"
#include "support/dense_algebra.h"
#include "support/full_matrix.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/check_derivatives.h>
#include <CGAL/Flip_free_maps/energies/internal/energy_traits.h>
#include <CGAL/Flip_free_maps/method/concepts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_energies)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

typedef FFM::Weighted_sum<FFM::Arap, FFM::Hencky> Convex_sum;

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

// What the documentation says. Logarithms of the singular values of samples are within +-range.
struct Facts
{
  std::string name;
  double plane, space; // values at the identity
  double range = 3;
  bool only_similarities = false; // minimal at them
};

// One instantiation serves all energies with a barrier.
struct Case
{
  FFM::Any_energy energy;
  Facts facts;
};

std::vector<Case> cases()
{
  const double e = std::exp(1.);
  return {
    {FFM::Any_energy(FFM::Symmetric_dirichlet()), {"symmetric_dirichlet", 1, 1}},
    {FFM::Any_energy(FFM::Exponential_symmetric_dirichlet()), {"exponential_symmetric_dirichlet", e, e, 2}},
    {FFM::Any_energy(FFM::Symmetric_gradient()), {"symmetric_gradient", 1, 1.5}},
    {FFM::Any_energy(FFM::Symmetric_arap()), {"symmetric_arap", 0, 0}},
    {FFM::Any_energy(FFM::Hencky()), {"hencky", 0, 0}},
    {FFM::Any_energy(FFM::Conformal()), {"conformal", 2, 1, 3, true}},
    {FFM::Any_energy(FFM::Amips()), {"amips", 2, 2}},
    {FFM::Any_energy(FFM::Exponential_amips()), {"exponential_amips", e * e, e * e, 1.5}},
    {FFM::Any_energy(FFM::Neo_hookean()), {"neo_hookean", 0, 0}},
    // Far from 1 it is nearly linear, and differences of gradients vanish in rounding.
    {FFM::Any_energy(FFM::Aigerman_isometric()), {"aigerman_isometric", 1, 1, 1}},
    {FFM::Any_energy(Conformal_with_size()), {"weighted_sum", 3, 2.5}},
    {FFM::Any_energy(Convex_sum()), {"weighted_sum", 0, 0}},
  };
}

// Singular values, descending.
template <int D>
Vector<D> random_singular_values(Random& random, double range)
{
  Vector<D> s;
  for(int i = 0; i < D; ++i)
    s[i] = std::exp(random(-range, range));
  std::sort(s.data(), s.data() + D, [](double a, double b) { return a > b; });
  return s;
}

template <int D, typename Energy>
void check_finite_differences(const Energy& energy, const Facts& facts)
{
  Random random(1);
  for(int k = 0; k < 200; ++k) {
    const Vector<D> s = random_singular_values<D>(random, facts.range);
    // Differences must not reach across the kinks of the symmetric ARAP energy.
    if((s.template tail<D - 1>().array() > 0.999 * s.template head<D - 1>().array()).any())
      continue;
    const FFM::Derivative_report report = FFM::check_derivatives<D>(energy, s);
    BOOST_TEST(report.gradient_error <= 1e-6);
    BOOST_TEST(report.hessian_error <= 1e-6);
    Vector<D> gradient;
    Matrix<D> hessian;
    energy.template derivatives<D>(s, gradient, hessian);
    BOOST_TEST((hessian - hessian.transpose()).norm() == 0);
  }
}

// The rows of a matrix in the order that `s` has after a permutation must not matter.
template <int D, typename Energy>
void check_symmetry(const Energy& energy, const Facts& facts)
{
  Random random(2);
  for(int k = 0; k < 50; ++k) {
    const Vector<D> s = random_singular_values<D>(random, facts.range);
    const double value = energy.template value<D>(s);
    Vector<D> gradient;
    Matrix<D> hessian;
    energy.template derivatives<D>(s, gradient, hessian);
    // Large exponents enlarge rounding.
    const double tolerance = 1e-13 * (1 + std::abs(std::log(std::abs(value) + 1e-300)));
    Eigen::PermutationMatrix<D> permutation;
    permutation.setIdentity();
    while(std::next_permutation(permutation.indices().data(), permutation.indices().data() + D)) {
      const Vector<D> t = permutation * s;
      Vector<D> permuted_gradient;
      Matrix<D> permuted_hessian;
      energy.template derivatives<D>(t, permuted_gradient, permuted_hessian);
      BOOST_TEST(std::abs(energy.template value<D>(t) - value) <= tolerance * std::abs(value));
      BOOST_TEST((permuted_gradient - permutation * gradient).norm() <= tolerance * gradient.norm());
      BOOST_TEST((permuted_hessian - permutation * hessian * permutation.transpose()).norm() <= tolerance * hessian.norm());
    }
  }
}

template <int D, typename Energy>
void check_isometry(const Energy& energy, const Facts& facts)
{
  const Vector<D> one = Vector<D>::Ones();
  Vector<D> gradient;
  Matrix<D> hessian;
  energy.template derivatives<D>(one, gradient, hessian);
  const double minimum = D == 2 ? facts.plane : facts.space;
  BOOST_TEST(std::abs(energy.template value<D>(one) - minimum) <= 1e-15 * (1 + minimum));
  BOOST_TEST(gradient.norm() <= 1e-15);
  BOOST_TEST(relative_smallest_eigenvalue(hessian) >= -1e-15);
  BOOST_TEST(FFM::internal::curvature_at_identity<D>(energy) > 0);

  Random random(3);
  for(int k = 0; k < 200; ++k) {
    BOOST_TEST(energy.template value<D>(random_singular_values<D>(random, facts.range)) > minimum);
    const Vector<D> similarity = Vector<D>::Constant(std::exp(random(-3, 3)));
    const double value = energy.template value<D>(similarity);
    if(facts.only_similarities)
      BOOST_TEST(std::abs(value - minimum) <= 1e-14);
    else
      BOOST_TEST(value > minimum);
  }
}

// With one singular value going to zero, the others fixed.
template <int D, typename Energy>
void check_barrier(const Energy& energy)
{
  double last = 0;
  for(double s = 0.1; s > 1e-300; s *= 0.1) {
    Vector<D> values = Vector<D>::Ones();
    values[D - 1] = s;
    const double value = energy.template value<D>(values);
    BOOST_TEST((value > last || value == std::numeric_limits<double>::infinity()));
    last = value;
  }
  // The slowest is the logarithm.
  BOOST_TEST(last > 600);
}

// Not even where numbers overflow.
template <int D, typename Energy>
void check_no_nan(const Energy& energy)
{
  Random random(6);
  for(int k = 0; k < 1000; ++k) {
    const Vector<D> s = random_singular_values<D>(random, 30);
    Vector<D> gradient;
    Matrix<D> hessian;
    energy.template derivatives<D>(s, gradient, hessian);
    BOOST_TEST(!std::isnan(energy.template value<D>(s)));
    BOOST_TEST(!gradient.hasNaN());
    BOOST_TEST(!hessian.hasNaN());
    BOOST_TEST(!std::isnan(energy.template value<D>(random_singular_values<D>(random, 700))));
  }
}

// The Hessian is the difference of two positive semidefinite matrices, the convex part and minus the concave one.
template <int D, typename Energy>
void check_convex_part(double range)
{
  BOOST_CONCEPT_ASSERT((FFM::ConvexConcaveEnergyConcept<Energy, D>));
  const Energy energy;
  Random random(4);
  double smallest = 0, smallest_concave = 0;
  for(int k = 0; k < 200; ++k) {
    const Vector<D> s = random_singular_values<D>(random, range);
    Vector<D> gradient;
    Matrix<D> hessian, convex;
    energy.template derivatives<D>(s, gradient, hessian);
    energy.template convex_hessian<D>(s, hessian, convex);
    smallest = std::min(smallest, relative_smallest_eigenvalue(convex));
    smallest_concave = std::min(smallest_concave, smallest_eigenvalue(convex - hessian) / hessian.norm());
  }
  BOOST_TEST(smallest >= -1e-14);
  BOOST_TEST(smallest_concave >= -1e-14);
}

template <typename Energy>
void check_convex_parts(double range = 3)
{
  check_convex_part<2, Energy>(range);
  check_convex_part<3, Energy>(range);
}

// Where psi_i vanishes: positive beyond, negative before.
template <int D, typename Energy>
void check_slim_target(const Energy& energy, const Facts& facts)
{
  Random random(5);
  for(int k = 0; k < 200; ++k) {
    const Vector<D> s = random_singular_values<D>(random, facts.range);
    const Vector<D> target = FFM::internal::slim_target<D>(energy, s);
    Vector<D> gradient;
    Matrix<D> hessian;
    energy.template derivatives<D>(s, gradient, hessian);
    for(int i = 0; i < D; ++i) {
      BOOST_TEST(target[i] > 0);
      BOOST_TEST(gradient[i] * (s[i] - target[i]) >= 0);
    }
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(derivatives)
{
  for(const Case& c : cases()) {
    BOOST_TEST_CONTEXT(c.facts.name)
    {
      BOOST_TEST(c.energy.energy_name() == c.facts.name);
      check_finite_differences<2>(c.energy, c.facts);
      check_finite_differences<3>(c.energy, c.facts);
    }
  }
  check_finite_differences<2>(FFM::Arap(), Facts{"arap", 0, 0});
  check_finite_differences<3>(FFM::Arap(), Facts{"arap", 0, 0});
}

BOOST_AUTO_TEST_CASE(symmetric_in_the_singular_values)
{
  for(const Case& c : cases()) {
    BOOST_TEST_CONTEXT(c.facts.name)
    {
      check_symmetry<2>(c.energy, c.facts);
      check_symmetry<3>(c.energy, c.facts);
    }
  }
}

BOOST_AUTO_TEST_CASE(isometry_is_the_minimum)
{
  for(const Case& c : cases()) {
    BOOST_TEST_CONTEXT(c.facts.name)
    {
      check_isometry<2>(c.energy, c.facts);
      check_isometry<3>(c.energy, c.facts);
    }
  }
  check_isometry<2>(FFM::Arap(), Facts{"arap", 0, 0});
  check_isometry<3>(FFM::Arap(), Facts{"arap", 0, 0});
}

BOOST_AUTO_TEST_CASE(barrier)
{
  for(const Case& c : cases()) {
    BOOST_TEST_CONTEXT(c.facts.name)
    {
      check_barrier<2>(c.energy);
      check_barrier<3>(c.energy);
    }
  }
  BOOST_TEST(!FFM::Arap::has_barrier);
  BOOST_TEST(Convex_sum::has_barrier);
}

BOOST_AUTO_TEST_CASE(no_nan)
{
  for(const Case& c : cases()) {
    BOOST_TEST_CONTEXT(c.facts.name)
    {
      check_no_nan<2>(c.energy);
      check_no_nan<3>(c.energy);
    }
  }
}

BOOST_AUTO_TEST_CASE(slim_target)
{
  for(const Case& c : cases()) {
    BOOST_TEST_CONTEXT(c.facts.name)
    {
      check_slim_target<2>(c.energy, c.facts);
      check_slim_target<3>(c.energy, c.facts);
    }
  }
}

BOOST_AUTO_TEST_CASE(convex_part)
{
  check_convex_parts<FFM::Symmetric_dirichlet>();
  check_convex_parts<FFM::Exponential_symmetric_dirichlet>(2);
  check_convex_parts<FFM::Symmetric_gradient>();
  check_convex_parts<FFM::Symmetric_arap>();
  check_convex_parts<FFM::Arap>();
  check_convex_parts<FFM::Hencky>();
  check_convex_parts<FFM::Aigerman_isometric>();
  check_convex_parts<Convex_sum>();
  BOOST_TEST(!(FFM::internal::Has_convex_hessian<FFM::Conformal, 2>::value));
  BOOST_TEST(!(FFM::internal::Has_convex_hessian<FFM::Amips, 2>::value));
  BOOST_TEST(!(FFM::internal::Has_convex_hessian<FFM::Exponential_amips, 2>::value));
  BOOST_TEST(!(FFM::internal::Has_convex_hessian<FFM::Neo_hookean, 2>::value));
  BOOST_TEST(!(FFM::internal::Has_convex_hessian<Conformal_with_size, 2>::value));
}

BOOST_AUTO_TEST_SUITE_END() // test_energies
