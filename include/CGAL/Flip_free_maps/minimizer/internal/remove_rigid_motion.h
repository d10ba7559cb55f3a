// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_REMOVE_RIGID_MOTION_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_REMOVE_RIGID_MOTION_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Removes the components along translations and infinitesimal rotations of the image x from a direction. Energies do not change
// along them, and solving with a nearly singular matrix leaves large multiples of them.
template <int D>
void remove_rigid_motion(const Positions<D>& x, Eigen::VectorXd& direction)
{
  Eigen::Map<Positions<D>> d(direction.data(), D, x.cols());
  d.colwise() -= Vector<D>(d.rowwise().mean());
  const Positions<D> centred = x.colwise() - Vector<D>(x.rowwise().mean());

  constexpr int ROTATIONS = D * (D - 1) / 2;
  Eigen::Matrix<double, Eigen::Dynamic, ROTATIONS> motions(x.size(), ROTATIONS);
  int r = 0;
  for(int i = 0; i < D; ++i)
    for(int j = i + 1; j < D; ++j, ++r) {
      motions.col(r).setZero();
      Eigen::Map<Positions<D>> motion(motions.col(r).data(), D, x.cols());
      motion.row(i) = -centred.row(j);
      motion.row(j) = centred.row(i);
      for(int k = 0; k < r; ++k)
        motions.col(r) -= motions.col(k).dot(motions.col(r)) * motions.col(k);
      const double norm = motions.col(r).norm();
      if(norm > 0)
        motions.col(r) /= norm;
      direction -= motions.col(r).dot(direction) * motions.col(r);
    }
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template void remove_rigid_motion<2>(const Positions<2>&, Eigen::VectorXd&);
extern template void remove_rigid_motion<3>(const Positions<3>&, Eigen::VectorXd&);
#endif

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_REMOVE_RIGID_MOTION_H
