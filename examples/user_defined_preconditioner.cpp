// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Finds directions with a preconditioner that is not part of the package: the Hessian of the energy with its negative eigenvalues
// turned around, where the projected Hessian sets them to zero.

#include "bumpy_surface.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/parameterize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace FFM = CGAL::Flip_free_maps;

//! [preconditioner]
struct Absolute_newton
{
  using Category = FFM::Varying_matrix_tag;
  static constexpr bool is_second_order = true;
  static const char* name() { return "absolute_newton"; }

  template <int D, typename Energy>
  void form(const FFM::Element_state<D>& state, const Energy&, FFM::Increment_form<D>& form) const
  {
    const auto& s = state.s;
    const auto& g = state.gradient;
    const auto& h = state.hessian;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D, D>> eigen(h);
    form.stretch = eigen.eigenvectors() * eigen.eigenvalues().cwiseAbs().asDiagonal() * eigen.eigenvectors().transpose();
    for(int p = 0, i = 0; i < D; ++i)
      for(int j = i + 1; j < D; ++j, ++p) {
        const bool is_equal = s[i] - s[j] < 1e-6 * s[i];
        const double symmetric = is_equal ? 0.5 * (h(i, i) + h(j, j)) - h(i, j) : (g[i] - g[j]) / (s[i] - s[j]);
        const double twist = (g[i] + g[j]) / (s[i] + s[j]);
        form.pairs[p].set_modes(std::abs(symmetric), std::abs(twist));
      }
  }
};
//! [preconditioner]

int main()
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  Mesh mesh;
  const auto border_halfedge = make_bumpy_surface(mesh);
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  const FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, Absolute_newton> traits;
  const FFM::Summary summary = FFM::parameterize(mesh, border_halfedge, uv, traits);
  std::cout << summary;
  return summary.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
