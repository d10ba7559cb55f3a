// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "solid_fields.h"

#include "../formats/volume_files.h"
#include <CGAL/Flip_free_maps/domains/Map_measure.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

namespace program {

Solid_input read_solid(const std::string& path, bool with_second_order)
{
  Solid_input input;
  std::string error = read_volume_file(path, input.file);
  check(error.empty(), error);
  error = take_solid(input.file, with_second_order, input.solid);
  check(error.empty(), "cannot read " + path + ": " + error);
  return input;
}

double distortion_of(const Eigen::Vector3d& singular_values)
{
  return singular_values[2] > 0 ? (std::min)(FFM::Symmetric_dirichlet().value<3>(singular_values), 1e30) : 1e30;
}

std::vector<Eigen::Vector3d> singular_values_of(const FFM::Simplicial_domain<3>& domain, const FFM::Tetrahedral_domain& numbers,
                                                const std::vector<Kernel::Point_3>& points)
{
  FFM::Positions<3> x(3, domain.number_of_vertices);
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v) {
    const Kernel::Point_3& p = points[numbers.vertices()[v]];
    x.col(v) = numbers.to_domain(Eigen::Vector3d(p.x(), p.y(), p.z()));
  }
  const FFM::Map_measure<3> measure(domain);
  std::vector<Eigen::Vector3d> result;
  for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
    result.push_back(measure.singular_values(x, e));
  return result;
}

namespace {

using Corners = std::array<int, 3>;

Corners sorted(Corners corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

// For each cell the tetrahedron whose values it has, or -1.
std::vector<std::ptrdiff_t> owners_of(const Solid& solid, const Cells& cells)
{
  std::vector<std::ptrdiff_t> owners(cells.size(), -1);
  std::multimap<Corners, std::size_t> triangles;
  for(std::size_t i = 0; i < cells.size(); ++i)
    if(cells.types[i] == cell_type::TRIANGLE || cells.types[i] == cell_type::QUADRATIC_TRIANGLE) {
      const int* nodes = cells.nodes.data() + cells.begin(i);
      triangles.emplace(sorted({nodes[0], nodes[1], nodes[2]}), i);
    }
  for(std::size_t t = 0; t < solid.cells.size(); ++t) {
    owners[solid.cells[t]] = static_cast<std::ptrdiff_t>(t);
    const std::array<int, 4>& corners = solid.mesh.tetrahedra[t];
    for(int k = 0; k < 4 && !triangles.empty(); ++k) {
      const auto range = triangles.equal_range(sorted({corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4]}));
      for(auto triangle = range.first; triangle != range.second; ++triangle)
        if(owners[triangle->second] < 0)
          owners[triangle->second] = static_cast<std::ptrdiff_t>(t);
    }
  }
  return owners;
}

} // namespace

void add_solid_fields(const Solid& solid, const std::vector<Eigen::Vector3d>& singular_values,
                      const std::vector<std::array<double, 3>>& points, const std::vector<std::size_t>& handles, Volume_file& file)
{
  std::vector<double> displacement;
  std::vector<std::int64_t> is_handle(points.size(), 0), is_on_boundary(points.size(), 0);
  for(std::size_t v = 0; v < points.size(); ++v)
    for(int c = 0; c < 3; ++c)
      displacement.push_back(points[v][c] - file.points[v][c]);
  for(const std::size_t v : handles)
    is_handle[v] = 1;
  for(const Corners& triangle : FFM::boundary_triangles(solid.mesh))
    for(const int v : triangle)
      is_on_boundary[v] = 1;
  set_array(file.point_data, real_array("displacement", 3, std::move(displacement)));
  set_array(file.point_data, integer_array("handle", Number_type::uint8, std::move(is_handle)));
  set_array(file.point_data, integer_array("boundary", Number_type::uint8, std::move(is_on_boundary)));

  std::vector<double> energies, ratios, stretches;
  for(const std::ptrdiff_t owner : owners_of(solid, file.cells)) {
    const Eigen::Vector3d s = owner < 0 ? Eigen::Vector3d::Zero().eval() : singular_values[owner];
    energies.push_back(owner < 0 ? 0 : distortion_of(s));
    ratios.push_back(s.prod());
    stretches.insert(stretches.end(), s.data(), s.data() + 3);
  }
  set_array(file.cell_data, real_array("symmetric_dirichlet_energy", 1, std::move(energies)));
  set_array(file.cell_data, real_array("volume_ratio", 1, std::move(ratios)));
  set_array(file.cell_data, real_array("singular_values", 3, std::move(stretches)));
}

} // namespace program
