// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CUTTING_CUT_SUMMARY_H
#define CGAL_FLIP_FREE_MAPS_CUTTING_CUT_SUMMARY_H

#include <CGAL/Flip_free_maps/report/Outcome.h>

#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSeams
/// The account of `cut_to_disk()`.
struct Cut_summary : Outcome
{
  int components = 0;               ///< connected components of the mesh
  int borders = 0;                  ///< borders of the mesh, of all components
  int genus = 0;                    ///< handles of the mesh, of all components
  int pieces = 0;                   ///< connected components of the cut surface;
                                    ///< more than `components` where the user's seams part one
  int borders_of_pieces = 0;        ///< borders of the cut surface: `pieces` if all of these are disks
  int points = 0;                   ///< extremities, peaks or far points that seams were led to
  std::int64_t user_seam_edges = 0; ///< seam edges that were there before
  std::int64_t seam_edges = 0;      ///< seam edges, those of the user included; edges on the mesh' border do not count
  double seam_length = 0;           ///< length of the seam edges, in the units of the mesh
  double expected_energy = -1;      ///< estimate of the mean symmetric Dirichlet energy of maps of the pieces,
                                    ///< -1 where none was made
  double seconds = 0;               ///< wall-clock seconds

  /// Calls `visit(name, value)` for each field.
  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    const Field_role if_valid = is_valid() ? Field_role::shown : Field_role::detail;
    Outcome::for_each_field(visit);
    visit("components", components, if_valid);
    visit("borders", borders, if_valid);
    visit("genus", genus, if_valid);
    visit("pieces", pieces, if_valid);
    visit("borders_of_pieces", borders_of_pieces, if_valid);
    visit("points", points, if_valid);
    visit("user_seam_edges", user_seam_edges, Field_role::detail);
    visit("seam_edges", seam_edges, if_valid);
    visit("seam_length", seam_length, if_valid);
    visit("expected_energy", expected_energy, if_valid);
    visit("seconds", seconds, if_valid);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CUTTING_CUT_SUMMARY_H
