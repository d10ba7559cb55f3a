// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Meshes the two tissues of a labelled image, a bone inside of a finger, by CGAL's 3D Mesh Generation, and bends the finger.

#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/domains/Mesh_complex_3_domain.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/ImageIO.h>
#include <CGAL/Image_3.h>
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

// Voxels of 1 mm: 0 outside, 1 in the flesh, 2 in the bone. An image of one's own comes by CGAL::Image_3::read().
CGAL::Image_3 finger()
{
  const int length = 64, width = 24;
  CGAL::Image_3 image(_createImage(length, width, width, 1, 1, 1, 1, 1, WK_FIXED, SGN_UNSIGNED));
  unsigned char* voxel = static_cast<unsigned char*>(image.data());
  for(int k = 0; k < width; ++k)
    for(int j = 0; j < width; ++j)
      for(int i = 0; i < length; ++i, ++voxel) {
        const double y = j - 11.5, z = k - 11.5, square = y * y + z * z;
        const bool inside = i >= 3 && i < length - 3;
        *voxel = !inside || square > 81 ? 0 : square > 16 ? 1 : 2;
      }
  return image;
}

int main()
{
  const CGAL::Image_3 image = finger();
  const Mesh_domain mesh_domain = Mesh_domain::create_labeled_image_mesh_domain(image);
  const Mesh_criteria criteria(Mesh_criteria::Facet_criteria(25, 5, 1.5), Mesh_criteria::Cell_criteria(3, 5));
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(mesh_domain, criteria);

  FFM::Mesh_complex_3_domain<C3t3> volume;
  std::string message;
  if(volume.load(c3t3, message) != FFM::Status::success) {
    std::cerr << message << std::endl;
    return EXIT_FAILURE;
  }

  // One end is held, the tip makes a quarter turn upwards around an axis 30 mm above the middle of the finger.
  std::vector<std::pair<C3t3::Vertex_handle, Kernel::Point_3>> handles;
  for(const C3t3::Vertex_handle v : volume.vertices()) {
    const Kernel::Point_3 p = v->point().point();
    if(p.x() < 8)
      handles.emplace_back(v, p);
    else if(p.x() > 56)
      handles.emplace_back(v, Kernel::Point_3(32 + 42 - p.z(), p.y(), p.x() - 32 + 42));
  }
  std::unordered_map<C3t3::Vertex_handle, Kernel::Point_3> result;
  const FFM::Summary summary = FFM::deform_volume(volume, handles, boost::make_assoc_property_map(result));
  std::cout << summary;
  return summary.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
