// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CONSTRAINTS_SOFT_POSITIONS_H
#define CGAL_FLIP_FREE_MAPS_CONSTRAINTS_SOFT_POSITIONS_H

#include <CGAL/Flip_free_maps/constraints/Objective_term.h>
#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsConstraints
/// The term sum_v w_v |x_v - target_v|^2.
template <int D>
class Soft_positions : public Objective_term<D>
{
public:
  /// Takes the soft positions of `constraints`.
  explicit Soft_positions(std::vector<Soft_position<D>> positions) : m_positions(std::move(positions)) {}

  /// Its value.
  double value(const Positions<D>& x) const override;

  /// Its derivatives; the matrix is exact.
  void add_derivatives(const Positions<D>& x, Positions<D>& gradient, Term_matrix<D>* matrix) const override;

  /// The greatest distance of a vertex from its target, in the domain's units.
  double residual(const Positions<D>& x) const;

  /// Multiplies all weights.
  void scale_weights(double factor)
  {
    for(Soft_position<D>& soft : m_positions)
      soft.weight *= factor;
  }

private:
  std::vector<Soft_position<D>> m_positions;
};

template <int D>
double Soft_positions<D>::value(const Positions<D>& x) const
{
  double sum = 0;
  for(const Soft_position<D>& soft : m_positions)
    sum += soft.weight * (x.col(soft.vertex) - soft.target).squaredNorm();
  return sum;
}

template <int D>
void Soft_positions<D>::add_derivatives(const Positions<D>& x, Positions<D>& gradient, Term_matrix<D>* matrix) const
{
  for(const Soft_position<D>& soft : m_positions) {
    gradient.col(soft.vertex) += 2 * soft.weight * (x.col(soft.vertex) - soft.target);
    if(matrix != nullptr)
      matrix->add(soft.vertex, soft.vertex, 2 * soft.weight * internal::Matrix<D>::Identity());
  }
}

template <int D>
double Soft_positions<D>::residual(const Positions<D>& x) const
{
  double largest = 0;
  for(const Soft_position<D>& soft : m_positions)
    largest = (std::max)(largest, (x.col(soft.vertex) - soft.target).norm());
  return largest;
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template class Soft_positions<2>;
extern template class Soft_positions<3>;
#endif

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CONSTRAINTS_SOFT_POSITIONS_H
