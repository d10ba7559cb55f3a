// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Minimises an energy that is not part of the package: the mean of s + 1/s over the singular values s.

#include "bumpy_surface.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/check_derivatives.h>
#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

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
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    gradient = (1 - s.array().square().inverse()) / (2 * D);
    hessian.setZero();
    hessian.diagonal() = s.array().cube().inverse() / D;
  }
};
//! [energy]

int main()
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  Mesh mesh;
  const auto border_halfedge = make_bumpy_surface(mesh);
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  const FFM::Flip_free_map_traits<CGAL::Default, Stretch_and_shrink> traits;
  const FFM::Summary summary = FFM::parameterize(mesh, border_halfedge, uv, traits);
  std::cout << summary;

  //! [check]
  const FFM::Derivative_report report = FFM::check_derivatives<2>(traits.energy, {1.7, 0.6});
  const bool are_derivatives_right = report.gradient_error < 1e-7 && report.hessian_error < 1e-7;
  //! [check]
  return are_derivatives_right && summary.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
