// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "support/generated_domains.h"

#include <Eigen/QR>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace test_support {

template <int D>
Eigen::Matrix<double, D, D> Random::rotation()
{
  const Eigen::HouseholderQR<Eigen::Matrix<double, D, D>> qr(matrix<D>());
  Eigen::Matrix<double, D, D> result = qr.householderQ();
  if(result.determinant() < 0)
    result.col(0) *= -1;
  return result;
}

template Eigen::Matrix2d Random::rotation<2>();
template Eigen::Matrix3d Random::rotation<3>();

Eigen::VectorXd Random::vector(Eigen::Index size, double low, double high)
{
  Eigen::VectorXd result(size);
  for(Eigen::Index i = 0; i < size; ++i)
    result[i] = (*this)(low, high);
  return result;
}

Surface bumpy_patch(int columns, int rows, double height)
{
  return grid(columns, rows, [height](double u, double v) {
    return Eigen::Vector3d(1.3 * u, v, height * std::sin(2.1 * pi * u + 0.3) * std::cos(1.7 * pi * v + 0.1));
  });
}

Surface cylinder_patch(int columns, int rows)
{
  return grid(columns, rows, [](double u, double v) {
    const double angle = 1.6 * pi * u;
    return Eigen::Vector3d(std::cos(angle), std::sin(angle), 1.5 * v);
  });
}

Surface cone_patch(int columns, int rows)
{
  return grid(columns, rows, [](double u, double v) {
    const double angle = 1.5 * pi * u, radius = 2 - 1.5 * v;
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), -0.8 * radius);
  });
}

Surface bent_sheet(int columns, int rows)
{
  return grid(
    columns, rows, [](double u, double v) { return Eigen::Vector3d(2 * u, v, 0.4 * std::sin(5 * u)); }, true);
}

Surface closed_tube(int around, int rings)
{
  Surface surface;
  const double radius = 0.5 / std::sin(pi / around);
  for(int r = 0; r <= rings; ++r)
    for(int i = 0; i < around; ++i) {
      const double angle = 2 * pi * i / around;
      surface.points.push_back({radius * std::cos(angle), radius * std::sin(angle), static_cast<double>(r)});
    }
  const std::int32_t apex = static_cast<std::int32_t>(surface.points.size());
  surface.points.push_back({0, 0, rings + 0.5});
  for(int r = 0; r <= rings; ++r)
    for(int i = 0; i < around; ++i) {
      const std::int32_t a = r * around + i, b = r * around + (i + 1) % around;
      if(r == rings) {
        surface.triangles.push_back({a, b, apex});
        continue;
      }
      surface.triangles.push_back({a, b, b + around});
      surface.triangles.push_back({a, b + around, a + around});
    }
  return surface;
}

FFM::Simplicial_domain<2> make_domain(const Surface& surface)
{
  std::vector<Eigen::Matrix2d> rest_edges;
  std::map<std::int32_t, std::int32_t> next;
  std::map<std::pair<std::int32_t, std::int32_t>, int> halfedges;
  for(const auto& t : surface.triangles) {
    const Eigen::Vector3d a = surface.points[t[1]] - surface.points[t[0]], b = surface.points[t[2]] - surface.points[t[0]];
    Eigen::Matrix2d edges;
    edges << a.norm(), a.dot(b) / a.norm(), 0, a.cross(b).norm() / a.norm();
    rest_edges.push_back(edges);
    for(int k = 0; k < 3; ++k)
      ++halfedges[{t[k], t[(k + 1) % 3]}];
  }
  auto domain = scaled_domain<2>(static_cast<std::int32_t>(surface.points.size()), surface.triangles, rest_edges);
  domain.rest_points.resize(3, surface.points.size());
  for(std::size_t v = 0; v < surface.points.size(); ++v)
    domain.rest_points.col(v) = surface.points[v] / domain.scale;
  for(const auto& h : halfedges)
    if(halfedges.count({h.first.second, h.first.first}) == 0)
      next[h.first.first] = h.first.second;
  if(next.empty())
    return domain;
  std::int32_t v = next.begin()->first;
  do {
    domain.border.push_back(v);
    domain.border_lengths.push_back((surface.points[next[v]] - surface.points[v]).norm() / domain.scale);
    v = next[v];
  } while(v != domain.border.front());
  return domain;
}

FFM::Simplicial_domain<3> make_domain(const Volume& volume)
{
  std::vector<Eigen::Matrix3d> rest_edges;
  for(const auto& t : volume.tetrahedra) {
    Eigen::Matrix3d edges;
    for(int k = 0; k < 3; ++k)
      edges.col(k) = volume.points[t[k + 1]] - volume.points[t[0]];
    rest_edges.push_back(edges);
  }
  return scaled_domain<3>(static_cast<std::int32_t>(volume.points.size()), volume.tetrahedra, rest_edges);
}

Distorted_example<2>::Distorted_example(int columns, int rows)
{
  Random random(17);
  const Surface surface = bumpy_patch(columns, rows, 0.4);
  domain = make_domain(surface);
  x = positions_of<2>(surface, domain.scale);
  const double length = 0.2 / (columns > rows ? columns : rows);
  for(Eigen::Index i = 0; i < x.size(); ++i)
    x.data()[i] += random(-length, length);
  const double angle = 0.7;
  Eigen::Matrix2d turned;
  turned << 1.4 * std::cos(angle), -0.8 * std::sin(angle), 1.4 * std::sin(angle), 0.8 * std::cos(angle);
  x = (turned * x).eval();
}

Distorted_example<3>::Distorted_example(int nx, int ny, int nz)
{
  Random random(18);
  const Volume volume = bar(nx, ny, nz, [&random](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return p + 0.1 * Eigen::Vector3d(random(-1, 1), random(-1, 1), random(-1, 1));
  });
  domain = make_domain(volume);
  x = positions_of<3>(volume, domain.scale);
  const double length = 0.1 / domain.scale;
  for(Eigen::Index i = 0; i < x.size(); ++i)
    x.data()[i] += random(-length, length);
  x = (random.rotation<3>() * Eigen::Vector3d(1.4, 1, 0.8).asDiagonal() * random.rotation<3>() * x).eval();
}

} // namespace test_support
