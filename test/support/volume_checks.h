// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_VOLUME_DOMAINS_VOLUME_CHECKS_H
#define CGAL_FLIP_FREE_MAPS_TEST_VOLUME_DOMAINS_VOLUME_CHECKS_H

// A block of tetrahedra that all tests of this folder give to the package in different ways, and numbers that tell whether the
// package sees the same shape.

#include "support/generated_domains.h"

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <system_error>

namespace test_support {

// 3 x 2 x 2 bent cubes, away from the origin, in odd units.
inline Volume block()
{
  return bar(3, 2, 2, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return 7.5 * Eigen::Vector3d(p[0] + 0.1 * std::sin(2 * p[1]), p[1] + 0.15 * p[0] * p[2], 1.3 * p[2] - 0.1 * p[0] * p[0]) +
           Eigen::Vector3d(40, -30, 20);
  });
}

inline FFM::Tetrahedral_mesh as_mesh(const Volume& volume)
{
  FFM::Tetrahedral_mesh mesh;
  for(const Eigen::Vector3d& p : volume.points)
    mesh.points.push_back({p[0], p[1], p[2]});
  for(const auto& t : volume.tetrahedra)
    mesh.tetrahedra.push_back({t[0], t[1], t[2], t[3]});
  return mesh;
}

// Scale, total volume, and the symmetric Dirichlet energy of a fixed curved map, which depends neither on the numbers nor on the
// order of vertices and elements. `place` maps the domain's coordinates to the user's.
struct Fingerprint
{
  double scale = 0;
  double volume = 0;
  double energy = 0;

  Fingerprint() = default;

  template <typename Place>
  Fingerprint(const FFM::Simplicial_domain<3>& domain, Place&& place) : scale(domain.scale)
  {
    FFM::Positions<3> x(3, domain.number_of_vertices);
    for(std::int32_t v = 0; v < domain.number_of_vertices; ++v) {
      const Eigen::Vector3d p = place(domain.rest_points.col(v)) / 10;
      x.col(v) =
        10 / domain.scale * Eigen::Vector3d(1.2 * p[0] + 0.02 * p[1] * p[1], 0.9 * p[1] + 0.2 * p[0], 1.1 * p[2] - 0.03 * p[0] * p[2]);
    }
    for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
      const Eigen::Matrix3d J = domain.jacobian(e, x);
      volume += domain.measures[e];
      energy += domain.measures[e] * (J.squaredNorm() + J.inverse().squaredNorm());
    }
  }

  template <typename VolumeDomain>
  static Fingerprint of(const VolumeDomain& d)
  {
    return Fingerprint(d.domain(), [&d](const Eigen::Vector3d& p) { return d.from_domain(p); });
  }

  // The largest relative difference.
  double distance(const Fingerprint& other) const
  {
    const Eigen::Array3d a(scale, volume, energy), b(other.scale, other.volume, other.energy);
    return ((a - b) / b).abs().maxCoeff();
  }
};

// Of the block, without any class that is tested here.
inline Fingerprint fingerprint_of_block()
{
  const Volume volume = block();
  FFM::Simplicial_domain<3> domain = make_domain(volume);
  domain.rest_points = positions_of<3>(volume, domain.scale);
  return Fingerprint(domain, [&domain](const Eigen::Vector3d& p) -> Eigen::Vector3d { return p * domain.scale; });
}

// A directory that ends with the test.
struct Directory
{
  Directory()
  {
    std::random_device device;
    do
      path = std::filesystem::temp_directory_path() / ("flip_free_maps_volume_" + std::to_string(device()) + std::to_string(device()));
    while(!std::filesystem::create_directory(path));
  }

  ~Directory()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }

  std::string file(const std::string& name) const { return (path / name).string(); }

  std::string write(const std::string& name, const std::string& content) const
  {
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
  }

  std::string read(const std::string& name) const
  {
    std::ifstream stream(file(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }

  std::filesystem::path path;
};

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_VOLUME_DOMAINS_VOLUME_CHECKS_H
