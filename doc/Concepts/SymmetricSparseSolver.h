// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `SymmetricSparseSolver` describes solvers of sparse linear systems with a symmetric positive definite matrix, in
three phases: the pattern is analysed once, the matrix is factorized for each set of values, right-hand sides are solved for
with the last factorization. An iterative solver may take the second phase for the setup of its preconditioner; a distributed
one may distribute the matrix there.

A solver is made by `MapTraits::make_linear_solver()` and used by one thread. It need be neither copyable nor movable. Failures
are reported by the returned values, not by exceptions other than `std::bad_alloc`. When a factorization fails, the package
tries others with a larger diagonal.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_free_maps::Any_linear_solver}
\cgalHasModels{CGAL::Flip_free_maps::Automatic_solver}
\cgalHasModels{CGAL::Flip_free_maps::Block_jacobi}
\cgalHasModels{CGAL::Flip_free_maps::Cholmod_solver}
\cgalHasModels{CGAL::Flip_free_maps::Conjugate_gradient_solver}
\cgalHasModels{CGAL::Flip_free_maps::Distributed_multigrid}
\cgalHasModels{CGAL::Flip_free_maps::Eigen_simplicial_solver}
\cgalHasModels{CGAL::Flip_free_maps::Incomplete_cholesky}
\cgalHasModels{CGAL::Flip_free_maps::Petsc_direct_solver}
\cgalHasModels{CGAL::Flip_free_maps::Petsc_multigrid}
\cgalHasModels{CGAL::Flip_free_maps::Sparse_linear_algebra_solver}
\cgalHasModelsEnd

\sa `CGAL::Flip_free_maps::SymmetricSparseSolverConcept`
*/
class SymmetricSparseSolver
{
public:
  /// The name of the solver in reports. It may depend on what the analysis chose.
  std::string name() const;

  /// The name of the ordering in reports, known after the analysis.
  std::string ordering() const;

  /// Prepares for matrices with the pattern of `matrix`; its values are not to be used.
  /// \returns whether it succeeded
  bool analyze_pattern(const CGAL::Flip_free_maps::Block_sparse_matrix& matrix);

  /// Factorizes a matrix whose pattern is the one that was analysed. The matrix may change after the call.
  /// \returns `false` if the matrix is not positive definite to working precision, or if the factorization failed in another way
  bool factorize(const CGAL::Flip_free_maps::Block_sparse_matrix& matrix);

  /// Solves for one right-hand side with the matrix that was last factorized with success.
  /// \param b the right-hand side, as many entries as the matrix has rows
  /// \param x receives the solution; it is resized by this function and is not the same object as `b`
  /// \returns whether `x` is a solution with finite entries
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Number of stored entries of the factor for reports, -1 if unknown.
  std::int64_t factor_entries() const;

  /// Optional: iterations of the last solve, for reports of iterative solvers.
  int iterations() const;

  /// Optional, for solvers in a `World` of several processes: a constant that is known at compile time. The matrices are then those of the
  /// local unknowns, of which the rows of owned ones are complete; vectors hold the owned ones. All processes call the same functions,
  /// and get the same answers. No other solver is tried when a factorization fails.
  static constexpr bool has_part_of_matrix = true;

  /// Optional, with `set_positions()`: a constant that is known at compile time. `false` is as if there were neither. One without
  /// the other is an error.
  static constexpr bool takes_positions = true;

  /// Optional, for solvers that know what moves without effort: before each factorization it receives the positions of the vertices
  /// that are unknowns, in the order of the matrix' rows, in the map that the matrix is made for. The Killing operator and
  /// the Hessians of distortion, which have a row for each coordinate, nearly vanish on the rigid motions of that map. It is not
  /// called for other matrices, such as those of a start.
  void set_positions(const Eigen::VectorXd& positions);
};
