// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "support/volume_checks.h"

#include <cmath>
#include <fstream>
#include <string>

namespace test_support {

Volume block()
{
  return bar(3, 2, 2, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return 7.5 * Eigen::Vector3d(p[0] + 0.1 * std::sin(2 * p[1]), p[1] + 0.15 * p[0] * p[2], 1.3 * p[2] - 0.1 * p[0] * p[0]) +
           Eigen::Vector3d(40, -30, 20);
  });
}

FFM::Tetrahedral_mesh as_mesh(const Volume& volume)
{
  FFM::Tetrahedral_mesh mesh;
  for(const Eigen::Vector3d& p : volume.points)
    mesh.points.push_back({p[0], p[1], p[2]});
  for(const auto& t : volume.tetrahedra)
    mesh.tetrahedra.push_back({t[0], t[1], t[2], t[3]});
  return mesh;
}

double Fingerprint::distance(const Fingerprint& other) const
{
  const Eigen::Array3d a(scale, volume, energy), b(other.scale, other.volume, other.energy);
  return ((a - b) / b).abs().maxCoeff();
}

Fingerprint fingerprint_of_block()
{
  const Volume volume = block();
  FFM::Simplicial_domain<3> domain = make_domain(volume);
  domain.rest_points = positions_of<3>(volume, domain.scale);
  return Fingerprint(domain, [&domain](const Eigen::Vector3d& p) -> Eigen::Vector3d { return p * domain.scale; });
}

Directory::Directory()
{
  std::random_device device;
  do
    path = std::filesystem::temp_directory_path() / ("flip_free_maps_volume_" + std::to_string(device()) + std::to_string(device()));
  while(!std::filesystem::create_directory(path));
}

Directory::~Directory()
{
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

std::string Directory::write(const std::string& name, const std::string& content) const
{
  std::ofstream(file(name), std::ios::binary) << content;
  return file(name);
}

std::string Directory::read(const std::string& name) const
{
  std::ifstream stream(file(name), std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

} // namespace test_support
