// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPORT_SUMMARY_H
#define CGAL_FLIP_FREE_MAPS_REPORT_SUMMARY_H

#include <CGAL/Flip_free_maps/report/Status.h>
#include <CGAL/Flip_free_maps/report/internal/report_header.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

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
};

/// \ingroup PkgFlipFreeMapsRef
/// The account of a run: how it ended, what it cost, and what was used. Fields that a run did not reach keep their initial
/// values (-1 for counts and energies), so an unset field can be recognised.
struct Summary
{
  Status status = Status::invalid_option;   ///< how the run ended
  std::string message = "not run";          ///< a sentence that says why
  std::int64_t vertices = -1;               ///< vertices of the mapped component
  std::int64_t elements = -1;               ///< triangles or tetrahedra of the mapped component
  int iterations = 0;                       ///< accepted steps
  int factorizations = 0;                   ///< numeric factorizations, failed ones included
  int linear_solves = 0;                    ///< right-hand sides solved
  int inner_iterations = 0;                 ///< iterations of iterative linear solvers
  int energy_evaluations = 0;               ///< evaluations of the energy along directions
  int fallbacks = 0;                        ///< iterations in which `Newton` projected the Hessian
  double energy_initial = -1;               ///< mean energy of the start (symmetric Dirichlet: an isometry has 1)
  double energy = -1;                       ///< mean energy of the result
  double energy_of_terms = 0;               ///< the part of `energy` that terms beside the elements contribute,
                                            ///< soft positions for example
  double gradient_norm = -1;                ///< Euclidean norm of the gradient at the end, on the mesh scaled to measure 1
  double characteristic_gradient_norm = -1; ///< the same over the characteristic gradient (see `Map_options`)
  double min_singular_value = -1;           ///< smallest singular value over all elements
  double max_singular_value = -1;           ///< largest singular value over all elements
  int is_bijective = -1;                    ///< 1 when the image does not overlap itself, 0 when it does, -1 when nobody asked
  std::int64_t flips = -1;                  ///< elements that are not positively oriented, by exact predicates
  Phase_seconds seconds;                    ///< wall-clock seconds by phase
  double cpu_seconds = 0;                   ///< CPU seconds (all threads) of `seconds.total`
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

  /// `true` when a stopping rule was met. A map is valid, but not converged, when a limit or the observer ended the run.
  bool converged() const { return status == Status::success; }

  /// `true` when the caller's property map holds a flip-free map.
  bool is_valid() const { return is_valid_map(status); }
};

/// \ingroup PkgFlipFreeMapsRef
/// Fills a JSON value with all fields of a summary. Written against the interface of nlohmann::json, which finds this function
/// by argument-dependent lookup: `nlohmann::json j = summary;`. `factorization_units` is `null` when the run factorized nothing.
template <typename Json>
void to_json(Json& json, const Summary& summary)
{
  internal::report_header(json, summary);
  json["converged"] = summary.converged();
  json["vertices"] = summary.vertices;
  json["faces"] = summary.elements;
  json["iterations"] = summary.iterations;
  json["factorizations"] = summary.factorizations;
  json["linear_solves"] = summary.linear_solves;
  json["inner_iterations"] = summary.inner_iterations;
  json["energy_evaluations"] = summary.energy_evaluations;
  json["fallbacks"] = summary.fallbacks;
  json["energy"] = summary.energy;
  json["energy_of_terms"] = summary.energy_of_terms;
  json["energy_initial"] = summary.energy_initial;
  json["gradient_norm"] = summary.gradient_norm;
  json["characteristic_gradient_norm"] = summary.characteristic_gradient_norm;
  json["flips"] = summary.flips;
  json["bijective"] = nullptr;
  if(summary.is_bijective >= 0)
    json["bijective"] = summary.is_bijective == 1;
  json["min_singular_value"] = summary.min_singular_value;
  json["max_singular_value"] = summary.max_singular_value;
  Json seconds = Json::object();
  seconds["load"] = summary.seconds.load;
  seconds["start"] = summary.seconds.start;
  seconds["assemble"] = summary.seconds.assemble;
  seconds["analyze"] = summary.seconds.analyze;
  seconds["factorize"] = summary.seconds.factorize;
  seconds["solve"] = summary.seconds.solve;
  seconds["line_search"] = summary.seconds.line_search;
  seconds["certify"] = summary.seconds.certify;
  seconds["total"] = summary.seconds.total;
  json["seconds"] = seconds;
  json["cpu_seconds"] = summary.cpu_seconds;
  json["factorize_cpu_seconds"] = summary.factorize_cpu_seconds;
  json["factorization_units"] = nullptr;
  if(summary.factorizations > 0 && summary.factorize_cpu_seconds > 0)
    json["factorization_units"] = summary.cpu_seconds * summary.factorizations / summary.factorize_cpu_seconds;
  json["factor_entries"] = summary.factor_entries;
  json["peak_memory_mb"] = summary.peak_memory_mb;
  json["linear_solver"] = summary.linear_solver;
  json["ordering"] = summary.ordering;
  json["start"] = summary.start;
  json["energy_name"] = summary.energy_name;
  json["preconditioner"] = summary.preconditioner;
  json["reference"] = summary.reference;
  json["acceleration"] = summary.acceleration;
}

/// \ingroup PkgFlipFreeMapsRef
/// Writes a summary as a few lines of text.
inline std::ostream& operator<<(std::ostream& os, const Summary& summary)
{
  os << status_name(summary.status) << ": " << summary.message << '\n';
  if(summary.elements < 0)
    return os;
  os << "  " << summary.vertices << " vertices, " << summary.elements << " elements, " << summary.flips << " flipped\n"
     << "  energy " << summary.energy_initial << " -> " << summary.energy << ", singular values [" << summary.min_singular_value << ", "
     << summary.max_singular_value << "]\n"
     << "  " << summary.iterations << " iterations, " << summary.factorizations << " factorizations, " << summary.seconds.total << " s\n"
     << "  start: " << summary.start << "; preconditioner: " << summary.preconditioner << "; linear solver: " << summary.linear_solver
     << '\n';
  return os;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPORT_SUMMARY_H
