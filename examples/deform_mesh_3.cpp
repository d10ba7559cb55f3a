// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Meshes an implicit solid by CGAL's 3D Mesh Generation and bends it by its ends.

#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/domains/Mesh_complex_3_domain.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

#include <boost/property_map/property_map.hpp>

#include <cstdlib>
#include <iostream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Labeled_mesh_domain_3<Kernel> Mesh_domain;
typedef CGAL::Mesh_triangulation_3<Mesh_domain>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
typedef CGAL::Mesh_criteria_3<Triangulation> Mesh_criteria;

int main()
{
  // A cigar along the x-axis: negative inside.
  const auto cigar = [](const Kernel::Point_3& p) { return p.x() * p.x() / 9 + p.y() * p.y() + p.z() * p.z() - 1; };
  const Mesh_domain mesh_domain = Mesh_domain::create_implicit_mesh_domain(cigar, Kernel::Sphere_3(CGAL::ORIGIN, 16));
  const Mesh_criteria criteria(Mesh_criteria::Facet_criteria(25, 0.4, 0.05), Mesh_criteria::Cell_criteria(3, 0.4));
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(mesh_domain, criteria);

  //! [volume]
  FFM::Mesh_complex_3_domain<C3t3> volume;
  std::string message;
  if(volume.load(c3t3, message) != FFM::Status::success) {
    std::cerr << message << std::endl;
    return EXIT_FAILURE;
  }

  // The left end is held, the right one makes a quarter turn around the axis x = y = 1, upwards.
  std::vector<std::pair<C3t3::Vertex_handle, Kernel::Point_3>> handles;
  for(const C3t3::Vertex_handle v : volume.vertices()) {
    const Kernel::Point_3 p = v->point().point();
    if(p.x() < -2)
      handles.emplace_back(v, p);
    else if(p.x() > 2)
      handles.emplace_back(v, Kernel::Point_3(2 - p.y(), p.x(), p.z()));
  }
  std::unordered_map<C3t3::Vertex_handle, Kernel::Point_3> result;
  const FFM::Summary summary = FFM::deform_volume(volume, handles, boost::make_assoc_property_map(result));
  //! [volume]
  std::cout << summary;
  return summary.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
