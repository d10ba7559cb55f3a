// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_WORLDS_SEQUENTIAL_WORLD_H
#define CGAL_FLIP_FREE_MAPS_WORLDS_SEQUENTIAL_WORLD_H

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsWorlds
/// One process that has the whole mesh: what is asked of it is what is given to it. All functions are empty and inline, so that a
/// minimiser in this world costs what it would without the concept.
///
/// \cgalModels{World}
class Sequential_world
{
public:
  static constexpr bool is_sequential = true; ///< nothing is shared with other processes

  /// All of them.
  std::int64_t counted_elements(std::int64_t elements) const { return elements; }
  /// All of them.
  std::int32_t owned_vertices(std::int32_t vertices) const { return vertices; }

  /// Yes.
  bool owns_first_unknown() const { return true; }

  /// \name What all processes have together: that of this one.
  /// @{

  /// The sum.
  double sum(double x) const { return x; }
  /// The least.
  double minimum(double x) const { return x; }
  /// The greatest.
  int maximum(int x) const { return x; }
  /// Whether one has `true`.
  bool any(bool x) const { return x; }
  /// The inner product of vectors of unknowns.
  double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const { return a.dot(b); }
  /// The norm of a vector of unknowns.
  double norm(const Eigen::VectorXd& a) const { return a.norm(); }
  /// @}

  /// Nothing to do: the unknowns are numbered already.
  void number_unknowns(const std::vector<std::int32_t>& /* numbers */) const {}
  /// The vector itself.
  const Eigen::VectorXd& with_ghosts(const Eigen::VectorXd& owned) const { return owned; }
  /// Nothing to do: all of the vector is owned.
  void keep_owned(Eigen::VectorXd& /* vector */) const {}

  /// Calls `f()`.
  template <typename F>
  void together(F&& f) const
  {
    f();
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_WORLDS_SEQUENTIAL_WORLD_H
