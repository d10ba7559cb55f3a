// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_MINIMIZER_RUN_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_MINIMIZER_RUN_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/references/Fixed_reference.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <Eigen/Core>

#include <limits>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// What the stopping rules look at.
struct Minimizer_progress
{
  double energy = 0;                                                  // what is minimised in this iteration, measured on the reference
  double rest_energy = 0;                                             // the same, measured on the rest shape
  double relative_decrease = std::numeric_limits<double>::infinity(); // of the rest energy
  double model_ratio = std::numeric_limits<double>::quiet_NaN();
  double predicted_decrease = std::numeric_limits<double>::infinity(); // relative, by the full last step, as the model had it
  double gradient_norm = 0;
  double last_gradient_norm = 0; // before the last step
  double characteristic_gradient_norm = 0;
  double step = 0;
  double largest_step = 0;
  int small_decreases = 0;
  bool fresh = false; // the last direction was of second order with a matrix of its own
};

// The variables of one run of Map_minimizer, which its parts share.
template <int D>
struct Minimizer_run
{
  // Relative stiffness on the diagonal for the rotations, which are in the null space of some preconditioners.
  static constexpr double BASE_SHIFT = 1e-9;

  Minimizer_run(Positions<D>& positions, Summary& s) : x(positions), summary(s) {}

  // Iterations since the run began.
  int iterations() const { return summary.iterations - first_iteration; }

  // Ends the run; always false.
  bool finish(Status status, const std::string& message)
  {
    summary.status = status;
    summary.message = message;
    if(status == Status::time_limit || status == Status::stopped_by_observer)
      summary.message += remark;
    return false;
  }

  // Energies at x after x or the reference changed.
  template <typename Objective, typename Reference>
  void measure(const Objective& objective, const Reference& reference)
  {
    progress.energy = objective.energy(reference, x);
    progress.rest_energy = is_rest_reference ? progress.energy : objective.energy(Fixed_reference(), x);
  }

  // Gradient, and the matrix if asked for.
  template <typename Objective, typename Reference>
  void differentiate(Objective& objective, const Reference& reference, bool with_matrix)
  {
    {
      const Phase_timer timer(summary.seconds.assemble);
      objective.derivatives(reference, x, with_matrix, gradient);
    }
    progress.gradient_norm = objective.world().norm(gradient);
    progress.characteristic_gradient_norm = progress.gradient_norm / characteristic_gradient;
    summary.energy = progress.rest_energy;
    summary.gradient_norm = progress.gradient_norm;
    summary.characteristic_gradient_norm = progress.characteristic_gradient_norm;
  }

  Positions<D>& x;
  Summary& summary;
  std::string remark; // on a run that ends now
  Map_options options;
  Minimizer_progress progress;
  double time_begin = 0;
  double characteristic_gradient = 0;
  double energy_of_isometry = 0;
  bool is_rest_reference = true;
  double shift = BASE_SHIFT;
  int retries = 0;
  int first_iteration = 0; // of this run, in the counts of the summary
  Eigen::VectorXd unknowns, gradient, direction;
  Positions<D> displacement, trial;
};

} // namespace internal

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_MINIMIZER_RUN_H
