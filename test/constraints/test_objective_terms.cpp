// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Gradient and matrix of the energy and terms beside it, with some vertices fixed, by differences.

#include "support/unit_test.h"

#include "support/constraint_checks.h"

#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/preconditioners/Newton.h>

#include <cstdint>
#include <memory>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_objective_terms)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

typedef FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, FFM::Newton> Traits;

// Gradient and matrix of energy, soft positions and a spring, by differences of their sum and of the gradient.
template <int D>
void check_derivatives()
{
  const Distorted_example<D> example;
  const std::int32_t n = example.domain.number_of_vertices;
  const FFM::Symmetric_dirichlet energy;
  const FFM::Newton newton;
  const FFM::Fixed_reference reference;
  FFM::internal::Map_objective<D, Traits> objective(example.domain, energy, newton);
  BOOST_TEST(objective.is_rigid_motion_invariant());
  objective.add_term(nullptr);
  objective.add_term(std::make_shared<Spring<D>>(1, n - 1, 0.7));
  objective.add_term(std::make_shared<Spring<D>>(n - 2, 0, 0.2));
  BOOST_TEST(objective.is_rigid_motion_invariant());
  const std::vector<FFM::Soft_position<D>> soft{{1, 2 * example.x.col(1), 0.5}, {3, example.x.col(0), 3}};
  objective.add_term(std::make_shared<FFM::Soft_positions<D>>(soft));
  BOOST_TEST(!objective.is_rigid_motion_invariant());
  for(const std::vector<std::int32_t>& fixed : {std::vector<std::int32_t>(), std::vector<std::int32_t>{3, 4, n - 2}}) {
    objective.fix(fixed);
    objective.build_pattern();
    BOOST_TEST(objective.number_of_unknowns() == n - std::int32_t(fixed.size()));
    Eigen::VectorXd gradient, expected, unknowns;
    objective.derivatives(reference, example.x, true, gradient);
    objective.gather(gradient_by_differences<D>([&](const FFM::Positions<D>& y) { return objective.energy(reference, y); }, example.x),
                     expected);
    BOOST_TEST((gradient - expected).norm() <= 1e-8 * gradient.norm());

    Eigen::MatrixXd matrix = Eigen::MatrixXd(objective.matrix().lower()).template selfadjointView<Eigen::Lower>(), differences = matrix;
    for(Eigen::Index i = 0; i < gradient.size(); ++i) {
      const auto at = [&](double h) {
        FFM::Positions<D> displacement;
        Eigen::VectorXd unit = Eigen::VectorXd::Zero(gradient.size()), result;
        unit[i] = h;
        objective.spread(unit, displacement);
        objective.derivatives(reference, example.x + displacement, false, result);
        return result;
      };
      const double h = 1e-4;
      differences.col(i) = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
    }
    BOOST_TEST((matrix - differences).norm() <= 1e-8 * matrix.norm());
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(derivatives_2) { check_derivatives<2>(); }

BOOST_AUTO_TEST_CASE(derivatives_3) { check_derivatives<3>(); }

BOOST_AUTO_TEST_SUITE_END() // test_objective_terms
