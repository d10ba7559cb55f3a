// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SPLITTING_LINEAR_CONSTRAINTS_H
#define CGAL_FLIP_FREE_MAPS_SPLITTING_LINEAR_CONSTRAINTS_H

#include <CGAL/Flip_free_maps/internal/error_message.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSplitting
/// Linear equations that the positions of the vertices must satisfy: sum_v matrix(i, v) x_v = values.row(i) for all rows i, the
/// same coefficients for each coordinate. Positions are in the domain's units. Few rows are meant:
/// each costs a solve and |V| numbers.
template <int D>
struct Linear_constraints
{
  /// Coefficients, a row for each equation, a column for each vertex.
  Eigen::SparseMatrix<double> matrix;
  /// Right-hand sides, a row for each equation.
  Eigen::Matrix<double, Eigen::Dynamic, D> values;

  /// Whether there are no equations.
  bool empty() const { return matrix.rows() == 0; }

  /// Checks sizes and that all numbers are finite; when something is off, says what in `*message` (if given) and returns `false`.
  bool is_valid(std::int32_t number_of_vertices, std::string* message = nullptr) const
  {
    if(values.rows() != matrix.rows())
      return internal::fail(message, "linear constraints must have a row of values for each row of the matrix");
    if(!empty() && matrix.cols() != number_of_vertices)
      return internal::fail(message, "the matrix of the linear constraints must have a column for each vertex");
    for(int v = 0; v < matrix.outerSize(); ++v)
      for(Eigen::SparseMatrix<double>::InnerIterator entry(matrix, v); entry; ++entry)
        if(!std::isfinite(entry.value()))
          return internal::fail(message, "a coefficient of the linear constraints is not finite");
    if(!values.allFinite())
      return internal::fail(message, "a value of the linear constraints is not finite");
    return true;
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SPLITTING_LINEAR_CONSTRAINTS_H
