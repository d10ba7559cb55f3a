// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_CONSTRAINTS_H
#define CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_CONSTRAINTS_H

#include <CGAL/Flip_free_maps/constraints/Objective_term.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSeams
/// A seam on the flat arrays: a chain of edges of the surface that was cut open, each of which the map shows twice.
struct Seam
{
  /// The edges in their order: source and target as seen from the left of the chain, then the same two as seen from its right.
  /// The two sides share a vertex where the seam ends inside of the surface.
  std::vector<std::array<std::int32_t, 4>> edges;
  /// Their rest lengths, in the domain's units.
  std::vector<double> lengths;

  /// The sum of the lengths.
  double length() const;
};

/// \ingroup PkgFlipFreeMapsSeams
/// The term that asks the two sides of each seam s to be related by one linear map T = [a b; -b a], which is a similarity, up to
/// a translation (Shtengel et al. 2017, section 5.3, equation 27):
///   weight / 2 sum_k |r_k + y_k|^2 / (l_k L), r_k = (v2 - v1) - T (u2 - u1),
/// over all edges k with rest lengths l_k of sum L, with sides u and v and multipliers y_k; and, if `quarter_turn_weight` is
/// positive, to be a rotation by a multiple of 90 degrees (equation 28):
///   quarter_turn_weight / 2 sum_s (L_s / L) ((a^2 + b^2 - 1)^2 + (a b)^2).
///
/// The pairs (a, b) are unknowns, too: they are the positions of additional vertices without elements, `first_transformation`
/// plus the number of the seam, which may be fixed like others to prescribe T. The matrix is that of Gauss and Newton.
class Seam_constraints : public Objective_term<2>
{
public:
  double weight = 0.1;            ///< of the similarities, not negative
  double quarter_turn_weight = 0; ///< of the quarter turns, not negative

  /// \param seams the seams
  /// \param first_transformation the vertex of which the position is (a, b) of the first seam; those of the others follow
  Seam_constraints(std::vector<Seam> seams, std::int32_t first_transformation);

  /// The vertex of a seam's (a, b).
  std::int32_t transformation(std::size_t s) const { return m_first + static_cast<std::int32_t>(s); }

  /// The seams.
  const std::vector<Seam>& seams() const { return m_seams; }

  /// The vertices of each edge and its seam's (a, b).
  std::vector<std::vector<std::int32_t>> stencils() const override;

  /// Its value.
  double value(const Positions<2>& x) const override;

  /// Its derivatives; the matrix is that of Gauss and Newton.
  void add_derivatives(const Positions<2>& x, Positions<2>& gradient, Term_matrix<2>* matrix) const override;

  /// The greatest |r_k|, over the length of its seam.
  double residual(const Positions<2>& x) const;

  /// Adds the residuals to the multipliers (method of multipliers:
  /// the constraints are met in the limit with the weight as it is).
  void update_multipliers(const Positions<2>& x);

  /// Multiplies the weight of the similarities, leaving the forces that the multipliers exert as they are.
  void scale_weight(double factor);

  /// The (a, b) that relate the sides of a seam best.
  internal::Vector<2> best_transformation(const Positions<2>& x, std::size_t s) const;

  /// T.
  static internal::Matrix<2> transformation_matrix(const internal::Vector<2>& p);

private:
  // The derivative of T d by (a, b).
  static internal::Matrix<2> by_transformation(const internal::Vector<2>& d);

  static internal::Vector<2> quarter_turn_residual(const internal::Vector<2>& p) { return {p.squaredNorm() - 1, p[0] * p[1]}; }

  internal::Vector<2> residual_of(const Positions<2>& x, std::size_t s, std::size_t k) const;

  double weight_of(std::size_t s, std::size_t k) const { return weight / (m_seams[s].lengths[k] * m_length); }

  double quarter_turn_weight_of(std::size_t s) const { return quarter_turn_weight * m_seams[s].length() / m_length; }

  std::vector<Seam> m_seams;
  std::int32_t m_first;
  std::vector<std::vector<internal::Vector<2>>> m_multipliers;
  double m_length = 0;
};

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/seams/Seam_constraints_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_SEAMS_SEAM_CONSTRAINTS_H
