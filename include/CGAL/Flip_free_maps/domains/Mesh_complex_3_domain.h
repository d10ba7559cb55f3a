// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_MESH_COMPLEX_3_DOMAIN_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_MESH_COMPLEX_3_DOMAIN_H

#include <CGAL/Flip_free_maps/domains/Triangulation_3_domain.h>

#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsDomains
/// The cells in a 3D mesh complex, as `CGAL::make_mesh_3()` creates it from any domain. A vertex is named by its handle in the
/// triangulation, which is only read: results go to a property map keyed by the vertex handles.
///
/// \tparam MeshComplex_ must be a model of `MeshComplex_3InTriangulation_3`
template <typename MeshComplex_>
class Mesh_complex_3_domain : public Triangulation_3_domain<typename MeshComplex_::Triangulation>
{
public:
  /// The complex.
  using Mesh_complex = MeshComplex_;
  /// Names a part of the complex.
  using Subdomain_index = typename Mesh_complex::Subdomain_index;
  /// Cells of the triangulation.
  using Cell_handle = typename Mesh_complex::Cell_handle;

  /// Reads all cells in the complex.
  /// \returns as the other overload
  Status load(const Mesh_complex& complex, std::string& message)
  {
    return load_if(
      complex, [](Cell_handle) { return true; }, message);
  }

  /// Reads the cells in one subdomain.
  ///
  /// \param complex the complex
  /// \param subdomain the index that the cells have
  /// \param message receives a sentence on failure
  /// \returns `success`, `empty_mesh`, `non_finite_input`, `degenerate_rest_element` (the message counts the cells in the order
  ///   of the complex) or `several_components`. With `several_components` the domain is complete nevertheless, for uses that hold
  ///   every component.
  ///
  /// Complexity: linear in the size of the triangulation, on average.
  Status load(const Mesh_complex& complex, const Subdomain_index& subdomain, std::string& message)
  {
    return load_if(
      complex, [&](Cell_handle c) { return complex.subdomain_index(c) == subdomain; }, message);
  }

private:
  template <typename CellPredicate>
  Status load_if(const Mesh_complex& complex, const CellPredicate& is_selected, std::string& message)
  {
    this->clear();
    for(auto c = complex.cells_in_complex_begin(); c != complex.cells_in_complex_end(); ++c) {
      const Cell_handle cell = c;
      if(is_selected(cell))
        this->add({cell->vertex(0), cell->vertex(1), cell->vertex(2), cell->vertex(3)});
    }
    return this->finish(this->point_of(complex.triangulation()), message);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_MESH_COMPLEX_3_DOMAIN_H
