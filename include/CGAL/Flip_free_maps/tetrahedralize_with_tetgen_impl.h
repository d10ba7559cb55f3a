// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_WITH_TETGEN_IMPL_H
#define CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_WITH_TETGEN_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/tetrahedralize_with_tetgen.h>

#ifdef CGAL_FLIP_FREE_MAPS_USE_TETGEN

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <iomanip>
#include <locale>
#include <new>
#include <sstream>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE bool Tetgen_options::is_valid(std::string* message) const
{
  if(!(cell_size >= 0.001 && cell_size <= 1))
    return internal::fail(message, "cell_size is not from 0.001 to 1");
  if(radius_edge_ratio != 0 && !(radius_edge_ratio >= 1.2 && std::isfinite(radius_edge_ratio)))
    return internal::fail(message, "radius_edge_ratio is neither 0 nor at least 1.2");
  return true;
}

} // namespace Flip_free_maps
} // namespace CGAL

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void fill_tetgenio(const Closed_surface& surface, tetgenio& input)
{
  const double unit = tetgen_unit(surface);
  input.numberofpoints = static_cast<int>(surface.mesh().number_of_vertices());
  input.pointlist = new REAL[3 * surface.mesh().number_of_vertices()];
  std::size_t i = 0;
  for(const auto v : surface.mesh().vertices())
    for(int k = 0; k < 3; ++k)
      input.pointlist[i++] = surface.mesh().point(v)[k] / unit;

  const std::size_t n = surface.triangles().size();
  input.facetlist = new tetgenio::facet[n];
  for(std::size_t f = 0; f < n; ++f)
    tetgenio::init(&input.facetlist[f]);
  input.numberoffacets = static_cast<int>(n);
  for(std::size_t f = 0; f < n; ++f) {
    tetgenio::facet& facet = input.facetlist[f];
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::init(facet.polygonlist);
    facet.numberofpolygons = 1;
    facet.polygonlist->vertexlist = new int[3];
    facet.polygonlist->numberofvertices = 3;
    for(int k = 0; k < 3; ++k)
      facet.polygonlist->vertexlist[k] = surface.triangles()[f][k];
  }
}

CGAL_FLIP_FREE_MAPS_INLINE std::string tetgen_switches(const Closed_surface& surface, const Tetgen_options& options)
{
  std::string switches = "pYQ";
  const auto add = [&switches](char name, double value) {
    std::ostringstream digits;
    digits.imbue(std::locale::classic());
    digits << std::fixed << std::setprecision(15) << value;
    switches += name + digits.str();
  };
  if(options.radius_edge_ratio != 0)
    add('q', options.radius_edge_ratio);
  if(options.cell_size < 1) {
    const double edge = options.cell_size * surface.diagonal() / tetgen_unit(surface);
    add('a', edge * edge * edge / std::sqrt(72.));
  }
  return switches;
}

CGAL_FLIP_FREE_MAPS_INLINE int run_tetgen(const Closed_surface& surface, const Tetgen_options& options, std::string& bytes)
{
  try {
    tetgenio input, output;
    fill_tetgenio(surface, input);
    std::string switches = tetgen_switches(surface, options);
    ::tetrahedralize(&switches[0], &input, &output);
    const int counts[3] = {output.numberofpoints, output.numberoftetrahedra, output.firstnumber};
    bytes.assign(reinterpret_cast<const char*>(counts), sizeof(counts));
    if(counts[1] == 0 || output.numberofcorners != 4)
      return 0;
    bytes.append(reinterpret_cast<const char*>(output.pointlist), sizeof(double) * 3 * counts[0]);
    bytes.append(reinterpret_cast<const char*>(output.tetrahedronlist), sizeof(int) * 4 * counts[1]);
    return 0;
  } catch(const std::bad_alloc&) {
    return 1;
  } catch(int code) {
    return code > 0 && code < 200 ? code : 2;
  }
}

CGAL_FLIP_FREE_MAPS_INLINE bool unpack_tetgen(const Closed_surface& surface, const std::string& bytes, Tetrahedral_mesh& mesh)
{
  int counts[3];
  if(bytes.size() < sizeof(counts))
    return false;
  std::memcpy(counts, bytes.data(), sizeof(counts));
  static_assert(sizeof(std::array<double, 3>) == 3 * sizeof(double) && sizeof(std::array<int, 4>) == 4 * sizeof(int),
                "arrays without padding");
  if(counts[0] < static_cast<int>(surface.mesh().number_of_vertices()) || counts[1] < 1)
    return false;
  mesh.points.resize(counts[0]);
  mesh.tetrahedra.resize(counts[1]);
  const std::size_t point_bytes = mesh.points.size() * sizeof(mesh.points[0]);
  const std::size_t tetrahedron_bytes = mesh.tetrahedra.size() * sizeof(mesh.tetrahedra[0]);
  if(bytes.size() != sizeof(counts) + point_bytes + tetrahedron_bytes)
    return false;
  std::memcpy(mesh.points.data(), bytes.data() + sizeof(counts), point_bytes);
  std::memcpy(mesh.tetrahedra.data(), bytes.data() + sizeof(counts) + point_bytes, tetrahedron_bytes);
  for(std::array<double, 3>& point : mesh.points)
    for(double& coordinate : point)
      coordinate *= tetgen_unit(surface);
  for(std::array<int, 4>& tetrahedron : mesh.tetrahedra)
    for(int& v : tetrahedron)
      v -= counts[2];
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE Status tetgen_failure(int code, std::string& message)
{
  switch(code) {
  case 1:
    message = "not enough memory for so many tetrahedra";
    return Status::out_of_memory;
  case 3:
    message = "TetGen found a self-intersection of the surface";
    return Status::non_manifold;
  default:
    message = "TetGen gave up: details of the surface are too small or too close to each other for it";
    return Status::degenerate_rest_element;
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_TETGEN

#endif // CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZE_WITH_TETGEN_IMPL_H
