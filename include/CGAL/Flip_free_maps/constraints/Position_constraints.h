// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CONSTRAINTS_POSITION_CONSTRAINTS_H
#define CGAL_FLIP_FREE_MAPS_CONSTRAINTS_POSITION_CONSTRAINTS_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/internal/error_message.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsConstraints
/// Pulls one vertex towards a place: adds `weight` |x_v - target|^2 to the mean energy. Lengths are in the domain's units, in
/// which the total measure is 1, so a weight means the same on every mesh.
template <int D>
struct Soft_position
{
  std::int32_t vertex;        ///< number of the vertex
  internal::Vector<D> target; ///< where it is pulled to
  double weight;              ///< how strongly, not negative
};

/// \ingroup PkgFlipFreeMapsRef
/// A vertex that keeps to a line, or in space to a plane, through its position in the start.
template <int D>
struct Sliding_vertex
{
  std::int32_t vertex;            ///< number of the vertex
  internal::Matrix<D> projection; ///< the orthogonal projection on the directions in which it moves

  /// One that keeps to a line with a direction, which is not zero.
  static Sliding_vertex along(std::int32_t vertex, const internal::Vector<D>& direction)
  {
    return {vertex, direction * direction.transpose() / direction.squaredNorm()};
  }

  /// One that keeps to what is normal to a vector, which is not zero: a plane in space.
  static Sliding_vertex normal_to(std::int32_t vertex, const internal::Vector<D>& normal)
  {
    return {vertex, internal::Matrix<D>::Identity() - normal * normal.transpose() / normal.squaredNorm()};
  }
};

/// \ingroup PkgFlipFreeMapsConstraints
/// What is asked of the positions of single vertices.
template <int D>
struct Position_constraints
{
  /// Vertices that keep the positions that they have in the start, exactly: they are no unknowns. Duplicates do no harm.
  std::vector<std::int32_t> fixed_vertices;
  /// Vertices that are pulled to places.
  std::vector<Soft_position<D>> soft_positions;
  /// Vertices that move in some directions only, each named once; one that is fixed, too, is fixed. Only `Map_minimizer` knows them:
  /// repair and the splitting scheme do not.
  std::vector<Sliding_vertex<D>> sliding_vertices;

  /// Whether nothing is asked.
  bool empty() const { return fixed_vertices.empty() && soft_positions.empty() && sliding_vertices.empty(); }

  /// Checks the vertices' numbers, targets, weights and projections; when one is off, says which in `*message` (if given) and returns `false`.
  bool is_valid(std::int32_t number_of_vertices, std::string* message = nullptr) const;

private:
  static constexpr double PROJECTION_TOLERANCE = 1e-12;
};

template <int D>
bool Position_constraints<D>::is_valid(std::int32_t number_of_vertices, std::string* message) const
{
  for(std::int32_t v : fixed_vertices)
    if(v < 0 || v >= number_of_vertices)
      return internal::fail(message,
                            "a fixed vertex has the number " + std::to_string(v) + ", but there are " + std::to_string(number_of_vertices));
  for(std::size_t i = 0; i < soft_positions.size(); ++i) {
    const Soft_position<D>& soft = soft_positions[i];
    const auto fail = [&](const std::string& what) { // Users whose vertices have no numbers know the entry.
      return internal::fail(message, "soft position number " + std::to_string(i) + ", of vertex number " + std::to_string(soft.vertex) +
                                       ", " + what);
    };
    if(soft.vertex < 0 || soft.vertex >= number_of_vertices)
      return fail("but there are " + std::to_string(number_of_vertices) + " vertices");
    if(!soft.target.allFinite())
      return fail("is not finite");
    if(!(soft.weight >= 0) || !std::isfinite(soft.weight))
      return fail("has a weight that is negative or not finite");
  }
  for(const Sliding_vertex<D>& sliding : sliding_vertices) {
    const auto fail = [&](const std::string& what) {
      return internal::fail(message, "a sliding vertex has the number " + std::to_string(sliding.vertex) + ", " + what);
    };
    if(sliding.vertex < 0 || sliding.vertex >= number_of_vertices)
      return fail("but there are " + std::to_string(number_of_vertices));
    const internal::Matrix<D>& P = sliding.projection;
    if(!P.allFinite() || !(P - P.transpose()).isZero(PROJECTION_TOLERANCE) || !(P * P - P).isZero(PROJECTION_TOLERANCE))
      return fail("and a matrix that is no orthogonal projection");
  }
  return true;
}

namespace internal {

// For methods that know no sliding vertices.
template <int D>
bool has_no_sliding_vertices(const Position_constraints<D>& constraints, std::string* message)
{
  return constraints.sliding_vertices.empty() || fail(message, "sliding vertices are known to `Map_minimizer` only");
}

} // namespace internal

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template struct Position_constraints<2>;
extern template struct Position_constraints<3>;
#endif

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CONSTRAINTS_POSITION_CONSTRAINTS_H
