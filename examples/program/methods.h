// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Methods by their names, for the options of the command line and for others who let their users choose.

#ifndef FLIP_FREE_MAPS_PROGRAM_METHODS_H
#define FLIP_FREE_MAPS_PROGRAM_METHODS_H

#include <CGAL/Flip_free_maps/Any_map_traits.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/method/Start_options.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_options.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace program {

namespace FFM = CGAL::Flip_free_maps;

// A method of the literature, or the default one, with parts that differ from it, and when to stop.
struct Method_choice
{
  std::string method = "default", energy = "symmetric-dirichlet", preconditioner = "default", reference = "default",
              acceleration = "default", criterion = "auto", linear_solver = "default";
  double tolerance = -1;
  int max_iterations = FFM::Map_options().max_iterations;
  double time_limit = 0;
  double energy_parameter = 0;
  double young = 1, poisson = std::numeric_limits<double>::quiet_NaN(); // of neo-hookean, if the latter is given
  int dimension = 2;                                                    // of what is mapped

  bool is_material_given() const { return poisson == poisson; }

  // The splitting scheme as published, or with a + as this package has improved it.
  bool is_splitting() const { return method == "splitting" || method == "splitting+"; }

  // Whether nothing but the default method is asked for.
  bool is_default() const
  {
    return method == "default" && energy == "symmetric-dirichlet" && preconditioner == "default" && reference == "default" &&
           acceleration == "default" && linear_solver == "default";
  }
};

// The names that there are.
std::vector<std::string> method_names();
std::vector<std::string> energy_names();
std::vector<std::string> preconditioner_names();
std::vector<std::string> reference_names();
std::vector<std::string> acceleration_names();
std::vector<std::string> linear_solver_names();
std::vector<std::string> criterion_names();

// Why the choices contradict each other; empty if they do not.
std::string why_not_available(const Method_choice& choice, int dimension);

FFM::Any_map_traits make_traits(const Method_choice& choice);

// Sets limits and tolerances.
void set_limits(const Method_choice& choice, FFM::Map_options& options);

// Sets what differs between splitting and splitting+, and its tolerance.
void set_splitting(const Method_choice& choice, FFM::Splitting_options& options);

// The limits hold for each of the methods that remove flips; those of the polish are other ones.
template <typename RepairOptions>
void set_limits(const Method_choice& choice, RepairOptions& options)
{
  options.splitting.max_iterations = (std::min)(options.splitting.max_iterations, choice.max_iterations);
  if(choice.time_limit > 0)
    options.splitting.max_seconds = options.foldover_free.max_seconds = choice.time_limit;
}

// How the start of a parameterization is made.
struct Start_choice
{
  std::string start = "auto", border = "circle", weights = "uniform";
};

// The names that there are.
std::vector<std::string> border_names();
std::vector<std::string> weight_names();

// `has_fixed_vertices`: whether vertices are to keep the places that they have in the start.
void set_start(const Start_choice& choice, bool has_fixed_vertices, FFM::Start_options& options);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_METHODS_H
