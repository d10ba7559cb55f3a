// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_ADAPT_TO_DEVELOPABLE_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_ADAPT_TO_DEVELOPABLE_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/elements/Increment_form.h>
#include <CGAL/Flip_free_maps/energies/internal/energy_traits.h>
#include <CGAL/Flip_free_maps/initializers/internal/angle_sums.h>

#include <CGAL/number_type_basic.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The sum of |2 pi - angles| over the inner vertices of a disk: 0 for developable surfaces, 4 pi or more for most closed surfaces
// that were cut open. A hole adds the total curvature of whatever would close it (theorem of Gauss and Bonnet): 0 in a sheet that
// was flat, 2 pi at the end of a cylinder.
double total_curvature(const Simplicial_domain<2>& domain);

// Whether isometries are strict minima of the energy, but for rotations.
template <typename Energy>
bool favours_isometries(const Energy& energy)
{
  Vector<2> gradient;
  Matrix<2> hessian;
  energy.template derivatives<2>(Vector<2>::Ones(), gradient, hessian);
  Eigen::SelfAdjointEigenSolver<Matrix<2>> eigen;
  eigen.computeDirect(hessian, Eigen::EigenvaluesOnly);
  const Vector<2> curvatures = eigen.eigenvalues();
  return curvatures[0] > 1e-6 * curvatures[1] && gradient.norm() <= 1e-9 * curvatures[1];
}

template <typename Traits, typename = void>
struct Is_adaptive : std::false_type
{};

template <typename Traits>
struct Is_adaptive<Traits, std::void_t<decltype(std::declval<Traits&>().adapt_to_developable_surface())>> : std::true_type
{};

// Total curvature, in radians, up to which a surface counts as developable: that of a spherical cap of 18 degrees around its
// centre is greater.
constexpr double DEVELOPABLE = 0.3;

// Adapts a default method to the surface.
template <typename Traits>
void adapt_to_developable(const Simplicial_domain<2>& domain, Traits& traits)
{
  if constexpr(Is_adaptive<Traits>::value)
    if(favours_isometries(traits.energy) && total_curvature(domain) <= DEVELOPABLE)
      traits.adapt_to_developable_surface();
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/initializers/internal/adapt_to_developable_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_INTERNAL_ADAPT_TO_DEVELOPABLE_H
