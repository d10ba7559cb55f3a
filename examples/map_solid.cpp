// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Volume correspondence: the surface of a solid is mapped already, and the inside follows without flips. Without arguments a bar
// is mapped to a twisted and bulging one.
//
// usage: map_solid [SOLID.mesh TARGET.off RESULT.mesh]        vertex k of the target is where vertex k of the solid goes

#include <CGAL/Flip_free_maps/IO/Medit.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/map_volume.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;

namespace {

// A bar of 4 x 4 x 12 cubes, six tetrahedra each; the target of its surface.
void make_pair(FFM::Tetrahedral_mesh& solid, std::vector<int>& surface, std::vector<Eigen::Vector3d>& target)
{
  const int n = 4, length = 12;
  const auto number = [=](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  for(int k = 0; k <= length; ++k)
    for(int j = 0; j <= n; ++j)
      for(int i = 0; i <= n; ++i) {
        const double x = i - 0.5 * n, y = j - 0.5 * n, angle = 1.5 * k / length;
        solid.points.push_back({x, y, 1. * k});
        if(i % n != 0 && j % n != 0 && k % length != 0)
          continue;
        const double bulge = 1 + 0.5 * std::sin(3.14159265358979323846 * k / length);
        surface.push_back(number(i, j, k));
        target.emplace_back(bulge * (std::cos(angle) * x - std::sin(angle) * y), bulge * (std::sin(angle) * x + std::cos(angle) * y), k);
      }
  // Around the diagonal of a cube, one path along its edges for each order of the axes.
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};
  for(int k = 0; k < length; ++k)
    for(int j = 0; j < n; ++j)
      for(int i = 0; i < n; ++i)
        for(int o = 0; o < 6; ++o) {
          int at[3] = {i, j, k};
          std::array<int, 4> tetrahedron = {number(i, j, k), 0, 0, 0};
          for(int s = 0; s < 3; ++s) {
            ++at[orders[o][s]];
            tetrahedron[s + 1] = number(at[0], at[1], at[2]);
          }
          if(o >= 3)
            std::swap(tetrahedron[2], tetrahedron[3]);
          solid.tetrahedra.push_back(tetrahedron);
        }
}

bool read_pair(const std::string& solid_file, const std::string& target_file, FFM::Tetrahedral_mesh& solid, std::vector<int>& surface,
               std::vector<Eigen::Vector3d>& target)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  if(!FFM::read_Medit(solid_file, solid) || !CGAL::IO::read_polygon_soup(target_file, points, faces) || points.size() > solid.points.size())
    return false;
  for(const auto& p : points) {
    surface.push_back(static_cast<int>(surface.size()));
    target.emplace_back(p.x(), p.y(), p.z());
  }
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  FFM::Tetrahedral_mesh solid;
  std::vector<int> surface;
  std::vector<Eigen::Vector3d> target;
  if(argc < 4)
    make_pair(solid, surface, target);
  else if(!read_pair(argv[1], argv[2], solid, surface, target)) {
    std::cerr << "The files cannot be read." << std::endl;
    return EXIT_FAILURE;
  }

  //! [map]
  FFM::Tetrahedral_domain volume;
  std::string message;
  if(volume.load(solid.points, solid.tetrahedra, message) != FFM::Status::success) {
    std::cerr << message << std::endl;
    return EXIT_FAILURE;
  }
  // The surface goes to its target; the vertices inside begin at the mean of their neighbours.
  FFM::Positions<3> x = volume.domain().rest_points;
  std::vector<std::int32_t> boundary;
  for(std::size_t i = 0; i < surface.size(); ++i) {
    boundary.push_back(volume.number(surface[i]));
    x.col(boundary.back()) = volume.to_domain(target[i]);
  }
  const FFM::Summary summary = FFM::map_volume(volume.domain(), boundary, x);
  //! [map]
  std::cout << summary;
  if(!summary.is_valid())
    return EXIT_FAILURE;

  std::vector<CGAL::Simple_cartesian<double>::Point_3> result(solid.points.size());
  if(volume.write_back(x, CGAL::make_property_map(result), message) != FFM::Status::success)
    return EXIT_FAILURE;
  for(std::size_t v = 0; v < result.size(); ++v)
    solid.points[v] = {result[v].x(), result[v].y(), result[v].z()};
  return argc < 4 || FFM::write_Medit(argv[3], solid, &message) ? EXIT_SUCCESS : EXIT_FAILURE;
}
