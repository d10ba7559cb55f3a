// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ELEMENTS_INCREMENT_FORM_H
#define CGAL_FLIP_FREE_MAPS_ELEMENTS_INCREMENT_FORM_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <array>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// Category of preconditioners whose matrix is the same in every iteration: it is factorized once.
struct Constant_matrix_tag
{};

/// \ingroup PkgFlipFreeMapsPreconditioners
/// Category of preconditioners whose matrix depends on the current map: it is factorized as the refactorization rule says.
struct Varying_matrix_tag
{};

/// \ingroup PkgFlipFreeMapsPreconditioners
/// What a preconditioner is told about one element: the signed singular values `s` of its Jacobian J = U diag(s) V^T, and the
/// energy's derivatives there. An isotropic energy needs no more: its second differential and all its proxies are the same for
/// all U and V once the increment is written as dJ = U K V^T (Smith, de Goes and Kim 2019).
template <int D>
struct Element_state
{
  internal::Vector<D> s;        ///< signed singular values, descending
  internal::Vector<D> gradient; ///< psi_i
  internal::Matrix<D> hessian;  ///< psi_ij
};

namespace internal {

// Calls f(p, i, j) for the pairs i < j in the order in which an Increment_form holds them.
template <int D, typename F>
void for_each_pair(F&& f)
{
  int p = 0;
  for(int i = 0; i < D; ++i)
    for(int j = i + 1; j < D; ++j)
      f(p++, i, j);
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsPreconditioners
/// A quadratic form on the increment K = U^T dJ V of one element's Jacobian, in the frame of its singular vectors: the D x D
/// matrix `stretch` acts on the diagonal (K_11, .., K_DD), and one symmetric 2 x 2 matrix on each pair (K_ij, K_ji), i < j.
/// Entries between the two groups vanish for every isotropic energy, so this holds the whole D^2 x D^2 matrix. Pairs are ordered
/// (1,2), (1,3), (2,3).
template <int D>
struct Increment_form
{
  static constexpr int number_of_pairs = D * (D - 1) / 2; ///< 1 in the plane, 3 in space

  /// One symmetric 2 x 2 matrix.
  struct Pair
  {
    double ij_ij = 0; ///< factor of K_ij^2
    double ji_ji = 0; ///< factor of K_ji^2
    double ij_ji = 0; ///< half the factor of K_ij K_ji

    /// Sets the eigenvalues of the modes (K_ij + K_ji) / sqrt 2 and (K_ji - K_ij) / sqrt 2.
    void set_modes(double symmetric, double twist)
    {
      ij_ij = ji_ji = 0.5 * (symmetric + twist);
      ij_ji = 0.5 * (symmetric - twist);
    }
  };

  internal::Matrix<D> stretch;               ///< acts on the diagonal of K
  std::array<Pair, number_of_pairs> pairs{}; ///< act on the pairs of off-diagonal entries of K

  /// The form's matrix times the increment K.
  internal::Matrix<D> multiply(const internal::Matrix<D>& K) const
  {
    internal::Matrix<D> m = internal::Matrix<D>::Zero();
    m.diagonal() = stretch * K.diagonal();
    internal::for_each_pair<D>([&](int p, int i, int j) {
      const Pair& pair = pairs[p];
      m(i, j) = pair.ij_ij * K(i, j) + pair.ij_ji * K(j, i);
      m(j, i) = pair.ij_ji * K(i, j) + pair.ji_ji * K(j, i);
    });
    return m;
  }

  /// The D x D matrix M with y^T M z the form's bilinear value on K = y h^T and K = z g^T. A displacement of a vertex changes K
  /// by the displacement, turned by U^T, times the gradient of its hat function, turned by V^T; so this is the block of two
  /// vertices, in the frame of U, with the turned gradients h and g.
  internal::Matrix<D> block(const internal::Vector<D>& h, const internal::Vector<D>& g) const
  {
    internal::Matrix<D> m = stretch.cwiseProduct(h * g.transpose());
    internal::for_each_pair<D>([&](int p, int i, int j) {
      const Pair& pair = pairs[p];
      m(i, i) += pair.ij_ij * h[j] * g[j];
      m(j, j) += pair.ji_ji * h[i] * g[i];
      m(i, j) += pair.ij_ji * h[j] * g[i];
      m(j, i) += pair.ij_ji * h[i] * g[j];
    });
    return m;
  }
};

namespace internal {

// Second derivative of the energy along one stretch at the identity: constant preconditioners and the Killing operator are
// scaled by it so that the full step is the natural one near an isometry.
template <int D, typename Energy>
double curvature_at_identity(const Energy& energy)
{
  Vector<D> gradient;
  Matrix<D> hessian;
  energy.template derivatives<D>(Vector<D>::Ones(), gradient, hessian);
  return hessian.trace() / D;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ELEMENTS_INCREMENT_FORM_H
