// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_CONSTRAINTS_OBJECTIVE_TERM_H
#define CGAL_FLIP_FREE_MAPS_CONSTRAINTS_OBJECTIVE_TERM_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsConstraints
/// Where an `Objective_term` enters its part of the matrix. Blocks of fixed vertices, which are no unknowns, are left out.
template <int D>
class Term_matrix
{
public:
  /// Enters into `matrix`, in which vertex v has the block of rows number `rows[v]`, none if that is negative. Where `projection_of`,
  /// if it is given, is not null, the vertex moves in some directions only, and its rows and columns are projected on them.
  Term_matrix(Block_sparse_matrix& matrix, const std::vector<std::int32_t>& rows,
              std::function<const internal::Matrix<D>*(std::int32_t)> projection_of = nullptr)
    : m_matrix(matrix), m_rows(rows), m_projection_of(std::move(projection_of))
  {}

  /// Adds `block(i, j)` to row i of vertex v and column j of vertex w, and, if v and w differ, its transpose to the mirrored
  /// block. The two must be of one stencil of the term: for a pair that is in no stencil the matrix has no place, and nothing is
  /// added.
  void add(std::int32_t v, std::int32_t w, const internal::Matrix<D>& block)
  {
    if(!is_vertex(v) || !is_vertex(w)) {
      m_has_refused = true;
      return;
    }
    const std::int32_t r = m_rows[v], c = m_rows[w];
    if(r < 0 || c < 0)
      return;
    const std::int32_t slot = r == c ? 0 : m_matrix.slot(r, c);
    if(slot >= 0)
      m_matrix.add_block(r, c, slot, projected(v, w, block));
    else
      m_has_refused = true;
  }

  /// Whether a block was left out since there is no place for it.
  bool has_refused() const { return m_has_refused; }

private:
  bool is_vertex(std::int32_t v) const { return v >= 0 && static_cast<std::size_t>(v) < m_rows.size(); }

  internal::Matrix<D> projected(std::int32_t v, std::int32_t w, internal::Matrix<D> block) const
  {
    if(m_projection_of == nullptr)
      return block;
    if(const internal::Matrix<D>* P = m_projection_of(v))
      block = (*P * block).eval();
    if(const internal::Matrix<D>* P = m_projection_of(w))
      block = (block * *P).eval();
    return block;
  }

  Block_sparse_matrix& m_matrix;
  const std::vector<std::int32_t>& m_rows;
  std::function<const internal::Matrix<D>*(std::int32_t)> m_projection_of;
  bool m_has_refused = false;
};

/// \ingroup PkgFlipFreeMapsConstraints
/// A term that is minimised along with the mean energy of the elements: the base class of soft constraints. A term is a function
/// of the positions of the vertices, in the domain's units.
template <int D>
class Objective_term
{
public:
  virtual ~Objective_term() = default;

  /// Whether the term does not change when the whole map is translated or rotated.
  virtual bool is_rigid_motion_invariant() const { return false; }

  /// The groups of vertices whose blocks the term's matrix couples; single vertices need not be listed. A run whose matrix gets
  /// blocks of other pairs ends with the status `invalid_option`.
  virtual std::vector<std::vector<std::int32_t>> stencils() const { return {}; }

  /// Its value.
  virtual double value(const Positions<D>& x) const = 0;

  /// Adds its gradient to `gradient` and, unless `matrix` is null,
  /// a positive semidefinite approximation of its Hessian to `*matrix`.
  virtual void add_derivatives(const Positions<D>& x, Positions<D>& gradient, Term_matrix<D>* matrix) const = 0;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_CONSTRAINTS_OBJECTIVE_TERM_H
