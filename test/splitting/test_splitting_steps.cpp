// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Each local step of the splitting against minimisation by search, and the books of dual variables and penalties.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/energies/Any_energy.h>
#include <CGAL/Flip_free_maps/energies/Arap.h>
#include <CGAL/Flip_free_maps/energies/Hencky.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/splitting/Admm_splitting_step.h>

#include <boost/concept_check.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

BOOST_AUTO_TEST_SUITE(test_splitting_steps)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;
template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

// An energy with a proximal map of its own: the least c (p - 1)^2 + 1/2 (p - q)^2 among positive p.
int own_proximal_maps = 0;

struct Arap_with_proximal_map : FFM::Arap
{
  template <int D>
  Vector<D> proximal(const Vector<D>& q, double c) const
  {
    ++own_proximal_maps;
    return ((q.array() + 2 * c) / (1 + 2 * c)).cwiseMax(1e-12);
  }
};

// Another function under the name that it inherits.
struct Stiffer_gradient : FFM::Symmetric_gradient
{
  template <int D>
  double value(const Vector<D>& s) const
  {
    return FFM::Symmetric_gradient::value<D>(s) + (s.array() - 1).square().sum();
  }
  template <int D>
  void derivatives(const Vector<D>& s, Vector<D>& gradient, Matrix<D>& hessian) const
  {
    FFM::Symmetric_gradient::derivatives<D>(s, gradient, hessian);
    gradient.array() += 2 * (s.array() - 1);
    hessian.diagonal().array() += 2;
  }
};

// The least value of a function of one variable between two bounds, by golden sections.
template <typename F>
double search(F&& f, double low, double high)
{
  const double golden = 0.6180339887498949;
  for(int i = 0; i < 200; ++i) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
  }
  return 0.5 * (low + high);
}

template <int D>
Matrix<D> random_symmetric(Random& random, double low, double high)
{
  const Matrix<D> rotation = random.rotation<D>();
  Vector<D> values;
  for(int i = 0; i < D; ++i)
    values[i] = random(low, high);
  return rotation * values.asDiagonal() * rotation.transpose();
}

template <int D>
FFM::Split_element<D> random_element(Random& random)
{
  FFM::Split_element<D> element;
  element.jacobian = random.matrix<D>(-2, 2);
  element.rotation = random.rotation<D>();
  element.stretch = random_symmetric<D>(random, 0.1, 3);
  element.dual = random.matrix<D>(-0.5, 0.5);
  element.penalty = random(0.01, 1);
  element.inertia = random(0, 1);
  return element;
}

// The terms of the augmented Lagrangian that belong to one element.
template <int D, typename Energy>
double lagrangian(const Energy& energy, double measure, const FFM::Split_element<D>& element)
{
  const Vector<D> s = eigenvalues(element.stretch).reverse();
  const Matrix<D> residual = element.jacobian - element.rotation * element.stretch;
  return measure * energy.template value<D>(s) +
         0.5 * element.penalty * ((residual + element.dual).squaredNorm() - element.dual.squaredNorm());
}

template <int D>
void check_rotations()
{
  Random random(1);
  for(int i = 0; i < 2000; ++i) {
    Matrix<D> M = random.matrix<D>();
    if(i % 5 == 0)
      M.col(0) *= 1e-4;
    if(i % 7 == 0)
      M = random.rotation<D>() * random_symmetric<D>(random, 0.5, 1.5); // the easy case
    Matrix<D> R = random.rotation<D>();
    FFM::internal::closest_rotation(M, R);
    BOOST_TEST((R.transpose() * R - Matrix<D>::Identity()).norm() < 1e-13);
    BOOST_TEST(R.determinant() > 0);
    // The maximum is the sum of the signed singular values.
    FFM::internal::Signed_svd<D> svd;
    FFM::internal::signed_svd(M, svd);
    BOOST_TEST(R.cwiseProduct(M).sum() >= svd.s.sum() - 1e-13);
    for(int k = 0; k < 20; ++k)
      BOOST_TEST(random.rotation<D>().cwiseProduct(M).sum() <= R.cwiseProduct(M).sum() + 1e-13);
  }
  // Every rotation is as good as another: the guess stays.
  const Matrix<D> guess = random.rotation<D>();
  Matrix<D> R = guess;
  FFM::internal::closest_rotation(Matrix<D>(Matrix<D>::Zero()), R);
  BOOST_TEST((R.transpose() * R - Matrix<D>::Identity()).norm() < 1e-13);
}

