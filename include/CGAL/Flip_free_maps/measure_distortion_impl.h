// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_IMPL_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE Distortion_report measure_distortion(const Textured_mesh& mesh, std::vector<double>* face_energies)
{
  internal::Distortion_measure measure;
  if(face_energies != nullptr)
    face_energies->clear();
  for(std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    internal::Matrix<3> points;
    Eigen::Matrix<double, 2, 3> image;
    for(int k = 0; k < 3; ++k) {
      points.col(k) = Eigen::Map<const Eigen::Vector3d>(mesh.points[mesh.triangles[i][k]].data());
      image.col(k) = Eigen::Map<const Eigen::Vector2d>(mesh.texture[mesh.texture_triangles[i][k]].data());
    }
    const double energy = measure.add(points, image);
    if(std::isnan(energy))
      break;
    if(face_energies != nullptr)
      face_energies->push_back(energy);
  }
  return measure.report();
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_DISTORTION_IMPL_H
