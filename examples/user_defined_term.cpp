// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Smooths the border of a layout by a term of its own, which is minimised along with the distortion.

#include "bumpy_surface.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/domains/Face_graph_domain.h>
#include <CGAL/Flip_free_maps/initializers/Multilevel_initializer.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;

//! [term]
// The sum of weight |a - 2 b + c|^2 over triples of vertices: how much a spline through them is bent.
struct Bending : FFM::Objective_term<2>
{
  double weight = 10;
  std::vector<std::vector<std::int32_t>> triples;
  bool is_rigid_motion_invariant() const override { return true; }
  std::vector<std::vector<std::int32_t>> stencils() const override { return triples; }
  double value(const FFM::Positions<2>& x) const override
  {
    double sum = 0;
    for(const auto& t : triples)
      sum += weight * (x.col(t[0]) - 2 * x.col(t[1]) + x.col(t[2])).squaredNorm();
    return sum;
  }
  void add_derivatives(const FFM::Positions<2>& x, FFM::Positions<2>& gradient, FFM::Term_matrix<2>* matrix) const override
  {
    const double c[] = {1, -2, 1};
    for(const auto& t : triples)
      for(int i = 0; i < 3; ++i) {
        gradient.col(t[i]) += 2 * weight * c[i] * (x.col(t[0]) - 2 * x.col(t[1]) + x.col(t[2]));
        for(int j = 0; j <= i && matrix != nullptr; ++j)
          matrix->add(t[i], t[j], 2 * weight * c[i] * c[j] * Eigen::Matrix2d::Identity());
      }
  }
};
//! [term]

int main()
{
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
  Mesh mesh;
  const auto border_halfedge = make_bumpy_surface(mesh);
  //! [minimizer]
  FFM::Face_graph_domain<Mesh> graph; // flat arrays, in which the surface has area 1
  FFM::Positions<2> x;                // positions in the units of these arrays
  std::string name, message;
  graph.load(mesh, border_halfedge, mesh.points(), message);
  FFM::Multilevel_initializer<FFM::Flip_free_map_traits<>>({})(graph.domain(), x, name, message);
  const auto bending = std::make_shared<Bending>();
  const std::vector<std::int32_t>& border = graph.domain().border;
  for(std::size_t i = 0, n = border.size(); i < n; ++i)
    bending->triples.push_back({border[i], border[(i + 1) % n], border[(i + 2) % n]});
  const double before = bending->value(x);
  FFM::Map_minimizer<2> minimizer(graph.domain());
  minimizer.add_term(bending);
  const FFM::Summary summary = minimizer.minimize(x);
  //! [minimizer]
  std::cout << summary << "bending of the border: " << before << " -> " << summary.energy_of_terms << std::endl;
  return summary.is_valid() && summary.energy_of_terms < before ? EXIT_SUCCESS : EXIT_FAILURE;
}
