// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_REMOVE_RIGID_MOTION_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_REMOVE_RIGID_MOTION_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/worlds/Sequential_world.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Removes the components along translations and infinitesimal rotations of the image x from a direction. Energies do not change
// along them, and solving with a nearly singular matrix leaves large multiples of them. Of a part of a mesh `x` holds the positions of
// its vertices, and the direction those of the vertices that are owned.
template <int D, typename World = Sequential_world>
void remove_rigid_motion(const Positions<D>& x, Eigen::VectorXd& direction, const World& world = World())
{
  const Eigen::Index n = world.owned_vertices(static_cast<std::int32_t>(x.cols()));
  const double number = world.sum(static_cast<double>(n));
  const auto mean = [&](const auto& columns) {
    Vector<D> sum = columns.rowwise().sum();
    for(double& coordinate : sum)
      coordinate = world.sum(coordinate) / number;
    return sum;
  };
  Eigen::Map<Positions<D>> d(direction.data(), D, n);
  d.colwise() -= mean(d);
  const Positions<D> centred = x.leftCols(n).colwise() - mean(x.leftCols(n));

  constexpr int ROTATIONS = D * (D - 1) / 2;
  Eigen::Matrix<double, Eigen::Dynamic, ROTATIONS> motions(D * n, ROTATIONS);
  int r = 0;
  for(int i = 0; i < D; ++i)
    for(int j = i + 1; j < D; ++j, ++r) {
      motions.col(r).setZero();
      Eigen::Map<Positions<D>> motion(motions.col(r).data(), D, n);
      motion.row(i) = -centred.row(j);
      motion.row(j) = centred.row(i);
      for(int k = 0; k < r; ++k)
        motions.col(r) -= world.sum(motions.col(k).dot(motions.col(r))) * motions.col(k);
      const double norm = World::is_sequential ? motions.col(r).norm() : std::sqrt(world.sum(motions.col(r).squaredNorm()));
      if(norm > 0)
        motions.col(r) /= norm;
      direction -= world.sum(motions.col(r).dot(direction)) * motions.col(r);
    }
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template void remove_rigid_motion<2>(const Positions<2>&, Eigen::VectorXd&, const Sequential_world&);
extern template void remove_rigid_motion<3>(const Positions<3>&, Eigen::VectorXd&, const Sequential_world&);
#endif

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_REMOVE_RIGID_MOTION_H
