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

#include <filesystem>
#include <string>
#include <system_error>

namespace test_support {

// 3 x 2 x 2 bent cubes, away from the origin, in odd units.
Volume block();

FFM::Tetrahedral_mesh as_mesh(const Volume& volume);

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
  double distance(const Fingerprint& other) const;
};

// Of the block, without any class that is tested here.
Fingerprint fingerprint_of_block();

// A directory that ends with the test.
struct Directory
{
  Directory();

  ~Directory();

  std::string file(const std::string& name) const { return (path / name).string(); }

  std::string write(const std::string& name, const std::string& content) const;

  std::string read(const std::string& name) const;

  std::filesystem::path path;
};

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_VOLUME_DOMAINS_VOLUME_CHECKS_H
