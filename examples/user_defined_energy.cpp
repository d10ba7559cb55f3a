// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Minimises an energy that is not part of the package: the mean of s + 1/s over the singular values s.

#include "bumpy_surface.h"

#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace FFM = CGAL::Flip_free_maps;

//! [energy]
struct Stretch_and_shrink
{
  static constexpr bool has_barrier = true;
  static const char* name() { return "stretch_and_shrink"; }

  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return (s.array() + s.array().inverse()).sum() / (2 * D);
  }

  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient,
                   Eigen::Matrix<double, D, D>& hessian) const
  {
    gradient = (1 - s.array().square().inverse()) / (2 * D);
    hessian.setZero();
    hessian.diagonal() = s.array().cube().inverse() / D;
  }
};
//! [energy]

// Compares the derivatives with central differences, whose error is of the order h^2 for the step h.
template <typename Energy>
bool are_derivatives_right(const Energy& energy, const Eigen::Vector2d& s)
{
  const double h = 1e-5;
  Eigen::Vector2d gradient, above, below;
  Eigen::Matrix2d hessian, unused;
  energy.template derivatives<2>(s, gradient, hessian);
  for(int i = 0; i < 2; ++i)
  {
    const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(i);
    energy.template derivatives<2>(s + step, above, unused);
    energy.template derivatives<2>(s - step, below, unused);
    const double slope = (energy.template value<2>(s + step) - energy.template value<2>(s - step)) / (2 * h);
    if(std::abs(gradient[i] - slope) > 1e-7 || ((above - below) / (2 * h) - hessian.col(i)).norm() > 1e-7)
      return false;
  }
  return true;
}

int main()
{
  typedef CGAL::Simple_cartesian<double>      Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  Mesh mesh;
  const auto border_halfedge = make_bumpy_surface(mesh);
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  const FFM::Flip_free_map_traits<CGAL::Default, Stretch_and_shrink> traits;
  const FFM::Summary summary = FFM::parameterize(mesh, border_halfedge, uv, traits);
  std::cout << summary;
  return are_derivatives_right(traits.energy, {1.7, 0.6}) && summary.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
