// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// What the tests of the splitting scheme share: starts with flips, and the global step without a robust solver.

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_SPLITTING_CHECKS_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_SPLITTING_CHECKS_H

#include "generated_domains.h"

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>

#include <cstdint>

namespace test_support {

template <int D>
std::int64_t negative_elements(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& x)
{
  std::int64_t flips = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
    flips += !(domain.image_edges(e, x).determinant() > 0);
  return flips;
}

// Some vertices jump far enough to flip the elements around them.
template <int D>
FFM::Positions<D> shaken(const FFM::Positions<D>& x, double length, int every)
{
  Random random(11);
  FFM::Positions<D> result = x;
  for(Eigen::Index v = 0; v < x.cols(); v += every)
    for(int c = 0; c < D; ++c)
      result(c, v) += random(-length, length);
  return result;
}

// The shift of a robust solver is no business of tests of the global step.
struct Plain_solver
{
  FFM::Eigen_simplicial_solver solver;

  bool analyze_pattern(const FFM::Block_sparse_matrix& matrix) { return solver.analyze_pattern(matrix); }
  bool factorize(const FFM::Block_sparse_matrix& matrix, double) { return solver.factorize(matrix); }
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) { return solver.solve(b, x); }
};

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_SPLITTING_CHECKS_H