// Each component of the proximal map of a separable energy is the minimum of a function of one variable.
template <int D, typename Energy>
void check_proximal_map(const Energy& energy, double most)
{
  Random random(2);
  const FFM::Proximal_map<Energy, D> map(energy);
  for(int i = 0; i < 300; ++i) {
    const double c = std::pow(10, random(-3, 1));
    Vector<D> q;
    for(int k = 0; k < D; ++k)
      q[k] = random(-2, most);
    std::sort(q.data(), q.data() + D, std::greater<double>());
    const Vector<D> p = map.proximal(q, c);
    for(int k = 0; k < D; ++k) {
      const auto objective = [&](double value) {
        const double f = (energy.template value<D>(Vector<D>::Constant(value)) - energy.template value<D>(Vector<D>::Ones())) / D;
        return c * f / map.scale() + 0.5 * (value - q[k]) * (value - q[k]);
      };
      BOOST_TEST(p[k] > 0);
      const double found = search(objective, 1e-9, 10.);
      BOOST_TEST(objective(p[k]) <= objective(found) + 1e-12 * (1 + std::abs(objective(found))));
    }
  }
}

template <int D, typename Energy>
void check_matrix_proximal_map()
{
  Random random(3);
  const FFM::Admm_splitting_step<D, Energy> step;
  const FFM::Proximal_map<Energy, D> map;
  for(int i = 0; i < 500; ++i) {
    const double c = std::pow(10, random(-3, 1)), wide = std::pow(10, random(-6, 3));
    Matrix<D> Q = random_symmetric<D>(random, -wide, wide);
    if(i % 10 == 0)
      Q = Matrix<D>::Identity() * random(-1, 1); // equal eigenvalues
    else if(i % 10 == 1)
      Q = Matrix<D>::Identity() + 1e-9 * Q;
    Matrix<D> P;
    step.proximal(Q, c, P);
    const Eigen_decomposition<D> eigen(Q);
    const Vector<D> p = map.proximal(eigen.values.reverse(), c).reverse();
    const Matrix<D> expected = eigen.vectors * p.asDiagonal() * eigen.vectors.transpose();
    BOOST_TEST((P - expected).norm() <= 1e-12 * (expected.norm() + Q.norm()));
    BOOST_TEST((P - P.transpose()).norm() <= 1e-15 * P.norm());
  }
}

template <int D, typename Energy>
void check_decrease()
{
  Random random(4);
  const Energy energy{};
  const FFM::Admm_splitting_step<D, Energy> step(energy);
  for(int i = 0; i < 300; ++i) {
    FFM::Split_element<D> element = random_element<D>(random);
    const double measure = random(0.01, 0.5);
    const Matrix<D> previous = element.rotation;
    double before = lagrangian(energy, measure, element);
    step.update_rotation(element);
    double after =
      lagrangian(energy, measure, element) + 0.5 * element.penalty * element.inertia * (element.rotation - previous).squaredNorm();
    BOOST_TEST(after <= before + 1e-12 * std::abs(before));

    before = lagrangian(energy, measure, element);
    step.update_stretch(measure, element);
    after = lagrangian(energy, measure, element);
    BOOST_TEST(after <= before + 1e-12 * std::abs(before));
    // No stretch nearby is better.
    for(int k = 0; k < 10; ++k) {
      FFM::Split_element<D> other = element;
      other.stretch += 1e-3 * random_symmetric<D>(random, -0.1, 0.1);
      if(smallest_eigenvalue(other.stretch) > 0)
        BOOST_TEST(lagrangian(energy, measure, other) >= after - 1e-12 * std::abs(after));
    }
  }
}

