// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_CHARACTERISTIC_GRADIENT_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_CHARACTERISTIC_GRADIENT_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/elements/internal/eigenmodes.h>
#include <CGAL/Flip_free_maps/worlds/Sequential_world.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Measure of the facet of a rest element opposite its vertex k.
inline double opposite_measure(const Matrix<2>& edges, int k)
{
  return k == 0 ? (edges.col(1) - edges.col(0)).norm() : edges.col(2 - k).norm();
}

inline double opposite_measure(const Matrix<3>& edges, int k)
{
  if(k == 0)
    return 0.5 * (edges.col(1) - edges.col(0)).cross(edges.col(2) - edges.col(0)).norm();
  return 0.5 * edges.col(k % 3).cross(edges.col((k + 1) % 3)).norm();
}

// The gradient norm that a mesh and an energy produce at unit stress (Zhu, Bridson and Kaufman 2018, section 6): the energy's stiffness
// at the identity times the norm of the vector of the rest links' measures. They take the largest eigenvalue of the Hessian for the
// stiffness. Here it is the least one beside those that vanish, as rotations' do: by the largest, a material that hardly changes
// its volume would count as solved long before it has found its shape.
template <int D, typename Energy, typename World = Sequential_world>
double characteristic_gradient(const Simplicial_domain<D>& domain, const Energy& energy, const World& world = World())
{
  Element_state<D> state;
  state.s.setOnes();
  energy.template derivatives<D>(state.s, state.gradient, state.hessian);
  Eigen::SelfAdjointEigenSolver<Matrix<D>> eigen;
  eigen.computeDirect(state.hessian, Eigen::EigenvaluesOnly);
  std::vector<double> moduli(eigen.eigenvalues().data(), eigen.eigenvalues().data() + D);
  for_each_pair<D>([&](int, int i, int j) {
    moduli.push_back(symmetric_mode(state, i, j));
    moduli.push_back(twist_mode(state, i, j));
  });
  double largest = 0;
  for(double& modulus : moduli) {
    modulus = std::abs(modulus);
    largest = (std::max)(largest, modulus);
  }
  const double vanishing = 1e-6;
  double stiffness = largest;
  for(const double modulus : moduli)
    if(modulus > vanishing * largest)
      stiffness = (std::min)(stiffness, modulus);

  Eigen::VectorXd links = Eigen::VectorXd::Zero(domain.number_of_vertices);
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
    const Matrix<D> edges = domain.rest_inverses[e].inverse();
    for(int k = 0; k <= D; ++k)
      links[domain.elements[e][k]] += opposite_measure(edges, k);
  }
  if constexpr(!World::is_sequential)
    links.conservativeResize(world.owned_vertices(domain.number_of_vertices));
  return stiffness * world.norm(links);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_CHARACTERISTIC_GRADIENT_H
