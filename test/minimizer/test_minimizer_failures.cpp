// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Energies, preconditioners and linear solvers that misbehave.

#include "support/unit_test.h"

#include "support/dense_algebra.h"
#include "support/minimizer_fixture.h"

#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

#include <cmath>
#include <cstdint>
#include <string>

BOOST_AUTO_TEST_SUITE(test_minimizer_failures)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// NaN where an element is close to its rest shape, on purpose.
struct Energy_with_hole : FFM::Symmetric_dirichlet
{
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return s[D - 1] > 0.97 && s[0] < 1.03 ? not_a_number : FFM::Symmetric_dirichlet::value<D>(s);
  }
};

struct Nan_energy : FFM::Symmetric_dirichlet
{
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>&) const
  {
    return not_a_number;
  }
};

// Its derivatives promise a decrease that never comes.
struct Flat_energy : FFM::Symmetric_dirichlet
{
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>&) const
  {
    return 2;
  }
};

struct Nan_preconditioner : FFM::Projected_newton
{
  template <int D, typename Energy>
  void form(const FFM::Element_state<D>&, const Energy&, FFM::Increment_form<D>& form) const
  {
    form.stretch.setConstant(not_a_number);
  }
};

struct Failing_solver
{
  std::string name() const { return "failing"; }
  std::string ordering() const { return "none"; }
  bool analyze_pattern(const FFM::Block_sparse_matrix&) { return false; }
  bool factorize(const FFM::Block_sparse_matrix&) { return false; }
  bool solve(const Eigen::VectorXd&, Eigen::VectorXd&) { return false; }
  std::int64_t factor_entries() const { return -1; }
};

// Factorizes, but never solves.
struct Unsolving_solver : Failing_solver
{
  bool analyze_pattern(const FFM::Block_sparse_matrix&) { return true; }
  bool factorize(const FFM::Block_sparse_matrix&) { return true; }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(energies_of_nan_are_never_accepted, Fixture)
{
  check_failed(run<Varied_traits<Nan_energy>>(), FFM::Status::start_not_flip_free);

  // All elements of a developable surface want to go where the hole is: the run cannot converge, and stops short of it.
  domain = make_domain(bent_sheet(8, 7));
  start = tutte_start(domain);
  FFM::Map_options options;
  options.max_iterations = 200;
  bool is_finite = true;
  double last = infinity;
  options.observer = [&](const FFM::Iteration_report& report) {
    is_finite = is_finite && std::isfinite(report.energy) && report.energy <= last;
    last = report.energy;
    return true;
  };
  const FFM::Summary summary = run<Varied_traits<Energy_with_hole>>(options);
  BOOST_TEST(is_finite);
  BOOST_TEST(!summary.converged());
  BOOST_TEST(last == summary.energy);
  BOOST_TEST(summary.energy < summary.energy_initial);
  if(!summary.is_valid())
    return check_failed(summary, FFM::Status::line_search_failed);
  check_valid(summary, FFM::Status::iteration_limit);
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const Eigen::Vector2d s = singular_values(domain.jacobian(e, x));
    BOOST_TEST((s[1] <= 0.97 || s[0] >= 1.03));
  }
}

BOOST_FIXTURE_TEST_CASE(wrong_derivatives_end_in_the_line_search, Fixture)
{
  const FFM::Summary summary = run<Varied_traits<Flat_energy>>();
  check_failed(summary, FFM::Status::line_search_failed);
  BOOST_TEST(summary.iterations == 0);
}

BOOST_FIXTURE_TEST_CASE(failing_linear_solvers, Fixture)
{
  const FFM::Summary expected = run();
  const FFM::Positions<2> expected_x = x;
  const FFM::Summary fallen_back = run<Varied_traits<CGAL::Default, CGAL::Default, Failing_solver>>();
  check_valid(fallen_back, FFM::Status::success);
  BOOST_TEST(std::abs(fallen_back.energy - expected.energy) <= 1e-9);
  BOOST_TEST(fallen_back.linear_solver == "failing, then eigen_simplicial_ldlt");

  check_failed(run<Varied_traits<CGAL::Default, Nan_preconditioner>>(), FFM::Status::linear_solver_failed);
  check_failed(run<Varied_traits<CGAL::Default, Nan_preconditioner, Failing_solver>>(), FFM::Status::linear_solver_failed);

  // A solver that claims a factorization it cannot use must end in a failure, not in an endless loop.
  const FFM::Summary unsolved = run<Varied_traits<CGAL::Default, CGAL::Default, Unsolving_solver>>();
  BOOST_TEST(!unsolved.is_valid());
  BOOST_TEST((x == start));
}

BOOST_AUTO_TEST_SUITE_END() // test_minimizer_failures
