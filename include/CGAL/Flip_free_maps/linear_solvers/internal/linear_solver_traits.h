// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_LINEAR_SOLVER_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_LINEAR_SOLVER_TRAITS_H

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

template <typename Solver, typename = void>
struct Is_iterative : std::false_type
{};

template <typename Solver>
struct Is_iterative<Solver, std::void_t<decltype(std::declval<const Solver&>().iterations())>> : std::true_type
{};

// Iterations of an iterative solver's last solve, 0 for a direct one.
template <typename Solver>
int inner_iterations(const Solver& solver)
{
  if constexpr(Is_iterative<Solver>::value)
    return solver.iterations();
  static_cast<void>(solver);
  return 0;
}

template <typename Solver, typename = void>
struct Takes_memory_budget : std::false_type
{};

template <typename Solver>
struct Takes_memory_budget<Solver, std::enable_if_t<Solver::takes_memory_budget>> : std::true_type
{};

// A solver with a budget of memory, in bytes, if it can be told one; 0 leaves it to the solver.
template <typename Solver>
Solver make_solver(double memory_budget)
{
  static_cast<void>(memory_budget);
  if constexpr(Takes_memory_budget<Solver>::value)
    return Solver(memory_budget);
  else
    return Solver();
}

// Whether a solver has a part of the matrix only, the rows of the unknowns that this process owns.
template <typename Solver, typename = void>
struct Has_part_of_matrix : std::false_type
{};

template <typename Solver>
struct Has_part_of_matrix<Solver, std::enable_if_t<Solver::has_part_of_matrix>> : std::true_type
{};

template <typename Solver, typename = void>
struct Takes_positions : std::false_type
{};

template <typename Solver>
struct Takes_positions<Solver, std::enable_if_t<Solver::takes_positions>> : std::true_type
{};

// Tells a solver the positions of the unknown vertices in the map that its next matrix is made for, if it wants to know:
// `positions()` returns the vector of them, and is not called otherwise.
template <typename Solver, typename F>
void give_positions(Solver& solver, F&& positions)
{
  static_cast<void>(solver);
  static_cast<void>(positions);
  if constexpr(Takes_positions<Solver>::value)
    solver.set_positions(positions());
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_INTERNAL_LINEAR_SOLVER_TRAITS_H