template <int D, typename Energy>
void check_penalties()
{
  Random random(5);
  const FFM::Admm_splitting_step<D, Energy> step;
  for(int i = 0; i < 200; ++i) {
    FFM::Split_element<D> element = random_element<D>(random);
    const double measure = random(1e-6, 0.5);
    element.penalty = measure * std::pow(10, random(-2, 4));
    const FFM::Split_element<D> before = element;
    const double primal = i % 3 == 0 ? 1 : 0.1, dual = i % 3 == 1 ? 1 : 0.1;
    const bool changed = step.adapt_penalty(measure, primal, dual, i % 2 == 0, element);
    const Vector<D> p = eigenvalues(element.stretch).reverse();
    const double least = step.least_penalty(p, measure);
    const double wanted = before.penalty * (i % 3 == 0 ? 2.5 : i % 3 == 1 ? 0.4 : 1);
    BOOST_TEST(element.penalty == (std::max)(least, wanted), boost::test_tools::tolerance(1e-10));
    BOOST_TEST(changed == (element.penalty != before.penalty));
    // The dual variable itself stays, also where the bound has the last word.
    BOOST_TEST((element.penalty * element.dual - before.penalty * before.dual).norm() <= 1e-14 * (before.penalty * before.dual).norm());
    BOOST_TEST((element.inertia > 0) == (i % 2 == 0));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(closest_rotations)
{
  check_rotations<2>();
  check_rotations<3>();
}

BOOST_AUTO_TEST_CASE(proximal_maps_are_minima)
{
  check_proximal_map<2>(FFM::Symmetric_gradient(), 5);
  check_proximal_map<3>(FFM::Symmetric_gradient(), 5);
  check_proximal_map<2>(FFM::Symmetric_dirichlet(), 5);
  check_proximal_map<3>(FFM::Symmetric_dirichlet(), 5);
  check_proximal_map<2>(FFM::Arap(), 5);
  // (log s)^2 is convex up to e.
  check_proximal_map<3>(FFM::Hencky(), 2.5);
}

BOOST_AUTO_TEST_CASE(closed_forms_are_for_the_energy_itself)
{
  const auto form = [](const auto& energy) { return FFM::Proximal_map<FFM::Any_energy, 2>(FFM::Any_energy(energy)).closed_form(); };
  BOOST_CHECK(form(FFM::Symmetric_gradient()) == FFM::Closed_form::symmetric_gradient);
  BOOST_CHECK(form(FFM::Symmetric_dirichlet()) == FFM::Closed_form::symmetric_dirichlet);
  BOOST_CHECK(form(Stiffer_gradient()) == FFM::Closed_form::none);

  // At the minimum of c psi / scale + |p - q|^2 / 2 the gradient vanishes.
  const FFM::Proximal_map<FFM::Any_energy, 2> map{FFM::Any_energy(Stiffer_gradient())};
  const double c = 0.7;
  const Vector<2> q(2.5, -0.4), p = map.proximal(q, c);
  Vector<2> gradient;
  Matrix<2> hessian;
  Stiffer_gradient().derivatives<2>(p, gradient, hessian);
  BOOST_TEST((c / map.scale() * gradient + p - q).norm() < 1e-7);
}

BOOST_AUTO_TEST_CASE(models_of_the_concepts)
{
  BOOST_CONCEPT_ASSERT((FFM::ProximalEnergyConcept<Arap_with_proximal_map, 2>));
  BOOST_CONCEPT_ASSERT((FFM::ProximalEnergyConcept<Arap_with_proximal_map, 3>));
  BOOST_CONCEPT_ASSERT((FFM::SplittingStepConcept<FFM::Admm_splitting_step<2, FFM::Arap>, FFM::Arap, 2>));
  BOOST_CONCEPT_ASSERT((FFM::SplittingStepConcept<FFM::Admm_splitting_step<3>, FFM::Symmetric_gradient, 3>));
  // The energy's own proximal map is the one that is used.
  check_proximal_map<2>(Arap_with_proximal_map(), 5);
  BOOST_TEST(own_proximal_maps == 300);
}

BOOST_AUTO_TEST_CASE(quartic_roots)
{
  Random random(6);
  for(int i = 0; i < 2000; ++i) {
    const double a = std::pow(10, random(-4, 4)), k = std::pow(10, random(-8, 4)), q = random(-1, 1) * std::pow(10, random(-4, 6));
    const double p = FFM::internal::positive_root(a, q, k);
    BOOST_TEST(p > 0);
    const double terms = a * std::pow(p, 4) + std::abs(q) * std::pow(p, 3) + k;
    BOOST_TEST(std::abs(a * std::pow(p, 4) - q * std::pow(p, 3) - k) <= 1e-13 * terms);
  }
}

BOOST_AUTO_TEST_CASE(proximal_maps_of_matrices)
{
  check_matrix_proximal_map<2, FFM::Symmetric_gradient>();
  check_matrix_proximal_map<3, FFM::Symmetric_gradient>();
  check_matrix_proximal_map<2, FFM::Symmetric_dirichlet>();
  check_matrix_proximal_map<3, FFM::Symmetric_dirichlet>();
}

BOOST_AUTO_TEST_CASE(steps_decrease_the_lagrangian)
{
  check_decrease<2, FFM::Symmetric_gradient>();
  check_decrease<3, FFM::Symmetric_gradient>();
  check_decrease<2, FFM::Symmetric_dirichlet>();
  check_decrease<3, FFM::Symmetric_dirichlet>();
}

BOOST_AUTO_TEST_CASE(penalties_and_dual_variables)
{
  check_penalties<2, FFM::Symmetric_gradient>();
  check_penalties<3, FFM::Symmetric_dirichlet>();
}

BOOST_AUTO_TEST_CASE(least_penalty_at_the_identity)
{
  // b^2 = 5 there; symmetric gradient: x^2 + b x = 1, F = 1 + sqrt(2) / x^2.
  const double x = 0.5 * (3 - std::sqrt(5.)), F = 1 + std::sqrt(2.) / (x * x);
  const FFM::Admm_splitting_step<2, FFM::Symmetric_gradient> step;
  BOOST_TEST(step.least_penalty(Vector<2>::Ones(), 0.1) == 0.025 * (std::sqrt(1 + 16 * F * F) - 1), boost::test_tools::tolerance(1e-12));
  // The bound on F^2 is eps^(-1/4).
  const double F_most = std::pow(std::numeric_limits<double>::epsilon(), -0.125);
  BOOST_TEST(step.least_penalty(Vector<2>(1, 1e-8), 0.1) == 0.025 * (std::sqrt(1 + 16 * F_most * F_most) - 1),
             boost::test_tools::tolerance(1e-12));
}

// Stein, Li and Solomon 2022, section 6.
BOOST_AUTO_TEST_CASE(settings_of_the_paper)
{
  const FFM::Splitting_options options = FFM::Splitting_options::published();
  BOOST_TEST(options.is_valid());
  BOOST_TEST(options.absolute_tolerance == 1e-6);
  BOOST_TEST(options.relative_tolerance == 1e-5);
  BOOST_TEST((options.weights == FFM::Splitting_weights::equal));
  BOOST_TEST(options.penalty_factor == 2.5);
  BOOST_TEST(options.penalty_ratio == 5);
  BOOST_TEST(options.first_adaptations == 5);
  BOOST_TEST(options.adaptation_interval == 5);
  BOOST_TEST(options.largest_interval_with_flips > 1000000000);
  BOOST_TEST(!options.raises_penalties_of_flips);
  BOOST_TEST(options.largest_penalty == std::numeric_limits<double>::infinity());
}

// Errors of elements of different measures, (14), with one weight for all or by measure, and the penalties that follow from them.
BOOST_AUTO_TEST_CASE(weights_of_errors)
{
  using Step = FFM::Admm_splitting_step<2, FFM::Symmetric_gradient>;
  Random random(12);
  const Step published(FFM::Symmetric_gradient(), FFM::Splitting_options::published()), own;
  int differing = 0, flipped = 0;
  for(int i = 0; i < 300; ++i) {
    const double measure = std::pow(10, random(-5, -1));
    FFM::Split_element<2> element;
    own.start(random.matrix<2>(), measure, false, element);
    element.penalty *= std::pow(10, random(0, 6));
    const FFM::Split_element<2> before = element;
    const Matrix<2> jacobian = before.jacobian + 0.3 * random.matrix<2>();
    FFM::Split_element<2> other = element;
    FFM::Splitting_errors equal, weighted;
    published.update(jacobian, measure, true, false, element, equal);
    own.update(jacobian, measure, true, false, other, weighted);
    const double primal = (jacobian - element.rotation * element.stretch).norm();
    const double dual = before.penalty * (jacobian - before.jacobian).norm();
    BOOST_TEST(equal.primal == primal * primal, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(equal.dual == dual * dual, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(equal.primal_scale == jacobian.squaredNorm(), boost::test_tools::tolerance(1e-9));
    BOOST_TEST(weighted.primal == measure * equal.primal, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(weighted.dual == equal.dual / measure, boost::test_tools::tolerance(1e-9));
    const Vector<2> p = eigenvalues(element.stretch).reverse();
    const double factor = primal > 5 * dual ? 2.5 : dual > 5 * primal ? 0.4 : 1;
    BOOST_TEST(element.penalty == (std::max)(factor * before.penalty, published.least_penalty(p, measure)),
               boost::test_tools::tolerance(1e-9));
    differing += element.penalty != other.penalty;
    if(!(jacobian.determinant() > 0)) {
      ++flipped;
      BOOST_TEST(other.penalty >= 2.5 * before.penalty * (1 - 1e-9));
    }
  }
  BOOST_TEST(differing > 50);
  BOOST_TEST(flipped > 50);
}

BOOST_AUTO_TEST_CASE(start_of_a_flipped_element)
{
  Random random(7);
  const FFM::Admm_splitting_step<3, FFM::Symmetric_gradient> step;
  for(int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d J = random.matrix<3>();
    FFM::Split_element<3> element;
    step.start(J, 0.1, true, element);
    BOOST_TEST(element.rotation.determinant() == 1., boost::test_tools::tolerance(1e-12));
    BOOST_TEST(smallest_eigenvalue(element.stretch) > 0);
    if(J.determinant() > 0)
      BOOST_TEST((element.rotation * element.stretch - J).norm() < 1e-3);
    BOOST_TEST(element.penalty == 0.1);
    BOOST_TEST(element.dual.norm() == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_splitting_steps
