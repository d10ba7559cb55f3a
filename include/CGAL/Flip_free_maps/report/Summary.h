// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPORT_SUMMARY_H
#define CGAL_FLIP_FREE_MAPS_REPORT_SUMMARY_H

#include <CGAL/Flip_free_maps/report/Outcome.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Wall-clock seconds that a run spent in each of its phases.
struct Phase_seconds
{
  double load = 0;        ///< reading the mesh and its points into flat arrays
  double start = 0;       ///< computing and certifying the start
  double assemble = 0;    ///< gradient and matrix
  double analyze = 0;     ///< ordering and symbolic factorization
  double factorize = 0;   ///< numeric factorizations
  double solve = 0;       ///< triangular solves
  double line_search = 0; ///< largest steps and energies along directions
  double certify = 0;     ///< exact predicates on accepted maps
  double total = 0;       ///< everything, from the mesh in memory to the written map

  /// Calls `visit(name, value)` for each field.
  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    visit("load", load);
    visit("start", start);
    visit("assemble", assemble);
    visit("analyze", analyze);
    visit("factorize", factorize);
    visit("solve", solve);
    visit("line_search", line_search);
    visit("certify", certify);
    visit("total", total);
  }
};

/// \ingroup PkgFlipFreeMapsRef
/// The account of a run: how it ended, what it cost, and what was used. Fields that a run did not reach keep their initial
/// values (-1 for counts and energies), so an unset field can be recognised.
struct Summary : Outcome
{
  int dimension = 2;                        ///< 2 for maps of triangles, 3 for maps of tetrahedra
  std::int64_t vertices = -1;               ///< vertices of the mapped component
  std::int64_t elements = -1;               ///< triangles or tetrahedra of the mapped component
  int iterations = 0;                       ///< accepted steps
  int factorizations = 0;                   ///< numeric factorizations, failed ones included
  int linear_solves = 0;                    ///< right-hand sides solved
  int inner_iterations = 0;                 ///< iterations of iterative linear solvers
  int energy_evaluations = 0;               ///< evaluations of the energy along directions
  int fallbacks = 0;                        ///< iterations in which `Newton` projected the Hessian
  double energy_initial = -1;               ///< mean energy of the start (symmetric Dirichlet: an isometry has 1); -1
                                            ///< where it has flips and the energy is infinite on them
  double energy = -1;                       ///< mean energy of the result
  double energy_of_terms = 0;               ///< the part of `energy` that terms beside the elements contribute,
                                            ///< soft positions for example
  double gradient_norm = -1;                ///< Euclidean norm of the gradient at the end, on the mesh scaled to measure 1
  double characteristic_gradient_norm = -1; ///< the same over the characteristic gradient (see `Map_options`)
  double min_singular_value = -1;           ///< smallest singular value over all elements
  double max_singular_value = -1;           ///< largest singular value over all elements
  std::optional<bool> is_bijective;         ///< whether the image does not overlap itself; without a value when nobody asked
  std::int64_t flips = -1;                  ///< elements that are not positively oriented, by exact predicates
  Phase_seconds seconds;                    ///< wall-clock seconds by phase
  double cpu_seconds = 0;                   ///< CPU seconds of `seconds.total`, in all threads that worked for it
  double factorize_cpu_seconds = 0;         ///< CPU seconds of the numeric factorizations
  std::int64_t factor_entries = -1;         ///< nonzeros of the factor
  double peak_memory_mb = -1;               ///< peak resident memory of the process in MiB, -1 where it cannot be known
  std::string linear_solver;                ///< the solver that did the work, fallbacks included
  std::string ordering;                     ///< the fill-reducing ordering that was kept
  std::string start;                        ///< the start that was used, fallbacks included
  std::string energy_name;                  ///< name of the energy
  std::string preconditioner;               ///< name of the preconditioner
  std::string reference;                    ///< name of the reference
  std::string acceleration;                 ///< name of the acceleration
  /// Faces whose corners are on a line, up to rounding, or at less than three places. Their rest shapes are thin triangles instead,
  /// which count as such in the energy and among the singular values.
  std::int64_t faces_without_area = 0;
  std::vector<std::int64_t> first_faces_without_area; ///< the numbers of the first ten of them

  /// Elements that no map can have without flips: all of their vertices are held.
  std::vector<std::int64_t> impossible_elements;
  /// Edges inside a solid whose ends are held on one flat side of the target.
  std::vector<std::array<std::int32_t, 2>> impossible_edges;
  /// Where flips remain: the flipped elements of the best map that was found.
  std::vector<std::int64_t> flipped_elements;

  /// `true` when a stopping rule was met. A map is valid, but not converged, when a limit or the observer ended the run.
  bool converged() const { return status == Status::success; }

  /// The CPU seconds of the run in those of one factorization; 0 when it factorized nothing.
  double factorization_units() const
  {
    return factorizations > 0 && factorize_cpu_seconds > 0 ? cpu_seconds * factorizations / factorize_cpu_seconds : 0;
  }

  /// Calls `visit(name, value)` for each field. The elements are `faces` or `tetrahedra`.
  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    constexpr Field_role DETAIL = Field_role::detail;
    Outcome::for_each_field(visit);
    visit("converged", converged(), DETAIL);
    visit("dimension", dimension, DETAIL);
    visit("vertices", vertices);
    visit(dimension == 3 ? "tetrahedra" : "faces", elements);
    visit("flips", flips);
    visit("faces_without_area", faces_without_area, faces_without_area > 0 ? Field_role::shown : DETAIL);
    visit("first_faces_without_area", first_faces_without_area, DETAIL);
    visit("bijective", is_bijective);
    visit("impossible_elements", impossible_elements, DETAIL);
    visit("impossible_edges", impossible_edges, DETAIL);
    visit("flipped_elements", flipped_elements, DETAIL);
    visit("energy_initial", energy_initial);
    visit("energy", energy);
    visit("energy_of_terms", energy_of_terms, energy_of_terms != 0 ? Field_role::shown : DETAIL);
    visit("min_singular_value", min_singular_value);
    visit("max_singular_value", max_singular_value);
    visit("gradient_norm", gradient_norm, DETAIL);
    visit("characteristic_gradient_norm", characteristic_gradient_norm, DETAIL);
    visit("iterations", iterations);
    visit("factorizations", factorizations);
    visit("linear_solves", linear_solves, DETAIL);
    visit("inner_iterations", inner_iterations, DETAIL);
    visit("energy_evaluations", energy_evaluations, DETAIL);
    visit("fallbacks", fallbacks, DETAIL);
    visit("start", start);
    visit("energy_name", energy_name, DETAIL);
    visit("preconditioner", preconditioner);
    visit("reference", reference, DETAIL);
    visit("acceleration", acceleration, DETAIL);
    visit("linear_solver", linear_solver);
    visit("ordering", ordering, DETAIL);
    visit("factor_entries", factor_entries, DETAIL);
    visit("factorization_units", factorization_units(), DETAIL);
    visit("factorize_cpu_seconds", factorize_cpu_seconds, DETAIL);
    visit("cpu_seconds", cpu_seconds, DETAIL);
    visit("peak_memory_mb", peak_memory_mb, DETAIL);
    visit("seconds", seconds, elements < 0 ? DETAIL : Field_role::shown);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPORT_SUMMARY_H
