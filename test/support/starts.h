// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_STARTS_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_STARTS_H

// Starts of maps, and an independent count of flipped elements.

#include <CGAL/Flip_free_maps/initializers/Tutte_initializer.h>
#include <CGAL/Flip_free_maps/linear_solvers/Eigen_simplicial_solver.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>

#include <cstdint>

namespace test_support {

namespace FFM = CGAL::Flip_free_maps;

typedef FFM::Tutte_initializer<CGAL::Exact_predicates_inexact_constructions_kernel, FFM::Eigen_simplicial_solver, CGAL::Sequential_tag>
  Tutte;

inline FFM::Eigen_simplicial_solver make_eigen_solver() { return FFM::Eigen_simplicial_solver(); }

// The harmless start: a circle with uniform weights. Empty after a failure.
FFM::Positions<2> tutte_start(const FFM::Simplicial_domain<2>& domain);

// Elements that are not positively oriented, by exact predicates.
std::int64_t number_of_flips(const FFM::Simplicial_domain<2>& domain, const FFM::Positions<2>& x);

// Mean symmetric Dirichlet energy, without singular values.
template <int D>
double symmetric_dirichlet(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& x)
{
  double energy = 0;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const auto J = domain.jacobian(e, x);
    energy += domain.measures[e] * (J.squaredNorm() + J.inverse().squaredNorm()) / (2 * D);
  }
  return energy;
}

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_STARTS_H
