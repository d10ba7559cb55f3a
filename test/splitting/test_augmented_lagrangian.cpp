// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Whole iterations of the splitting: under the penalties of the convergence theorem the augmented Lagrangian decreases in each,
// though the step of the dual variables increases it, and the map comes to satisfy J = R P.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/splitting_checks.h"

#include <CGAL/Flip_free_maps/domains/internal/Element_coloring.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/splitting/Admm_splitting_step.h>
#include <CGAL/Flip_free_maps/splitting/internal/Position_solver.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_augmented_lagrangian)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

template <int D, typename Energy>
class Splitting_run
{
  using Step = FFM::Admm_splitting_step<D, Energy>;
  using Matrix = FFM::internal::Matrix<D>;
  using Vector = FFM::internal::Vector<D>;

public:
  Splitting_run(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& start, const FFM::Position_constraints<D>& constraints)
    : m_domain(domain), m_constraints(constraints), m_x(start), m_elements(domain.elements.size())
  {
    m_schedule.build(domain.elements, domain.number_of_vertices);
    for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
      m_step.start(domain.jacobian(e, start), domain.measures[e], true, m_elements[e]);
  }

  // The penalties that the theorem asks for at the present stretches, and for rotations h / mu = 4 (A b / mu)^2,
  // where they exceed `least`.
  std::vector<double> bounds(std::vector<double> least) const
  {
    for(std::size_t e = 0; e < m_elements.size(); ++e)
      least[e] = (std::max)(least[e], m_step.least_penalty(eigenvalues(m_elements[e].stretch), m_domain.measures[e]));
    return least;
  }

  void set_penalties(const std::vector<double>& penalties)
  {
    for(std::size_t e = 0; e < m_elements.size(); ++e)
      m_elements[e].penalty = penalties[e];
  }

  double lagrangian() const
  {
    double sum = 0;
    for(std::size_t e = 0; e < m_elements.size(); ++e) {
      const auto& element = m_elements[e];
      const Matrix residual = m_domain.jacobian(e, m_x) - element.rotation * element.stretch;
      sum += m_domain.measures[e] * Energy().template value<D>(eigenvalues(element.stretch)) +
             0.5 * element.penalty * ((residual + element.dual).squaredNorm() - element.dual.squaredNorm());
    }
    return sum;
  }

  // How far the Jacobians are from what they are split into.
  double primal_error() const
  {
    double sum = 0;
    for(std::size_t e = 0; e < m_elements.size(); ++e)
      sum += m_domain.measures[e] * (m_domain.jacobian(e, m_x) - m_elements[e].rotation * m_elements[e].stretch).squaredNorm();
    return std::sqrt(sum);
  }

  void iterate()
  {
    FFM::internal::Position_solver<D, FFM::Flip_free_map_traits<>> positions(m_domain, m_schedule, m_constraints, m_none);
    Plain_solver solver;
    BOOST_TEST_REQUIRE(positions.analyze_pattern(solver));
    BOOST_TEST_REQUIRE(positions.factorize(solver, [this](std::int64_t e) { return m_elements[e].penalty; }));
    for(std::int64_t e = 0; e < m_domain.number_of_elements(); ++e)
      m_elements[e].jacobian = m_domain.jacobian(e, m_x);
    BOOST_TEST_REQUIRE(positions.move(
      solver, [this](std::int64_t e) { return Step::pull(m_elements[e]); }, m_x));
    FFM::Splitting_errors errors;
    for(std::int64_t e = 0; e < m_domain.number_of_elements(); ++e) {
      auto& element = m_elements[e];
      // The bound on |grad psi| is that at the present stretch.
      const double relative = m_domain.measures[e] * FFM::Proximal_map<Energy, D>::scale() / element.penalty;
      element.inertia = 20 * relative * relative * (1 + FFM::Proximal_map<Energy, D>::squared_gradient(eigenvalues(element.stretch)));
      m_step.update(m_domain.jacobian(e, m_x), m_domain.measures[e], false, true, element, errors);
    }
  }

  const FFM::Positions<D>& positions() const { return m_x; }

private:
  static Vector eigenvalues(const Matrix& P) { return test_support::eigenvalues(P).reverse(); }

  const FFM::Simplicial_domain<D>& m_domain;
  FFM::Position_constraints<D> m_constraints;
  FFM::Linear_constraints<D> m_none;
  FFM::internal::Element_coloring m_schedule;
  Step m_step;
  FFM::Positions<D> m_x;
  std::vector<FFM::Split_element<D>> m_elements;
};

template <int D, typename Energy>
void check_decrease(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& start)
{
  FFM::Position_constraints<D> constraints;
  for(std::int32_t v = 0; v < domain.number_of_vertices; v += 4)
    constraints.fixed_vertices.push_back(v);
  const int iterations = 150;
  // Penalties of the theorem are constant and satisfy its condition at all stretches that occur:
  // runs with growing ones tell which.
  std::vector<double> penalties(domain.elements.size(), 0.);
  bool is_enough = false;
  for(int round = 0; round < 10 && !is_enough; ++round) {
    Splitting_run<D, Energy> run(domain, start, constraints);
    penalties = run.bounds(penalties);
    const std::vector<double> begin = penalties;
    run.set_penalties(penalties);
    const double first_error = run.primal_error();
    std::vector<double> values{run.lagrangian()};
    for(int i = 0; i < iterations; ++i) {
      run.iterate();
      penalties = run.bounds(penalties);
      values.push_back(run.lagrangian());
    }
    is_enough = penalties == begin;
    if(!is_enough)
      continue;
    // The dual variables of the start, 0, do not belong to its stretches yet.
    // The value is a sum over elements, whose rounding is not that of the decrease.
    for(int i = 2; i <= iterations; ++i)
      BOOST_TEST(values[i] <= values[i - 1] + 1e-11 * std::abs(values[i - 1]), "iteration " << i);
    BOOST_TEST(values.back() < values.front() - 1e-3 * std::abs(values.front()));
    BOOST_TEST(run.primal_error() < 0.1 * first_error + 1e-3);
  }
  BOOST_TEST(is_enough);
}

} // namespace

BOOST_AUTO_TEST_CASE(decreases_in_the_plane)
{
  const Distorted_example<2> example(6, 5);
  check_decrease<2, FFM::Symmetric_gradient>(example.domain, example.x);
  check_decrease<2, FFM::Symmetric_dirichlet>(example.domain, example.x);
}

BOOST_AUTO_TEST_CASE(decreases_in_space)
{
  const Distorted_example<3> example(3, 2, 2);
  check_decrease<3, FFM::Symmetric_gradient>(example.domain, example.x);
}

BOOST_AUTO_TEST_CASE(small_penalties_do_not_suffice)
{
  // Otherwise the tests above would prove nothing about penalties.
  const Distorted_example<2> example(6, 5);
  FFM::Position_constraints<2> constraints;
  constraints.fixed_vertices = {0, 4, 8, 12, 16, 20};
  Splitting_run<2, FFM::Symmetric_dirichlet> run(example.domain, shaken<2>(example.x, 0.4, 3), constraints);
  std::vector<double> penalties = example.domain.measures;
  for(double& penalty : penalties)
    penalty *= 1e-3;
  run.set_penalties(penalties);
  bool increases = false;
  for(int i = 0; i < 50; ++i) {
    const double before = run.lagrangian();
    run.iterate();
    increases = increases || run.lagrangian() > before + 1e-9 * std::abs(before);
  }
  BOOST_TEST(increases);
}

BOOST_AUTO_TEST_SUITE_END() // test_augmented_lagrangian
