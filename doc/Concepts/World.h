// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

/*!
\ingroup PkgFlipFreeMapsConcepts
\cgalConcept

The concept `World` describes where a mesh is: in one process, or in parts in several. It is all that the minimiser asks of other processes, so
that one minimiser serves both. Traits name it by a type `World` and a member `world`; those that do not work alone.

In a world of several processes each has some vertices that it owns, all elements around them, and as ghosts the other vertices of
these elements. Local numbers begin with the owned vertices. An element that several processes have is counted by one of them, where it is
among the first. A vertex that is held may be known to processes that have no element of it. Vectors of unknowns hold the coordinates of
the owned vertices that are not held.

All processes call the same functions in the same order, and get the same results, to the last bit. So all of them take the same branches.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_free_maps::Mpi_world}
\cgalHasModels{CGAL::Flip_free_maps::Sequential_world}
\cgalHasModelsEnd

\sa `CGAL::Flip_free_maps::WorldConcept`
*/
class World
{
public:
  /// Whether there is only this process; a constant that is known at compile time.
  static constexpr bool is_sequential = true;

  /// Of so many local elements, those that this process counts.
  std::int64_t counted_elements(std::int64_t elements) const;

  /// Of so many local vertices, those that this process owns.
  std::int32_t owned_vertices(std::int32_t vertices) const;

  /// The sum of what the processes have, in an order that does not depend on time.
  double sum(double x) const;

  /// The least of what the processes have; NaN is passed over.
  double minimum(double x) const;

  /// The greatest of what the processes have.
  int maximum(int x) const;

  /// Whether one of the processes has `true`.
  bool any(bool x) const;

  /// The inner product of two vectors of unknowns.
  double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;

  /// The Euclidean norm of a vector of unknowns.
  double norm(const Eigen::VectorXd& a) const;

  /// Tells which vertices are unknowns: for each local vertex its number among the local unknowns, in the order of the vertices, or -1. It
  /// holds for the vectors that follow.
  void number_unknowns(const std::vector<std::int32_t>& numbers);

  /// Whether the first unknown of all processes is one that this process owns.
  bool owns_first_unknown() const;

  /// A vector of unknowns with the entries of ghosts behind, as their owners have them. Where nothing is to be added it is
  /// the argument itself; otherwise it lasts until the next call.
  const Eigen::VectorXd& with_ghosts(const Eigen::VectorXd& owned) const;

  /// Removes the entries of ghosts from a vector of local unknowns.
  void keep_owned(Eigen::VectorXd& vector) const;

  /// Calls `f()`. If it throws in one process, all throw the same: `Interruption` or `std::bad_alloc` if it was that.
  template <typename F>
  void together(F&& f) const;
};
